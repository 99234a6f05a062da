#pragma once
// Embree alone, with nothing of ours about it: what the path tracer is held against.

#include <memory>
#include <span>

#include "guides/mesh/triangle_mesh.h"
#include "procedural/curves/curves.h"
#include "render_test/trace/rays.h"

namespace lancret::bench {

class BareEmbree {
  public:
    BareEmbree(const Curves& curves, const TriangleMesh& mesh, int tessellation);
    ~BareEmbree();
    /// Traces all rays on this thread, in their order; gives how many met something.
    std::size_t trace(std::span<const TracedRay> rays) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace lancret::bench
