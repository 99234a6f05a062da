#pragma once
// Figures of strands as false colours: what check measures, where a groomer can see it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "procedural/curves/strand_values.h"
#include "render_test/scene/embree_scene.h"

namespace lancret {

struct RayCounter;

/// How a figure becomes a colour.
struct ColourScale {
    enum class Kind {
        sequential,  ///< linear from low to high
        diverging,   ///< linear, its middle a neutral grey
        logarithmic  ///< low > 0
    };
    Kind kind = Kind::sequential;
    float low = 0, high = 1;     ///< low < high; what is beyond has the colour of the end
    std::string over;            ///< what is above `high` is red and is called so; empty:
                                 ///< it is not told apart
    std::optional<float> clean;  ///< what is at most this is grey: nothing to see
};

/// Where `value` is on the scale, 0..1.
float scale_place(const ColourScale& scale, float value);
/// The colour at a place of the scale, 0..1.
Vec3f scale_colour_at(const ColourScale& scale, float place);
/// The colour of a value: that at its place, red or grey.
Vec3f scale_colour(const ColourScale& scale, float value);

/// A colour with a name.
struct Swatch {
    std::string name;
    Vec3f colour;
};

/// Some of a scene's strands as a scene of their own, with its mesh.
struct StrandsApart {
    std::vector<std::uint32_t> strands;  ///< their numbers in the whole
    Curves curves;
    std::optional<HairScene> scene;
};

/// One figure of a groom and how it is shown.
struct CheckView {
    std::string title;               ///< with the unit
    ColourScale scale;               ///< where there are no colours of strands
    StrandValues values;             ///< of the strands in the scene
    std::vector<std::uint32_t> ids;  ///< of these; or empty: their numbers
    std::vector<Vec3f> colours;    ///< [strands], linear: in place of the scale; or empty
    std::vector<Swatch> swatches;  ///< for the legend of these
    /// Strands that show through all that is clean and through the mesh's surface; none:
    /// nothing does.
    std::shared_ptr<const StrandsApart> apart;
};

/// How bright a strand is that runs at right angles to the sight is at its middle: its
/// colour itself. Seen along it, or at its sides, it is no darker than this share.
inline constexpr float kMinShade = 0.3f;

/// What is seen at `hit`, which `ray` met: the strand's colour, darker where it turns
/// away; the mesh in dark grey. No light is traced.
Vec3f view_radiance(const CheckView& view, const Ray& ray, const Hit& hit,
                    RayCounter& counter);

/// The strands that are not clean everywhere, of those that `view` has values of. `mesh`
/// may be null; `aspect` is HairSceneOptions'.
std::shared_ptr<const StrandsApart> strands_apart(const CheckView& view,
                                                  const Curves& curves,
                                                  const TriangleMesh* mesh,
                                                  float aspect = 1);

/// The raw figure there; 0 on a mesh.
float view_value(const CheckView& view, const Hit& hit);

}  // namespace lancret
