#pragma once
// The stages in which a groom is prepared, for progress and timings.

#include <functional>
#include <string_view>

namespace lancret {

enum class GroomStage { load, fit, bind, cut };

/// The stages by their order in GroomStage.
inline constexpr std::string_view kGroomStageNames[] = {"load", "fit", "bind",
                                                        "cut into chunks"};

constexpr std::string_view stage_name(GroomStage stage) {
    return kGroomStageNames[int(stage)];
}

/// Called when a stage begins.
using StageCallback = std::function<void(GroomStage stage)>;

/// Wall time of the stages, s. `bind` includes cutting into chunks.
struct StageSeconds {
    double load = 0, fit = 0, bind = 0;
};

}  // namespace lancret
