#pragma once
// Embree without Lancret: the reference for the speed of the path tracer.

#include <memory>
#include <span>

#include "guides/mesh/triangle_mesh.h"
#include "procedural/curves/curves.h"
#include "render_test/trace/rays.h"

namespace lancret::bench {

/// Strands and a mesh in an Embree scene. The curves must outlive it.
class BareEmbree {
  public:
    BareEmbree(const Curves& curves, const TriangleMesh& mesh, int tessellation);
    ~BareEmbree();
    /// Traces all rays in order on this thread. Returns the number of hits.
    std::size_t trace(std::span<const TracedRay> rays) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace lancret::bench
