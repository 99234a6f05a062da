#pragma once
// All strands of a groom, written by the plugin, chunk by chunk, directly into the curves
// that are traced.

#include <functional>
#include <span>
#include <vector>

#include "procedural/curves/curves.h"
#include "procedural/curves/strand_values.h"
#include "render_test/plugin/groom.h"

namespace lancret {

/// The request for all chunks.
struct StrandRequest {
    std::vector<double> times;     ///< frame numbers, at least one
    bool faces = false;            ///< normals for all shapes; ribbons always have them
    std::vector<double> pixels;    ///< [chunks] area in the picture, for level of detail
    double strands_per_pixel = 0;  ///< maximum; 0: no level of detail
};

/// The guides of each strand and their weights.
struct StrandGuides {
    std::size_t neighbours = 0;
    std::vector<std::uint32_t> guides;  ///< [strands * neighbours]
    std::vector<float> weights;         ///< [strands * neighbours]; unused ones are 0
};

/// The strands of a groom, bound to their guides. All results list them in the same
/// order, one chunk after another. Chunks are processed in parallel.
class PluginStrands {
  public:
    /// `groom` must outlive it. Throws InputError, also if there are more than 2^32
    /// points.
    PluginStrands(const PluginGroom& groom, StrandRequest request);
    ~PluginStrands();
    PluginStrands(const PluginStrands&) = delete;
    PluginStrands& operator=(const PluginStrands&) = delete;

    std::size_t size() const { return strands_; }
    /// Summed over all chunks.
    const lancret_chunk_info& info() const { return info_; }

    /// The strands at each time; flat if the groom requests no shape. Throws InputError.
    std::vector<Curves> curves() const;
    /// A figure of lancret_chunk_get_figures at times[time]; `curves` may be of any time.
    /// Throws InputError.
    StrandValues figures(int figure, std::size_t time, const Curves& curves) const;
    StrandGuides guides() const;

  private:
    struct Chunk {
        lancret_chunk* handle = nullptr;
        std::size_t strand = 0, point = 0;  ///< index of its first
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
