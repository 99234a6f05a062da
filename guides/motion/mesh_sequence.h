#pragma once
// A mesh that deforms in time, as one OBJ file per frame.

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "guides/mesh/triangle_mesh.h"

namespace lancret {

/// The files of a sequence.
struct ObjSequence {
    /// A path whose file name has one field for the frame number: "head.%04d.obj",
    /// "head.%d.obj" or "head.####.obj" (one digit per #, with leading zeros).
    std::string pattern;
    int first = 0, last = 0;          ///< frame numbers of the files
    double centimetres_per_unit = 1;  ///< of the files' coordinates
    double frames_per_second = 24;
};

/// The path of a frame's file. Throws InputError if the file name does not have exactly
/// one field for the frame number, of at most 12 digits.
std::filesystem::path frame_path(std::string_view pattern, int frame);

/// A vertex at one time.
struct VertexMotion {
    Vec3 position = Vec3::Zero();      ///< cm
    Vec3 velocity = Vec3::Zero();      ///< cm/s
    Vec3 acceleration = Vec3::Zero();  ///< cm/s^2
};

/// A mesh sequence at one time: a vertex is the weighted sum of its positions in four
/// files. Shares ownership of their meshes. May be read from several threads.
struct MeshMotion {
    std::shared_ptr<const TriangleMesh> rest;                 ///< the topology
    std::array<std::shared_ptr<const TriangleMesh>, 4> keys;  ///< cm
    std::array<double, 4> weights{}, rates{},
        bends{};       ///< and their first and second derivatives, 1/s, 1/s^2
    std::string name;  ///< the sequence and the frame, for errors
};

/// Vertex i (in range) of the sequence at its time, in double.
VertexMotion vertex_motion(const MeshMotion& mesh, std::uint32_t i);

/// Meshes of one topology, read on demand; the last few stay in memory.
class MeshSequence {
  public:
    /// Reads no file yet. Throws InputError if the pattern or the range of frames is
    /// invalid, and std::invalid_argument if a unit or a rate is not above 0.
    MeshSequence(ObjSequence files, TriangleMesh rest);
    ~MeshSequence();
    MeshSequence(MeshSequence&&) noexcept;
    MeshSequence& operator=(MeshSequence&&) noexcept;

    /// The sequence at `frame` (finite): Catmull-Rom in time between files, with the
    /// first and last file repeated beyond the ends; constant before the first frame and
    /// after the last. Velocities are continuous except at those two ends; accelerations
    /// jump at whole frames. May be called from several threads, which wait while one
    /// reads.
    ///
    /// Throws InputError if a file cannot be read or its topology is not that of the rest
    /// mesh, and std::invalid_argument if the frame is not finite.
    MeshMotion at(double frame) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lancret
