#pragma once
// What lancret preview is asked for.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/frames.h"
#include "tools/options.h"
#include "tools/preview/check_views.h"

namespace lancret {

struct PreviewOptions {
    GroomOptions groom;
    FrameOptions frames;
    std::string size, shutter, lobes, output, deep, contact_sheet, view, view_range;
    std::optional<int> samples, motion_samples, turntable;
    std::optional<float> regularisation, noise;
    std::optional<double> lod;
    bool progressive = false, denoise = false, draft = false;
};

void add_preview_options(CLI::App& command, PreviewOptions& options);

/// The pictures to write: one a frame, or one a view of a turntable. Throws InputError
/// where one of the outputs cannot be written or options do not go together.
std::vector<PictureFiles> outputs_of(const PreviewOptions& options, const Job& job,
                                     const ChosenFrames& chosen);

/// The options laid over what the groom says of its picture. Throws InputError.
void set_override(const PreviewOptions& options, const ChosenFrames& chosen,
                  PreviewSettings& settings);

/// The check view that is asked for, if any. Throws InputError.
std::optional<ViewRequest> view_request(const PreviewOptions& options);

}  // namespace lancret
