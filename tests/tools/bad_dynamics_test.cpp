// Invalid [dynamics], [motion] and [[colliders]], and outputs that cannot be written:
// each error is one line with the file and its line number.

#include <gtest/gtest.h>

#include "guides/files/guide_cache.h"
#include "tests/tools/simulate_runs.h"

namespace lancret {
namespace {

struct BadDynamics : SmallGrooms {
    CommandRun run(std::string_view text, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{
            "simulate", file("g.toml", text), "--frames", "1-2", "-o", at("c.h5")};
        words.insert(words.end(), more.begin(), more.end());
        return lancret(words);
    }
    /// Expects one line with "g.toml:<line>: " and `parts`.
    template <class... Parts>
    void expect_error(int line, std::string_view text, const Parts&... parts) {
        EXPECT_THAT(run(text),
                    refuses_with("g.toml:" + std::to_string(line) + ": ", parts...))
            << text;
        EXPECT_FALSE(std::filesystem::exists(at("c.h5")));
    }
};

TEST(BadDynamicsFile, TypingErrorsAreNamedWithTheNearestKey) {
    BadDynamics f;
    f.expect_error(2, "[dynamics]\nsubstep = 3\n", "substep", "substeps");
    f.expect_error(3, "[dynamics]\n\nyoung_modulos = 1e10\n", "young_modulos",
                   "young_modulus");
    f.expect_error(2, "[dynamics.contact]\nfrictoin = 1\n", "frictoin", "friction");
    f.expect_error(2, "[dynamics.strands]\nradios = 1\n", "radios", "radius");
    f.expect_error(2, "[dynamics.wind]\nvelocty = [1, 0, 0]\n", "velocty", "velocity");
    f.expect_error(1, "[dynamics.winds]\nturbulence = 1\n", "winds", "wind");
    f.expect_error(1, "[dynamic]\ndrag = 1\n", "dynamic", "dynamics");
    f.expect_error(2, "[motion]\nkey = []\n", "key", "keys");
    f.expect_error(2, "[motion]\nkeys = [{frame = 1, mov = [1, 0, 0]}]\n", "mov", "move");
    f.expect_error(3, "[[colliders]]\nshape = 'sphere'\nradios = 1\n", "radios",
                   "radius");
    f.expect_error(1, "[[collider]]\nshape = 'sphere'\n", "collider", "colliders");
}

TEST(BadDynamicsFile, WrongTypesAndRangesAreNamedWithTheirLine) {
    BadDynamics f;
    const auto dynamics = [&](const std::string& key, const std::string& value) {
        f.expect_error(2, "[dynamics]\n" + key + " = " + value + "\n", key);
    };
    dynamics("young_modulus", "0");
    dynamics("poisson_ratio", "0.6");
    dynamics("radius", "-0.1");
    dynamics("radius", "nan");
    dynamics("radius2", "11");
    dynamics("density", "'heavy'");
    dynamics("dissipation", "'viscus'");
    dynamics("damping", "inf");
    dynamics("drag", "-1");
    dynamics("integrator", "'bdf3'");
    dynamics("substeps", "0");
    dynamics("substeps", "1.5");
    dynamics("adaptive", "1");
    dynamics("error_tolerance", "0");
    dynamics("sag_free", "'yes'");
    dynamics("contact", "3");
    const auto in = [&](const std::string& table, const std::string& key,
                        const std::string& value) {
        f.expect_error(2, "[dynamics." + table + "]\n" + key + " = " + value + "\n", key);
    };
    in("contact", "head", "3");
    in("contact", "thickness", "-1");
    in("contact", "stiffness", "0");
    in("contact", "regularization", "0");
    in("contact", "friction", "nan");
    in("contact", "free_root", "-1");
    in("contact", "stations", "17");
    in("strands", "radius", "-1");
    in("strands", "stiffness", "1e9");
    in("strands", "friction_across", "-1");
    in("strands", "friction_along", "nan");
    in("strands", "cohesion", "-2");
    in("wind", "velocity", "3");
    in("wind", "velocity", "[1, 2]");
    in("wind", "velocity", "[1, 2, nan]");
    in("wind", "turbulence", "-1");
    in("wind", "length_scale", "0");
    in("wind", "time_scale", "0");
    in("wind", "seed", "-1");
}

TEST(BadDynamicsFile, InvalidMotions) {
    BadDynamics f;
    f.expect_error(2, "[motion]\nkeys = 3\n", "keys");
    f.expect_error(2, "[motion]\nkeys = [1, 2]\n", "keys");
    f.expect_error(3, "[motion]\nkeys = [{frame = 1},\n {turn = [0, 1, 0]}]\n", "frame");
    f.expect_error(3, "[motion]\nkeys = [{frame = 2},\n {frame = 2}]\n", "increase");
    f.expect_error(2, "[motion]\nkeys = [{frame = nan}]\n", "frame");
    f.expect_error(2, "[motion]\nkeys = [{frame = 1e9}]\n", "frame");
    f.expect_error(2, "[motion]\nkeys = [{frame = 1, turn = 3}]\n", "turn");
    f.expect_error(2, "[motion]\nkeys = [{frame = 1, move = [0, 0, inf]}]\n", "move");
    f.expect_error(2, "[motion]\npivot = [0, 0]\n", "pivot");
    f.expect_error(2, "[motion]\nfiles = 'a.%04d.obj'\n", "first", "last");
    f.expect_error(2, "[motion]\nfiles = 'a.%04d.obj'\nfirst = 3\nlast = 2\n", "first",
                   "last");
    f.expect_error(
        3, "[motion]\nkeys = [{frame = 1}]\nfiles = 'a.%d.obj'\nfirst = 1\nlast = 2\n",
        "keys", "files");
    f.expect_error(3, "[motion]\nfiles = 'a.%d.obj'\nfirst = -1\nlast = 2\n", "first");
    f.expect_error(2, "[[motion.keys]]\nframe = 'one'\n", "frame");
    f.expect_error(2, "[motion]\nkeys = [{frame = 1, move = [1e30, 0, 0]}]\n", "move",
                   "within");
}

TEST(BadDynamicsFile, InvalidColliders) {
    BadDynamics f;
    f.expect_error(1, "[[colliders]]\nradius = 3\n", "shape");
    f.expect_error(3, "[[colliders]]\nshape = 'sphere'\n[[colliders]]\nradius = 3\n",
                   "shape");
    f.expect_error(2, "[[colliders]]\nshape = 'cube'\n", "cube", "sphere", "capsule",
                   "mesh");
    f.expect_error(2, "[[colliders]]\nshape = 'mesh'\n", "file");
    f.expect_error(3, "[[colliders]]\nshape = 'sphere'\nradius = 0\n", "radius");
    f.expect_error(3, "[[colliders]]\nshape = 'sphere'\nfrom = [0, 0, 0]\n", "from");
    f.expect_error(3, "[[colliders]]\nshape = 'capsule'\nto = 3\n", "to");
    f.expect_error(3, "[[colliders]]\nshape = 'sphere'\nwith_head = 3\n", "with_head");
    f.expect_error(
        4, "[[colliders]]\nshape = 'sphere'\nwith_head = true\nkeys = [{frame = 1}]\n",
        "keys");
    f.expect_error(1, "[colliders]\nshape = 'sphere'\n", "colliders", "[[colliders]]");
    f.expect_error(7,
                   "[motion]\nfiles = 'a.%d.obj'\nfirst = 1\nlast = 2\n[[colliders]]\n"
                   "shape = 'sphere'\nwith_head = true\n",
                   "with_head", "deforms");
    EXPECT_THAT(f.run("[[colliders]]\nshape = 'mesh'\nfile = 'nothing.obj'\n"),
                refuses_with("nothing.obj"));
}

TEST(BadDynamicsFile, MotionByFilesNeedsAScalpAndTheFiles) {
    BadDynamics f;
    const std::string files = "[motion]\nfiles = 'a.%d.obj'\nfirst = 1\nlast = 2\n";
    EXPECT_THAT(f.run("[guides]\nfile = 'lawn.hair'\n" + files),
                refuses_with("a.%d.obj"));
    const std::string lawn =
        "[guides]\nfile = 'lawn.hair'\nsegments = 5\n[scalp]\nfile = 'lawn.obj'\n";
    EXPECT_THAT(f.run(lawn + files), refuses_with("a.1.obj"));
    write_obj(f / "a.1.obj", square_mesh(4, 2));
    EXPECT_THAT(f.run(lawn + files), refuses_with("a.1.obj", "vert"));
    EXPECT_THAT(f.run(lawn + "[motion]\nfiles = 'a.obj'\nfirst = 1\nlast = 2\n"),
                refuses_with("a.obj"));
}

TEST(BadDynamicsFile, OptionsAndOutputs) {
    BadDynamics f;
    const auto simulate = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"simulate", f.made});
        return lancret(words);
    };
    const std::string c = f.at("c.h5");
    for (const char* frames : {"", "a", "3-1", "1-", "1-2-3", "99999999999", "1.5"}) {
        EXPECT_THAT(simulate({"--frames", frames, "-o", c}), refuses_with("--frames"));
    }
    for (const char* fps : {"0", "-24", "nan", "inf", "fast"}) {
        EXPECT_THAT(simulate({"--fps", fps, "-o", c}), refuses_with("--fps"));
    }
    for (const char* substeps : {"0", "1001", "2.5"}) {
        EXPECT_THAT(simulate({"--substeps", substeps, "-o", c}),
                    refuses_with("--substeps"));
    }
    EXPECT_THAT(simulate({"--frames", "1-2"}), refuses_with("--output"));
    EXPECT_THAT(simulate({"-o", f.at("c.txt")}), refuses_with("c.txt", ".h5"));
    EXPECT_THAT(simulate({"-o", f.at("no/c.h5")}), refuses_with("no/c.h5"));
    EXPECT_THAT(simulate({"-o", c, "--stats", f.at("no/s.json")}),
                refuses_with("no/s.json"));
    std::filesystem::create_directory(f / "folder.h5");
    EXPECT_THAT(simulate({"-o", f.at("folder.h5")}), refuses_with("folder.h5"));
    write_bytes(f / "c.h5.frames", "not a folder");
    EXPECT_THAT(simulate({"--frames", "1-2", "-o", c}), refuses_with("c.h5.frames"));
}

