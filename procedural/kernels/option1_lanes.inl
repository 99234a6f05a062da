// Included once for each instruction set: no #pragma once.
// The rates of blend/option1.cpp, with a place of one strand in each lane, as places are
// independent. The sum of the joints' turns is serial and follows with a strand in each
// lane.

#if defined(LANCRET_OPTION1_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LANCRET_OPTION1_LANES_INL
#undef LANCRET_OPTION1_LANES_INL
#else
#define LANCRET_OPTION1_LANES_INL
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

/// sum(w kappa P N) on one side of the joints from `first` on, as bend_of returns it.
HWY_INLINE Lanes3 bend_at(const TurnedGuides& guides, const float* const* rows,
                          std::size_t stride, std::size_t first, const Lanes3& tangent) {
    Lanes3 bend = zero3();
    for (std::size_t k = 0; k < guides.count; ++k) {
        const float* row = rows[k] + first;
        const V kappa = hn::Add(hn::Load(D(), row + 3 * stride), set(kFaint));
        bend = times_plus(hn::Mul(set(guides.weights[k]), kappa),
                          turned(guides.turns[k], load3(row, stride)), bend);
    }
    return across(bend, tangent);
}

/// The rows of one lane in StrandBatch::joint_rows.
struct JointRows {
    float *cosines, *sines;
};

/// Cosines and sines of the turn of N~ at the joints from `first` on. Unless null, `root`
/// receives T~ and the bend at the first of them.
HWY_INLINE void joint_turns(const TurnedGuides& guides, const float* const* joints,
                            std::size_t stride, std::size_t first, JointRows rows,
                            Vec3f* root) {
    const D d;
    const float *before[kMaxNeighbours], *after[kMaxNeighbours];
    Lanes3 sum = zero3(), heaviest = zero3();
    for (std::size_t k = 0; k < guides.count; ++k) {
        const Lanes3 tangent = turned(guides.turns[k], load3(joints[k] + first, stride));
        sum = times_plus(set(guides.weights[k]), tangent, sum);
        if (k == guides.heaviest) heaviest = tangent;
        before[k] = joints[k] + 3 * stride;
        after[k] = joints[k] + 7 * stride;
    }
    const Lanes3 tangent = direction(sum, heaviest);
    const Lanes3 from = bend_at(guides, before, stride, first, tangent);
    const Lanes3 to = bend_at(guides, after, stride, first, tangent);
    const V cosine = dot(from, to), sine = dot(tangent, cross(from, to));
    const V size = hn::Sqrt(hn::MulAdd(cosine, cosine, hn::Mul(sine, sine)));
    // Products of vanishing bends underflow; the turn is then zero.
    const auto some = size > set(kNothing * kNothing);
    const V inverse = hn::Div(set(1), size);
    hn::Store(hn::IfThenElse(some, hn::Mul(cosine, inverse), set(1)), d,
              rows.cosines + first);
    hn::Store(hn::IfThenElse(some, hn::Mul(sine, inverse), hn::Zero(d)), d,
              rows.sines + first);
    if (!root) return;
    root[0] = {hn::GetLane(tangent.x), hn::GetLane(tangent.y), hn::GetLane(tangent.z)};
    root[1] = {hn::GetLane(to.x), hn::GetLane(to.y), hn::GetLane(to.z)};
}

