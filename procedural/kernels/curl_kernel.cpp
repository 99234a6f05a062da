// The curl kernel: blends that integrate curvature and torsion, a strand in each lane.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/kernels/curl_kernel.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "procedural/bind/child.h"
#include "procedural/blend/anchor_constants.h"
#include "procedural/blend/option1_constants.h"
#include "procedural/curves/emitted_curve.h"
#include "procedural/kernels/curl_kernel.h"
#include "procedural/kernels/strand_batch.h"
// each .inl uses those before it
#include "procedural/kernels/copy_points.inl"
//
#include "procedural/kernels/lane_math.inl"
//
#include "procedural/kernels/curl_lanes.inl"
//
#include "procedural/kernels/transpose_rows.inl"
//
#include "procedural/kernels/option1_rates.inl"
//
#include "procedural/kernels/option1_lanes.inl"
//
#include "procedural/kernels/fill_batch.inl"

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

/// Synthesises children [first, first + used) to the batch's frames and places.
void synthesize(const KernelInput& in, std::size_t first, std::size_t used,
                StrandBatch& batch) {
    const BlendTraits& traits = traits_of(in.blend);
    const bool with_anchor = traits.anchored;
    const bool blends_rates = traits.rates == BlendRates::blended;
    fill_batch(in, first, used, with_anchor, blends_rates, batch);
    store4(lanes_start(batch, blends_rates), batch.frames.get());
    LanesSpine spine = integrate(in, with_anchor, batch);
    if (with_anchor) {
        const LanesGoal goal = lanes_goal(batch);
        for (int j = 2; j < kSpineTerms; ++j) {
            spine.terms[j] = times(goal.taper[j], spine.terms[j]);
        }
        anchor_frames(in, spine, goal.spine, batch);
    }
    set_places(batch);
}

/// Writes the B-spline control points of all lanes to `points`, as bspline_points does.
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
    const auto store = [&](std::size_t j, const Lanes3& p) {
        const Lanes3 c = root + p;
        const V radius =
            hn::Mul(width, set(radius_of(in.taper, std::ptrdiff_t(j) - 1, n)));
        hn::StoreInterleaved4(c.x, c.y, c.z, radius, d,
                              &batch.points[j * 4 * hn::Lanes(d)]);
    };
    // The curve begins at (c[-1] + 4 c[0] + c[1]) / 6, and ends likewise.
    const auto outermost = [&](std::size_t end, const Lanes3& at_end,
                               const Lanes3& next) {
        return times_plus(set(6), place(end),
                          times_plus(set(-4), at_end, times(set(-1), next)));
    };
    Lanes3 before = smoothed(0), now = smoothed(1);
    store(0, outermost(0, before, now));
    store(1, before);
    store(2, now);
    for (std::size_t i = 2; i <= n; ++i) {
        before = now;
        now = smoothed(i);
        store(i + 1, now);
    }
    store(n + 2, outermost(n, now, before));
}

/// Writes the places, or the tangents times ds, of all lanes to `points`, as
/// hermite_points does.
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

/// Copies the strands in `points` to their destination.
void copy_strands(const StrandBatch& batch, std::size_t used, std::size_t count,
                  Point4f* to, bool past_caches) {
    const std::size_t lanes = hn::Lanes(D());
    for (std::size_t lane = 0; lane < used; ++lane, to += count) {
        copy_points(&batch.points[4 * lane], 4 * lanes, count, to, past_caches);
    }
}

/// Writes the control points of child i with the scalar blend.
void expand_scalar(const KernelInput& in, std::size_t i, Point4f* points,
                   Point4f* tangents) {
    const std::size_t n = in.guides.count;
    std::vector<HelixState<float>> states(n + 1);
    synthesize_child<float>(in.binding, in.profiles, in.blend, i, states);
    const std::size_t count = control_points_of(in.basis, std::uint32_t(n));
    emit({.states = states,
          .ds = in.binding.lengths[i] / float(n),
          .root = in.binding.roots.positions[i],
          .taper = in.taper.times(in.binding.roots.width(i))},
         in.basis, {points, count}, {tangents, tangents ? count : 0});
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
            expand_scalar(in, out.first + s + lane, points + lane * count,
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
            const auto out = states.subspan((s + lane) * places, places);
            if (batch.scalar[lane]) {
                synthesize_child<float>(in.binding, in.profiles, in.blend,
                                        first + s + lane, out);
                continue;
            }
            for (std::size_t i = 0; i < places; ++i) {
                const float* q = &batch.frames[i * 4 * lanes + lane];
                const float* p = &batch.places[(i + 2) * 3 * lanes + lane];
                out[i].frame =
                    Eigen::Quaterniond(q[0], q[lanes], q[2 * lanes], q[3 * lanes])
                        .normalized()
                        .toRotationMatrix()
                        .cast<float>();
                out[i].position = {p[0], p[lanes], p[2 * lanes]};
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
