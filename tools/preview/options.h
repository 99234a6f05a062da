#pragma once
// The options of lancret preview.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/frames.h"
#include "tools/job.h"
#include "tools/options.h"
#include "tools/preview/picture.h"
#include "tools/preview/view_request.h"

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

/// The pictures to write: one per frame, or one per view of a turntable. Throws
/// InputError if an output cannot be written or options contradict each other.
std::vector<PictureFiles> outputs_of(const PreviewOptions& options, const Job& job,
                                     const ChosenFrames& chosen);

/// Overrides a groom's picture settings by the options. Throws InputError.
void set_override(const PreviewOptions& options, const ChosenFrames& chosen,
                  PreviewSettings& settings);

/// The requested check view, if any. Throws InputError.
std::optional<ViewRequest> view_request(const PreviewOptions& options);

}  // namespace lancret
