// Blends that go along curvatures, a strand in each lane.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/curl_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "procedural/bind/child.h"
#include "procedural/blend/option1_constants.h"
#include "procedural/kernels/curl_kernel.h"
#include "procedural/kernels/strand_batch.h"
// after what they use, each after the other
#include "procedural/kernels/copy_points.inl"
//
#include "procedural/kernels/lane_math.inl"
//
#include "procedural/kernels/curl_lanes.inl"
//
#include "procedural/kernels/transpose_rows.inl"
//
#include "procedural/kernels/option1_lanes.inl"
//
#include "procedural/kernels/fill_batch.inl"

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

/// Children [first, first + used), in frames and places.
void synthesize(const KernelInput& in, std::size_t first, std::size_t used,
                StrandBatch& batch) {
    const BlendTraits& traits = traits_of(in.blend);
    const bool with_anchor = traits.anchored;
    const bool own_rates = traits.rates == BlendRates::blended;
    fill_batch(in, first, used, with_anchor, own_rates, batch);
    store4(lanes_start(batch, own_rates), batch.frames.get());
    LanesSpine own = walk(in, with_anchor, batch);
    if (with_anchor) {
        const LanesGoal goal = lanes_goal(batch);
        for (int j = 2; j < kSpineTerms; ++j) {
            own.terms[j] = times(goal.taper[j], own.terms[j]);
        }
        anchor_frames(in, own, goal.spine, batch);
    }
    put_places(batch);
}

/// B-spline control points of every lane to `points`: bspline_points.
void spline_points(const KernelInput& in, StrandBatch& batch) {
    const D d;
    const std::size_t n = batch.intervals, row = 3 * hn::Lanes(d);
    const Lanes3 root = load3(batch.root);
    const V width = hn::Load(d, batch.width);
    const auto place = [&](std::size_t i) {
        return load3(&batch.places[(i + 2) * row], hn::Lanes(d));
    };
    const auto smoothed = [&](std::size_t i) {
        const Lanes3 p = place(i);
        const Lanes3 inner = (place(i - 1) - p) + (place(i + 1) - p);
        const Lanes3 outer = (place(i - 2) - p) + (place(i + 2) - p);
        return times_plus(set(1 / 36.0f), times_plus(set(-10), inner, outer), p);
    };
    const auto put = [&](std::size_t j, const Lanes3& p) {
        const Lanes3 at = root + p;
        const V radius =
            hn::Mul(width, set(radius_of(in.taper, std::ptrdiff_t(j) - 1, n)));
        hn::StoreInterleaved4(at.x, at.y, at.z, radius, d,
                              &batch.points[j * 4 * hn::Lanes(d)]);
    };
    // The curve is at (c[-1] + 4 c[0] + c[1]) / 6 where it begins, and so where it ends.
    const auto outermost = [&](std::size_t end, const Lanes3& at_end,
                               const Lanes3& next) {
        return times_plus(set(6), place(end),
                          times_plus(set(-4), at_end, times(set(-1), next)));
    };
    Lanes3 before = smoothed(0), now = smoothed(1);
    put(0, outermost(0, before, now));
    put(1, before);
    put(2, now);
    for (std::size_t i = 2; i <= n; ++i) {
        before = now;
        now = smoothed(i);
        put(i + 1, now);
    }
    put(n + 2, outermost(n, now, before));
}

/// Places, or tangents times ds, of every lane to `points`: hermite_points.
void hermite_row(const KernelInput& in, bool tangents, StrandBatch& batch) {
    const D d;
    const std::size_t n = batch.intervals, lanes = hn::Lanes(d);
    const Lanes3 root = load3(batch.root);
    const V ds = hn::Mul(hn::Load(d, batch.length), set(1 / float(n)));
    const V width = hn::Load(d, batch.width);
    const float slope = (in.taper.tip - in.taper.root) / float(n);
    for (std::size_t i = 0; i <= n; ++i) {
        const Lanes3 p = tangents
                             ? times(ds, first_axis(load4(&batch.frames[i * 4 * lanes])))
                             : root + load3(&batch.places[(i + 2) * 3 * lanes], lanes);
        const V w = hn::Mul(
            width, set(tangents ? slope : radius_of(in.taper, std::ptrdiff_t(i), n)));
        hn::StoreInterleaved4(p.x, p.y, p.z, w, d, &batch.points[i * 4 * lanes]);
    }
}