TEST(BadDynamicsFile, ACacheIsNotOverwrittenByItsOwnSimulation) {
    const MovingGroom f;
    ASSERT_THAT(f.simulate("1-4", f.cache), works());
    EXPECT_THAT(lancret({"simulate", f.cache, "--frames", "1-4", "-o", f.cache}),
                refuses_with("cache.h5", "input"));
    // From its rest pose, with its groom's settings: the frames of the groom, but for
    // the roots being put on the scalp once more, which moves them by round-off. In three
    // frames that grows by far less than 1e5.
    const std::string again = f.at("again.h5");
    ASSERT_THAT(lancret({"simulate", f.cache, "--frames", "1-4", "-o", again}), works());
    const Guides a = read_guide_cache(f.cache, 3), b = read_guide_cache(again, 3);
    double roots = 0, curvatures = 0;
    for (std::size_t g = 0; g < a.size(); ++g) {
        roots = std::max(roots, (a.root_positions[g] - b.root_positions[g]).norm());
    }
    for (std::size_t i = 0; i < a.curvatures.size(); ++i) {
        curvatures = std::max(curvatures, (a.curvatures[i] - b.curvatures[i]).norm());
    }
    EXPECT_LT(roots, 1e-13);
    EXPECT_LT(curvatures, 1e-10);
}

}  // namespace
}  // namespace lancret
