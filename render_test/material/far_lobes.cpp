#include "render_test/material/far_lobes.h"

#include <algorithm>
#include <cmath>

#include "render_test/material/longitudinal.h"
#include "render_test/sampling/sampling.h"

namespace lancret {
namespace {

using Eigen::Array4f;

FarTable::Node between(const FarTable::Node& a, const FarTable::Node& b, float share) {
    FarTable::Node out;
    out.tt = a.tt + share * (b.tt - a.tt);
    out.trt = a.trt + share * (b.trt - a.trt);
    out.r = a.r + share * (b.r - a.r);
    return out;
}

/// The position of a value in [0, 1] among `spans` spans.
struct Place {
    int span;
    float share;  ///< 0..1
};
Place place_of(float x, int spans) {
    const float scaled = x * float(spans);
    const int span = std::clamp(int(scaled), 0, spans - 1);
    return {span, std::clamp(scaled - float(span), 0.0f, 1.0f)};
}

/// Weights after absorption. Interpolated weights may undershoot where nearly all is
/// absorbed.
float absorbed(const Array4f& weights, const Array4f& kept) {
    return std::max(0.0f, (weights * kept).sum());
}

}  // namespace

FarHairBsdf::FarHairBsdf(const HairModel& model, const FarTable& table,
                         const Vec3f& sigma_a, const Vec3f& wo)
    : model_(&model), table_(&table) {
    const float sine_o = std::clamp(wo.x(), -1.0f, 1.0f);
    const float cosine_o = std::sqrt(1 - sine_o * sine_o);
    wo_ = turned_inclination(model, sine_o, cosine_o);
    const Place row = place_of(cosine_o, kFarRows);
    row_ = row.span, share_ = row.share;

    const float sine_t = sine_o / model.eta;
    const float crossing = 2 / std::sqrt(1 - sine_t * sine_t);  // radii, at h = 0
    const FarTable::Energy energy =
        between(table.energy[row_], table.energy[row_ + 1], share_);
    const float* residual = &table.residual[std::size_t(row_) * (kFarDepths + 1)];
    energy_[0].setConstant(energy.r);
    for (int channel = 0; channel < 3; ++channel) {
        const float a = crossing * sigma_a[channel];
        once_[channel] = (-a * table.c).exp();
        twice_[channel] = once_[channel].square();
        energy_[1][channel] = absorbed(energy.tt, once_[channel]);
        energy_[2][channel] = absorbed(energy.trt, twice_[channel]);
        const Place depth = place_of(std::exp(-a), kFarDepths);
        const auto residual_at = [&](int i) {
            const float here = residual[i], next = residual[i + kFarDepths + 1];
            return here + share_ * (next - here);
        };
        energy_[3][channel] =
            residual_at(depth.span) +
            depth.share * (residual_at(depth.span + 1) - residual_at(depth.span));
    }
    for (int p = 0; p < kHairLobes; ++p) probability_[p] = luminance(energy_[p]);
    probability_ /= probability_.sum();
    const Array4f unabsorbed(energy.r, energy.tt.sum(), energy.trt.sum(), 2 * kPif);
    density_ = (unabsorbed > 0).select(probability_ / unabsorbed, 0.0f);
}

FarTable::Node FarHairBsdf::node(float phi) const {
    const Place cell = place_of(phi / kPif, table_->cells);
    const std::size_t first = std::size_t(row_) * (table_->cells + 1) + cell.span;
    const FarTable::Node* here = &table_->nodes[first];
    const FarTable::Node* next = here + table_->cells + 1;
    return between(between(here[0], here[1], cell.share),
                   between(next[0], next[1], cell.share), share_);
}

BsdfValue FarHairBsdf::evaluate(const Vec3f& wi) const {
    return evaluate(std::clamp(wi.x(), -1.0f, 1.0f), length_across(wi),
                    std::atan2(std::abs(wi.y()), wi.z()));
}

BsdfValue FarHairBsdf::evaluate(float sine_i, float cosine_i, float phi) const {
    const FarTable::Node n = node(phi);
    const Array4f m = longitudinal(*model_, wo_, sine_i, cosine_i);
    BsdfValue out;
    out.value = energy_[3] * (m[3] / (2 * kPif));
    for (int channel = 0; channel < 3; ++channel) {
        out.value[channel] += m[0] * n.r + m[1] * absorbed(n.tt, once_[channel]) +
                              m[2] * absorbed(n.trt, twice_[channel]);
    }
    out.pdf = (m * density_ * Array4f(n.r, n.tt.sum(), n.trt.sum(), 1).max(0)).sum();
    return out;
}

/// Samples |phi| of a lobe: first one of the two rows that are mixed linearly, by its
/// share of samples, then an angle of that row.
float FarHairBsdf::sampled_azimuth(int lobe, float pick, float random) const {
    const std::size_t nodes = std::size_t(table_->cells) + 1;
    const auto density = [&](const FarTable::Node& node) {
        return lobe == 0 ? node.r : lobe == 1 ? node.tt.sum() : node.trt.sum();
    };
    const float here = (1 - share_) * density(table_->energy[row_]),
                next = share_ * density(table_->energy[row_ + 1]);
    const int row = pick * (here + next) < here ? row_ : row_ + 1;
    const float* below =
        &table_->distribution[(std::size_t(lobe) * (kFarRows + 1) + row) * nodes];
    const auto cell = std::ptrdiff_t(
        std::upper_bound(below + 1, below + nodes - 1, random) - below - 1);
    // Within a cell the density is linear.
    const FarTable::Node* ends = &table_->nodes[row * nodes + cell];
    const float a = std::max(0.0f, density(ends[0])),
                b = std::max(0.0f, density(ends[1]));
    const float width = below[cell + 1] - below[cell];
    const float v =
        width > 0 ? std::clamp((random - below[cell]) / width, 0.0f, 1.0f) : 0;
    const float root = a + std::sqrt((1 - v) * a * a + v * b * b);
    const float share = root > 0 ? std::min(1.0f, v * (a + b) / root) : v;
    return kPif * (float(cell) + share) / float(table_->cells);
}

std::optional<BsdfSample> FarHairBsdf::sample(float pick, float azimuth,
                                              const Vec2f& longitude) const {
    int p = 0;
    while (p + 1 < kHairLobes && pick >= probability_[p]) pick -= probability_[p++];
    const float sine_i = sampled_sine(*model_, wo_, p, longitude);
    const float cosine_i = std::sqrt(std::max(0.0f, 1 - sine_i * sine_i));
    // The random number of the azimuth also chooses its sign, the rest of `pick` the row.
    const bool left = azimuth < 0.5f;
    const float random = left ? 2 * azimuth : 2 * azimuth - 1;
    const float phi =
        p + 1 < kHairLobes
            ? sampled_azimuth(p, std::min(pick / probability_[p], 1.0f), random)
            : kPif * random;
    const float across = left ? -std::sin(phi) : std::sin(phi);
    BsdfSample sample;
    sample.direction = {sine_i, cosine_i * across, cosine_i * std::cos(phi)};
    sample.at = evaluate(sine_i, cosine_i, phi);
    if (!(sample.at.pdf > 0)) return std::nullopt;
    return sample;
}

}  // namespace lancret
