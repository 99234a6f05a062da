// Included once for each instruction set: no #pragma once.
// The rates of blend/option1.cpp, with a place of one strand in each lane, as places are
// independent.

#if defined(LANCRET_OPTION1_RATES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LANCRET_OPTION1_RATES_INL
#undef LANCRET_OPTION1_RATES_INL
#else
#define LANCRET_OPTION1_RATES_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

/// A child's guides, with the rotations from their roots to the child's.
struct TurnedGuides {
    std::size_t count, heaviest;
    const float* weights;
    Mat3f turns[kMaxNeighbours];
};

HWY_INLINE TurnedGuides turned_guides(const Binding& binding, const LightChild& child,
                                      std::size_t i) {
    TurnedGuides out{child.count, child.heaviest, child.weights, {}};
    for (std::size_t k = 0; k < child.count; ++k) {
        out.turns[k] = smallest_rotation<float>(binding.guide_normals[child.guides[k]],
                                                binding.roots.normals[i]);
    }
    return out;
}

HWY_INLINE Lanes3 turned(const Mat3f& m, const Lanes3& v) {
    const auto row = [&](int r) {
        return hn::MulAdd(set(m(r, 2)), v.z,
                          hn::MulAdd(set(m(r, 1)), v.y, hn::Mul(set(m(r, 0)), v.x)));
    };
    return {row(0), row(1), row(2)};
}

HWY_INLINE Lanes3 zero3() {
    const V zero = hn::Zero(D());
    return {zero, zero, zero};
}
template <class Mask>
HWY_INLINE Lanes3 choice(Mask mask, const Lanes3& yes, const Lanes3& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
            hn::IfThenElse(mask, yes.z, no.z)};
}
HWY_INLINE Lanes3 across(const Lanes3& v, const Lanes3& axis) {
    return times_plus(hn::Neg(dot(axis, v)), axis, v);
}
HWY_INLINE V length_of(const Lanes3& v) { return hn::Sqrt(dot(v, v)); }

constexpr float kSteady = option1::kSteady<float>, kNothing = option1::kNothing<float>,
                kFaint = option1::kFaint<float>, kFloor = option1::kFloor<float>;

/// mean_direction of vectors whose weighted sum is `sum`.
HWY_INLINE Lanes3 direction(const Lanes3& sum, const Lanes3& of_heaviest) {
    const V size = length_of(sum);
    return choice(size > set(kSteady), times(hn::Div(set(1), size), sum), of_heaviest);
}

/// The struct Means of option1.cpp, an interval in each lane.
struct LanesMeans {
    Lanes3 tangent, tangents[kMaxNeighbours], normals[kMaxNeighbours];
    V kappas[kMaxNeighbours], taus[kMaxNeighbours];
    Lanes3 bend, flat_sum;
    V bending, torsion, plain_tau;
    V kappa_low, kappa_high, tau_low, tau_high;
};

