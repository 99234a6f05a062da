#include "tools/lod.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "guides/errors.h"
#include "procedural/chunk_bound.h"
#include "procedural/chunks.h"
#include "procedural/density.h"

namespace lancret {

namespace {

constexpr std::size_t kSeen = 32;  ///< strands that say how large a chunk is

/// The rectangle round what a camera sees of a box, in pixels.
double pixels_of(const Eigen::AlignedBox3f& box, const Camera& camera, int height) {
    Eigen::AlignedBox2f seen;
    for (int c = 0; c < 8; ++c) {
        const auto place =
            camera.place_of(box.corner(Eigen::AlignedBox3f::CornerType(c)));
        if (!place) return std::numeric_limits<double>::infinity();
        seen.extend(*place);
    }
    const double high = height, wide = high * double(camera.aspect);
    return double(seen.sizes().x()) * wide * double(seen.sizes().y()) * high;
}

/// Spread over the chunk, whose first strands are the curliest.
std::vector<std::uint32_t> seen_of(std::span<const std::uint32_t> chunk) {
    const std::size_t count = std::min(chunk.size(), kSeen);
    std::vector<std::uint32_t> out;
    for (std::size_t i = 0; i < count; ++i)
        out.push_back(chunk[i * chunk.size() / count]);
    return out;
}

double density_of(const Generator& generator, const ClassedGuides& guides,
                  std::span<const std::uint32_t> chunk, std::span<const Camera> cameras,
                  int height, double strands_a_pixel) {
    const Binding few = picked(generator.binding, seen_of(chunk));
    const Eigen::AlignedBox3f box =
        chunk_bound(few, guides, generator.groom.expand).box();
    double pixels = 0;
    for (const Camera& camera : cameras) {
        pixels = std::max(pixels, pixels_of(box, camera, height));
    }
    const double own = generator.groom.density;
    const auto strands = std::size_t(double(chunk.size()) / own);
    return std::min(own, lod_density(pixels, strands, strands_a_pixel));
}

}  // namespace

void prune_by_size(Generator& generator, std::span<const Camera> cameras, int height,
                   double strands_a_pixel) {
    Binding& binding = generator.binding;
    const std::vector<Vec3f>& roots = binding.roots.positions;
    const Chunks chunks =
        make_chunks(roots.size(), [&](std::uint32_t i) { return roots[i]; });
    ClassedGuides guides = rest_guides(generator);
    guides.kernels.clear();  // decided once for all machines
    std::vector<float> widths(roots.size());
    tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t c) {
        const double density =
            density_of(generator, guides, chunks.of(c), cameras, height, strands_a_pixel);
        for (const std::uint32_t i : chunks.of(c)) {
            const double rank = strand_rank(generator.groom.seed, binding.roots.id(i));
            widths[i] = float(width_at(rank, density));
        }
    });
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < widths.size(); ++i) {
        if (widths[i] > 0) kept.push_back(i);
    }
    if (kept.empty()) {
        throw InputError(fmt::format("--lod: {} strands a pixel leave none of {} strands",
                                     strands_a_pixel, widths.size()));
    }
    Binding left = picked(binding, kept);
    left.report = binding.report;
    left.roots.widths.clear();
    for (const std::uint32_t i : kept) left.roots.widths.push_back(widths[i]);
    binding = std::move(left);
}

}  // namespace lancret
