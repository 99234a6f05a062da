#pragma once
// Statistics asserted by tests, with their error rates.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// Mean and its standard error of a stream of numbers.
struct Mean {
    double count = 0, sum = 0, squares = 0;

    void add(double x) { count += 1, sum += x, squares += x * x; }
    double value() const { return sum / count; }
    double error() const {
        const double variance = squares / count - value() * value();
        return std::sqrt(std::max(0.0, variance) / count);
    }
};

/// A normal deviate exceeds this many standard errors once in 1.5e5 trials.
inline constexpr double kSigmas = 4.5;

/// The p-value of a chi-square statistic, by Wilson and Hilferty's cube root (relative
/// error below 10 % at 1e-4 for 30 degrees of freedom and more).
inline double chi_square_chance(double statistic, double freedom) {
    const double k = 2 / (9 * freedom);
    const double z = (std::cbrt(statistic / freedom) - (1 - k)) / std::sqrt(k);
    return 0.5 * std::erfc(z / std::sqrt(2.0));
}

/// The p-value of Pearson's test of counts against expected counts. Bins with fewer than
/// five expected are merged.
inline double pearson_chance(const std::vector<double>& counts,
                             const std::vector<double>& expected) {
    double statistic = 0, joined_count = 0, joined_expected = 0;
    int bins = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (expected[i] < 5) {
            joined_count += counts[i];
            joined_expected += expected[i];
            continue;
        }
        statistic += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
        ++bins;
    }
    if (joined_expected >= 5) {
        statistic += (joined_count - joined_expected) * (joined_count - joined_expected) /
                     joined_expected;
        ++bins;
    } else if (joined_count > 30) {
        return 0;  // P(Poisson(5) > 30) is below 1e-13
    }
    return chi_square_chance(statistic, bins - 1);
}

/// Directions binned by height along x and azimuth about x: bins of equal solid angle.
class SphereBins {
  public:
    SphereBins(int heights, int azimuths)
        : heights_(heights),
          azimuths_(azimuths),
          counts(std::size_t(heights) * azimuths) {}

    void add(const Vec3f& d) {
        const double turn = std::atan2(double(d.z()), double(d.y())) / (2 * M_PI);
        const int x = int((double(d.x()) + 1) / 2 * heights_);
        const int y = int((turn < 0 ? turn + 1 : turn) * azimuths_);
        counts[std::size_t(std::clamp(x, 0, heights_ - 1)) * azimuths_ +
               std::clamp(y, 0, azimuths_ - 1)] += 1;
    }

    /// The integral of a density over each bin, by `fine` x `fine` midpoints uniform in
    /// the angle, in which densities are smooth up to the poles.
    std::vector<double> integrals(const std::function<double(const Vec3f&)>& density,
                                  int fine) const {
        std::vector<double> result(counts.size(), 0);
        const int columns = azimuths_ * fine;
        for (int bin = 0; bin < heights_; ++bin) {
            const double low = std::asin(-1 + 2.0 * bin / heights_);
            const double high = std::asin(-1 + 2.0 * (bin + 1) / heights_);
            const double step = (high - low) / fine;
            for (int i = 0; i < fine; ++i) {
                const double from = low + i * step, middle = from + step / 2;
                const double area =
                    (std::sin(from + step) - std::sin(from)) * 2 * M_PI / columns;
                for (int j = 0; j < columns; ++j) {
                    const double a = 2 * M_PI * (j + 0.5) / columns, r = std::cos(middle);
                    result[std::size_t(bin) * azimuths_ + j / fine] +=
                        area *
                        density(Vec3f(float(std::sin(middle)), float(r * std::cos(a)),
                                      float(r * std::sin(a))));
                }
            }
        }
        return result;
    }

  private:
    int heights_, azimuths_;

  public:
    std::vector<double> counts;
};

}  // namespace lancret
