#pragma once
// The library that grows the strands, loaded at run time: the path tracer uses the C
// interface like any other host.

#include <memory>

#include "procedural/lancret_procedural.h"

namespace lancret {

/// The functions of the interface that the path tracer calls, each as lancret_NAME.
struct PluginFunctions {
    decltype(&lancret_abi_version) abi_version = nullptr;
    decltype(&lancret_context_create) context_create = nullptr;
    decltype(&lancret_context_destroy) context_destroy = nullptr;
    decltype(&lancret_groom_open) groom_open = nullptr;
    decltype(&lancret_groom_close) groom_close = nullptr;
    decltype(&lancret_groom_get_info) groom_get_info = nullptr;
    decltype(&lancret_groom_describe) groom_describe = nullptr;
    decltype(&lancret_groom_get_head) groom_get_head = nullptr;
    decltype(&lancret_groom_is_still) groom_is_still = nullptr;
    decltype(&lancret_groom_get_chunk_box) groom_get_chunk_box = nullptr;
    decltype(&lancret_chunk_open) chunk_open = nullptr;
    decltype(&lancret_chunk_get_sizes) chunk_get_sizes = nullptr;
    decltype(&lancret_chunk_write) chunk_write = nullptr;
    decltype(&lancret_chunk_close) chunk_close = nullptr;
    decltype(&lancret_chunk_get_info) chunk_get_info = nullptr;
    decltype(&lancret_chunk_get_figures) chunk_get_figures = nullptr;
};

/// A loaded library, unloaded with this object.
class Plugin {
  public:
    /// Loads $LANCRET_LIBRARY if it is set, else the library that was installed or built
    /// with the program. Throws InputError if it cannot be loaded, lacks a function or
    /// has another version of the interface.
    Plugin();

    const PluginFunctions* operator->() const { return &functions_; }

  private:
    struct Unload {
        void operator()(void* library) const;
    };

    std::unique_ptr<void, Unload> library_;
    PluginFunctions functions_;
};

}  // namespace lancret
