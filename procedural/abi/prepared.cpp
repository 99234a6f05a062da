#include "procedural/abi/prepared.h"

namespace lancret::abi {

Prepared::Prepared(ChunkedGroom made) : groom(std::move(made)) {
    const GroomGuides& source = generator().source;
    for (const Mat3& frame : source.guides.root_frames) {
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 3; ++c) guides.root_frames.push_back(frame(r, c));
        }
    }
    for (const FitReport& fit : source.fits) guides.fit_rms.push_back(fit.rms);
}

std::size_t Prepared::bytes() const {
    const GroomGuides& source = generator().source;
    const auto of = [](const auto& v) { return v.size() * sizeof(v[0]); };
    std::size_t out = groom.bytes() + generator().binding.bytes() +
                      generator().sample.bytes() + of(guides.root_frames) +
                      of(guides.fit_rms);
    out += of(source.guides.root_positions) + of(source.guides.root_frames) +
           of(source.guides.segment_lengths) + of(source.guides.curvatures);
    out += of(source.grown_roots) + of(source.grown_tangents) + of(source.normals);
    const auto of_mesh = [&](const TriangleMesh& mesh) {
        return of(mesh.positions) + of(mesh.triangles) + of(mesh.uvs);
    };
    if (source.scalp) {
        out += of_mesh(source.scalp->mesh) + of(source.scalp->normals) +
               of(source.scalp->areas);
    }
    if (source.body) out += of_mesh(*source.body);
    return out;
}

}  // namespace lancret::abi
