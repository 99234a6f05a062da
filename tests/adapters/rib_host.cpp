#include "tests/adapters/rib_host.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <sstream>

namespace lancret {
namespace {

/// The host and RIB of the calling thread, like the context of a renderer.
thread_local RibHost* host = nullptr;
thread_local std::string* rib = nullptr;

struct Working {
    Working(RibHost* for_host, std::string* into) {
        host = for_host;
        rib = into;
    }
    ~Working() { host = nullptr, rib = nullptr; }
};

/// With enough digits to read back the same float.
void write_number(float value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g ", double(value));
    *rib += text;
}
void write_number(int value) { *rib += std::to_string(value) + " "; }

template <class T>
void write_array(const T* values, std::size_t n) {
    *rib += "[ ";
    for (std::size_t i = 0; i < n; ++i) write_number(values[i]);
    *rib += "] ";
}

void write_string(const std::string& text) { *rib += '"' + text + "\" "; }

/// Number and type of the values of a token of RiCurves, by the rules of the RenderMan
/// Interface, independent of the adapter.
struct Values {
    std::size_t count = 0;
    bool integers = false;
};

struct CurveCounts {
    std::size_t curves = 0, vertices = 0, varying = 0;
};

Values values_of(const std::string& token, const CurveCounts& counts) {
    if (token == "P") return {3 * counts.vertices, false};
    if (token == "constantwidth") return {1, false};
    std::istringstream words(token);
    std::string storage, type, name;
    words >> storage >> type >> name;
    std::size_t each = 1;
    if (const auto bracket = type.find('['); bracket != type.npos) {
        each = std::size_t(std::stoi(type.substr(bracket + 1)));
        type = type.substr(0, bracket);
    }
    if (type == "point" || type == "normal" || type == "vector") each *= 3;
    const std::size_t elements = storage == "uniform"   ? counts.curves
                                 : storage == "vertex"  ? counts.vertices
                                 : storage == "varying" ? counts.varying
                                                        : 0;
    EXPECT_TRUE(elements > 0 && !name.empty()) << token;
    EXPECT_TRUE(type == "float" || type == "point" || type == "normal" ||
                type == "vector" || type == "integer")
        << token;
    return {each * elements, type == "integer"};
}

/// Vertices per segment, as set by RiBasis.
thread_local int basis_step = 1;

}  // namespace

RibHost::RibHost(const std::string& dso) {
    library_ = dlopen(dso.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library_) {
        ADD_FAILURE() << dlerror();
        return;
    }
    convert_parameters =
        reinterpret_cast<RtPointer (*)(char*)>(dlsym(library_, "ConvertParameters"));
    subdivide_function =
        reinterpret_cast<void (*)(RtPointer, RtFloat)>(dlsym(library_, "Subdivide"));
    free_function = reinterpret_cast<void (*)(RtPointer)>(dlsym(library_, "Free"));
    EXPECT_TRUE(convert_parameters && subdivide_function && free_function);
}

RibHost::~RibHost() {
    free_children();
    while (!roots_.empty()) free_root(roots_.back());
    if (library_) dlclose(library_);
}

RtPointer RibHost::convert(const std::string& parameters) {
    std::string unused, text = parameters;
    const Working working(this, &unused);
    const RtPointer out = convert_parameters(text.data());
    std::ranges::fill(text, '#');  // the renderer may reuse its string
    if (out) roots_.push_back(out);
    return out;
}

void RibHost::subdivide_root(RtPointer root, float detail) {
    std::string emitted;
    const Working working(this, &emitted);
    subdivide_function(root, detail);
    EXPECT_EQ(emitted, "") << "a root emits procedurals only";
}

void RibHost::free_root(RtPointer root) {
    const Working working(this, nullptr);
    std::erase(roots_, root);
    free_function(root);
}

std::string RibHost::subdivide(const Procedural& child, float detail) {
    std::string out = "AttributeBegin\nBound ";
    const Working working(this, &out);
    write_array(child.bound.data(), 6);
    out += "\n";
    child.subdivide(child.data, detail);
    out += "AttributeEnd\n";
    return out;
}

void RibHost::free_children() {
    const Working working(this, nullptr);
    for (const Procedural& child : children) child.release(child.data);
    children.clear();
}

std::string RibHost::rib_of(const std::string& parameters, float detail) {
    std::string out = "##RenderMan RIB\nversion 3.04\n";
    const RtPointer root = convert(parameters);
    if (!root) return out;
    subdivide_root(root, detail);
    free_root(root);
    for (const Procedural& child : children) out += subdivide(child, detail);
    free_children();
    return out;
}

}  // namespace lancret

