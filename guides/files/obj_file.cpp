#include "guides/files/obj_file.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>

#include "guides/base/atomic_file.h"
#include "guides/base/coordinates.h"
#include "guides/base/errors.h"

namespace lancret {

namespace {

constexpr int kMaxCorners = 1000;

/// Finds the errors that the library accepts silently: it reads an invalid number as 0
/// and does not validate every index. Each line is checked first, and the library gets
/// only those of vertices, texture coordinates and faces.
class ObjChecker {
  public:
    explicit ObjChecker(std::string name) : name_(std::move(name)) {}

    /// Checks the text; returns the lines that define the mesh.
    std::string check(std::string_view text) {
        std::string kept;
        kept.reserve(text.size());
        while (!text.empty()) {
            ++line_;
            const std::size_t end = std::min(text.find('\n'), text.size());
            rest_ = text.substr(0, end);
            text.remove_prefix(std::min(end + 1, text.size()));
            const std::string_view whole = rest_, keyword = token();
            if (keyword == "v") {
                check_vertex();
            } else if (keyword == "vt") {
                check_uv();
            } else if (keyword == "f") {
                check_face();
            } else {
                continue;
            }
            kept.append(whole).push_back('\n');
        }
        for (const auto& [index, count, what] :
             {std::tuple(last_vertex_, vertices_, "vertex"),
              std::tuple(last_uv_, uvs_, "texture coordinate")}) {
            line_ = index.line;
            if (index.value > count) fail_index(index.value, count, what);
        }
        return kept;
    }

  private:
    struct Index {
        long value = 0;
        std::size_t line = 0;
    };

    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("{}:{}: {}", name_, line_, what));
    }
    [[noreturn]] void fail_index(long index, long count, std::string_view what) const {
        fail(fmt::format("index {} of a {}, but there are {}", index, what, count));
    }

    /// The next word of the line; empty at the end.
    std::string_view token() {
        constexpr std::string_view kBlank = " \t\r";
        rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlank), rest_.size()));
        const auto word = rest_.substr(0, rest_.find_first_of(kBlank));
        rest_.remove_prefix(word.size());
        return word;
    }

    float number(std::string_view what) {
        std::string_view word = token();
        if (word.empty()) fail(fmt::format("a number of the {} is missing", what));
        const std::string_view read = word;
        if (word.front() == '+') word.remove_prefix(1);
        double value = 0;
        const auto [end, error] =
            std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size()) {
            fail(fmt::format("'{}' in the {} is not a number", read, what));
        }
        return float(value);
    }

    void check_vertex() {
        ++vertices_;
        const float x = number("vertex"), y = number("vertex"), z = number("vertex");
        if (!is_place({x, y, z})) {
            fail(
                fmt::format("invalid vertex ({}, {}, {}), expected finite "
                            "coordinates within {:g}",
                            x, y, z, kLargestCoordinate));
        }
    }

    void check_uv() {
        ++uvs_;
        do {
            if (!std::isfinite(number("texture coordinate"))) {
                fail("the texture coordinate is not finite");
            }
        } while (rest_.find_first_not_of(" \t\r") != rest_.npos);
    }

    void check_face() {
        int corners = 0;
        for (std::string_view word = token(); !word.empty(); word = token()) {
            if (++corners > kMaxCorners) {
                fail(fmt::format("a face has more than {} corners", kMaxCorners));
            }
            const char* end = word.data() + word.size();
            const char* at =
                check_index(word.data(), end, vertices_, last_vertex_, "vertex");
            if (at < end - 1 && at[0] == '/' && at[1] != '/') {
                at = check_index(at + 1, end, uvs_, last_uv_, "texture coordinate");
            } else if (at != end && *at == '/') {
                ++at;
            }
            // The index of a normal is not used, but the library must be able to read it.
            if (at < end - 1 && *at == '/') {
                long normal = 0;
                at = std::from_chars(at + 1, end, normal).ptr;
                if (normal == 0 || std::abs(normal) > 0x7fffffff) at = word.data();
            }
            if (at != end) {
                fail(
                    fmt::format("'{}' is not a corner of a face, expected v, v/vt, v//vn "
                                "or v/vt/vn",
                                word));
            }
        }
        if (corners < 3) {
            fail(fmt::format("a face has {} corners, expected at least 3", corners));
        }
    }

    const char* check_index(const char* at, const char* end, long count, Index& last,
                            std::string_view what) const {
        long index = 0;
        const auto [after, error] = std::from_chars(at, end, index);
        if (error != std::errc()) {
            fail(fmt::format("the index of a {} is not a number", what));
        }
        if (index == 0 || index < -count) fail_index(index, count, what);
        // A face may come before its vertices: positive indices are validated at the end.
        if (index > last.value) last = {index, line_};
        return after;
    }

    std::string name_;
    std::string_view rest_;
    std::size_t line_ = 0;
    long vertices_ = 0, uvs_ = 0;
    Index last_vertex_, last_uv_;
};

