#include "tools/preview/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "guides/base/errors.h"

namespace lancret {

namespace {

/// Paths per pixel of a draft: a quarter of those of a clean picture, and enough to
/// estimate the variance for denoising.
constexpr int kDraftSamples = 4;

/// "A,B", two numbers.
std::optional<Vec2> parse_pair(const std::string& text) {
    Vec2 out;
    const std::size_t comma = std::min(text.find(','), text.size());
    const bool good = CLI::detail::lexical_cast(text.substr(0, comma), out.x()) &&
                      comma < text.size() &&
                      CLI::detail::lexical_cast(text.substr(comma + 1), out.y());
    if (!good) return std::nullopt;
    return out;
}

/// "0,0.5" or "-0.25,0.25". Throws InputError.
Vec2 parse_shutter(const std::string& text) {
    const std::optional<Vec2> out = parse_pair(text);
    if (!out || !is_shutter(*out)) {
        throw InputError(fmt::format(
            "--shutter: invalid shutter '{}': expected the times at which it opens and "
            "closes, in frames after the frame, such as 0,0.5",
            text));
    }
    return *out;
}

/// Throws InputError if an option of light is combined with a view, which traces none.
void refuse_with_view(const PreviewOptions& options) {
    if (options.view.empty()) return;
    const std::pair<bool, const char*> of_light[] = {
        {!options.deep.empty(), "--deep"},
        {options.denoise, "--denoise"},
        {options.draft, "--draft"},
        {options.noise.has_value(), "--noise"}};
    for (const auto& [given, name] : of_light) {
        if (given) {
            throw InputError(
                fmt::format("{}: applies to pictures of light, but --view {} shows "
                            "figures; remove one "
                            "of them",
                            name, options.view));
        }
    }
}

}  // namespace

std::vector<PictureFiles> outputs_of(const PreviewOptions& options, const Job& job,
                                     const ChosenFrames& chosen) {
    std::vector<PictureFiles> out;
    const bool several = chosen.frames.size() > 1;
    if (options.turntable && several) {
        throw InputError(
            "--turntable: shows a single frame; use --frame instead of --frames");
    }
    if (options.progressive && !options.deep.empty()) {
        throw InputError("--deep: is written once, at the end; remove --progressive");
    }
    refuse_with_view(options);
    const auto add = [&](const auto& path_of) {
        out.push_back({path_of(options.output), options.deep.empty()
                                                    ? std::filesystem::path()
                                                    : path_of(options.deep)});
    };
    for (int view = 1; view <= options.turntable.value_or(0); ++view) {
        add([&](const std::string& name) { return picture_path(name, view, true); });
    }
    for (const double frame : chosen.frames) {
        if (options.turntable) break;
        add([&](const std::string& name) {
            return options.frames.given() ? picture_path(name, frame, several)
                                          : std::filesystem::path(name);
        });
    }
    const std::filesystem::path sheet = options.contact_sheet;
    if (!sheet.empty() && !options.turntable && options.frames.frames.empty()) {
        throw InputError(
            "--contact-sheet: needs several pictures; add --frames or --turntable");
    }
    check_output(sheet, {".png"}, job.inputs, options.groom.stats);
    for (const auto& [picture, deep] : out) {
        check_output(picture, {".exr", ".png"}, job.inputs, sheet);
        check_output(deep, {".exr"}, job.inputs, picture);
        check_output(options.groom.stats, {}, job.inputs, picture);
        check_output(options.groom.stats, {}, job.inputs, deep);
    }
    return out;
}

void set_override(const PreviewOptions& options, const ChosenFrames& chosen,
                  PreviewSettings& settings) {
    RenderSettings& render = settings.render;
    if (!options.size.empty()) {
        std::tie(render.width, render.height) = parse_size(options.size);
    }
    if (!options.view.empty()) {
        // One instant, in focus, on a dark background; a view has little noise.
        render.samples = 8;
        render.noise = 0;
        settings.shutter.reset();
        settings.camera.f_stop.reset();
        settings.min_width = 0;
        settings.background = Vec3f::Constant(0.012f);
    }
    settings.denoise = options.denoise || options.draft;
    if (options.draft) render.samples = kDraftSamples, render.noise = 0;
    if (options.samples) render.samples = *options.samples;
    if (options.noise) {
        render.noise = *options.noise;
        if (!settings.samples_given) render.samples = kMaxAdaptiveSamples;
    }
    if (settings.denoise && render.samples < 2) {
        throw InputError(
            "--denoise and --draft: noise cannot be estimated from one sample per pixel; "
            "use --samples 2 or more");
    }
    if (options.regularisation) settings.regularisation = *options.regularisation;
    assign_if(render.path.lobes, value_named(kLobeWidthNames, options.lobes));
    if (options.motion_samples) settings.motion_samples = *options.motion_samples;
    if (options.shutter.empty()) return;
    settings.shutter = parse_shutter(options.shutter);
    if (chosen.cache.empty()) {
        throw InputError("--shutter: only a cache (.h5) moves; simulate one first");
    }
}

std::optional<ViewRequest> view_request(const PreviewOptions& options) {
    if (options.view.empty()) return std::nullopt;
    ViewRequest out{*value_named(kViewNames, options.view), std::nullopt};
    if (options.view_range.empty()) return out;
    out.range = parse_pair(options.view_range);
    // Written so that NaN is refused.
    if (!out.range || !(out.range->x() < out.range->y()) ||
        !(out.range->cwiseAbs().maxCoeff() <= 1e30)) {
        throw InputError(fmt::format(
            "--view-range: invalid range '{}': expected two numbers, the smaller first, "
            "such as 0,2.5",
            options.view_range));
    }
    check_range(out);
    return out;
}

namespace {

void add_picture_options(CLI::App& command, PreviewOptions& options) {
    command.add_option("--samples", options.samples, "paths per pixel")
        ->type_name("N")
        ->check(CLI::Range(1, 65536));
    command
        .add_option("--noise", options.noise,
                    "render until the picture has this relative noise, each pixel with "
                    "as many paths as it needs, at most --samples (default 1024)")
        ->type_name("N")
        ->check(number_between(0.001, 10.0));
    command
        .add_option("--lod", options.lod,
                    "level of detail: at most this many strands per pixel that a chunk "
                    "of hair covers; fewer strands are drawn wider")
        ->type_name("N")
        ->check(number_between(1e-6, 1e6));
    command.add_option("--size", options.size, "picture size in pixels")
        ->type_name("WxH")
        ->check(not_empty());
    command
        .add_flag("--draft", options.draft,
                  "fast preview: 4 paths per pixel, denoised; softens shadows between "
                  "strands")
        ->excludes("--noise");
    command.add_flag("--progressive", options.progressive,
                     "write the picture at 1, 2, 4, ... samples per pixel");
    command.add_flag("--denoise", options.denoise,
                     "denoise, guided by coverage, normals, tangents and depth");
}

void add_time_options(CLI::App& command, PreviewOptions& options) {
    add_frames_options(command, options.frames);
    command
        .add_option("--shutter", options.shutter,
                    "motion blur: when the shutter opens and closes, in frames after the "
                    "frame")
        ->type_name("A,B")
        ->check(not_empty());
    command
        .add_option("--motion-samples", options.motion_samples,
                    "times within the shutter at which strands are grown")
        ->type_name("N")
        ->check(CLI::Range(2, int(kMaxSceneTimes)));
    command
        .add_option("--turntable", options.turntable,
                    "number of views evenly spaced around the groom, which is grown "
                    "once; pictures are numbered")
        ->type_name("N")
        ->check(CLI::Range(2, 100000));
}

void add_light_options(CLI::App& command, PreviewOptions& options) {
    command
        .add_option("--regularisation", options.regularisation,
                    "minimum roughness of hair after a path's first scattering: reduces "
                    "noise, brightens slightly; default 0.5, 0 for a reference")
        ->type_name("R")
        ->check(number_between(0, 1));
    const auto lobes = names_of(kLobeWidthNames);
    command
        .add_option("--lobes", options.lobes,
                    "scattering across a strand: 'near' by the offset of each ray, 'far' "
                    "the mean over offsets, 'auto' the mean for strands thinner than a "
                    "pixel")
        ->check(CLI::IsMember(std::vector<std::string>(lobes.begin(), lobes.end())));
}

void add_view_options(CLI::App& command, PreviewOptions& options) {
    const auto views = names_of(kViewNames);
    CLI::Option* view =
        command
            .add_option("--view", options.view,
                        "show a figure of every strand in false colours instead of hair")
            ->type_name("NAME")
            ->check(CLI::IsMember(std::vector<std::string>(views.begin(), views.end())))
            ->excludes("--shutter")
            ->excludes("--motion-samples");
    command
        .add_option("--view-range", options.view_range,
                    "values at the ends of the view's colour scale")
        ->type_name("A,B")
        ->check(not_empty())
        ->needs(view);
}

void add_output_options(CLI::App& command, PreviewOptions& options) {
    command
        .add_option("--deep", options.deep,
                    "also write a deep image (.exr) with strands at their depths")
        ->type_name("FILE")
        ->check(not_empty());
    command
        .add_option("--contact-sheet", options.contact_sheet,
                    "also write all pictures as one contact sheet (with --frames or "
                    "--turntable)")
        ->type_name("PNG")
        ->check(not_empty());
    command
        .add_option("-o,--output", options.output,
                    "output picture: .exr or .png; for several frames, head.####.png")
        ->required()
        ->type_name("FILE")
        ->check(not_empty());
}

}  // namespace

void add_preview_options(CLI::App& command, PreviewOptions& options) {
    add_groom_options(command, options.groom);
    add_picture_options(command, options);
    add_light_options(command, options);
    add_time_options(command, options);
    add_view_options(command, options);
    add_output_options(command, options);
    command.footer(
        "Examples:\n"
        "  lancret preview examples/made_groom.toml -o head.png\n"
        "  lancret preview groom.hair --scalp head.obj --guides 400 --strands 100000 -o "
        "head.exr\n"
        "  lancret preview cache.h5 --frames 1-96 -o head.####.png\n"
        "  lancret preview cache.h5 --frame 12 --shutter 0,0.5 -o blurred.png\n"
        "  lancret preview groom.toml --turntable 48 -o turn.####.png\n"
        "  lancret preview groom.toml --view curvature -o curvature.png\n"
        "  lancret preview groom.toml --progressive -o window.png\n"
        "  lancret preview groom.toml --noise 0.1 -o even.exr\n"
        "  lancret preview groom.toml -o head.exr --deep head_deep.exr\n"
        "  lancret preview groom.toml --draft -o draft.png\n"
        "  lancret preview groom.hair --guides 5% --strands 5000 --size 640x640 "
        "--samples 16 "
        "-o quick.png");
}

}  // namespace lancret
