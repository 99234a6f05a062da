#pragma once
// The check views of lancret preview: their figures and colour scales.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "render_test/trace/check_view.h"
#include "tools/job.h"
#include "tools/preview/shown_times.h"

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
    std::optional<Vec2>
        range;  ///< at the ends of the colour scale; unset: chosen by the view
};

/// Throws InputError if the view has no scale or its scale cannot have the range.
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

/// Keeps the scale of the view for later pictures, unless a range was requested.
void keep_range(const CheckView& view, ViewRequest& request);

/// Greatest depth of each emitted curve below `surface`, cm, [strands]; 0 if it is
/// outside. Tests both ends and the middle of every segment.
StrandValues penetration_values(const Curves& curves, const TriangleMesh& surface);

/// The largest figure, its strand, and the number of strands above the limit: as a line,
/// and for --stats.
std::string view_line(const ViewRequest& request, const CheckView& view);
nlohmann::json view_json(const ViewRequest& request, const CheckView& view);

}  // namespace lancret
