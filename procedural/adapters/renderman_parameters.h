#pragma once
// The string that RenderMan hands to ConvertParameters, read:
//
//     head.toml frame=12 samples=0,0.5 strands.count=5000 strands.blend='detail'
//
// Words are parted by spaces; a value with spaces stands in ' ' or " ". The first word
// without = is the groom's file; a name with a dot is one of the groom's own parameters,
// laid over the file; docs/plugin.md has the others.

#include <string>
#include <string_view>
#include <vector>

#include "procedural/lancret_procedural.h"

namespace lancret {

/// One of the groom's own parameters.
struct GroomValue {
    std::string name, text;
    double number = 0;
    bool is_text = false;
};

struct RendermanParameters {
    std::string file;
    std::vector<GroomValue> values;

    std::vector<double> times;  ///< frame + samples; none: at rest, of a cache its
                                ///< first frame
    std::vector<float> motion;  ///< [times] where the renderer's motion blocks have them
    int basis = LANCRET_BSPLINE;
    float max_error = 0;           ///< units; 0: the groom's own
    double density = 0;            ///< 0: the groom's own
    double strands_per_pixel = 0;  ///< 0: no level of detail
    double min_density = 0.01;   ///< that level of detail may come to
    lancret_u32 attributes = 0;
    lancret_u32 chunk_strands = 4096;
    float unit = 1;   ///< cm of a unit of the scene
    int threads = 0;  ///< of one call; 0: as many as the machine has
    int bound = LANCRET_REACH;
};

/// Throws std::invalid_argument with what is wrong and where.
RendermanParameters read_parameters(std::string_view text);

}  // namespace lancret
