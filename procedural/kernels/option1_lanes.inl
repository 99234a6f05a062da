// Included once for each instruction set: no #pragma once.
// The rates of option 1, blend_option1.cpp, with a place of one strand in each lane: they
// do not depend on each other. What is serial, the sum of the joints' turns, comes after
// it with a strand in each lane.

#if defined(LANCRET_OPTION1_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LANCRET_OPTION1_LANES_INL
#undef LANCRET_OPTION1_LANES_INL
#else
#define LANCRET_OPTION1_LANES_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

/// A child's guides, from the space that they stand in to that of the child.
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

/// As in blend_option1.cpp.
constexpr float kSteady = 1e-5f, kNothing = 1e-12f, kFaint = 1e-6f;

/// mean_direction of vectors whose weighted sum is `sum`.
HWY_INLINE Lanes3 direction(const Lanes3& sum, const Lanes3& of_heaviest) {
    const V size = length_of(sum);
    return choice(size > set(kSteady), times(hn::Div(set(1), size), sum), of_heaviest);
}

/// kappa~ and tau~ of intervals from `at` on to two rows; the larger kappa~^2 + tau~^2 of
/// `most` and theirs.
HWY_INLINE V blended_rates(const TurnedGuides& guides, const float* const* frenet,
                           std::size_t stride, std::size_t at, float* kappas, float* taus,
                           V most) {
    const D d;
    Lanes3 tangents[kMaxNeighbours], normals[kMaxNeighbours];
    V kappa[kMaxNeighbours], tau[kMaxNeighbours];
    Lanes3 sum = zero3(), first = zero3();
    V heaviest_bend = set(-1);
    for (std::size_t k = 0; k < guides.count; ++k) {
        const float* row = frenet[k] + at;
        const V w = set(guides.weights[k]);
        kappa[k] = hn::Load(d, row);
        tau[k] = hn::Load(d, row + stride);
        tangents[k] = turned(guides.turns[k], load3(row + 2 * stride, stride));
        normals[k] = turned(guides.turns[k], load3(row + 5 * stride, stride));
        sum = times_plus(w, tangents[k], sum);
        const V bend = hn::Mul(w, kappa[k]);
        first = choice(bend > heaviest_bend, normals[k], first);
        heaviest_bend = hn::Max(bend, heaviest_bend);
    }
    const Lanes3 tangent = direction(sum, tangents[guides.heaviest]);
    const Lanes3 side = across(first, tangent);

    Lanes3 bend = zero3(), flats = zero3();
    V bending = hn::Zero(d), torsion = bending, plain_tau = bending;
    V kappa_low = kappa[0], kappa_high = bending, tau_low = tau[0], tau_high = tau[0];
    for (std::size_t k = 0; k < guides.count; ++k) {
        const V w = set(guides.weights[k]), weighted = hn::Mul(w, kappa[k]);
        bending = hn::Add(bending, weighted);
        torsion = hn::MulAdd(weighted, tau[k], torsion);
        plain_tau = hn::MulAdd(w, tau[k], plain_tau);
        kappa_low = hn::Min(kappa_low, kappa[k]);
        kappa_high = hn::Max(kappa_high, kappa[k]);
        tau_low = hn::Min(tau_low, tau[k]);
        tau_high = hn::Max(tau_high, tau[k]);
        // (kappa, N) and (-kappa, -N) are one bend: all with N on one side.
        const auto other = dot(normals[k], side) < hn::Zero(d);
        const V sign = hn::IfThenElse(other, set(-1), set(1));
        normals[k] = times(sign, normals[k]);
        kappa[k] = hn::Mul(sign, kappa[k]);
        const Lanes3 flat = across(normals[k], tangent);
        bend = times_plus(hn::Mul(w, kappa[k]), flat, bend);
        flats = times_plus(w, flat, flats);
    }
    const V mean_tau = hn::Div(hn::MulAdd(set(kNothing), plain_tau, torsion),
                               hn::Add(bending, set(kNothing)));
    const V size = length_of(bend);
    const V printed = hn::Div(hn::MulAdd(set(kSteady), bending, size),
                              hn::Add(length_of(flats), set(kSteady)));
    const V kappa_out = hn::Min(hn::Max(printed, kappa_low), kappa_high);

    const Lanes3 binormal = times(hn::Div(set(1), size), cross(tangent, bend));
    V product = hn::Zero(d), binormals = product;
    for (std::size_t k = 0; k < guides.count; ++k) {
        const V along = hn::Mul(set(guides.weights[k]),
                                dot(cross(tangents[k], normals[k]), binormal));
        product = hn::MulAdd(along, hn::Mul(kappa[k], tau[k]), product);
        binormals = hn::Add(binormals, along);
    }
    const V kappa_tau =
        hn::Div(hn::MulAdd(hn::Mul(set(kSteady), kappa_out), mean_tau, product),
                hn::Add(hn::Abs(binormals), set(kSteady)));
    const V floor = hn::MulAdd(set(1e-3f), bending, set(kNothing));
    const V weight = hn::Mul(floor, floor);
    const V quotient =
        hn::Div(hn::MulAdd(kappa_tau, kappa_out, hn::Mul(weight, mean_tau)),
                hn::MulAdd(kappa_out, kappa_out, weight));
    const V any_tau = hn::IfThenElse(size > hn::Zero(d), quotient, mean_tau);
    const V tau_out = hn::Min(hn::Max(any_tau, tau_low), tau_high);
    hn::Store(kappa_out, d, kappas + at);
    hn::Store(tau_out, d, taus + at);
    return hn::Max(most, hn::MulAdd(kappa_out, kappa_out, hn::Mul(tau_out, tau_out)));
}

