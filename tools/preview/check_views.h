#pragma once
// The check views of lancret preview: which figure, of which function, on which scale.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "render_test/trace/check_view.h"
#include "tools/job.h"
#include "tools/preview/shown_times.h"

namespace lancret {

enum class View {
    length_error,   ///< relative, of the strand as synthesised, up to the check's limit
    orthogonality,  ///< of the frames, up to the check's limit
    curvature,      ///< 1/cm
    torsion,        ///< 1/cm
    influence,      ///< which guides a strand follows, each a colour, mixed by weight
    region,         ///< of the scalp
    penetration,    ///< cm, of the strand's deepest place below the surface
};

struct ViewName {
    View view;
    std::string_view name;
};
inline constexpr ViewName kViewNames[] = {
    {View::length_error, "length-error"}, {View::orthogonality, "orthogonality"},
    {View::curvature, "curvature"},       {View::torsion, "torsion"},
    {View::influence, "influence"},       {View::region, "region"},
    {View::penetration, "penetration"}};

std::string_view view_name(View view);
std::optional<View> view_named(std::string_view name);

struct ViewRequest {
    View view = View::curvature;
    std::optional<Vec2> range;  ///< at the ends of the colours; none: by the view's kind
};

/// Throws InputError where the view has no scale or its scale cannot have the range.
void check_range(const ViewRequest& request);

/// The strands that a view shows. References must outlive it.
struct ViewSubject {
    const PluginGroom& plugin;
    const PluginStrands& strands;
    const ShownTime& shown;  ///< the first of their times
    const GroomSettings& groom;
    float aspect;  ///< of their section
};

/// Throws InputError if the groom lacks what the view shows.
CheckView view_of(const ViewRequest& request, const ViewSubject& subject);

/// Makes the view's scale that of the pictures to come, where nothing else was asked for.
void keep_range(const CheckView& view, ViewRequest& request);

/// cm, [strands]: how far the deepest place of each emitted curve is behind `surface`, 0
/// where it is nowhere. Looks at both ends and the middle of every segment.
StrandValues penetration_values(const Curves& curves, const TriangleMesh& surface);

/// The largest figure and where it is, how many strands are beyond the limit: as a line,
/// and for --stats.
std::string view_line(const ViewRequest& request, const CheckView& view);
nlohmann::json view_json(const ViewRequest& request, const CheckView& view);

}  // namespace lancret
