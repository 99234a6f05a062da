#pragma once
// Figures of strands as false colours: the measurements of `lancret check`, as a picture.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "procedural/curves/strand_values.h"
#include "render_test/image/colour_scale.h"
#include "render_test/trace/rays.h"

namespace lancret {

/// A named colour.
struct Swatch {
    std::string name;
    Vec3f colour;
};

/// Some of a scene's strands as a scene of their own, with its mesh.
struct StrandsApart {
    std::vector<std::uint32_t> strands;  ///< their indices in the whole scene
    Curves curves;
    std::optional<HairScene> scene;
};

/// One figure of a groom and how it is shown.
struct CheckView {
    std::string title;               ///< with the unit
    ColourScale scale;               ///< used if `colours` is empty
    StrandValues values;             ///< of the strands in the scene
    std::vector<std::uint32_t> ids;  ///< of these strands; empty: their indices
    std::vector<Vec3f> colours;    ///< [strands], linear, instead of the scale; or empty
    std::vector<Swatch> swatches;  ///< legend of `colours`
    /// Strands that show through clean strands and through the mesh's surface; null: none
    /// does.
    std::shared_ptr<const StrandsApart> apart;
};

/// A strand at right angles to the view shows its colour unchanged at its middle. Seen
/// lengthwise or at its edges it darkens, down to this share.
inline constexpr float kMinShade = 0.3f;

/// The colour at `hit`, which `ray` met: that of the strand, darker where it turns away;
/// dark grey for the mesh. No light is traced.
Vec3f view_radiance(const CheckView& view, const Ray& ray, const Hit& hit,
                    RayCounter& counter);

/// The strands that are not clean over their whole length, among those for which `view`
/// has values. `mesh` may be null; `aspect` is that of HairSceneOptions.
std::shared_ptr<const StrandsApart> strands_apart(const CheckView& view,
                                                  const Curves& curves,
                                                  const TriangleMesh* mesh,
                                                  float aspect = 1);

/// The raw figure at a hit; 0 on a mesh.
float view_value(const CheckView& view, const Hit& hit);

}  // namespace lancret
