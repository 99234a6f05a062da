#include "render_test/scene/hit.h"

#include <cmath>

namespace lancret {

float StrandSection::half_width() const {
    const float c = std::cos(angle), s = aspect * std::sin(angle);
    return std::sqrt(c * c + s * s);
}

}  // namespace lancret
