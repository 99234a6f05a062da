#include "tools/preview/shown_times.h"

#include <algorithm>
#include <array>

#include "guides/base/stopwatch.h"
#include "render_test/scene/strand_width.h"
#include "render_test/scene/thin_strands.h"
#include "tools/progress.h"

namespace lancret {

namespace {

/// Makes all strands round, at all times, if one is wide in any picture.
void choose_shape(const StrandDrawing& drawing, std::vector<ShownTime>& moments) {
    const auto wide = [&](const ShownTime& m) {
        return any_wider(m.curves, drawing.cameras, drawing.height, kFlatPixels);
    };
    if (!std::ranges::any_of(moments, wide)) return;
    for (ShownTime& m : moments) m.curves.shape = CurveShape::round;
}

}  // namespace

std::vector<ShownTime> grow(const PluginGroom& groom, const PluginStrands& strands,
                            const std::vector<double>& times,
                            const StrandDrawing& drawing, PictureCost& cost) {
    StageLine line;
    line.show("expand");
    Stopwatch watch;
    std::vector<Curves> curves = strands.curves();
    cost.expand = watch.lap();
    line.clear();
    std::vector<ShownTime> out;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (drawing.shape) curves[i].shape = *drawing.shape;
        out.push_back({times[i], std::move(curves[i]), groom.head(times[i]), {}});
    }
    if (!drawing.shape) choose_shape(drawing, out);
    if (!(drawing.min_width > 0)) return out;
    for (ShownTime& m : out) {
        m.true_radii = widen_thin_strands(m.curves, drawing.cameras, drawing.height,
                                          drawing.min_width);
    }
    return out;
}

std::vector<SceneTime> scene_times(const std::vector<ShownTime>& moments) {
    std::vector<SceneTime> out;
    for (const ShownTime& m : moments) {
        out.push_back({&m.curves, m.body ? &*m.body : nullptr});
    }
    return out;
}

bool is_unchanged(const std::vector<ShownTime>& moments, const PluginGroom& groom,
                  const std::vector<double>& times) {
    if (moments.size() != times.size()) return false;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!groom.is_still(std::array{moments[i].frame, times[i]})) return false;
    }
    return true;
}

}  // namespace lancret
