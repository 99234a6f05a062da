#pragma once
// Grooms that are small enough for fast tests.

#include <cmath>
#include <string>

#include "guides/files/hair_file.h"
#include "guides/files/hair_file_write.h"
#include "guides/files/obj_file.h"
#include "guides/made/made_groom.h"
#include "tests/guides/mesh/meshes.h"
#include "tests/tools/command_run.h"

namespace lancret {

/// n x n hairs of the same length on the square [0, side]^2, each a helix about the
/// normal +Z.
inline Strands curled_lawn(int n, float side, float length, int points = 24) {
    Strands out;
    for (int s = 0; s < n * n; ++s) {
        const Vec3f root(side * (float(s % n) + 0.5f) / float(n),
                         side * (float(s / n) + 0.5f) / float(n), 0);
        for (int i = 0; i < points; ++i) {
            const float t = float(i) / float(points - 1), angle = 9 * t;
            out.points.push_back(root + length * Vec3f(0.04f * (std::cos(angle) - 1),
                                                       0.04f * std::sin(angle), t));
        }
        out.first.push_back(std::uint32_t(out.points.size()));
    }
    return out;
}

/// Straight hairs from each of `roots` to the root plus `reach`.
inline Strands straight_hairs(const std::vector<Vec3f>& roots, const Vec3f& reach,
                              int points = 2) {
    Strands out;
    for (const Vec3f& root : roots) {
        for (int i = 0; i < points; ++i) {
            out.points.push_back(root + reach * (float(i) / float(points - 1)));
        }
        out.first.push_back(std::uint32_t(out.points.size()));
    }
    return out;
}

/// A folder with lawn.hair (25 hairs of 5 cm on 4 x 4 cm), lawn.obj, the square below it,
/// and made.toml, a generated head with 40 guides.
struct SmallGrooms : TemporaryFolder {
    std::string hair = (*this / "lawn.hair").string();
    std::string obj = (*this / "lawn.obj").string();
    std::string made = (*this / "made.toml").string();

    SmallGrooms() {
        write_hair(hair, curled_lawn(5, 4, 5));
        write_obj(obj, square_mesh(4, 3));
        write_bytes(made,
                    "[guides]\nsegments = 6\n[guides.made]\nstrands = 40\n"
                    "[strands]\ncount = 60\n"
                    "[render]\nwidth = 32\nheight = 32\nsamples = 2\n");
    }

    /// Writes `text` to the file `name` and returns its path.
    std::string file(const std::string& name, std::string_view text) const {
        write_bytes(*this / name, text);
        return (*this / name).string();
    }
    std::string at(const std::string& name) const { return (*this / name).string(); }
};

}  // namespace lancret
