#include "guides/fit/super_helix_fit.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <numeric>
#include <random>

#include "guides/files/hair_file.h"
#include "guides/helix/super_helix.h"

namespace lancret {
namespace {

/// A Super-Helix of equal segments, sampled as a fit requires.
struct Known {
    std::vector<double> lengths;
    std::vector<Vec3> curvatures;
    HelixState<double> root;

    SampledCurve sampled(int samples) const {
        SampledCurve out;
        out.length = std::accumulate(lengths.begin(), lengths.end(), 0.0);
        std::vector<double> s(samples + 1);
        for (int i = 0; i <= samples; ++i) s[i] = out.length * i / samples;
        sample({root, lengths, curvatures}, s,
               [&](std::size_t, std::size_t, const HelixState<double>& state) {
                   out.positions.push_back(state.position);
                   out.tangents.push_back(state.frame.col(0));
               });
        out.parameters = s;
        return out;
    }
};

Known random_known(int segments, double twist, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, 0.2);
    Known out;
    for (int q = 0; q < segments; ++q) {
        out.lengths.push_back(1.5);
        const double k0 = normal(random), k1 = normal(random), k2 = normal(random);
        out.curvatures.emplace_back(twist * k0, k1, k2);
    }
    out.root.position = Vec3(1, 2, 3);
    return out;
}

/// The RMS distance of a fit from the samples, relative to the length, computed from its
/// positions.
double rms_of(const FittedGuide& fit, const SampledCurve& target) {
    const std::size_t n = fit.curvatures.size(), samples = target.positions.size() - 1;
    const std::vector<double> lengths(n, target.length / double(n));
    double sum = 0;
    for (std::size_t i = 1; i <= samples; ++i) {
        const auto state =
            state_at({{fit.root_frame, target.positions[0]}, lengths, fit.curvatures},
                     target.length * double(i) / double(samples));
        sum += (state.position - target.positions[i]).squaredNorm();
    }
    return std::sqrt(sum / double(samples)) / target.length;
}

FittedGuide fit(const SampledCurve& target, const FitSettings& settings) {
    return fit_super_helix(target, Vec3::UnitX(), settings);
}

SampledCurve samples_of(const std::function<Vec3(double)>& curve, int points,
                        int samples) {
    std::vector<Vec3> p;
    for (int i = 0; i < points; ++i) p.push_back(curve(double(i) / (points - 1)));
    return resample(*curve_through(p), samples);
}

TEST(SuperHelixFit, RecoversAKnownStrandOfArcs) {
    const FitSettings settings;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const SampledCurve target =
            random_known(8, 0, seed).sampled(fit_samples(settings));
        // Without twist no cost keeps the fit from the strand itself.
        EXPECT_LT(rms_of(fit(target, settings), target), 1e-6) << seed;
    }
}

TEST(SuperHelixFit, ApproachesATwistedStrandUpToTheCostOfTwist) {
    const FitSettings settings;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Known known = random_known(8, 1, seed);
        const SampledCurve target = known.sampled(fit_samples(settings));
        // The strand itself costs 1e-7 of its squared twist, so a fit that costs less is
        // at most the root of that away.
        double twist = 0;
        for (const Vec3& u : known.curvatures) twist += std::pow(1.5 * u.x(), 2);
        EXPECT_LT(rms_of(fit(target, settings), target), std::sqrt(1e-7 * twist) + 1e-6)
            << seed;
    }
}

TEST(SuperHelixFit, ReportsTheDistanceItReached) {
    const FitSettings settings{.segments = 3};
    const SampledCurve target = samples_of(
        [](double t) { return Vec3(10 * t, std::sin(6 * t), std::cos(5 * t)); }, 60,
        fit_samples(settings));
    const FittedGuide fitted = fit(target, settings);
    EXPECT_NEAR(fitted.report.rms / target.length, rms_of(fitted, target), 1e-12);
    EXPECT_EQ(fitted.report.length, target.length);
    EXPECT_GE(fitted.report.max, fitted.report.rms);
    // The largest of n is at most sqrt(n) times their RMS.
    EXPECT_LE(fitted.report.max,
              fitted.report.rms * std::sqrt(fit_samples(settings)) * (1 + 1e-9));
    EXPECT_GT(fitted.report.iterations, 0);
    EXPECT_LT(
        (fitted.root_frame.transpose() * fitted.root_frame - Mat3::Identity()).norm(),
        1e-12);
}

TEST(SuperHelixFit, ConvergesWithSegmentsOnASmoothCurve) {
    double before = 1;
    for (const int segments : {2, 4, 8, 16}) {
        const FitSettings settings{.segments = segments,
                                   .samples_per_segment = 64 / segments};
        const SampledCurve target = samples_of(
            [](double t) {
                return Vec3(12 * t, 2 * std::sin(5 * t), 1.5 * std::sin(4 * t + 1));
            },
            200, fit_samples(settings));
        const double rms = rms_of(fit(target, settings), target);
        // The error of piecewise constant curvature is of the order of the segments'
        // length, that of tangents and places of its square: a quarter for half the
        // length, once segments are short enough; half is required.
        EXPECT_LT(rms, 0.5 * before) << segments;
        before = rms;
    }
    EXPECT_LT(before, 1e-3);
}

