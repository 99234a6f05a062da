#pragma once
// A groom that is open: what all handles on the same source share.

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

/// The guides and the scalp at one time, cut for some classes of strands.
struct GuidePose {
    std::shared_ptr<const StrandClasses> classes;
    Guides guides;
    PosedScalp scalp;
    ClassedGuides classed;
};

/// The guides as the interface gives them.
struct GuideArrays {
    std::vector<double> root_frames;  ///< [guides][3][3], row by row
    std::vector<double> fit_rms;      ///< [guides], or empty
};

/// Where the search for intervals ends that a host's own error takes.
inline constexpr int kMaxIntervalsAsked = 1024;

/// Poses that are kept even for calls of one time.
inline constexpr std::size_t kPosesKept = 16;

/// Read by any number of threads.
class OpenGroom {
  public:
    using Warn = std::function<void(const std::string& text)>;

    /// Loads, fits, places and cuts. `warn` is told, from any thread and as long as this
    /// lives, what later calls cannot keep. Throws InputError, Cancelled.
    OpenGroom(const SourcedGroom& sourced, std::uint32_t chunk_strands,
              const StageCallback& stage, Warn warn);

    const ChunkedGroom& groom() const { return groom_; }
    const ReadyGroom& ready() const { return groom_.ready; }
    const GroomTimes& times() const { return times_; }
    const GuideArrays& guide_arrays() const { return arrays_; }

    /// A time as what is there at it: held where the cache ends, 0 where nothing moves.
    double frame_at(double time) const;
    /// Of a call that asks for so many times of each chunk, one after the other.
    void expect_times(std::size_t times) const { poses_.keep_at_least(times); }
    /// The last few of these are kept, or as many as were ever expected. Throws
    /// InputError, Cancelled.
    std::shared_ptr<const GuidePose> pose(
        double frame, const std::shared_ptr<const StrandClasses>& classes) const;
    /// The numbers of intervals that keep curves of `basis` within `max_error` cm of the
    /// strands, at 0 within the groom's own tolerance. All strands are `alike` where they
    /// have faces. Throws InputError, Cancelled.
    std::shared_ptr<const StrandClasses> classes(CurveBasis basis, float max_error,
                                                 bool alike) const;
    /// Kept while this is open; of what can be made again nothing.
    std::size_t bytes() const;

  private:
    /// Frames are read when they are wanted: of a cache that is still the one that was
    /// opened. Throws InputError where it is not.
    void expect_same_cache() const;

    Warn warn_;
    FileStamp cache_;
    ChunkedGroom groom_;
    GroomTimes times_;
    GuideArrays arrays_;
    mutable SharedByKey<std::pair<double, const StrandClasses*>, GuidePose> poses_{
        kPosesKept};
    mutable SharedByKey<std::tuple<CurveBasis, float, bool>, StrandClasses> classes_{64};
};

}  // namespace lancret::abi
