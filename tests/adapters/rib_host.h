#pragma once
// Stands in for RenderMan: loads a DynamicLoad DSO, keeps its procedurals until they are
// subdivided, and writes what they emit as RIB. The Ri calls are in rib_host.cpp; each
// goes to the host of the calling thread.

#include <array>
#include <mutex>
#include <string>
#include <vector>

#include "procedural/adapters/ri.h"

namespace lancret {

/// A procedural emitted by the DSO.
struct Procedural {
    RtPointer data;
    std::array<float, 6> bound;  ///< minimum and maximum x, then y, then z
    RtProcSubdivFunc subdivide;
    RtProcFreeFunc release;
};

class RibHost {
  public:
    /// Fails the test if `dso` does not load.
    explicit RibHost(const std::string& dso);
    /// Frees all procedurals and unloads the DSO.
    ~RibHost();
    RibHost(const RibHost&) = delete;
    RibHost& operator=(const RibHost&) = delete;

    /// Procedural "DynamicLoad" ["dso" "parameters"]; null if the DSO refuses.
    RtPointer convert(const std::string& parameters);
    /// Subdivides a procedural of `convert`; its children are added to `children`.
    void subdivide_root(RtPointer root, float detail = 1e38f);
    void free_root(RtPointer root);
    /// RIB of a child: AttributeBegin, Bound, what it emits, AttributeEnd. Thread-safe.
    std::string subdivide(const Procedural& child, float detail = 1e38f);
    void free_children();

    /// RIB of a groom, each of whose procedurals is subdivided once and freed.
    std::string rib_of(const std::string& parameters, float detail = 1e38f);

    std::vector<Procedural> children;
    std::string errors;  ///< texts of RiErrorPrint, one per line

    /// The functions of the DSO.
    RtPointer (*convert_parameters)(char*) = nullptr;
    void (*subdivide_function)(RtPointer, RtFloat) = nullptr;
    void (*free_function)(RtPointer) = nullptr;

    std::mutex mutex;  ///< guards `children` and `errors`

  private:
    void* library_ = nullptr;
    std::vector<RtPointer> roots_;
};

}  // namespace lancret
