#include "tools/preview/view_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "guides/base/errors.h"

namespace lancret {

std::string_view view_name(View view) {
    return std::ranges::find(kViewNames, view, &Named<View>::value)->name;
}

bool has_scale(View view) { return view != View::influence && view != View::region; }

bool is_error(View view) {
    return view == View::length_error || view == View::orthogonality;
}

void check_range(const ViewRequest& request) {
    if (!request.range) return;
    // In single precision, as used: two doubles may be one float.
    const Eigen::Vector2f range = request.range->cast<float>();
    if (!(range.x() < range.y()) || !range.allFinite()) {
        throw InputError(
            "--view-range: the two numbers are too close to each other or too far from 1 "
            "for a scale of colours");
    }
    if (!has_scale(request.view)) {
        throw InputError(
            fmt::format("--view-range: view {} has no scale", view_name(request.view)));
    }
    if (is_error(request.view) && !(range.x() >= std::numeric_limits<float>::min())) {
        throw InputError(
            fmt::format("--view-range: the scale of {} is logarithmic and must begin at "
                        "1e-37 or more",
                        view_name(request.view)));
    }
}

}  // namespace lancret
