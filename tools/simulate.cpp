// lancret simulate: guides in, guides in time out.

#include "tools/subcommands.h"

#include <fmt/format.h>

#include <memory>

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

/// A number that tells contents apart.
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

/// What decides the frames of a run, as a text.
std::string job_text(const SimulateOptions& options, const Job& job,
                     const PlacedGuides& source, int first) {
    Fingerprint print;
    const Guides& guides = source.guides;
    print.add(std::span<const double>(guides.segment_lengths));
    for (const auto* vectors : {&guides.root_positions, &guides.curvatures}) {
        print.add(std::span(vectors->front().data(), 3 * vectors->size()));
    }
    print.add(std::span(guides.root_frames.front().data(), 9 * guides.size()));
    if (source.scalp) print.add(source.scalp->mesh);
    if (source.body) print.add(*source.body);
    for (const ColliderSettings& collider : job.dynamics.colliders) {
        const auto* file = std::get_if<std::filesystem::path>(&collider.shape);
        if (file) print.add(read_obj(*file));
    }
    print.add(std::span<const char>(job.settings_text));
    // Files of a sequence by what they were last written: reading them all would take as
    // long as the frames.
    const ObjSequence& files = job.dynamics.motion.files;
    for (int frame = files.first; !files.pattern.empty() && frame <= files.last;
         ++frame) {
        std::error_code missing;  // is told when the frame is read
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

int simulate_groom(const SimulateOptions& options) {
    if (!(options.fps >= 1)) throw InputError("--fps: is no number of frames");
    Job job = read_job(options.groom);
    check_output(options.output, {".h5"}, job.inputs);
    check_output(options.groom.stats, {}, job.inputs, options.output);
    const auto [first, last] = parse_frames(options.frames, "--frames");
    if (options.substeps) job.dynamics.simulation.substeps = *options.substeps;

    StageLine line;
    const PlacedGuides source =
        groom_guides(job.groom, [&](const char* stage) { line.show(stage); });
    line.clear();
    for (const std::string& warning : source.warnings) {
        fmt::print(stderr, "lancret: warning: {}\n", warning);
    }
    Simulation simulation(
        source.guides, job.dynamics.simulation,
        simulation_scene(job.dynamics, source, job.groom.scene, options.fps), first);

    const std::size_t falling =
        job.dynamics.simulation.sag_free
            ? falling_guides(simulation.guides(), simulation.natural(),
                             simulation.section(), job.dynamics.simulation.gravity)
                  .size()
            : 0;
    GuideCacheHeader header;
    header.frames_per_second = options.fps;
    header.first_frame = first;
    header.groom = std::filesystem::absolute(job.groom.name).lexically_normal().string();
    FrameStore store(options.output, header, job_text(options, job, source, first),
                     source.guides, options.restart);
    if (falling > 0) {
        fmt::print(
            stderr,
            "lancret: {} of {} guides rest where a touch makes them fall: too soft "
            "for their shape (see [dynamics])\n",
            falling, source.guides.size());
    }
    if (store.frames_done() > 0) {
        const LastFrame at = store.last();
        fmt::print(stderr, "lancret: goes on after frame {}\n", at.number);
        simulation.resume(at.number, at.guides, at.arrays);
    } else {
        store.add(simulation.guides(), simulation.restart());
    }
    const int begun = first + store.frames_done() - 1;
    Stopwatch watch;
    ProgressBar bar("simulate");
    SimulationReport total;
    double deepest = 0;
    int deepest_frame = first;
    for (int frame = begun; frame < last; ++frame) {
        simulation.advance();
        store.add(simulation.guides(), simulation.restart());
        const SimulationReport report = simulation.take_report();
        add(total, report);
        if (report.deepest > deepest) {
            deepest = report.deepest;
            deepest_frame = frame + 1;
        }
        bar.show(double(frame + 1 - begun) / (last - begun));
    }
    const double seconds = watch.lap();
    store.finish();

    const std::size_t frames = std::size_t(std::max(last - begun, 0));
    nlohmann::json stats;
    stats["frames"] = {
        {"first", first}, {"last", std::max(last, begun)}, {"simulated", frames}};
    stats["guides"] = source.guides.size();
    stats["segments"] = source.guides.segments;
    stats["falling_guides"] = falling;
    stats["guides_in_bodies"] = simulation.guides_in_bodies();
    stats["seconds"] = {{"load", source.seconds.load},
                        {"fit", source.seconds.fit},
                        {"simulate", seconds}};
    stats["steps"] = total.steps;
    stats["iterations"] = total.iterations;
    stats["unconverged_steps"] = total.unconverged;
    stats["unsolved_steps"] = total.unsolved;
    stats["largest_local_error_cm"] = total.largest_error;
    stats["deepest_penetration_cm"] = deepest;
    stats["deepest_penetration_frame"] = deepest_frame;
    write_stats(options.groom.stats, std::move(stats));
    std::string troubles;
    if (total.unsolved) troubles += fmt::format("; {} steps failed", total.unsolved);
    // A few that end a little above the tolerance are of no account.
    if (total.unconverged > total.steps / 100) {
        troubles += fmt::format("; {:.1f} % of steps did not converge",
                                100. * double(total.unconverged) / double(total.steps));
    }
    fmt::print(
        "{}: {} guides of {} segments, frames {}-{}; {} simulated in {:.2f} s{}; deepest "
        "penetration in them {:.4f} cm{}\n",
        options.output, source.guides.size(), source.guides.segments, first,
        std::max(last, begun), frames, seconds,
        total.steps ? fmt::format(" ({:.1f} us a guide's step, all threads)",
                                  seconds * 1e6 / double(total.steps))
                    : "",
        deepest, troubles);
    return kFine;
}

}  // namespace

void add_simulate(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<SimulateOptions>();
    CLI::App* command = app.add_subcommand(
        "simulate", "Move a groom's guides with its head: a cache of frames");
    add_groom_options(*command, options->groom);
    command->add_option("--frames", options->frames, "to simulate, the first at rest")
        ->type_name("A-B")
        ->capture_default_str()
        ->check(not_empty());
    command->add_option("--fps", options->fps, "frames a second")
        ->type_name("N")
        ->capture_default_str()
        ->check(number_between(1, 10000));
    command->add_option("--substeps", options->substeps, "of a frame")
        ->type_name("N")
        ->check(CLI::Range(1, 1000));
    command->add_flag("--restart", options->restart,
                      "begin anew where an unfinished run lies");
    command->add_option("-o,--output", options->output, "the cache: .h5")
        ->required()
        ->type_name("FILE")
        ->check(not_empty());
    command->footer(
        "A run that was killed goes on when the same command is given again.\n"
        "The head's motion, hair and colliders are said in the groom's TOML.\n"
        "Examples:\n"
        "  lancret simulate examples/made_groom.toml --frames 1-96 -o cache.h5\n"
        "  lancret preview cache.h5 --frames 1-96 -o head.####.png\n"
        "  lancret check cache.h5");
    command->callback([options, &exit_code] { exit_code = simulate_groom(*options); });
}

}  // namespace lancret
