#pragma once
// From a groom's files to all that expansion needs.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "guides/scalp.h"
#include "procedural/groom.h"

namespace lancret {

/// Wall time of the stages, s.
struct StageSeconds {
    double load = 0, fit = 0, bind = 0;
};

/// A groom that is ready to expand. `guides` are at rest; for another time, make other
/// profiles from the guides of that time and keep the binding.
struct Generator {
    Groom groom;
    std::optional<Scalp> scalp;  ///< nothing where the groom has no surface
    Guides guides;
    std::vector<FitReport> fits;    ///< [guides]
    GuideProfiles<float> profiles;  ///< of `guides`
    Binding binding;
    StageSeconds seconds;
    std::size_t groom_strands = 0;      ///< in the groom's file
    std::size_t snapped_roots = 0;      ///< guides whose root was off the scalp
    double largest_snap = 0;            ///< cm
    std::vector<std::string> warnings;  ///< a line each
};

/// Names a stage as it begins.
using StageCallback = std::function<void(const char* stage)>;

/// Loads, chooses and fits guides, places and binds children. Throws InputError.
Generator make_generator(const Groom& groom, const StageCallback& stage = {});

/// The strands that a groom starts from, in cm, and its scalp, where it has one.
struct LoadedGroom {
    Strands strands;
    std::optional<TriangleMesh> scalp;
    std::vector<std::string> warnings;
};
LoadedGroom load_groom(const Groom& groom);

}  // namespace lancret
