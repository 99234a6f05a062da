#include "guides/files/frame_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "guides/base/atomic_file.h"
#include "guides/base/errors.h"
#include "guides/files/guide_cache_write.h"

namespace lancret {

namespace fs = std::filesystem;

namespace {

bool same_guides(const Guides& a, const Guides& b) {
    return a.size() == b.size() && a.segments == b.segments &&
           a.segment_lengths == b.segment_lengths;
}

/// The frame number of a file name such as "000042.h5" or "-00003.h5"; otherwise nullopt.
std::optional<int> number_of(const fs::path& file) {
    const std::string name = file.stem().string();
    int number = 0;
    const char* const end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data(), end, number);
    const bool all = error == std::errc() && stop == end && file.extension() == ".h5";
    return all ? std::optional(number) : std::nullopt;
}

/// Whether `file` is a temporary file of a frame that a killed run left.
bool is_left_over(const fs::path& file) {
    const std::string name = file.filename().string();
    return number_of(name.substr(0, name.find(".tmp-")) + ".h5") &&
           name.find(".tmp-") != std::string::npos && file.extension() == ".h5";
}

/// The sorted files of a folder; empty if there is no such folder.
std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> out;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) {
        out.push_back(at->path());
    }
    std::ranges::sort(out);
    return out;
}

void remove_file(const fs::path& file) {
    std::error_code error;
    fs::remove(file, error);
    if (error) {
        throw InputError(
            fmt::format("{}: cannot be removed: {}", file.string(), error.message()));
    }
}

/// The reason for which reading would reject these guides; empty if it would not.
std::string fault_of(const Guides& guides) {
    for (std::size_t g = 0; g < guides.size(); ++g) {
        if (!guides.root_positions[g].allFinite()) {
            return fmt::format("the root of guide {} is not finite", g);
        }
        if (!is_cache_rotation(guides.root_frames[g])) {
            return fmt::format("the root frame of guide {} is not a rotation", g);
        }
        for (const Vec3& u : guides.curvatures_of(g)) {
            if (!u.allFinite()) {
                return fmt::format("the curvatures of guide {} are not finite", g);
            }
        }
    }
    return {};
}

}  // namespace

FrameStore::FrameStore(fs::path cache, GuideCacheHeader header, std::string job,
                       Guides rest, bool restart)
    : cache_(std::move(cache)),
      folder_(folder_of(cache_)),
      header_(std::move(header)),
      job_(std::move(job)),
      rest_(std::move(rest)) {
    { const PendingFile writable(cache_); }
    std::error_code error;
    if (fs::exists(folder_, error) && !fs::is_directory(folder_, error)) {
        throw InputError(
            fmt::format("{}: must be a folder, for the frames", folder_.string()));
    }
    if (!restart) {
        refuse_other_runs();
        base_ = finished_frames();
        done_ = base_;
        while (is_whole(done_)) ++done_;
    }
    remove_from(done_);
}

fs::path FrameStore::folder_of(const fs::path& cache) {
    return fs::path(cache).concat(".frames");
}

fs::path FrameStore::frame_file(int k) const {
    return folder_ / fmt::format("{:06}.h5", number(k));
}

int FrameStore::number(int k) const {
    const std::int64_t out = std::int64_t(header_.first_frame) + k;
    if (out > std::numeric_limits<int>::max()) {
        throw std::invalid_argument("FrameStore: the frame number is too large");
    }
    return int(out);
}

/// Throws if the folder contains any readable frame of another run, which may still be
/// wanted. An unreadable one is of no use.
void FrameStore::refuse_other_runs() const {
    for (const fs::path& file : files_in(folder_)) {
        if (!number_of(file)) continue;
        bool ours = true;
        try {
            const GuideCacheInfo info = guide_cache_info(file);
            ours = read_restart(file).job == job_ &&
                   info.frames_per_second == header_.frames_per_second &&
                   same_guides(read_guide_cache(file, 0), rest_);
        } catch (const InputError&) {
            continue;
        }
        if (!ours) {
            throw InputError(fmt::format(
                "{}: is a frame of another run, with another groom, other guides or "
                "other "
                "settings. Give the cache another name, or use --restart to remove the "
                "frames in {} and start over",
                file.string(), folder_.string()));
        }
    }
}

