// Included once for each instruction set: no #pragma once.
// Strands integrated along their curvatures, and anchored if the blend is: the templates
// blend_nearest and anchor, a strand in each lane.

#if defined(LANCRET_CURL_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LANCRET_CURL_LANES_INL
#undef LANCRET_CURL_LANES_INL
#else
#define LANCRET_CURL_LANES_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace lancret::HWY_NAMESPACE {

HWY_INLINE Lanes3 load3(const float* rows, std::size_t row_size) {
    const D d;
    return {hn::Load(d, rows), hn::Load(d, rows + row_size),
            hn::Load(d, rows + 2 * row_size)};
}
HWY_INLINE Lanes3 load3(const float (&rows)[3][kMaxLanes]) {
    return load3(&rows[0][0], kMaxLanes);
}
HWY_INLINE void store3(const Lanes3& v, float* rows) {
    const D d;
    hn::Store(v.x, d, rows);
    hn::Store(v.y, d, rows + hn::Lanes(d));
    hn::Store(v.z, d, rows + 2 * hn::Lanes(d));
}
HWY_INLINE Lanes4 load4(const float* rows) {
    const D d;
    return {hn::Load(d, rows), load3(rows + hn::Lanes(d), hn::Lanes(d))};
}
HWY_INLINE void store4(const Lanes4& q, float* rows) {
    const D d;
    hn::Store(q.w, d, rows);
    store3(q.v, rows + hn::Lanes(d));
}

/// The coefficients of a spine, multiplied by the taper.
struct LanesSpine {
    Lanes3 terms[kSpineTerms];
};

/// The spine's vector at a place with the polynomials `basis`.
HWY_INLINE Lanes3 at_place(const LanesSpine& spine,
                           const std::array<float, kSpineTerms>& basis) {
    Lanes3 sum = spine.terms[0];
    for (int j = 1; j < kSpineTerms; ++j) {
        sum = times_plus(set(basis[std::size_t(j)]), spine.terms[j], sum);
    }
    return sum;
}

/// The guides' spine and its taper, as goal_of and spine_taper return them.
struct LanesGoal {
    LanesSpine spine;
    V taper[kSpineTerms];
};

HWY_INLINE LanesGoal lanes_goal(const StrandBatch& batch) {
    const D d;
    const Lanes3 up = load3(batch.normal);
    const V zero = hn::Zero(d);
    LanesGoal out;
    for (Lanes3& term : out.spine.terms) term = {zero, zero, zero};
    V turns = zero;
    for (std::size_t k = 0; k < batch.neighbours; ++k) {
        const float(&record)[16][kMaxLanes] = batch.records[k];
        const V share = hn::Load(d, batch.shares[k]);
        const Lanes3 from = load3(&record[0][0], kMaxLanes);
        turns = hn::MulAdd(share, hn::Load(d, record[3]), turns);
        // The smallest rotation from `from` to `up`, applied to each term.
        const V cosine = dot(from, up);
        const Lanes3 axis = cross(from, up);
        const V inverse = hn::Div(set(1), hn::Add(set(1), cosine));
        for (std::size_t j = 0; j < kSpineTerms; ++j) {
            const Lanes3 term = load3(&record[4 + 3 * j][0], kMaxLanes);
            const V along = hn::Mul(dot(axis, term), inverse);
            const Lanes3 turned =
                times_plus(along, axis, cross_plus(axis, term, times(cosine, term)));
            out.spine.terms[j] = times_plus(share, turned, out.spine.terms[j]);
        }
    }
    out.taper[0] = out.taper[1] = set(1);
    for (int j = 2; j < kSpineTerms; ++j) {
        out.taper[j] = hn::Min(hn::Max(hn::Sub(turns, set(float(j - 1))), zero), set(1));
        out.spine.terms[j] = times(out.taper[j], out.spine.terms[j]);
    }
    return out;
}

/// The frame at the root: the child's, or if not `blended` the heaviest guide's, turned
/// to the child's normal.
HWY_INLINE Lanes4 lanes_start(const StrandBatch& batch, bool blended) {
    const Lanes4 start{hn::Load(D(), batch.start[0]),
                       load3(&batch.start[1][0], kMaxLanes)};
    if (blended) return start;
    const Lanes3 from = load3(batch.start_normal), up = load3(batch.normal);
    const Lanes4 turn{hn::Add(set(1), dot(from, up)), cross(from, up)};
    return normalized(product(turn, start));
}

