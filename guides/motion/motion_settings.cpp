#include "guides/motion/motion_settings.h"

#include <fmt/format.h>

#include "guides/base/errors.h"

namespace lancret {

namespace {

constexpr double kMaxFrameNumber = 1e6, kMaxCoordinate = 1e6;

}  // namespace

std::optional<Vec3> bounded_vector(const TomlTable& table, std::string_view key) {
    const auto value = table.vector(key);
    if (value && value->cwiseAbs().maxCoeff() > kMaxCoordinate) {
        table.fail(key, fmt::format("'{}' must be within {} in each direction", key,
                                    kMaxCoordinate));
    }
    return value;
}

void read_motion_keys(const TomlTable& table, MotionSettings& out) {
    assign_if(out.pivot, bounded_vector(table, "pivot"));
    for (const TomlTable& key : table.tables("keys")) {
        PoseKey pose;
        const auto frame = key.number("frame", -kMaxFrameNumber, kMaxFrameNumber);
        if (!frame) key.fail("", "a key needs its 'frame'");
        pose.frame = *frame;
        if (!out.keys.empty() && pose.frame < out.keys.back().frame + 1e-6) {
            key.fail("frame", "the frames of keys must increase");
        }
        assign_if(pose.translation, bounded_vector(key, "move"));
        assign_if(pose.rotation, bounded_vector(key, "turn"));
        out.keys.push_back(pose);
    }
}

MotionSettings read_motion(const TomlTable& table, double centimetres_per_unit) {
    MotionSettings out;
    out.files.centimetres_per_unit = centimetres_per_unit;
    read_motion_keys(table, out);
    if (const auto files = table.path("files")) {
        if (!out.keys.empty()) {
            table.fail("files", "a head moves by 'keys' or by 'files', not both");
        }
        out.files.pattern = files->string();
        const auto first = table.integer("first", 0, std::int64_t(kMaxFrameNumber));
        const auto last = table.integer("last", 0, std::int64_t(kMaxFrameNumber));
        if (!first || !last || *first > *last) {
            table.fail("files",
                       "'files' needs the frame numbers of its files, 'first' <= 'last'");
        }
        out.files.first = int(*first);
        out.files.last = int(*last);
    }
    return out;
}

ScalpMotion scalp_motion(const MotionSettings& settings, const TriangleMesh* rest,
                         double frames_per_second) {
    if (!settings.files.pattern.empty()) {
        if (!rest) {
            throw InputError(fmt::format("{}: moves a scalp, but the groom has none",
                                         settings.files.pattern));
        }
        ObjSequence files = settings.files;
        files.frames_per_second = frames_per_second;
        return MeshSequence(std::move(files), *rest);
    }
    std::vector<PoseKey> keys = settings.keys;
    if (keys.empty()) keys.push_back({});
    return make_rigid_path(std::move(keys), settings.pivot, frames_per_second);
}

}  // namespace lancret
