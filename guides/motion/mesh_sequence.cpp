#include "guides/motion/mesh_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

#include "guides/base/coordinates.h"
#include "guides/base/errors.h"
#include "guides/files/obj_file.h"

namespace lancret {

namespace {

/// A time needs four files; the next step needs mostly the same.
constexpr std::size_t kMaxInMemory = 6;
constexpr int kMaxDigits = 12;

/// The field of the frame number in a pattern.
struct FrameField {
    std::size_t begin, end;
    int digits;
};

/// The first field at or after `from`; `begin` is npos if there is none.
FrameField next_field(std::string_view pattern, std::size_t from) {
    for (std::size_t i = from; i < pattern.size(); ++i) {
        if (pattern[i] == '#') {
            const std::size_t end =
                std::min(pattern.find_first_not_of('#', i), pattern.size());
            return {i, end, int(std::min<std::size_t>(end - i, kMaxDigits + 1))};
        }
        if (pattern[i] != '%') continue;
        std::size_t end = i + 1;
        int digits = 0;
        for (; end < pattern.size() && pattern[end] >= '0' && pattern[end] <= '9';
             ++end) {
            digits = std::min(10 * digits + (pattern[end] - '0'), kMaxDigits + 1);
        }
        if (end < pattern.size() && pattern[end] == 'd') return {i, end + 1, digits};
    }
    return {pattern.npos, pattern.npos, 0};
}

void check_topology(const std::string& name, const TriangleMesh& mesh,
                    const TriangleMesh& rest) {
    if (mesh.positions.size() != rest.positions.size() ||
        mesh.triangles.size() != rest.triangles.size()) {
        throw InputError(fmt::format(
            "{}: {} vertices and {} triangles, expected {} and {} as in the rest mesh",
            name, mesh.positions.size(), mesh.triangles.size(), rest.positions.size(),
            rest.triangles.size()));
    }
    const auto [other, own] = std::ranges::mismatch(mesh.triangles, rest.triangles);
    if (other != mesh.triangles.end()) {
        throw InputError(fmt::format(
            "{}: triangle {} has other vertices than in the rest mesh, expected the same "
            "topology",
            name, other - mesh.triangles.begin()));
    }
}

}  // namespace

std::filesystem::path frame_path(std::string_view pattern, int frame) {
    // Only the file name is searched: folders may contain any characters.
    const std::size_t name = pattern.find_last_of('/') + 1;
    const FrameField field = next_field(pattern, name);
    if (field.begin == pattern.npos || field.digits > kMaxDigits ||
        next_field(pattern, field.end).begin != pattern.npos) {
        throw InputError(fmt::format(
            "{}: expected one field for the frame number, such as %04d or ####, of at "
            "most {} digits",
            pattern, kMaxDigits));
    }
    return fmt::format("{}{:0{}}{}", pattern.substr(0, field.begin), frame, field.digits,
                       pattern.substr(field.end));
}

VertexMotion vertex_motion(const MeshMotion& mesh, std::uint32_t i) {
    VertexMotion out;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 p = mesh.keys[k]->positions[i].cast<double>();
        out.position += mesh.weights[k] * p;
        out.velocity += mesh.rates[k] * p;
        out.acceleration += mesh.bends[k] * p;
    }
    return out;
}

struct MeshSequence::State {
    ObjSequence files;
    std::shared_ptr<const TriangleMesh> rest;
    std::mutex mutex;
    /// Most recently used last.
    std::vector<std::pair<int, std::shared_ptr<const TriangleMesh>>> in_memory;

    std::shared_ptr<const TriangleMesh> mesh_at(int frame);
};

std::shared_ptr<const TriangleMesh> MeshSequence::State::mesh_at(int frame) {
    const auto known =
        std::ranges::find(in_memory, frame, [](auto& m) { return m.first; });
    if (known != in_memory.end()) {
        std::rotate(known, known + 1, in_memory.end());
        return in_memory.back().second;
    }
    const std::filesystem::path path = frame_path(files.pattern, frame);
    auto mesh = std::make_shared<TriangleMesh>(read_obj(path));
    check_topology(path.string(), *mesh, *rest);
    mesh->triangles = {};
    mesh->uvs = {};
    for (Vec3f& p : mesh->positions) {
        p *= float(files.centimetres_per_unit);
        if (!is_place(p)) {
            throw InputError(fmt::format("{}: a vertex is beyond {:g} cm", path.string(),
                                         kLargestCoordinate));
        }
    }
    if (in_memory.size() >= kMaxInMemory) in_memory.erase(in_memory.begin());
    in_memory.emplace_back(frame, mesh);
    return mesh;
}

MeshSequence::MeshSequence(ObjSequence files, TriangleMesh rest)
    : state_(std::make_unique<State>()) {
    frame_path(files.pattern, files.first);
    if (files.first > files.last) {
        throw InputError(fmt::format("{}: the first frame {} is after the last frame {}",
                                     files.pattern, files.first, files.last));
    }
    const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
    if (!positive(files.centimetres_per_unit) || !positive(files.frames_per_second)) {
        throw std::invalid_argument(
            "MeshSequence: the unit and the frames per second must be above 0");
    }
    state_->files = std::move(files);
    state_->rest = std::make_shared<TriangleMesh>(std::move(rest));
}

MeshSequence::~MeshSequence() = default;
MeshSequence::MeshSequence(MeshSequence&&) noexcept = default;
MeshSequence& MeshSequence::operator=(MeshSequence&&) noexcept = default;

MeshMotion MeshSequence::at(double frame) const {
    if (!std::isfinite(frame)) {
        throw std::invalid_argument("MeshSequence: the frame must be finite");
    }
    const auto& [pattern, first, last, unit, fps] = state_->files;
    const double inside = std::clamp(frame, double(first), double(last));
    // The last frame is the end of the last interval.
    const int from =
        int(std::max(double(first), std::min(std::floor(inside), double(last) - 1.0)));
    const double t = inside - from, t2 = t * t, t3 = t2 * t;
    MeshMotion out;
    out.rest = state_->rest;
    out.name = fmt::format("{} at frame {:g}", pattern, frame);
    out.weights = {(2 * t2 - t3 - t) / 2, (3 * t3 - 5 * t2 + 2) / 2,
                   (4 * t2 - 3 * t3 + t) / 2, (t3 - t2) / 2};
    if (frame >= first && frame <= last && first < last) {
        out.rates = {(4 * t - 3 * t2 - 1) / 2, (9 * t2 - 10 * t) / 2,
                     (8 * t - 9 * t2 + 1) / 2, (3 * t2 - 2 * t) / 2};
        out.bends = {2 - 3 * t, 9 * t - 5, 4 - 9 * t, 3 * t - 1};
        for (double& rate : out.rates) rate *= fps;
        for (double& bend : out.bends) bend *= fps * fps;
    }
    const std::scoped_lock lock(state_->mutex);
    for (int k = 0; k < 4; ++k) {
        const long file = std::clamp<long>(long(from) - 1 + k, first, last);
        out.keys[std::size_t(k)] = state_->mesh_at(int(file));
    }
    return out;
}

}  // namespace lancret