/// Integrates the curvatures from the first frame; writes `frames`. Returns the strand's
/// spine if `with_spine`: the sum over the intervals of the chords over the length, times
/// the polynomials in the middle.
HWY_INLINE LanesSpine integrate(const KernelInput& in, bool with_spine,
                                StrandBatch& batch) {
    const D d;
    const std::size_t n = batch.intervals, lanes = hn::Lanes(d);
    const V share = set(1 / float(n));
    const V ds = hn::Mul(hn::Load(d, batch.length), share);
    const V zero = hn::Zero(d);
    LanesSpine spine;
    for (Lanes3& term : spine.terms) term = {zero, zero, zero};
    Lanes4 q = load4(batch.frames.get());
    for (std::size_t i = 0; i < n; ++i) {
        const Lanes3 u = load3(&batch.curvatures[i * lanes], batch.stride * lanes);
        const LanesStep step = lanes_step(times(ds, u));
        if (with_spine) {
            const Lanes3 chord = times(share, rotated(q, step.displacement));
            for (std::size_t j = 0; j < kSpineTerms; ++j) {
                spine.terms[j] = times_plus(set(in.profiles.basis.in_middles[i][j]),
                                            chord, spine.terms[j]);
            }
        }
        q = renormalized(product(q, step.turn));
        store4(q, &batch.frames[(i + 1) * 4 * lanes]);
    }
    return spine;
}

/// The frame q turned as `anchor` turns it: tilted to reach `advance`, then turned from
/// the strand's spine `from` to the guides' spine `to`.
HWY_INLINE Lanes4 anchored(const Lanes4& q, const Lanes3& from, const Lanes3& to,
                           V advance) {
    // As in tilt_speed and turn_of_spine.
    constexpr float kNone = anchoring::kNone<float>, kSoft = anchoring::kSoft<float>,
                    kMaxSpeed = anchoring::kMaxSpeed<float>,
                    kShort = anchoring::kShort<float>;
    const V length2 = dot(from, from), length = hn::Sqrt(length2);
    const V size = hn::Min(length, set(1));
    const V below = hn::Add(hn::NegMulAdd(advance, size, set(1)), set(kSoft));
    const V limit = hn::Mul(set(kMaxSpeed), below);
    const V above = hn::Min(hn::Max(hn::Sub(advance, size), hn::Neg(limit)), limit);
    const V softened = hn::Sqrt(hn::MulAdd(size, size, set(kShort * kShort)));
    const Lanes3 v = times(hn::Div(above, hn::Mul(below, softened)), from);
    // With s = sqrt(1 - v^2) and a = v.T, the smallest rotation from T to its image under
    // the speed v is the quaternion (1 + s + a, T x v), of any length.
    const Lanes3 tangent = first_axis(q);
    const V s = hn::Sqrt(hn::Sub(set(1), dot(v, v)));
    const Lanes4 tilt{hn::Add(hn::Add(set(1), s), dot(v, tangent)), cross(tangent, v)};
    const V both = hn::MulAdd(length, hn::Sqrt(dot(to, to)), dot(from, to));
    const Lanes4 turn{hn::Add(both, set(kNone)), cross(from, to)};
    return normalized(product(turn, product(tilt, q)));
}

/// Turns the frames from the strand's spine to the guides'.
HWY_INLINE void anchor_frames(const KernelInput& in, const LanesSpine& spine,
                              const LanesSpine& goal, StrandBatch& batch) {
    const std::size_t lanes = hn::Lanes(D());
    for (std::size_t i = 0; i <= batch.intervals; ++i) {
        float* const frame = &batch.frames[i * 4 * lanes];
        const auto& basis = in.profiles.basis.at_places[i];
        store4(anchored(load4(frame), at_place(spine, basis), at_place(goal, basis),
                        hn::Load(D(), &batch.advances[i * lanes])),
               frame);
    }
}

/// Computes the places from the frames, and two more beyond each end.
HWY_INLINE void set_places(StrandBatch& batch) {
    const D d;
    const std::size_t n = batch.intervals, lanes = hn::Lanes(d);
    const V ds = hn::Mul(hn::Load(d, batch.length), set(1 / float(n)));
    const V zero = hn::Zero(d);
    float* const places = batch.places.get() + 2 * 3 * lanes;  // of the root
    Lanes3 place{zero, zero, zero};
    Lanes4 before{};
    LanesBetween helix{};
    for (std::size_t i = 0; i <= n; ++i) {
        float* const frame = &batch.frames[i * 4 * lanes];
        Lanes4 q = load4(frame);
        if (i > 0) {
            // q and -q are one rotation; take the one nearer to the frame before.
            const V cosine = dot(before, q);
            q = times(hn::CopySignToAbs(set(1), cosine), q);
            helix = lanes_between(before, q, hn::Abs(cosine));
            place = times_plus(ds, helix.chord, place);
            if (i == 1) {
                const Lanes4 back = conjugate(helix.turn);
                const Lanes3 first = rotated(back, helix.chord);
                const Lanes3 one = times(hn::Neg(ds), first);
                store3(one, places - 3 * lanes);
                store3(times_plus(hn::Neg(ds), rotated(back, first), one),
                       places - 6 * lanes);
            }
        }
        store4(q, frame);
        store3(place, places + i * 3 * lanes);
        before = q;
    }
    for (std::size_t i = n + 1; i <= n + 2; ++i) {
        helix.chord = rotated(helix.turn, helix.chord);
        place = times_plus(ds, helix.chord, place);
        store3(place, places + i * 3 * lanes);
    }
}

}  // namespace lancret::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
