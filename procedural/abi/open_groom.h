#pragma once
// An open groom, shared by all handles with the same source.

#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "procedural/abi/file_stamp.h"
#include "procedural/abi/shared_by_key.h"
#include "procedural/chunk/chunked_groom.h"
#include "procedural/groom/groom_source.h"
#include "procedural/motion/moving_groom.h"

namespace lancret::abi {

/// The guides and the scalp at one time, sampled for the given strand classes.
struct GuidePose {
    std::shared_ptr<const StrandClasses> classes;
    Guides guides;
    PosedScalp scalp;
    ClassedGuides classed;
};

/// Arrays of lancret_guides that differ from the layout of Guides.
struct GuideArrays {
    std::vector<double> root_frames;  ///< [guides][3][3], row by row
    std::vector<double> fit_rms;      ///< [guides], or empty
};

/// Maximum number of intervals per strand if the host sets max_error.
inline constexpr int kMaxRequestedIntervals = 1024;

/// Number of poses that are cached even if every call has a single time.
inline constexpr std::size_t kPosesKept = 16;

/// All members may be called by any number of threads at once.
class OpenGroom {
  public:
    using Warn = std::function<void(const std::string& text)>;

    /// Loads the groom, fits its guides, places its strands and divides them into chunks.
    /// `warn` may be called from any thread for the lifetime of this object, if a later
    /// call cannot meet its tolerance. Throws InputError, Cancelled.
    OpenGroom(const SourcedGroom& sourced, std::uint32_t chunk_strands,
              const StageCallback& stage, Warn warn);

    const ChunkedGroom& chunked() const { return chunked_; }
    const ReadyGroom& ready() const { return chunked_.ready; }
    const GroomTimes& times() const { return times_; }
    const GuideArrays& guide_arrays() const { return arrays_; }

    /// The frame number at `time`: clamped to the range of the cache, 0 if static.
    double frame_at(double time) const;
    /// Caches at least this many poses from now on: the times of one chunk request.
    void expect_times(std::size_t times) const { poses_.keep_at_least(times); }
    /// The pose at a frame number as returned by `frame_at`. The most recent poses are
    /// cached. Throws InputError, Cancelled.
    std::shared_ptr<const GuidePose> pose(
        double frame, const std::shared_ptr<const StrandClasses>& classes) const;
    /// Interval counts that keep curves of `basis` within `max_error` cm of the strands,
    /// or within the groom's tolerance if it is 0. A single class if `alike`, and for
    /// strands with faces. Throws InputError, Cancelled.
    std::shared_ptr<const StrandClasses> classes(CurveBasis basis, float max_error,
                                                 bool alike) const;
    /// Memory held by this object, without its caches.
    std::size_t bytes() const;

  private:
    /// Frames are read on demand, so the cache file must not change. Throws InputError if
    /// it has.
    void expect_same_cache() const;

    Warn warn_;
    FileStamp cache_;
    ChunkedGroom chunked_;
    GroomTimes times_;
    GuideArrays arrays_;
    mutable SharedByKey<std::pair<double, const StrandClasses*>, GuidePose> poses_{
        kPosesKept};
    mutable SharedByKey<std::tuple<CurveBasis, float, bool>, StrandClasses> classes_{64};
};

}  // namespace lancret::abi
