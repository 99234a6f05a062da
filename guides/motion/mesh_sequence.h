#pragma once
// A mesh that deforms in time, as one OBJ file a frame.

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// Where the files are.
struct ObjSequence {
    /// A path with the frame's place in the file's name, once: "head.%04d.obj",
    /// "head.%d.obj" or "head.####.obj" (as many digits as there are #, zeros before).
    std::string pattern;
    int first = 0, last = 0;          ///< frames that there are files for
    double centimetres_per_unit = 1;  ///< of the files' coordinates
    double frames_per_second = 24;
};

/// The path of a frame's file. Throws InputError where the file's name has not exactly
/// one place for a frame, or one of more than 12 digits.
std::filesystem::path frame_path(std::string_view pattern, int frame);

/// A vertex at one time.
struct VertexMotion {
    Vec3 position = Vec3::Zero();      ///< cm
    Vec3 velocity = Vec3::Zero();      ///< cm/s
    Vec3 acceleration = Vec3::Zero();  ///< cm/s^2
};

/// A mesh sequence at one time: a vertex is the sum of its places in four files, times
/// weights. Holds the files' data for as long as it lives; safe to read from many
/// threads.
struct MeshMotion {
    std::shared_ptr<const TriangleMesh> rest;                 ///< the topology
    std::array<std::shared_ptr<const TriangleMesh>, 4> keys;  ///< cm
    std::array<double, 4> weights{}, rates{},
        bends{};       ///< and their derivatives, 1/s, 1/s^2
    std::string name;  ///< of sequence and frame, for errors
};

/// Vertex i (in range) of the sequence at its time, in double.
VertexMotion vertex_motion(const MeshMotion& mesh, std::uint32_t i);

/// Meshes of one topology, read when they are asked for; the last few stay in memory.
class MeshSequence {
  public:
    /// Reads no file yet. Throws InputError where the pattern or the range of frames is
    /// wrong, and std::invalid_argument where a factor is not above 0.
    MeshSequence(ObjSequence files, TriangleMesh rest);
    ~MeshSequence();
    MeshSequence(MeshSequence&&) noexcept;
    MeshSequence& operator=(MeshSequence&&) noexcept;

    /// The sequence at `frame` (finite): Catmull-Rom in time between files, the first and
    /// last file counting for those beyond them; held, and still, before the first frame
    /// and after the last. Velocities are continuous but for those two ends;
    /// accelerations step at whole frames. Safe to call from many threads, which wait
    /// while one reads.
    ///
    /// Throws InputError where a file cannot be read or its topology is not that of the
    /// rest mesh, and std::invalid_argument where the frame is not finite.
    MeshMotion at(double frame) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lancret
