// lancret simulate: simulates guides and writes a cache of frames.

#include "tools/subcommands.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <tuple>

#include "guides/base/errors.h"
#include "guides/base/hash.h"
#include "guides/files/frame_store.h"
#include "guides/files/obj_file.h"
#include "sim/equilibrium/sag_free.h"
#include "tools/frames.h"
#include "tools/job.h"
#include "tools/options.h"
#include "tools/progress.h"
#include "tools/stats.h"

namespace lancret {

namespace {

struct SimulateOptions {
    GroomOptions groom;
    std::string frames = "1-96", output;
    double fps = 24;
    std::optional<int> substeps;
    bool restart = false;
};

/// A hash of the contents of a job.
class Fingerprint {
  public:
    template <class T>
    void add(std::span<const T> values) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
        const std::size_t size = values.size_bytes();
        add_word(size);
        for (std::size_t i = 0; i < size; i += 8) {
            std::uint64_t word = 0;
            for (std::size_t b = i; b < std::min(i + 8, size); ++b) {
                word = word << 8 | bytes[b];
            }
            add_word(word);
        }
    }
    void add(const TriangleMesh& mesh) {
        if (mesh.triangles.empty()) return;
        add(std::span(mesh.positions.front().data(), 3 * mesh.positions.size()));
        add(std::span(mesh.triangles.front().data(), 3 * mesh.triangles.size()));
    }
    std::uint64_t value() const { return value_; }