/// Writes rates, joint turns and root frame of child i to its lane. Marks the lane for
/// the scalar blend if the root has no normal or an interval turns by more than
/// `max_turn`.
HWY_INLINE void fill_option1(const KernelInput& in, std::size_t i, std::size_t lane,
                             float max_turn, StrandBatch& batch) {
    const D d;
    const KernelGuides& guides = in.guides;
    const std::size_t n = batch.intervals, stride = batch.stride, lanes = hn::Lanes(d);
    const LightChild& child = batch.children[lane];
    const TurnedGuides turned = turned_guides(in.binding, child, i);
    const float *frenet[kMaxNeighbours], *joints[kMaxNeighbours];
    for (std::size_t k = 0; k < child.count; ++k) {
        frenet[k] = &guides.frenet[child.guides[k] * 8 * stride];
        joints[k] = &guides.joints[child.guides[k] * 11 * guides.joint_stride];
    }
    float* const kappas = &batch.rows[lane * stride];
    float* const taus = &batch.rows[(lanes + lane) * stride];
    V largest = hn::Zero(d);  // |Darboux vector|^2
    for (std::size_t j = 0; j < n; j += lanes) {
        const auto [kappa, tau] = blended_rates(turned, frenet, stride, j);
        hn::Store(kappa, d, kappas + j);
        hn::Store(tau, d, taus + j);
        largest = hn::Max(largest, hn::MulAdd(kappa, kappa, hn::Mul(tau, tau)));
    }
    const float ds = in.binding.lengths[i] / float(n);
    const float turn = std::sqrt(hn::GetLane(hn::MaxOfLanes(d, largest))) * ds;
    if (!(turn <= max_turn)) batch.scalar[lane] = true;

    Vec3f root[2];
    const std::size_t joint_stride = guides.joint_stride;
    const JointRows rows{&batch.joint_rows[lane * joint_stride],
                         &batch.joint_rows[(lanes + lane) * joint_stride]};
    for (std::size_t j = 0; j < guides.joint_places.size(); j += lanes) {
        joint_turns(turned, joints, joint_stride, j, rows, j == 0 ? root : nullptr);
    }
    const float size = root[1].norm();
    if (!(size > kNothing)) batch.scalar[lane] = true;
    Mat3f frame;
    frame << root[0], root[1] / size, root[0].cross(root[1] / size);
    const Eigen::Quaternionf q = Eigen::Quaternionf(frame).normalized();
    batch.start[0][lane] = q.w();
    for (int axis = 0; axis < 3; ++axis) batch.start[axis + 1][lane] = q.vec()[axis];
}

/// The Darboux vectors of all lanes, from their rates and the turns at their joints.
HWY_INLINE void sum_joints(const KernelInput& in, StrandBatch& batch) {
    const D d;
    const std::size_t n = batch.intervals, stride = batch.stride, lanes = hn::Lanes(d);
    const std::size_t plane = stride * lanes, joint_stride = in.guides.joint_stride;
    const std::span<const std::uint32_t> places = in.guides.joint_places;
    const auto transposed = [&](const float* from, std::size_t row_size,
                                std::size_t count, float* to) {
        const float* rows[kMaxLanes];
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            rows[lane] = from + lane * row_size;
        }
        transpose_rows(rows, lanes, count, to, lanes);
    };
    float* const u = batch.curvatures.get();
    float* const turns = batch.joint_columns.get();
    const std::size_t joint_plane = joint_stride * lanes;
    transposed(batch.rows.get(), stride, n, u + plane);
    transposed(&batch.rows[lanes * stride], stride, n, u);
    transposed(batch.joint_rows.get(), joint_stride, places.size(), turns);
    transposed(&batch.joint_rows[lanes * joint_stride], joint_stride, places.size(),
               turns + joint_plane);
    V cosine = set(1), sine = hn::Zero(d);
    std::size_t joint = 1;  // joint 0 is the root, which has no turn
    for (std::size_t i = 0; i < n; ++i) {
        if (joint < places.size() && places[joint] == i) {
            const V c = hn::Load(d, turns + joint * lanes);
            const V s = hn::Load(d, turns + joint_plane + joint * lanes);
            const V sum = hn::NegMulAdd(sine, s, hn::Mul(cosine, c));
            sine = hn::MulAdd(cosine, s, hn::Mul(sine, c));
            // A Newton step restores unit length.
            const V size2 = hn::MulAdd(sum, sum, hn::Mul(sine, sine));
            const V factor = hn::NegMulAdd(set(0.5f), size2, set(1.5f));
            cosine = hn::Mul(factor, sum);
            sine = hn::Mul(factor, sine);
            ++joint;
        }
        const V kappa = hn::Load(d, u + plane + i * lanes);
        hn::Store(hn::Neg(hn::Mul(kappa, sine)), d, u + plane + i * lanes);
        hn::Store(hn::Mul(kappa, cosine), d, u + 2 * plane + i * lanes);
    }
}

}  // namespace lancret::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
