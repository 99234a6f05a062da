#pragma once
// Plays RenderMan: loads a DynamicLoad DSO, keeps its procedurals until they are reached,
// and writes what they make as RIB. The Ri calls that the DSO needs are in rib_host.cpp;
// each goes to the host that the calling thread works for.

#include <array>
#include <mutex>
#include <string>
#include <vector>

#include "procedural/adapters/ri.h"

namespace lancret {

/// A procedural that the DSO made.
struct Procedural {
    RtPointer data;
    std::array<float, 6> bound;  ///< minimum and maximum x, then y, then z
    RtProcSubdivFunc subdivide;
    RtProcFreeFunc release;
};

class RibHost {
  public:
    /// Fails the test where `dso` does not load.
    explicit RibHost(const std::string& dso);
    /// Frees what was not freed and unloads the DSO.
    ~RibHost();
    RibHost(const RibHost&) = delete;
    RibHost& operator=(const RibHost&) = delete;

    /// Procedural "DynamicLoad" ["dso" "parameters"]; null where the DSO refuses.
    RtPointer convert(const std::string& parameters);
    /// Reaches a procedural of convert's: its children are added to `children`.
    void subdivide_root(RtPointer root, float detail = 1e38f);
    void free_root(RtPointer root);
    /// What a child makes when it is reached, in AttributeBegin, Bound, ... AttributeEnd.
    /// From any thread.
    std::string subdivide(const Procedural& child, float detail = 1e38f);
    void free_children();

    /// One groom from its string to RIB, each procedural reached once and freed.
    std::string rib_of(const std::string& parameters, float detail = 1e38f);

    std::vector<Procedural> children;
    std::string errors;  ///< what RiErrorPrint was given, a line each

    /// The functions of the DSO.
    RtPointer (*convert_parameters)(char*) = nullptr;
    void (*subdivide_function)(RtPointer, RtFloat) = nullptr;
    void (*free_function)(RtPointer) = nullptr;

    std::mutex mutex;  ///< over `children` and `errors`

  private:
    void* library_ = nullptr;
    std::vector<RtPointer> roots_;
};

}  // namespace lancret
