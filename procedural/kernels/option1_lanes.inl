// Included once for each instruction set: no #pragma once.
// The joints of blend/option1.cpp: turns with a joint of one strand in each lane, then
// their sum along the strand, which is serial, with a strand in each lane.

#if defined(LANCRET_OPTION1_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LANCRET_OPTION1_LANES_INL
#undef LANCRET_OPTION1_LANES_INL
#else
#define LANCRET_OPTION1_LANES_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

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
