#pragma once
// A groom that is open: what all handles on the same source share.

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "procedural/abi/shared_by_key.h"
#include "procedural/chunked_groom.h"

namespace lancret::abi {

/// A chunked groom's guides at one time, cut for one number of intervals.
struct GuidePose {
    GuideProfiles<float> profiles;
    KernelGuides kernel;
};

/// The guides as the interface gives them.
struct GuideArrays {
    std::vector<double> root_frames;  ///< [guides][3][3], row by row
    std::vector<double> fit_rms;      ///< [guides], or empty
};

/// Read by any number of threads.
struct Prepared {
    explicit Prepared(ChunkedGroom groom);

    ChunkedGroom groom;
    GuideArrays guides;
    mutable SharedByKey<int, GuidePose> poses{4};

    const Generator& generator() const { return groom.generator; }
    /// Kept while this is open; of what can be made again nothing.
    std::size_t bytes() const;
};

}  // namespace lancret::abi