std::string read_text(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        throw InputError(path.string() + (std::filesystem::exists(path, error)
                                              ? ": not a regular file"
                                              : ": there is no such file"));
    }
    std::ifstream stream(path, std::ios::binary);
    std::string text(std::size_t(std::filesystem::file_size(path, error)), '\0');
    stream.read(text.data(), std::streamsize(text.size()));
    if (!stream) throw InputError(path.string() + ": cannot be read");
    return text;
}

/// A UV by its bits, so that 0 and -0 stay distinct.
using UvKey = std::pair<std::uint32_t, std::uint32_t>;

UvKey key_of(const Vec2f& uv) {
    return {std::bit_cast<std::uint32_t>(uv.x()), std::bit_cast<std::uint32_t>(uv.y())};
}

}  // namespace

TriangleMesh read_obj(const std::filesystem::path& path) {
    const std::string text = ObjChecker(path.string()).check(read_text(path));
    tinyobj::ObjReaderConfig config;
    config.triangulate = true;
    config.vertex_color = false;
    tinyobj::ObjReader reader;
    if (!reader.ParseFromString(text, "", config)) {
        throw InputError(path.string() + ": " + reader.Error());
    }

    TriangleMesh mesh;
    const auto& read = reader.GetAttrib();
    for (std::size_t i = 0; i + 2 < read.vertices.size(); i += 3) {
        mesh.positions.emplace_back(Vec3f::Map(&read.vertices[i]));
    }
    bool any_uv = false;
    for (const tinyobj::shape_t& shape : reader.GetShapes()) {
        const auto& corners = shape.mesh.indices;
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            auto& triangle = mesh.triangles.emplace_back();
            auto& uvs = mesh.uvs.emplace_back();
            for (std::size_t c = 0; c < 3; ++c) {
                const auto& [vertex, normal, uv] = corners[i + c];
                if (vertex < 0 || std::size_t(vertex) >= mesh.positions.size() ||
                    2 * std::ptrdiff_t(uv) + 1 >= std::ptrdiff_t(read.texcoords.size())) {
                    throw InputError(path.string() + ": an index is out of range");
                }
                triangle[c] = std::uint32_t(vertex);
                uvs[c] = Vec2f::Zero();
                if (uv >= 0) uvs[c] = Vec2f::Map(&read.texcoords[2 * std::size_t(uv)]);
                any_uv = any_uv || uv >= 0;
            }
        }
    }
    if (mesh.triangles.empty()) {
        throw InputError(path.string() + ": no triangles, expected at least one");
    }
    if (!any_uv) mesh.uvs.clear();
    return mesh;
}

void write_obj(const std::filesystem::path& path, const TriangleMesh& mesh) {
    if (!mesh.uvs.empty() && mesh.uvs.size() != mesh.triangles.size()) {
        throw std::invalid_argument("write_obj: expected UVs for every triangle or none");
    }
    fmt::memory_buffer out;
    auto to = std::back_inserter(out);
    for (const Vec3f& p : mesh.positions) {
        fmt::format_to(to, "v {} {} {}\n", p.x(), p.y(), p.z());
    }
    // Corners that share a texture coordinate share its line.
    std::map<UvKey, std::size_t> uv_lines;
    for (const auto& uvs : mesh.uvs) {
        for (const Vec2f& uv : uvs) {
            if (!uv_lines.try_emplace(key_of(uv), uv_lines.size() + 1).second) continue;
            fmt::format_to(to, "vt {} {}\n", uv.x(), uv.y());
        }
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        fmt::format_to(to, "f");
        for (std::size_t c = 0; c < 3; ++c) {
            fmt::format_to(to, " {}", mesh.triangles[i][c] + 1);
            if (!mesh.uvs.empty()) {
                fmt::format_to(to, "/{}", uv_lines.at(key_of(mesh.uvs[i][c])));
            }
        }
        fmt::format_to(to, "\n");
    }
    write_beside_and_rename(path, std::string_view(out.data(), out.size()));
}

}  // namespace lancret
