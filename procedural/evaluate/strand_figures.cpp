#include "procedural/evaluate/strand_figures.h"

#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "guides/base/cancel.h"

namespace lancret {

namespace {

constexpr std::size_t kQuantiles = 199;

double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

double rms_distance(std::span<const Vec3> a, std::span<const Vec3> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
    return std::sqrt(sum / double(a.size()));
}

/// The 199 quantiles of a weighted distribution. A value is the quantile at the middle of
/// its weight, (i + 1/2) / n with equal weights; between values they are interpolated
/// linearly. All 0 if no value has weight.
std::array<double, kQuantiles> quantiles(std::vector<Weighted>& values) {
    tbb::parallel_sort(values.begin(), values.end(), [](const auto& a, const auto& b) {
        return a.value != b.value ? a.value < b.value : a.weight < b.weight;
    });
    stop_if_cancelled();
    double total = 0;
    for (const Weighted& v : values) total += v.weight;
    std::array<double, kQuantiles> out{};
    if (!(total > 0)) return out;
    const Weighted* before = nullptr;
    double place = 0, place_before = 0, sum = 0;
    std::size_t q = 0;
    for (const Weighted& v : values) {
        if (!(v.weight > 0)) continue;
        place = sum + v.weight / 2;
        for (; q < kQuantiles; ++q) {
            const double target = 0.005 * double(q + 1) * total;
            if (target > place) break;
            const double share =
                before ? (target - place_before) / (place - place_before) : 1;
            out[q] = before ? before->value + share * (v.value - before->value) : v.value;
        }
        before = &v;
        place_before = place;
        sum += v.weight;
    }
    for (; q < kQuantiles; ++q) out[q] = before->value;
    return out;
}

double mean_magnitude(const std::vector<Weighted>& values) {
    double sum = 0, total = 0;
    for (const Weighted& v : values) {
        sum += std::abs(v.value) * v.weight;
        total += v.weight;
    }
    return total > 0 ? sum / total : 0;
}

DistributionFigures compared(const StrandSamples& truth, const StrandSamples& made,
                             void (*add)(std::span<const Vec3>, std::vector<Weighted>&)) {
    std::vector<Weighted> real, other;
    const auto fill = [&](const StrandSamples& from, std::vector<Weighted>& into) {
        into.reserve(from.points.size());
        for (std::size_t i = 0; i < from.size(); ++i) add(from.strand(i), into);
    };
    tbb::parallel_invoke([&] { fill(truth, real); }, [&] { fill(made, other); });
    stop_if_cancelled();
    return compare(real, other);
}

}  // namespace

LowPass::LowPass(int steps) {
    const double sigma = kPlaceSigma * steps;
    const int radius = int(4 * sigma + 0.5);
    double total = 0;
    for (int j = -radius; j <= radius; ++j) {
        kernel_.push_back(std::exp(-0.5 * (j / sigma) * (j / sigma)));
        total += kernel_.back();
    }
    for (double& weight : kernel_) weight /= total;
}

void LowPass::operator()(std::span<const Vec3> strand, std::span<Vec3> out) const {
    const std::ptrdiff_t last = std::ptrdiff_t(strand.size()) - 1;
    const std::ptrdiff_t radius = std::ptrdiff_t(kernel_.size() / 2);
    for (std::ptrdiff_t i = 0; i <= last; ++i) {
        Vec3 sum = Vec3::Zero();
        for (std::ptrdiff_t j = -radius; j <= radius; ++j) {
            sum +=
                kernel_[j + radius] * strand[std::clamp<std::ptrdiff_t>(i + j, 0, last)];
        }
        out[i] = sum;
    }
}

void add_curvatures(std::span<const Vec3> strand, std::vector<Weighted>& out) {
    double length = 0;
    for (std::size_t i = 1; i < strand.size(); ++i) {
        length += (strand[i] - strand[i - 1]).norm();
    }
    const double step = length / double(strand.size() - 1);
    for (std::size_t i = 1; i + 1 < strand.size(); ++i) {
        const double turn =
            angle_between(strand[i] - strand[i - 1], strand[i + 1] - strand[i]);
        out.push_back({step > 0 ? turn / step : 0, 1});
    }
}

void add_torsions(std::span<const Vec3> strand, std::vector<Weighted>& out) {
    for (std::size_t i = 1; i + 2 < strand.size(); ++i) {
        const Vec3 before = strand[i] - strand[i - 1], step = strand[i + 1] - strand[i],
                   after = strand[i + 2] - strand[i + 1];
        const Vec3 plane = before.cross(step), next = step.cross(after);
        const double length = step.norm();
        // tan(angle) = length (plane x next . step / length^2) / (plane . next).
        const double sine = length > 0 ? plane.cross(next).dot(step) / length : 0;
        const double angle = std::atan2(sine, plane.dot(next));
        out.push_back({length > 0 ? angle / length : 0,
                       angle_between(before, step) * angle_between(step, after)});
    }
}

DistributionFigures compare(std::vector<Weighted>& real, std::vector<Weighted>& made) {
    const auto a = quantiles(real), b = quantiles(made);
    double distance = 0, size = 0;
    for (std::size_t q = 0; q < kQuantiles; ++q) {
        distance += std::abs(a[q] - b[q]);
        size += std::abs(a[q]);
    }
    const double real_mean = mean_magnitude(real), made_mean = mean_magnitude(made);
    DistributionFigures out;
    out.w1 = size > 0 ? distance / size : distance / double(kQuantiles);
    out.mean_ratio = real_mean > 0 ? made_mean / real_mean : 1;
    return out;
}

StrandFigures strand_figures(const StrandSamples& truth, std::span<const double> lengths,
                             const StrandSamples& made) {
    if (truth.steps < 2 || made.steps != truth.steps || truth.points.empty() ||
        made.points.size() != truth.points.size() || lengths.size() != truth.size()) {
        throw std::invalid_argument("strand_figures: the strands do not match");
    }
    const std::size_t size = truth.size();
    std::vector<double> rms(size), place(size), tip(size);
    const LowPass low_pass(truth.steps);
    using Range = tbb::blocked_range<std::size_t>;
    cancellable_for(Range(0, size, 64), [&](const Range& range) {
        std::vector<Vec3> a(truth.steps + 1), b(truth.steps + 1);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const auto real = truth.strand(i), other = made.strand(i);
            rms[i] = rms_distance(real, other) / lengths[i];
            tip[i] = (real.back() - other.back()).norm() / lengths[i];
            low_pass(real, a);
            low_pass(other, b);
            place[i] = rms_distance(a, b) / lengths[i];
        }
    });
    const auto spread = [](const std::vector<double>& values) {
        return Spread{quantile(values, 0.5), quantile(values, 0.95)};
    };
    StrandFigures out;
    out.rms = spread(rms);
    out.place = spread(place);
    out.tip = spread(tip);
    out.curvature = compared(truth, made, add_curvatures);
    out.torsion = compared(truth, made, add_torsions);
    return out;
}

}  // namespace lancret
