#pragma once
// A check view as requested on the command line.

#include <optional>
#include <string_view>

#include "guides/base/named.h"
#include "guides/base/types.h"

namespace lancret {

enum class View {
    length_error,   ///< relative, of the strand as synthesised, up to the limit of the
                    ///< check
    orthogonality,  ///< of the frames, up to the limit of the check
    curvature,      ///< 1/cm
    torsion,        ///< 1/cm
    influence,    ///< the guides that a strand follows: one colour each, mixed by weight
    region,       ///< scalp region of the root
    penetration,  ///< greatest depth of the strand below the surface, cm
};

inline constexpr Named<View> kViewNames[] = {
    {View::length_error, "length-error"}, {View::orthogonality, "orthogonality"},
    {View::curvature, "curvature"},       {View::torsion, "torsion"},
    {View::influence, "influence"},       {View::region, "region"},
    {View::penetration, "penetration"}};

std::string_view view_name(View view);
/// Whether values have a colour scale, instead of one colour per category.
bool has_scale(View view);
/// Whether the figure is an error that `lancret check` limits.
bool is_error(View view);

/// A view and its range.
struct ViewRequest {
    View view = View::curvature;
    std::optional<Vec2> range;  ///< ends of the colour scale; unset: by the view
};

/// Throws InputError if the view has no scale or its scale cannot have the range.
void check_range(const ViewRequest& request);

}  // namespace lancret