/// means_of for the intervals from `first` on; `frenet` has a row per guide.
HWY_INLINE LanesMeans means_of(const TurnedGuides& guides, const float* const* frenet,
                               std::size_t stride, std::size_t first) {
    const D d;
    LanesMeans out;
    Lanes3 sum = zero3(), most_bent = zero3();
    V largest_bend = set(-1);
    for (std::size_t k = 0; k < guides.count; ++k) {
        const float* row = frenet[k] + first;
        const V w = set(guides.weights[k]);
        out.kappas[k] = hn::Load(d, row);
        out.taus[k] = hn::Load(d, row + stride);
        out.tangents[k] = turned(guides.turns[k], load3(row + 2 * stride, stride));
        out.normals[k] = turned(guides.turns[k], load3(row + 5 * stride, stride));
        sum = times_plus(w, out.tangents[k], sum);
        const V bend = hn::Mul(w, out.kappas[k]);
        most_bent = choice(bend > largest_bend, out.normals[k], most_bent);
        largest_bend = hn::Max(bend, largest_bend);
    }
    out.tangent = direction(sum, out.tangents[guides.heaviest]);
    const Lanes3 side = across(most_bent, out.tangent);

    out.bend = out.flat_sum = zero3();
    out.bending = out.torsion = out.plain_tau = out.kappa_high = hn::Zero(d);
    out.kappa_low = out.kappas[0];
    out.tau_low = out.tau_high = out.taus[0];
    for (std::size_t k = 0; k < guides.count; ++k) {
        const V w = set(guides.weights[k]), kappa = out.kappas[k], tau = out.taus[k];
        const V weighted = hn::Mul(w, kappa);
        out.bending = hn::Add(out.bending, weighted);
        out.torsion = hn::MulAdd(weighted, tau, out.torsion);
        out.plain_tau = hn::MulAdd(w, tau, out.plain_tau);
        out.kappa_low = hn::Min(out.kappa_low, kappa);
        out.kappa_high = hn::Max(out.kappa_high, kappa);
        out.tau_low = hn::Min(out.tau_low, tau);
        out.tau_high = hn::Max(out.tau_high, tau);
        // (kappa, N) and (-kappa, -N) are one bend: all with N on one side.
        const auto other = dot(out.normals[k], side) < hn::Zero(d);
        const V sign = hn::IfThenElse(other, set(-1), set(1));
        out.normals[k] = times(sign, out.normals[k]);
        out.kappas[k] = hn::Mul(sign, kappa);
        const Lanes3 flat = across(out.normals[k], out.tangent);
        out.bend = times_plus(hn::Mul(w, out.kappas[k]), flat, out.bend);
        out.flat_sum = times_plus(w, flat, out.flat_sum);
    }
    return out;
}

HWY_INLINE V blended_kappa(const LanesMeans& means, V size) {
    const V printed = hn::Div(hn::MulAdd(set(kSteady), means.bending, size),
                              hn::Add(length_of(means.flat_sum), set(kSteady)));
    return hn::Min(hn::Max(printed, means.kappa_low), means.kappa_high);
}

HWY_INLINE V blended_tau(const TurnedGuides& guides, const LanesMeans& means, V size,
                         V kappa) {
    const V mean_tau = hn::Div(hn::MulAdd(set(kNothing), means.plain_tau, means.torsion),
                               hn::Add(means.bending, set(kNothing)));
    const Lanes3 binormal =
        times(hn::Div(set(1), size), cross(means.tangent, means.bend));
    V product = hn::Zero(D()), binormals = product;
    for (std::size_t k = 0; k < guides.count; ++k) {
        const V along =
            hn::Mul(set(guides.weights[k]),
                    dot(cross(means.tangents[k], means.normals[k]), binormal));
        product = hn::MulAdd(along, hn::Mul(means.kappas[k], means.taus[k]), product);
        binormals = hn::Add(binormals, along);
    }
    const V kappa_tau =
        hn::Div(hn::MulAdd(hn::Mul(set(kSteady), kappa), mean_tau, product),
                hn::Add(hn::Abs(binormals), set(kSteady)));
    const V floor = hn::MulAdd(set(kFloor), means.bending, set(kNothing));
    const V weight = hn::Mul(floor, floor);
    const V quotient = hn::Div(hn::MulAdd(kappa_tau, kappa, hn::Mul(weight, mean_tau)),
                               hn::MulAdd(kappa, kappa, weight));
    const V tau = hn::IfThenElse(size > hn::Zero(D()), quotient, mean_tau);
    return hn::Min(hn::Max(tau, means.tau_low), means.tau_high);
}

/// kappa~ and tau~ on the intervals from `first` on.
struct LanesRates {
    V kappa, tau;
};

HWY_INLINE LanesRates blended_rates(const TurnedGuides& guides,
                                    const float* const* frenet, std::size_t stride,
                                    std::size_t first) {
    const LanesMeans means = means_of(guides, frenet, stride, first);
    const V size = length_of(means.bend), kappa = blended_kappa(means, size);
    return {kappa, blended_tau(guides, means, size, kappa)};
}

}  // namespace lancret::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
