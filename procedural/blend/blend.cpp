#include "procedural/blend/blend.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

namespace lancret {

namespace {

constexpr BlendTraits kBlends[] = {
    {.blend = Blend::detail,
     .name = "detail",
     .in_float = blend_detail<float>,
     .in_double = blend_detail<double>,
     .rates = BlendRates::copied,
     .anchored = true,
     .has_torsion = true,
     .keeps_hull = false,
     .mean_places = false,
     .ends = Ends::helix,
     .kernel = BlendKernel::curl},
    {.blend = Blend::option1,
     .name = "option1",
     .in_float = blend_option1<float>,
     .in_double = blend_option1<double>,
     .rates = BlendRates::blended,
     .anchored = false,
     .has_torsion = true,
     .keeps_hull = true,
     .mean_places = false,
     .ends = Ends::helix,
     .kernel = BlendKernel::curl},
    {.blend = Blend::option1_anchored,
     .name = "option1-anchored",
     .in_float = blend_option1_anchored<float>,
     .in_double = blend_option1_anchored<double>,
     .rates = BlendRates::blended,
     .anchored = true,
     .has_torsion = true,
     .keeps_hull = false,
     .mean_places = false,
     .ends = Ends::helix,
     .kernel = BlendKernel::curl},
    {.blend = Blend::option2,
     .name = "option2",
     .in_float = blend_option2<float>,
     .in_double = blend_option2<double>,
     .rates = BlendRates::none,
     .anchored = false,
     .has_torsion = true,
     .keeps_hull = false,
     .mean_places = false,
     .ends = Ends::helix,
     .kernel = BlendKernel::none},
    {.blend = Blend::option3,
     .name = "option3",
     .in_float = blend_option3<float>,
     .in_double = blend_option3<double>,
     .rates = BlendRates::none,
     .anchored = false,
     .has_torsion = false,
     .keeps_hull = false,
     .mean_places = false,
     .ends = Ends::helix,
     .kernel = BlendKernel::none},
    {.blend = Blend::bishop,
     .name = "bishop",
     .in_float = blend_bishop<float>,
     .in_double = blend_bishop<double>,
     .rates = BlendRates::none,
     .anchored = false,
     .has_torsion = true,
     .keeps_hull = false,
     .mean_places = false,
     .ends = Ends::helix,
     .kernel = BlendKernel::none},
    {.blend = Blend::nearest,
     .name = "nearest",
     .in_float = blend_nearest<float>,
     .in_double = blend_nearest<double>,
     .rates = BlendRates::copied,
     .anchored = false,
     .has_torsion = true,
     .keeps_hull = false,
     .mean_places = false,
     .ends = Ends::helix,
     .kernel = BlendKernel::curl},
    {.blend = Blend::position,
     .name = "position",
     .in_float = blend_position<float>,
     .in_double = blend_position<double>,
     .rates = BlendRates::none,
     .anchored = false,
     .has_torsion = false,
     .keeps_hull = false,
     .mean_places = true,
     .ends = Ends::parabola,
     .kernel = BlendKernel::position},
};

}  // namespace

std::span<const BlendTraits> blends() { return kBlends; }

const BlendTraits& traits_of(Blend blend) {
    const auto found = std::ranges::find(kBlends, blend, &BlendTraits::blend);
    assert(found != std::end(kBlends));
    return *found;
}

std::string_view blend_name(Blend blend) { return traits_of(blend).name; }

std::optional<Blend> blend_named(std::string_view name) {
    const auto found = std::ranges::find(kBlends, name, &BlendTraits::name);
    if (found == std::end(kBlends)) return std::nullopt;
    return found->blend;
}

template <class T>
BlendFunction<T> blend_function(Blend blend) {
    const BlendTraits& traits = traits_of(blend);
    if constexpr (std::is_same_v<T, float>) {
        return traits.in_float;
    } else {
        return traits.in_double;
    }
}

template BlendFunction<float> blend_function(Blend);
template BlendFunction<double> blend_function(Blend);

}  // namespace lancret
