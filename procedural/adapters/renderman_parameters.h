#pragma once
// Parses the string that RenderMan passes to ConvertParameters:
//
//     head.toml frame=12 samples=0,0.5 strands.count=5000 strands.blend='detail'
//
// Words are separated by spaces; a value with spaces is quoted by ' or ". A word without
// = is the groom's file. A name with a dot overrides a setting of the groom.
// docs/plugin.md lists the other parameters.

#include <string>
#include <string_view>
#include <vector>

#include "procedural/lancret_procedural.h"

namespace lancret {

/// An override of a groom setting.
struct GroomValue {
    std::string name, text;
    double number = 0;
    bool is_text = false;
};

struct RendermanParameters {
    std::string file;
    std::vector<GroomValue> values;

    std::vector<double> times;  ///< frame + samples; empty: the first frame, or rest
    std::vector<float> motion;  ///< [times] the same as times of the motion block
    int basis = LANCRET_BSPLINE;
    float max_error = 0;           ///< units of the scene; 0: the groom's tolerance
    double density = 0;            ///< 0: the groom's density
    double strands_per_pixel = 0;  ///< 0: no level of detail
    double min_density = 0.01;     ///< lower limit of level of detail
    lancret_u32 attributes = 0;
    lancret_u32 chunk_strands = 4096;
    float unit = 1;   ///< of the scene, cm
    int threads = 0;  ///< per call; 0: all of the machine
    int bound = LANCRET_REACH;
};

/// Throws std::invalid_argument with the position and what was expected.
RendermanParameters read_parameters(std::string_view text);

}  // namespace lancret