// The calls that a renderer provides to a DSO.

using namespace lancret;

extern "C" {

RtBasis RiBSplineBasis = {{-1 / 6.f, 3 / 6.f, -3 / 6.f, 1 / 6.f},
                          {3 / 6.f, -1, 3 / 6.f, 0},
                          {-3 / 6.f, 0, 3 / 6.f, 0},
                          {1 / 6.f, 4 / 6.f, 1 / 6.f, 0}};
RtBasis RiCatmullRomBasis = {
    {-.5f, 1.5f, -1.5f, .5f}, {1, -2.5f, 2, -.5f}, {-.5f, 0, .5f, 0}, {0, 1, 0, 0}};
RtBasis RiBezierBasis = {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}};
RtBasis RiHermiteBasis = {{2, 1, -2, 1}, {-3, -2, 3, -1}, {0, 1, 0, 0}, {1, 0, 0, 0}};

void RiAttributeBegin(void) { *rib += "AttributeBegin\n"; }
void RiAttributeEnd(void) { *rib += "AttributeEnd\n"; }

void RiMotionBeginV(RtInt n, RtFloat times[]) {
    *rib += "MotionBegin ";
    write_array(times, std::size_t(n));
    *rib += "\n";
}
void RiMotionEnd(void) { *rib += "MotionEnd\n"; }

void RiBasis(RtBasis u, RtInt u_step, RtBasis v, RtInt v_step) {
    basis_step = v_step;
    *rib += "Basis ";
    write_array(&u[0][0], 16);
    write_number(u_step);
    write_array(&v[0][0], 16);
    write_number(v_step);
    *rib += "\n";
}

void RiCurvesV(RtToken type, RtInt curves, RtInt vertices[], RtToken wrap, RtInt n,
               RtToken tokens[], RtPointer values[]) {
    const bool cubic = std::strcmp(type, "cubic") == 0;
    CurveCounts counts{std::size_t(curves), 0, 0};
    for (RtInt i = 0; i < curves; ++i) {
        counts.vertices += std::size_t(vertices[i]);
        counts.varying +=
            std::size_t(cubic ? (vertices[i] - 4) / basis_step + 2 : vertices[i]);
        // A renderer rejects a curve whose last segment is incomplete.
        EXPECT_EQ(cubic ? (vertices[i] - 4) % basis_step : 0, 0);
        EXPECT_GE(vertices[i], cubic ? 4 : 2);
    }
    *rib += "Curves ";
    write_string(type);
    write_array(vertices, counts.curves);
    write_string(wrap);
    for (RtInt i = 0; i < n; ++i) {
        write_string(tokens[i]);
        const Values shape = values_of(tokens[i], counts);
        if (shape.integers) {
            write_array(static_cast<const RtInt*>(values[i]), shape.count);
        } else {
            write_array(static_cast<const RtFloat*>(values[i]), shape.count);
        }
    }
    *rib += "\n";
}

void RiProcedural(RtPointer data, RtBound bound, RtProcSubdivFunc subdivide,
                  RtProcFreeFunc release) {
    Procedural child{data, {}, subdivide, release};
    std::copy(bound, bound + 6, child.bound.begin());
    const std::lock_guard lock(host->mutex);
    host->children.push_back(child);
}

void RiErrorPrint(RtInt, RtInt severity, const char* message) {
    const std::lock_guard lock(host->mutex);
    if (severity >= kRiError) host->errors += std::string(message) + "\n";
}

}  // extern "C"