/// What was written to `points`, strand by strand to where it goes.
void copy_strands(const StrandBatch& batch, std::size_t used, std::size_t count,
                  Point4f* to, bool past_caches) {
    const std::size_t lanes = hn::Lanes(D());
    for (std::size_t lane = 0; lane < used; ++lane, to += count) {
        copy_points(&batch.points[4 * lane], 4 * lanes, count, to, past_caches);
    }
}

void expand_alone(const KernelInput& in, std::size_t i, Point4f* points,
                  Point4f* tangents) {
    const std::size_t n = in.guides.count;
    std::vector<HelixState<float>> states(n + 1);
    synthesize_child<float>(in.binding, in.profiles, in.blend, i, states);
    const float ds = in.binding.lengths[i] / float(n);
    const Vec3f& root = in.binding.roots.positions[i];
    const Taper taper = in.taper.times(in.binding.roots.width(i));
    if (in.basis == CurveBasis::hermite) {
        hermite_points(states, ds, root, taper, {points, n + 1}, {tangents, n + 1});
    } else {
        bspline_points(states, ds, root, taper, {points, n + 3});
    }
}

void ExpandCurls(const KernelInput& in, const KernelOutput& out) {
    const std::size_t lanes = hn::Lanes(D());
    const std::size_t count = control_points_of(in.basis, std::uint32_t(in.guides.count));
    StrandBatch batch(in, lanes);
    for (std::size_t s = 0; s < out.count; s += lanes) {
        const std::size_t used = std::min(lanes, out.count - s);
        Point4f* const points = out.points + s * count;
        synthesize(in, out.first + s, used, batch);
        if (in.basis == CurveBasis::hermite) {
            hermite_row(in, false, batch);
            copy_strands(batch, used, count, points, out.past_caches);
            hermite_row(in, true, batch);
            copy_strands(batch, used, count, out.tangents + s * count, out.past_caches);
        } else {
            spline_points(in, batch);
            copy_strands(batch, used, count, points, out.past_caches);
        }
        for (std::size_t lane = 0; lane < used; ++lane) {
            if (!batch.scalar[lane]) continue;
            if (out.past_caches) hwy::FlushStream();
            expand_alone(in, out.first + s + lane, points + lane * count,
                         out.tangents ? out.tangents + (s + lane) * count : nullptr);
        }
    }
    if (out.past_caches) hwy::FlushStream();
}

void SynthesizeCurls(const KernelInput& in, std::size_t first, std::size_t count,
                     std::span<HelixState<float>> states) {
    const std::size_t lanes = hn::Lanes(D()), places = in.guides.count + 1;
    StrandBatch batch(in, lanes);
    for (std::size_t s = 0; s < count; s += lanes) {
        const std::size_t used = std::min(lanes, count - s);
        synthesize(in, first + s, used, batch);
        for (std::size_t lane = 0; lane < used; ++lane) {
            const auto own = states.subspan((s + lane) * places, places);
            if (batch.scalar[lane]) {
                synthesize_child<float>(in.binding, in.profiles, in.blend,
                                        first + s + lane, own);
                continue;
            }
            for (std::size_t i = 0; i < places; ++i) {
                const float* q = &batch.frames[i * 4 * lanes + lane];
                const float* p = &batch.places[(i + 2) * 3 * lanes + lane];
                own[i].frame =
                    Eigen::Quaterniond(q[0], q[lanes], q[2 * lanes], q[3 * lanes])
                        .normalized()  // the same rotation, at whatever length
                        .toRotationMatrix()
                        .cast<float>();
                own[i].position = {p[0], p[lanes], p[2 * lanes]};
            }
        }
    }
}

}  // namespace lancret::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lancret {

HWY_EXPORT(ExpandCurls);
HWY_EXPORT(SynthesizeCurls);

void expand_curls(const KernelInput& in, const KernelOutput& out) {
    HWY_DYNAMIC_DISPATCH(ExpandCurls)(in, out);
}

void synthesize_curls(const KernelInput& in, std::size_t first, std::size_t count,
                      std::span<HelixState<float>> states) {
    HWY_DYNAMIC_DISPATCH(SynthesizeCurls)(in, first, count, states);
}

}  // namespace lancret
#endif
