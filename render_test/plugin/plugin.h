#pragma once
// The library that strands come from, loaded by its name: the path tracer is a host of
// the C interface like any other.

#include <filesystem>
#include <memory>

#include "procedural/lancret_procedural.h"

namespace lancret {

/// The interface's functions as the library has them.
struct PluginFunctions {
    decltype(&lancret_abi_version) abi_version = nullptr;
    decltype(&lancret_context_create) create = nullptr;
    decltype(&lancret_context_destroy) destroy = nullptr;
    decltype(&lancret_groom_open) open = nullptr;
    decltype(&lancret_groom_close) close = nullptr;
    decltype(&lancret_groom_get_info) get_info = nullptr;
    decltype(&lancret_groom_describe) describe = nullptr;
    decltype(&lancret_groom_get_head) get_head = nullptr;
    decltype(&lancret_groom_is_still) is_still = nullptr;
    decltype(&lancret_groom_get_chunk_box) bound = nullptr;
    decltype(&lancret_chunk_open) chunk_open = nullptr;
    decltype(&lancret_chunk_get_sizes) chunk_sizes = nullptr;
    decltype(&lancret_chunk_write) chunk_write = nullptr;
    decltype(&lancret_chunk_close) chunk_close = nullptr;
    decltype(&lancret_chunk_get_info) get_chunk_info = nullptr;
    decltype(&lancret_chunk_get_figures) chunk_figures = nullptr;
};

/// A library that is loaded, as long as this lives.
class Plugin {
  public:
    /// $LANCRET_LIBRARY where that is said, else the library that was installed or built
    /// with the program. Throws InputError where it cannot be loaded, lacks a function or
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