  private:
    void add_word(std::uint64_t word) { value_ = hash_bits(value_, word, 0); }
    std::uint64_t value_ = 0;
};

/// Everything that determines the frames of a run, as a text.
std::string job_text(const SimulateOptions& options, const Job& job,
                     const PlacedGuides& placed, int first) {
    Fingerprint print;
    const Guides& guides = placed.guides;
    print.add(std::span<const double>(guides.segment_lengths));
    for (const auto* vectors : {&guides.root_positions, &guides.curvatures}) {
        print.add(std::span(vectors->front().data(), 3 * vectors->size()));
    }
    print.add(std::span(guides.root_frames.front().data(), 9 * guides.size()));
    if (placed.scalp) print.add(placed.scalp->mesh);
    if (placed.body) print.add(*placed.body);
    for (const ColliderSettings& collider : job.dynamics.colliders) {
        const auto* file = std::get_if<std::filesystem::path>(&collider.shape);
        if (file) print.add(read_obj(*file));
    }
    print.add(std::span<const char>(job.settings_text));
    // The files of a sequence by size and modification time: reading them all would take
    // as long as the frames.
    const ObjSequence& files = job.dynamics.motion.files;
    for (int frame = files.first; !files.pattern.empty() && frame <= files.last;
         ++frame) {
        std::error_code missing;  // reported when the frame is read
        const auto file = frame_path(files.pattern, frame);
        const std::uint64_t written[] = {
            std::uint64_t(std::filesystem::file_size(file, missing)),
            std::uint64_t(std::filesystem::last_write_time(file, missing)
                              .time_since_epoch()
                              .count())};
        print.add(std::span<const std::uint64_t>(written));
    }
    return fmt::format(
        "{}, from frame {} at {} fps, {} substeps, method {}, contents {:016x}",
        job.groom.name, first, options.fps, job.dynamics.simulation.substeps,
        kSimulationMethod, print.value());
}

/// A job whose options are checked and whose guides are placed.
struct PreparedJob {
    Job job;
    int first = 0, last = 0;  ///< frame numbers
    PlacedGuides placed;
};

PreparedJob prepare(const SimulateOptions& options) {
    if (!(options.fps >= 1)) {
        throw InputError("--fps: expected a number of frames per second, at least 1");
    }
    PreparedJob out;
    out.job = read_job(options.groom);
    const GroomSettings& groom = out.job.groom;
    check_output(options.output, {".h5"}, out.job.inputs);
    check_output(options.groom.stats, {}, out.job.inputs, options.output);
    std::tie(out.first, out.last) = parse_frames(options.frames, "--frames");
    if (options.substeps) out.job.dynamics.simulation.substeps = *options.substeps;

    StageLine line;
    out.placed =
        place_guides(groom, [&](GroomStage stage) { line.show(stage_name(stage)); });
    line.clear();
    for (const std::string& warning : out.placed.report.warnings) {
        fmt::print(stderr, "lancret: warning: {}\n", warning);
    }
    return out;
}

GuideCacheHeader cache_header(const SimulateOptions& options,
                              const PreparedJob& prepared) {
    GuideCacheHeader header;
    header.frames_per_second = options.fps;
    header.first_frame = prepared.first;
    header.groom =
        std::filesystem::absolute(prepared.job.groom.name).lexically_normal().string();
    return header;
}

/// The number of guides that start in an unstable equilibrium.
std::size_t count_falling(const Simulation& simulation,
                          const SimulationSettings& settings) {
    if (!settings.sag_free) return 0;
    return falling_guides(simulation.guides(), simulation.natural(), simulation.section(),
                          settings.gravity)
        .size();
}

/// Statistics of the frames that were simulated.
struct FramesReport {
    int start_frame = 0;  ///< frame number of the state that the run started from
    SimulationReport total;
    double deepest = 0;     ///< cm
    int deepest_frame = 0;  ///< frame number
    double seconds = 0;
};

/// Simulates the frames that `store` does not have yet.
FramesReport run_frames(Simulation& simulation, FrameStore& store, int first, int last) {
    if (store.frames_done() > 0) {
        const LastFrame stored = store.last();
        fmt::print(stderr, "lancret: continuing after frame {}\n", stored.number);
        simulation.resume(stored.number, stored.guides, stored.arrays);
    } else {
        store.add(simulation.guides(), simulation.restart());
    }
    FramesReport out;
    out.start_frame = first + store.frames_done() - 1;
    out.deepest_frame = first;
    Stopwatch watch;
    ProgressBar bar("simulate");
    for (int frame = out.start_frame; frame < last; ++frame) {
        simulation.advance();
        store.add(simulation.guides(), simulation.restart());
        const SimulationReport report = simulation.take_report();
        add(out.total, report);
        if (report.deepest > out.deepest) {
            out.deepest = report.deepest;
            out.deepest_frame = frame + 1;
        }
        bar.show(double(frame + 1 - out.start_frame) / (last - out.start_frame));
    }
    out.seconds = watch.lap();
    return out;
}

nlohmann::json stats_of(const PreparedJob& prepared, const FramesReport& run) {
    const std::size_t frames = std::size_t(std::max(prepared.last - run.start_frame, 0));
    nlohmann::json stats;
    stats["frames"] = {{"first", prepared.first},
                       {"last", std::max(prepared.last, run.start_frame)},
                       {"simulated", frames}};
    stats["guides"] = prepared.placed.guides.size();
    stats["segments"] = prepared.placed.guides.segments;
    stats["seconds"] = {{"load", prepared.placed.report.seconds.load},
                        {"fit", prepared.placed.report.seconds.fit},
                        {"simulate", run.seconds}};
    stats["steps"] = run.total.steps;
    stats["iterations"] = run.total.iterations;
    stats["unconverged_steps"] = run.total.unconverged;
    stats["unsolved_steps"] = run.total.unsolved;
    stats["largest_local_error_cm"] = run.total.largest_error;
    stats["deepest_penetration_cm"] = run.deepest;
    stats["deepest_penetration_frame"] = run.deepest_frame;
    return stats;
}

void print_summary(const std::string& output, const PreparedJob& prepared,
                   const FramesReport& run) {
    const SimulationReport& total = run.total;
    std::string problems;
    if (total.unsolved) problems += fmt::format("; {} steps failed", total.unsolved);
    // A few steps that end a little above the tolerance do not matter.
    if (total.unconverged > total.steps / 100) {
        problems += fmt::format("; {:.1f} % of steps did not converge",
                                100. * double(total.unconverged) / double(total.steps));
    }
    fmt::print(
        "{}: {} guides of {} segments, frames {}-{}; {} simulated in {:.2f} s{}; deepest "
        "penetration {:.4f} cm{}\n",
        output, prepared.placed.guides.size(), prepared.placed.guides.segments,
        prepared.first, std::max(prepared.last, run.start_frame),
        std::max(prepared.last - run.start_frame, 0), run.seconds,
        total.steps ? fmt::format(" ({:.1f} us per step of one guide, all threads)",
                                  run.seconds * 1e6 / double(total.steps))
                    : "",
        run.deepest, problems);
}

int simulate_groom(const SimulateOptions& options) {
    const PreparedJob prepared = prepare(options);
    const Job& job = prepared.job;
    const DynamicsSettings& dynamics = job.dynamics;
    const Guides& guides = prepared.placed.guides;
    Simulation simulation(
        guides, dynamics.simulation,
        simulation_scene(dynamics, prepared.placed, job.groom.scene, options.fps),
        prepared.first);
    const std::size_t falling = count_falling(simulation, dynamics.simulation);
    FrameStore store(options.output, cache_header(options, prepared),
                     job_text(options, job, prepared.placed, prepared.first), guides,
                     options.restart);
    if (falling > 0) {
        fmt::print(stderr,
                   "lancret: {} of {} guides rest in an unstable equilibrium and may "
                   "fall; the material is too soft for their shape (see [dynamics])\n",
                   falling, guides.size());
    }
    const FramesReport run = run_frames(simulation, store, prepared.first, prepared.last);
    store.finish();

    nlohmann::json stats = stats_of(prepared, run);
    stats["falling_guides"] = falling;
    stats["guides_in_bodies"] = simulation.guides_in_bodies();
    write_stats(options.groom.stats, std::move(stats));
    print_summary(options.output, prepared, run);
    return kFine;
}

}  // namespace

void add_simulate(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<SimulateOptions>();
    CLI::App* command = app.add_subcommand(
        "simulate", "Simulate a groom's guides on its moving head; writes a frame cache");
    add_groom_options(*command, options->groom);
    command
        ->add_option("--frames", options->frames,
                     "frames to simulate; the first is at rest")
        ->type_name("A-B")
        ->capture_default_str()
        ->check(not_empty());
    command->add_option("--fps", options->fps, "frames per second")
        ->type_name("N")
        ->capture_default_str()
        ->check(number_between(1, 10000));
    command->add_option("--substeps", options->substeps, "steps per frame")
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    command->add_flag("--restart", options->restart,
                      "discard an unfinished run and start over");
    command->add_option("-o,--output", options->output, "cache of frames (.h5)")
        ->required()
        ->type_name("FILE")
        ->check(not_empty());
    command->footer(
        "An interrupted run continues when the same command is given again.\n"
        "The groom's TOML sets the head's motion, the material of the hair and the "
        "colliders.\n"
        "Examples:\n"
        "  lancret simulate examples/made_groom.toml --frames 1-96 -o cache.h5\n"
        "  lancret preview cache.h5 --frames 1-96 -o head.####.png\n"
        "  lancret check cache.h5");
    command->callback([options, &exit_code] { exit_code = simulate_groom(*options); });
}

}  // namespace lancret
