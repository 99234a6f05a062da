#include "procedural/blend/blend.h"

#include <algorithm>
#include <cassert>

namespace lancret {

std::string_view blend_name(Blend blend) {
    const auto at = std::ranges::find(kBlendNames, blend, &BlendName::blend);
    assert(at != std::end(kBlendNames));
    return at->name;
}

bool has_torsion(Blend blend) {
    return blend != Blend::position && blend != Blend::option3;
}

std::optional<Blend> blend_named(std::string_view name) {
    const auto at = std::ranges::find(kBlendNames, name, &BlendName::name);
    if (at == std::end(kBlendNames)) return std::nullopt;
    return at->blend;
}

template <class T>
BlendFunction<T> blend_function(Blend blend) {
    switch (blend) {
        case Blend::detail:
            return blend_detail<T>;
        case Blend::option1:
            return blend_option1<T>;
        case Blend::option1_anchored:
            return blend_option1_anchored<T>;
        case Blend::option2:
            return blend_option2<T>;
        case Blend::option3:
            return blend_option3<T>;
        case Blend::bishop:
            return blend_bishop<T>;
        case Blend::nearest:
            return blend_nearest<T>;
        case Blend::position:
            return blend_position<T>;
    }
    return nullptr;
}

template BlendFunction<float> blend_function(Blend);
template BlendFunction<double> blend_function(Blend);

}  // namespace lancret