/// The number of frames of a finished cache of this run if all are undamaged; otherwise
/// 0.
int FrameStore::finished_frames() const {
    try {
        const GuideCacheInfo info = guide_cache_info(cache_);
        if (!info.has_restart || info.first_frame != header_.first_frame ||
            info.frames_per_second != header_.frames_per_second ||
            read_restart(cache_).job != job_) {
            return 0;
        }
        for (int k = 0; k < info.frames; ++k) {
            if (!same_guides(read_guide_cache(cache_, k), rest_)) return 0;
        }
        return info.frames;
    } catch (const InputError&) {
        return 0;
    }
}

bool FrameStore::is_whole(int k) const {
    const fs::path file = frame_file(k);
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return false;
    try {
        const GuideCacheInfo info = guide_cache_info(file);
        return info.frames == 1 && info.first_frame == number(k) &&
               read_restart(file).job == job_ &&
               same_guides(read_guide_cache(file, 0), rest_);
    } catch (const InputError&) {
        return false;
    }
}

/// Removes temporary files and the frames from k on, in the order of their numbers: if
/// the process is killed here, a gap precedes the remaining ones.
void FrameStore::remove_from(int k) const {
    std::vector<std::pair<int, fs::path>> frames;
    for (const fs::path& file : files_in(folder_)) {
        if (is_left_over(file)) remove_file(file);
        const auto n = number_of(file);
        const std::int64_t first = std::int64_t(header_.first_frame) + k;
        if (n && (*n >= first || *n < header_.first_frame)) frames.emplace_back(*n, file);
    }
    std::ranges::sort(frames);
    for (const auto& [n, file] : frames) remove_file(file);
}

Guides FrameStore::frame(int k) const {
    return k < base_ ? read_guide_cache(cache_, k) : read_guide_cache(frame_file(k), 0);
}

LastFrame FrameStore::last() const {
    if (done_ == 0) throw std::logic_error("FrameStore: no frame is done");
    const int k = done_ - 1;
    return {number(k), frame(k), read_restart(k < base_ ? cache_ : frame_file(k)).arrays};
}

void FrameStore::add(const Guides& frame, const RestartArrays& arrays) {
    if (!same_guides(frame, rest_)) {
        throw std::invalid_argument("FrameStore: expected the guides of the rest pose");
    }
    if (const std::string fault = fault_of(frame); !fault.empty()) {
        throw std::invalid_argument(
            fmt::format("FrameStore: frame {}: {}", number(done_), fault));
    }
    std::error_code error;
    fs::create_directory(folder_, error);
    if (error) {
        throw InputError(
            fmt::format("{}: cannot be created: {}", folder_.string(), error.message()));
    }
    GuideCacheHeader header = header_;
    header.first_frame = number(done_);
    GuideCacheWriter writer(frame_file(done_), header, 1, &rest_);
    writer.add(frame);
    const Restart restart{job_, arrays};
    writer.finish(&restart);
    ++done_;
}

void FrameStore::finish() {
    if (done_ == 0) throw std::logic_error("FrameStore: no frame is done");
    if (done_ > base_) {
        const Restart restart{job_, last().arrays};
        GuideCacheWriter writer(cache_, header_, done_, &rest_);
        for (int k = 0; k < done_; ++k) writer.add(frame(k));
        writer.finish(&restart);
        base_ = done_;
    }
    // The cache has all frames: a kill from here on loses none.
    remove_from(0);
    std::error_code not_empty;  // a folder with other files stays
    fs::remove(folder_, not_empty);
}

}  // namespace lancret
