#pragma once
// All strands of a groom, chunk by chunk from a plugin straight into the curves that rays
// meet.

#include <functional>
#include <span>
#include <vector>

#include "procedural/curves/curves.h"
#include "procedural/curves/strand_values.h"
#include "render_test/plugin/groom.h"

namespace lancret {

/// What is asked of all chunks.
struct StrandRequest {
    std::vector<double> times;  ///< frames, at least one
    bool faces = false;  ///< normals of strands that are no ribbons, which have them
    std::vector<double> pixels;    ///< [chunks] that each covers, for:
    double strands_per_pixel = 0;  ///< at most so many; 0: no level of detail
};

/// Which guides strands follow, and how much.
struct StrandGuides {
    std::size_t neighbours = 0;
    std::vector<std::uint32_t> guides;  ///< [strands * neighbours]
    std::vector<float> weights;         ///< the same; unused ones are 0
};

/// A groom's strands, bound. The same order in all that it gives: chunk after chunk.
/// Threads work on several chunks at once.
class PluginStrands {
  public:
    /// `groom` must outlive it. Throws InputError, also where there are more points than
    /// 32 bits can count.
    PluginStrands(const PluginGroom& groom, StrandRequest request);
    ~PluginStrands();
    PluginStrands(const PluginStrands&) = delete;
    PluginStrands& operator=(const PluginStrands&) = delete;

    std::size_t size() const { return strands_; }
    /// What binding had to work around, of all chunks.
    const lancret_chunk_info& info() const { return info_; }

    /// The strands at each time, flat where the groom does not say. Throws InputError.
    std::vector<Curves> curves() const;
    /// One of lancret_chunk_get_figures at one of the times; `curves` are any time's.
    /// Throws InputError.
    StrandValues figures(int figure, std::size_t time, const Curves& curves) const;
    StrandGuides guides() const;

  private:
    struct Chunk {
        lancret_chunk* handle = nullptr;
        std::size_t strand = 0, point = 0;  ///< the first
        lancret_curves sizes{};
    };

    lancret_options options_of(std::size_t chunk) const;
    void each_chunk(const std::function<void(const Chunk&)>& work) const;
    void close();

    const PluginGroom& groom_;
    StrandRequest request_;
    std::vector<Chunk> chunks_;
    std::size_t strands_ = 0, points_ = 0;
    lancret_chunk_info info_{};
};

}  // namespace lancret
