// Included once for each instruction set: no #pragma once.
// Fills a batch from the binding, a strand in each lane.

#if defined(LANCRET_FILL_BATCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LANCRET_FILL_BATCH_INL
#undef LANCRET_FILL_BATCH_INL
#else
#define LANCRET_FILL_BATCH_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

/// Writes a lane's shares of its guides, their records, and the mean of their advances.
HWY_INLINE void fill_guides(const KernelGuides& guides,
                            const GuideProfiles<float>& profiles, std::size_t lane,
                            StrandBatch& batch) {
    const D d;
    const LightChild& child = batch.children[lane];
    float shares[kMaxNeighbours], sum = 0;
    const float* rows[kMaxNeighbours];
    for (std::size_t k = 0; k < child.count; ++k) {
        const std::uint32_t g = child.guides[k];
        sum += shares[k] = child.weights[k] * profiles.lengths[g];
        rows[k] = &guides.advances[g * batch.stride];
    }
    for (std::size_t k = 0; k < batch.neighbours; ++k) {
        const bool used = k < child.count;
        const std::uint32_t g = child.guides[used ? k : child.heaviest];
        batch.shares[k][lane] = used ? shares[k] /= sum : 0;
        batch.record_rows[k][lane] = guides.records[g].normal;
    }
    for (std::size_t i = 0; i <= batch.intervals; i += hn::Lanes(d)) {
        V advance = hn::Mul(set(shares[0]), hn::Load(d, rows[0] + i));
        for (std::size_t k = 1; k < child.count; ++k) {
            advance = hn::MulAdd(set(shares[k]), hn::Load(d, rows[k] + i), advance);
        }
        hn::Store(advance, d, &batch.rows[(2 * hn::Lanes(d) + lane) * batch.stride + i]);
    }
}

/// Fills the first lanes with children [first, first + used), and the rest with the last
/// of them.
HWY_INLINE void fill_batch(const KernelInput& in, std::size_t first, std::size_t used,
                           bool with_anchor, bool blends_rates, StrandBatch& batch) {
    static_assert(sizeof(GuideRecord) == 16 * sizeof(float));
    const Binding& binding = in.binding;
    const std::size_t lanes = hn::Lanes(D());
    const float* curvatures[kMaxLanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const std::size_t i = first + std::min(lane, used - 1);
        LightChild& child = batch.children[lane] = light_child(binding, i);
        const std::uint32_t heaviest = child.guides[child.heaviest];
        const Vec3f &root = binding.roots.positions[i], &up = binding.roots.normals[i];
        const Vec3f& start_normal = binding.guide_normals[heaviest];
        batch.length[lane] = binding.lengths[i];
        batch.width[lane] = binding.roots.width(i);
        for (int axis = 0; axis < 3; ++axis) {
            batch.root[axis][lane] = root[axis];
            batch.normal[axis][lane] = up[axis];
            batch.start_normal[axis][lane] = start_normal[axis];
        }
        const Eigen::Quaternionf& start = in.guides.root_frames[heaviest];
        batch.start[0][lane] = start.w();
        for (int axis = 0; axis < 3; ++axis) {
            batch.start[axis + 1][lane] = start.vec()[axis];
        }
        curvatures[lane] = &in.guides.curvatures[heaviest * 3 * batch.stride];
        const float ds = binding.lengths[i] / float(batch.intervals);
        const float max_turn = with_anchor ? kMaxTurnAnchored : kMaxTurnAlone;
        bool scalar =
            !blends_rates && !(in.guides.most_curved[heaviest] * ds <= max_turn);
        for (std::size_t k = 0; k < child.count; ++k) {
            const Vec3f& normal = binding.guide_normals[child.guides[k]];
            scalar = scalar || !(normal.dot(up) >= kOpposedCosine);
        }
        batch.scalar[lane] = scalar;
        if (blends_rates) fill_option1(in, i, lane, max_turn, batch);
        if (with_anchor) fill_guides(in.guides, in.profiles, lane, batch);
    }
    const std::size_t n = batch.intervals, stride = batch.stride;
    if (blends_rates) {
        sum_joints(in, batch);
    } else {
        for (int axis = 0; axis < 3; ++axis) {
            transpose_rows(curvatures, lanes, n, &batch.curvatures[axis * stride * lanes],
                           lanes);
            for (const float*& row : std::span(curvatures, lanes)) row += stride;
        }
    }
    if (!with_anchor) return;
    for (std::size_t k = 0; k < batch.neighbours; ++k) {
        transpose_rows(batch.record_rows[k], lanes, 16, &batch.records[k][0][0],
                       kMaxLanes);
    }
    const float* advances[kMaxLanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        advances[lane] = &batch.rows[(2 * lanes + lane) * stride];
    }
    transpose_rows(advances, lanes, n + 1, batch.advances.get(), lanes);
}

}  // namespace lancret::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
