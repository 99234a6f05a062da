#include "procedural/check/child_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "guides/base/cancel.h"
#include "guides/base/worst.h"
#include "procedural/blend/motion_limit.h"

namespace lancret {

namespace {

/// A child and its guides at one time, expressed in the frame of its carrier.
class ChildAtTime {
  public:
    ChildAtTime(const Moment& moment, Blend blend, std::size_t i)
        : profiles_(*moment.profiles),
          bound_(bound_child(*moment.binding, profiles_, i)),
          states_(profiles_.count + 1) {
        const std::size_t carrier = moment.carriers.size() == 1 ? 0 : i;
        unturn_ = moment.carriers[carrier].rotation.transpose();
        blend_function<double>(blend)(bound_.child(), profiles_, states_);
        double length = 0;
        for (std::size_t k = 0; k < bound_.count; ++k) {
            length += bound_.weights[k] * profiles_.lengths[bound_.guides[k]];
            // `position` blends the guides as they stand in space.
            const Mat3& turn = traits_of(blend).mean_places
                                   ? profiles_.root_frames[bound_.guides[k]]
                                   : bound_.to_space[k];
            turns_[k] = unturn_ * turn;
        }
        scale_ = bound_.length / length;
    }
    std::size_t guides() const { return bound_.count; }
    std::size_t places() const { return states_.size(); }
    /// The bound child in the frame of the carrier.
    BoundChild<double> carried() const {
        BoundChild<double> out = bound_;
        for (std::size_t k = 0; k < out.count; ++k) {
            out.to_space[k] = unturn_ * out.to_space[k];
        }
        return out;
    }
    const GuideProfiles<double>& profiles() const { return profiles_; }
    Vec3 place(std::size_t j) const { return unturn_ * states_[j].position; }
    Vec3 guide_place(std::size_t k, std::size_t j) const {
        return scale_ *
               (turns_[k] * profiles_.positions[bound_.guides[k] * places() + j]);
    }

  private:
    const GuideProfiles<double>& profiles_;
    BoundChild<double> bound_;
    std::vector<HelixState<double>> states_;
    Mat3 unturn_, turns_[kMaxNeighbours];
    double scale_;
};

void validate(const Moment& a, const Moment& b) {
    for (const Moment* m : {&a, &b}) {
        if (m->carriers.size() != 1 && m->carriers.size() != m->binding->size()) {
            throw std::invalid_argument(
                "child_motion: need one carrier per child, or one for all");
        }
    }
    if (a.profiles->count != b.profiles->count ||
        a.profiles->size() != b.profiles->size() ||
        a.binding->size() != b.binding->size()) {
        throw std::invalid_argument("child_motion: the moments are not of one groom");
    }
}

}  // namespace

ChildMotion child_motion(const Moment& a, const Moment& b, Blend blend, std::size_t i) {
    validate(a, b);
    const ChildAtTime before(a, blend, i), after(b, blend, i);
    ChildMotion out;
    for (std::size_t j = 0; j < before.places(); ++j) {
        out.child = std::max(out.child, (after.place(j) - before.place(j)).norm());
        for (std::size_t k = 0; k < before.guides(); ++k) {
            const Vec3 step = after.guide_place(k, j) - before.guide_place(k, j);
            out.guides = std::max(out.guides, step.norm());
        }
    }
    if (const auto limit = amplification_limit(blend)) out.limit = *limit * out.guides;
    const BlendTraits& traits = traits_of(blend);
    if (traits.anchored && traits.rates == BlendRates::copied) {
        const BoundChild<double> from = before.carried(), to = after.carried();
        out.limit = anchored_motion_limit(
            {from.child(), to.child(), before.profiles(), after.profiles()});
    }
    return out;
}

MotionReport check_motion(const Moment& a, const Moment& b, Blend blend) {
    validate(a, b);
    std::vector<ChildMotion> motions(a.binding->size());
    cancellable_for(std::size_t(0), motions.size(),
                    [&](std::size_t i) { motions[i] = child_motion(a, b, blend, i); });
    MotionReport out;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const ChildMotion& m = motions[i];
        const double amplification = std::isnan(m.child) || std::isnan(m.guides)
                                         ? std::numeric_limits<double>::infinity()
                                         : m.amplification();
        if (i == 0 || amplification > out.amplification) {
            out.amplification = amplification;
            out.child = a.binding->roots.id(i);
            out.motion = m;
        }
        if (m.limit) {
            out.share_of_limit = worst_of(out.share_of_limit, m.share_of_limit());
        }
        out.largest_child = std::max(out.largest_child, m.child);
        out.largest_guides = std::max(out.largest_guides, m.guides);
    }
    return out;
}

std::optional<double> amplification_limit(Blend blend) {
    // A place is the weighted mean of the guides' places, and so is its motion.
    if (traits_of(blend).mean_places) return 1;
    return std::nullopt;
}

}  // namespace lancret