TEST(SuperHelixFit, AStraightStrandIsStraight) {
    const FitSettings settings;
    const Vec3 direction = Vec3(1, -2, 0.5).normalized();
    const SampledCurve target = samples_of(
        [&](double t) { return Vec3(7 * t * direction); }, 10, fit_samples(settings));
    for (const Vec3& hint : {Vec3(Vec3::UnitX()), direction}) {
        const FittedGuide fitted = fit_super_helix(target, hint, settings);
        EXPECT_LT(rms_of(fitted, target), 1e-7);
        // The spline's tangents are accurate to about 1e-12, and the angle between two
        // nearly equal ones to the root of round-off.
        EXPECT_LT((fitted.root_frame.col(0) - direction).norm(), 1e-7);
        for (const Vec3& u : fitted.curvatures) EXPECT_LT(u.norm(), 1e-6);
    }
}

TEST(SuperHelixFit, FollowsACurl) {
    // Five turns of radius 0.5 cm in 16 segments: two radians each, a helix throughout.
    const FitSettings settings{.segments = 16};
    const SampledCurve target = samples_of(
        [](double t) {
            const double a = 10 * kPi * t;
            return Vec3(0.5 * std::cos(a), 0.5 * std::sin(a), -10 * t);
        },
        400, fit_samples(settings));
    EXPECT_LT(rms_of(fit(target, settings), target), 0.005);
}

TEST(SuperHelixFit, RootFrameStartsFromTheTangentAndTheSurface) {
    const FitSettings settings{.fit_root_frame = false};
    const Known known = random_known(8, 0, 3);
    const SampledCurve target = known.sampled(fit_samples(settings));
    const Vec3 hint(0.3, 0.8, -0.2);
    const FittedGuide fitted = fit_super_helix(target, hint, settings);
    const Vec3 tangent = target.tangents[0];
    EXPECT_LT((fitted.root_frame.col(0) - tangent).norm(), 1e-12);
    const Vec3 across = (hint - tangent * tangent.dot(hint)).normalized();
    EXPECT_LT((fitted.root_frame.col(1) - across).norm(), 1e-12);
    EXPECT_NEAR(fitted.root_frame.determinant(), 1, 1e-12);
}

TEST(FitGuides, LeavesOutStrandsWithoutALengthAndFitsTwoPoints) {
    Strands strands;
    const auto add = [&](std::initializer_list<Vec3f> points) {
        strands.points.insert(strands.points.end(), points);
        strands.first.push_back(std::uint32_t(strands.points.size()));
    };
    add({{0, 0, 0}, {0, 0, 4}});
    add({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
    add({{0, 1, 0}, {0, 1, 1}, {0.5, 1, 2}, {1.5, 1, 2.5}});
    const std::uint32_t which[] = {2, 1, 0};
    const FittedGuides fitted = fit_guides(strands, which, {}, {.segments = 5});
    EXPECT_EQ(fitted.left_out, 1u);
    EXPECT_EQ(fitted.strands, (std::vector<std::uint32_t>{2, 0}));
    EXPECT_EQ(fitted.guides.segments, 5);
    ASSERT_EQ(fitted.guides.size(), 2u);
    ASSERT_EQ(fitted.guides.curvatures.size(), 10u);
    EXPECT_EQ(fitted.reports.size(), 2u);
    // The strand of two points.
    EXPECT_EQ(fitted.guides.root_positions[1], Vec3::Zero());
    EXPECT_NEAR(guide_length(fitted.guides, 1), 4, 1e-9);
    EXPECT_LT(
        (state_at(super_helix(fitted.guides, 1), 4).position - Vec3(0, 0, 4)).norm(),
        1e-6);
}

TEST(FitGuides, AreTheSameForAnyNumberOfThreads) {
    Strands strands;
    std::mt19937 random(5);
    std::normal_distribution<float> normal(0, 0.4f);
    for (int i = 0; i < 24; ++i) {
        for (int j = 0; j < 12; ++j) {
            const float x = normal(random), y = normal(random);
            strands.points.emplace_back(x, y, float(j));
        }
        strands.first.push_back(std::uint32_t(strands.points.size()));
    }
    std::vector<std::uint32_t> which(24);
    std::iota(which.begin(), which.end(), 0u);
    const auto fitted = [&](int threads) {
        tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    threads);
        return fit_guides(strands, which, {}, {});
    };
    const FittedGuides one = fitted(1), three = fitted(3);
    EXPECT_EQ(one.guides.curvatures, three.guides.curvatures);
    EXPECT_EQ(one.guides.root_frames, three.guides.root_frames);
}

TEST(FitGuides, FollowARealGroomToOnePercent) {
    const std::filesystem::path file = LANCRET_SOURCE_DIR "/../shared/data/sintel.hair";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file;
    const Strands strands = read_hair(file);
    std::vector<std::uint32_t> which;
    for (std::uint32_t i = 0; i < strands.size(); i += 57) which.push_back(i);
    const FittedGuides fitted = fit_guides(strands, which, {}, {});
    std::vector<double> rms;
    for (const FitReport& report : fitted.reports) {
        rms.push_back(report.rms / report.length);
    }
    ASSERT_EQ(rms.size(), which.size());
    std::ranges::nth_element(rms, rms.begin() + rms.size() / 2);
    EXPECT_LT(rms[rms.size() / 2], 0.01);
}

}  // namespace
}  // namespace lancret
