#include "procedural/bind/binding.h"

#include <oneapi/tbb/blocked_range.h>

#include <array>
#include <cmath>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "procedural/bind/candidates.h"
#include "procedural/bind/guide_lookup.h"
#include "procedural/bind/weights.h"

namespace lancret {

std::size_t Binding::bytes() const {
    return roots.bytes() + guides.size() * sizeof(guides[0]) +
           weights.size() * sizeof(float) + lengths.size() * sizeof(float) +
           guide_normals.size() * sizeof(Vec3f) + faces.size() * sizeof(Vec2f);
}

namespace {

/// Binds children one after another.
class Binder {
  public:
    Binder(Binding& binding, const Guides& guides, const GuideLookup& lookup,
           const BindSettings& settings, const BindBorders& borders)
        : binding_(binding),
          guides_(guides),
          lookup_(lookup),
          settings_(settings),
          borders_(borders),
          finder_(lookup.index(), guides, binding.guide_normals, settings,
                  borders.partings) {}

    void bind_child(std::size_t i, BindReport& report) {
        const std::size_t k = std::size_t(binding_.neighbours);
        const Vec3 place = binding_.roots.positions[i].cast<double>();
        const Vec3 up = binding_.roots.normals[i].cast<double>();
        const std::uint32_t region =
            borders_.child_regions.empty() ? 0 : borders_.child_regions[i];
        const Candidates& near = finder_.find(place, up, region, k);
        report.no_guide_in_region += near.from_all_regions;

        const std::span<std::uint32_t> chosen(&binding_.guides[i * k], k);
        const std::span<float> weights(&binding_.weights[i * k], k);
        weigh(near, up, chosen, weights, report);

        double length = 0;
        bool straight = true;
        for (std::size_t j = 0; j < k; ++j) {
            length += double(weights[j]) * lookup_.length(chosen[j]);
            straight = straight && (weights[j] == 0 || lookup_.straight(chosen[j]));
        }
        binding_.lengths[i] = float(length * settings_.length_scale);
        report.straight_guides += straight;
        report.opposed_root_frames += opposed(up, chosen, weights);
    }

  private:
    void weigh(const Candidates& near, const Vec3& up, std::span<std::uint32_t> chosen,
               std::span<float> weights, BindReport& report) {
        const std::size_t k = weights.size(), n = near.within;
        for (std::size_t j = 0; j < n; ++j) {
            facing_[j] = settings_.facing
                             ? up.dot(guides_.root_frames[near.guides[j]].col(0))
                             : 1.0;
        }
        const std::span<float> all(weights_.data(), n);
        const WeightSource source =
            guide_weights({near.distances.data(), n}, {near.shares.data(), n}, near.reach,
                          {facing_.data(), n}, settings_.exponent, all);
        report.no_facing_guide += source == WeightSource::distance;
        std::ranges::fill(weights, 0.0f);
        if (source == WeightSource::none) {
            const auto visible = near.first_in_sight();
            std::ranges::fill(chosen, near.guides[visible.value_or(0)]);
            weights[0] = 1;
            ++(visible ? report.no_guide_in_reach : report.no_guide_in_sight);
            return;
        }
        keep_heaviest(all, k);
        std::size_t used = 0;
        for (std::size_t j = 0; j < n; ++j) {
            // A visible guide that does not face the child stays listed, with weight 0.
            if (!(all[j] > 0) && (n > k || near.shares[j] == 0)) continue;
            chosen[used] = near.guides[j];
            weights[used] = all[j];
            ++used;
        }
        // Unused entries repeat the first guide, with weight 0.
        std::fill(chosen.begin() + std::ptrdiff_t(used), chosen.end(), chosen[0]);
    }

    bool opposed(const Vec3& up, std::span<const std::uint32_t> chosen,
                 std::span<const float> weights) const {
        constexpr double kOpposedNormals = -0.999;
        Vec3 mean = Vec3::Zero();
        for (std::size_t j = 0; j < chosen.size(); ++j) {
            if (!(weights[j] > 0)) continue;
            const Vec3 from = binding_.guide_normals[chosen[j]].cast<double>();
            if (from.dot(up) < kOpposedNormals) return true;
            mean += double(weights[j]) * turned(from, up, tangent(chosen[j]));
        }
        return mean.squaredNorm() < kOpposedTangents * kOpposedTangents;
    }