/// sum(w kappa P N) of one side of joints, across the tangent: bend_of.
HWY_INLINE Lanes3 bend_at(const TurnedGuides& guides, const float* const* rows,
                          std::size_t stride, std::size_t at, const Lanes3& tangent) {
    Lanes3 bend = zero3();
    for (std::size_t k = 0; k < guides.count; ++k) {
        const float* row = rows[k] + at;
        const V kappa = hn::Add(hn::Load(D(), row + 3 * stride), set(kFaint));
        bend = times_plus(hn::Mul(set(guides.weights[k]), kappa),
                          turned(guides.turns[k], load3(row, stride)), bend);
    }
    return across(bend, tangent);
}

/// Cosine and sine of the turn of N~ at joints from `at` on, to two rows. With `root`,
/// where it is asked for: T~ and the bend at the first of them.
HWY_INLINE void joint_turns(const TurnedGuides& guides, const float* const* joints,
                            std::size_t stride, std::size_t at, float* cosines,
                            float* sines, Vec3f* root) {
    const D d;
    const float *before[kMaxNeighbours], *after[kMaxNeighbours];
    Lanes3 sum = zero3(), heaviest = zero3();
    for (std::size_t k = 0; k < guides.count; ++k) {
        const Lanes3 tangent = turned(guides.turns[k], load3(joints[k] + at, stride));
        sum = times_plus(set(guides.weights[k]), tangent, sum);
        if (k == guides.heaviest) heaviest = tangent;
        before[k] = joints[k] + 3 * stride;
        after[k] = joints[k] + 7 * stride;
    }
    const Lanes3 tangent = direction(sum, heaviest);
    const Lanes3 from = bend_at(guides, before, stride, at, tangent);
    const Lanes3 to = bend_at(guides, after, stride, at, tangent);
    const V cosine = dot(from, to), sine = dot(tangent, cross(from, to));
    const V size = hn::Sqrt(hn::MulAdd(cosine, cosine, hn::Mul(sine, sine)));
    // Squares of what is nothing underflow: it turns nothing either way.
    const auto some = size > set(kNothing * kNothing);
    const V inverse = hn::Div(set(1), size);
    hn::Store(hn::IfThenElse(some, hn::Mul(cosine, inverse), set(1)), d, cosines + at);
    hn::Store(hn::IfThenElse(some, hn::Mul(sine, inverse), hn::Zero(d)), d, sines + at);
    if (!root) return;
    root[0] = {hn::GetLane(tangent.x), hn::GetLane(tangent.y), hn::GetLane(tangent.z)};
    root[1] = {hn::GetLane(to.x), hn::GetLane(to.y), hn::GetLane(to.z)};
}

/// Rates of the lane's child to its rows, and its root frame; left to the scalar blend
/// where that has no normal, or turns too far.
HWY_INLINE void fill_option1(const KernelInput& in, std::size_t i, std::size_t lane,
                             float most_turn, StrandBatch& batch) {
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
    V most = hn::Zero(d);
    for (std::size_t at = 0; at < n; at += lanes) {
        most = blended_rates(turned, frenet, stride, at, kappas, taus, most);
    }
    const float ds = in.binding.lengths[i] / float(n);
    const float turn = std::sqrt(hn::GetLane(hn::MaxOfLanes(d, most))) * ds;
    if (!(turn <= most_turn)) batch.scalar[lane] = true;

    Vec3f root[2];
    const std::size_t joint_stride = guides.joint_stride;
    float* const cosines = &batch.joint_rows[lane * joint_stride];
    float* const sines = &batch.joint_rows[(lanes + lane) * joint_stride];
    for (std::size_t at = 0; at < guides.joint_places.size(); at += lanes) {
        joint_turns(turned, joints, joint_stride, at, cosines, sines,
                    at == 0 ? root : nullptr);
    }
    const float size = root[1].norm();
    if (!(size > kNothing)) batch.scalar[lane] = true;
    Mat3f frame;
    frame << root[0], root[1] / size, root[0].cross(root[1] / size);
    const Eigen::Quaternionf q = Eigen::Quaternionf(frame).normalized();
    batch.start[0][lane] = q.w();
    for (int axis = 0; axis < 3; ++axis) batch.start[axis + 1][lane] = q.vec()[axis];
}

/// Darboux vectors of every lane, from their rates and the turns at their joints.
HWY_INLINE void sum_joints(const KernelInput& in, StrandBatch& batch) {
    const D d;
    const std::size_t n = batch.intervals, stride = batch.stride, lanes = hn::Lanes(d);
    const std::size_t plane = stride * lanes, joint_stride = in.guides.joint_stride;
    const std::span<const std::uint32_t> places = in.guides.joint_places;
    const auto transposed = [&](const float* from, std::size_t row_size,
                                std::size_t count, float* to) {
        const float* rows[kMaxLanes];
        for (std::size_t lane = 0; lane < lanes; ++lane)
            rows[lane] = from + lane * row_size;
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
    std::size_t joint = 1;  // the first is the root, where nothing turns
    for (std::size_t i = 0; i < n; ++i) {
        if (joint < places.size() && places[joint] == i) {
            const V c = hn::Load(d, turns + joint * lanes);
            const V s = hn::Load(d, turns + joint_plane + joint * lanes);
            const V sum = hn::NegMulAdd(sine, s, hn::Mul(cosine, c));
            sine = hn::MulAdd(cosine, s, hn::Mul(sine, c));
            // To unit length, but for round-off, by a Newton step.
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
