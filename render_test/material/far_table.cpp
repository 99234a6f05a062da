#include "render_test/material/far_table.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "render_test/sampling/sampling.h"

namespace lancret {
namespace {

using Eigen::Array4f, Eigen::ArrayXf;

constexpr int kRowCount = kFarRows + 1, kDepthCount = kFarDepths + 1;

/// Offsets h = sin(gamma), with gamma at the middles of uniform steps. From one to the
/// next R and TT turn by at most two steps and TRT by six, so steps of a quarter of the
/// lobes' scale s keep a sum of lobes smooth.
constexpr int kMinOffsets = 64, kMaxOffsets = 1024;

/// One offset h > 0 at one inclination.
struct Offset {
    float weight;                  ///< weights sum to one
    float reflected;               ///< Fresnel's f
    float c;                       ///< cosine of gamma_t
    std::array<float, 3> azimuth;  ///< Phi of R, TT, TRT
};

std::vector<Offset> offsets_at(const HairModel& model, float cosine_o) {
    const int count =
        std::clamp(int(std::ceil(2 * kPif / model.s)), kMinOffsets, kMaxOffsets);
    const float index = std::sqrt(model.eta * model.eta - 1 + cosine_o * cosine_o);
    std::vector<Offset> offsets;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const float gamma = 0.5f * kPif * (float(i) + 0.5f) / float(count);
        const float sine_t = std::sin(gamma) * cosine_o / index;
        const float gamma_t = std::asin(sine_t);
        Offset o{std::cos(gamma),
                 fresnel_dielectric(cosine_o * std::cos(gamma), model.eta),
                 std::sqrt(1 - sine_t * sine_t),
                 {}};
        for (int p = 0; p < 3; ++p) {
            o.azimuth[p] = -2 * gamma + float(p) * (2 * gamma_t + kPif);
        }
        sum += o.weight;
        offsets.push_back(o);
    }
    for (Offset& o : offsets) o.weight /= float(sum);
    return offsets;
}

/// D's distribution function, of angles within [-pi, pi] [Chiang et al. 2016, Eq. 8].
ArrayXf logistic_distribution(const HairModel& model, const ArrayXf& x) {
    const ArrayXf e = (-x.abs() / model.s).exp();
    const ArrayXf upper = 1 / (1 + e);
    return ((x < 0).select(1 - upper, upper) - model.s_tail) / (1 - 2 * model.s_tail);
}

/// Distributes D about `azimuth` over the nodes of phi from 0 to pi: calls add(node,
/// mass) with masses that sum to one. D and its mirror image count half each.
template <class Add>
void spread_over(const HairModel& model, int cells, float azimuth, const Add& add) {
    constexpr float kReach = 20;  // in s: exp(-20) = 2e-9 of D lies beyond
    const float step = kPif / float(cells);
    const int around = 2 * cells;
    const float first = azimuth - std::min(kPif, kReach * model.s);
    // The first boundary between nodes at or after `first`.
    const auto boundary = std::ptrdiff_t(std::ceil(first / step - 0.5f));
    const int count =
        std::min(around, 1 + int(std::ceil(2 * std::min(kPif, kReach * model.s) / step)));
    const ArrayXf angles =
        ((ArrayXf::LinSpaced(count, 0, float(count - 1)) + (float(boundary) + 0.5f)) *
             step -
         azimuth)
            .max(-kPif)
            .min(kPif);
    const ArrayXf below = logistic_distribution(model, angles);
    for (int i = 0; i < count; ++i) {
        // The last mass is that from the last boundary around to the first.
        const float mass =
            i + 1 < count ? below[i + 1] - below[i] : 1 - below[count - 1] + below[0];
        const auto node = int(((boundary + i + 1) % around + around) % around);
        add(std::min(node, around - node), mass);
    }
}

/// The values at `c` of the four cubics that are one at one node and zero at the others.
Array4f lagrange(const Array4f& nodes, float c) {
    Array4f out = Array4f::Ones();
    for (int k = 0; k < 4; ++k) {
        for (int j = 0; j < 4; ++j) {
            if (j != k) out[k] *= (c - nodes[j]) / (nodes[k] - nodes[j]);
        }
    }
    return out;
}

/// The integral over the whole circle by the trapezium rule, which is exact for functions
/// that are linear between nodes.
FarTable::Energy integral(const FarTable::Node* nodes, int cells) {
    FarTable::Energy sum;
    for (int j = 0; j <= cells; ++j) {
        const float width = (j == 0 || j == cells ? 1.0f : 2.0f) * kPif / float(cells);
        sum.r += width * nodes[j].r;
        sum.tt += width * nodes[j].tt;
        sum.trt += width * nodes[j].trt;
    }
    return sum;
}

void fill_row(const HairModel& model, int row, FarTable& table) {
    const int cells = table.cells;
    FarTable::Node* nodes = &table.nodes[std::size_t(row) * (cells + 1)];
    Eigen::Map<ArrayXf> residual(&table.residual[std::size_t(row) * kDepthCount],
                                 kDepthCount);
    const ArrayXf log_depth =
        (ArrayXf::LinSpaced(kFarDepths, 1, kFarDepths) / kFarDepths).log();
    for (const Offset& o : offsets_at(model, float(row) / kFarRows)) {
        const float enters = 1 - o.reflected;
        const Array4f through =
            o.weight * enters * enters * lagrange(table.c, o.c) * float(cells) / kPif;
        const float surface = o.weight * o.reflected * float(cells) / kPif;
        // An inner node has half of its mass at each sign of phi.
        const auto share = [&](int j) { return j == 0 || j == cells ? 1.0f : 0.5f; };
        spread_over(model, cells, o.azimuth[0],
                    [&](int j, float mass) { nodes[j].r += mass * share(j) * surface; });
        spread_over(model, cells, o.azimuth[1],
                    [&](int j, float mass) { nodes[j].tt += mass * share(j) * through; });
        spread_over(model, cells, o.azimuth[2], [&](int j, float mass) {
            nodes[j].trt += mass * share(j) * o.reflected * through;
        });
        if (!(enters > 0)) continue;
        // The geometric sum of all longer paths.
        const float more = o.weight * enters * enters * o.reflected * o.reflected;
        const ArrayXf t = (o.c * log_depth).exp();
        residual.tail(kFarDepths) += more * t.cube() / (1 - o.reflected * t);
    }
    table.energy[row] = integral(nodes, cells);
}

std::array<float, 3> unabsorbed(const FarTable::Node& node) {
    return {node.r, node.tt.sum(), node.trt.sum()};
}

void fill_distribution(int row, FarTable& table) {
    const int cells = table.cells;
    const FarTable::Node* nodes = &table.nodes[std::size_t(row) * (cells + 1)];
    for (int lobe = 0; lobe < 3; ++lobe) {
        float* below =
            &table.distribution[(std::size_t(lobe) * kRowCount + row) * (cells + 1)];
        double sum = 0;
        for (int j = 1; j <= cells; ++j) {
            sum += unabsorbed(nodes[j - 1])[lobe] + unabsorbed(nodes[j])[lobe];
            below[j] = float(sum);
        }
        for (int j = 1; j <= cells; ++j) below[j] = sum > 0 ? below[j] / float(sum) : 1;
    }
}

}  // namespace

FarTable::FarTable(const HairModel& model)
    // Cells of a fifth of D's scale, within limits.
    : cells(std::clamp(int(std::ceil(kPif / (0.2f * model.s))), 64, 512)),
      min_c(std::sqrt(1 - 1 / (model.eta * model.eta))),
      nodes(std::size_t(kRowCount) * (cells + 1)),
      energy(kRowCount),
      residual(std::size_t(kRowCount) * kDepthCount),
      distribution(3 * std::size_t(kRowCount) * (cells + 1)) {
    for (int k = 0; k < 4; ++k) {
        c[k] = 0.5f * (1 + min_c) +
               0.5f * (1 - min_c) * std::cos((float(k) + 0.5f) * kPif / 4);
    }
    tbb::parallel_for(0, kRowCount, [&](int row) {
        fill_row(model, row, *this);
        fill_distribution(row, *this);
    });
}

std::size_t FarTable::bytes() const {
    return nodes.size() * sizeof(Node) + energy.size() * sizeof(Energy) +
           (residual.size() + distribution.size()) * sizeof(float);
}

}  // namespace lancret