    Vec3 tangent(std::uint32_t g) const { return guides_.root_frames[g].col(0); }

    /// `v` turned by the smallest rotation from `from` to `to`, which are not opposed. It
    /// rounds differently from smallest_rotation (guides/helix/helix.h), which builds the
    /// matrix first; the counts of the report depend on these bits.
    static Vec3 turned(const Vec3& from, const Vec3& to, const Vec3& v) {
        const Vec3 axis = from.cross(to);
        const double cosine = from.dot(to);
        return cosine * v + axis.cross(v) + axis * (axis.dot(v) / (1 + cosine));
    }

    Binding& binding_;
    const Guides& guides_;
    const GuideLookup& lookup_;
    const BindSettings& settings_;
    const BindBorders& borders_;
    CandidateFinder finder_;
    std::array<double, kMaxCandidates> facing_;
    std::array<float, kMaxCandidates> weights_;
};

void validate(const Roots& roots, const Guides& guides, const BindSettings& settings,
              const BindBorders& borders) {
    require(guides.size() > 0, "bind: no guides");
    require(settings.neighbours >= 1 && settings.neighbours <= kMaxNeighbours,
            "bind: neighbours out of range");
    require(settings.max_distance > 0 && settings.max_angle > 0,
            "bind: expected a maximum distance and angle above 0");
    const bool no_regions =
        borders.guide_regions.empty() && borders.child_regions.empty();
    require(no_regions || (borders.guide_regions.size() == guides.size() &&
                           borders.child_regions.size() == roots.size()),
            "bind: expected one region per guide and per child, or none");
}

}  // namespace

Binding bind(Roots roots, const Guides& guides, std::vector<Vec3f> guide_normals,
             const BindSettings& settings, const BindBorders& borders) {
    validate(roots, guides, settings, borders);
    const GuideLookup lookup(guides, borders.guide_regions);
    return bind(std::move(roots), guides, lookup, std::move(guide_normals), settings,
                borders);
}

Binding bind(Roots roots, const Guides& guides, const GuideLookup& lookup,
             std::vector<Vec3f> guide_normals, const BindSettings& settings,
             const BindBorders& borders) {
    validate(roots, guides, settings, borders);
    Binding out;
    const std::size_t k = std::min<std::size_t>(settings.neighbours, guides.size());
    const std::size_t children = roots.size();
    out.neighbours = int(k);
    out.roots = std::move(roots);
    out.guide_normals = std::move(guide_normals);
    out.guides.resize(children * k);
    out.weights.resize(children * k);
    out.lengths.resize(children);

    out.report = cancellable_reduce(
        tbb::blocked_range<std::size_t>(0, children, 1024), BindReport(),
        [&](const tbb::blocked_range<std::size_t>& range, BindReport report) {
            Binder binder(out, guides, lookup, settings, borders);
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                binder.bind_child(i, report);
            }
            return report;
        },
        [](BindReport a, const BindReport& b) { return a += b; });
    return out;
}

Binding picked(const Binding& binding, std::span<const std::uint32_t> which) {
    Binding out;
    const std::size_t k = std::size_t(binding.neighbours);
    out.neighbours = binding.neighbours;
    out.roots = picked(binding.roots, which);
    out.guide_normals = binding.guide_normals;
    out.guides.reserve(which.size() * k);
    out.weights.reserve(which.size() * k);
    out.lengths.reserve(which.size());
    for (const std::size_t i : which) {
        const auto from = std::ptrdiff_t(i * k), to = std::ptrdiff_t((i + 1) * k);
        out.guides.insert(out.guides.end(), binding.guides.begin() + from,
                          binding.guides.begin() + to);
        out.weights.insert(out.weights.end(), binding.weights.begin() + from,
                           binding.weights.begin() + to);
        out.lengths.push_back(binding.lengths[i]);
        if (!binding.faces.empty()) out.faces.push_back(binding.faces[i]);
    }
    return out;
}

}  // namespace lancret
