#include "render_test/plugin/plugin.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "guides/base/errors.h"

namespace lancret {

namespace {

/// Found by the run path of the program.
constexpr const char* kName = "liblancret_procedural.so.2";

std::string library_name() {
    const char* name = std::getenv("LANCRET_LIBRARY");
    return name && *name ? name : kName;
}

}  // namespace

void Plugin::Unload::operator()(void* library) const { dlclose(library); }

Plugin::Plugin() {
    const std::string name = library_name();
    library_.reset(dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL));
    if (!library_) {
        const char* reason = dlerror();
        throw InputError(fmt::format("{}: cannot be loaded: {}", name,
                                     reason ? reason : "unknown reason"));
    }
    const auto find = [&]<class Function>(const char* function, Function& to) {
        to = reinterpret_cast<Function>(dlsym(library_.get(), function));
        if (to) return;
        throw InputError(fmt::format(
            "{}: has no function {}, expected the library of this version of Lancret",
            name, function));
    };
    PluginFunctions& f = functions_;
    find("lancret_abi_version", f.abi_version);
    if (f.abi_version() != LANCRET_ABI_VERSION) {
        throw InputError(fmt::format("{}: has version {} of the interface, expected {}",
                                     name, f.abi_version(), LANCRET_ABI_VERSION));
    }
    find("lancret_context_create", f.context_create);
    find("lancret_context_destroy", f.context_destroy);
    find("lancret_groom_open", f.groom_open);
    find("lancret_groom_close", f.groom_close);
    find("lancret_groom_get_info", f.groom_get_info);
    find("lancret_groom_describe", f.groom_describe);
    find("lancret_groom_get_head", f.groom_get_head);
    find("lancret_groom_is_still", f.groom_is_still);
    find("lancret_groom_get_chunk_box", f.groom_get_chunk_box);
    find("lancret_chunk_open", f.chunk_open);
    find("lancret_chunk_get_sizes", f.chunk_get_sizes);
    find("lancret_chunk_write", f.chunk_write);
    find("lancret_chunk_close", f.chunk_close);
    find("lancret_chunk_get_info", f.chunk_get_info);
    find("lancret_chunk_get_figures", f.chunk_get_figures);
}

}  // namespace lancret
