#pragma once
// A groom opened through the plugin: everything that a picture needs besides its strands.

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "guides/mesh/triangle_mesh.h"
#include "procedural/curves/curves.h"
#include "render_test/plugin/plugin.h"

namespace lancret {

/// An override of one groom setting, as in lancret_parameter.
struct PluginParameter {
    std::string name;
    std::optional<std::string> text;
    double number = 0;
};

/// Receives the stages of opening a groom, and warnings. Called from any thread, one call
/// at a time; either may be empty.
struct PluginLog {
    std::function<void(const std::string&)> stage, warning;
};

/// All const members may be called by any number of threads at once.
class PluginGroom {
  public:
    /// Loads the library and opens the groom of a file. Throws InputError.
    PluginGroom(const std::filesystem::path& file,
                std::span<const PluginParameter> parameters, PluginLog log);
    ~PluginGroom();
    PluginGroom(const PluginGroom&) = delete;
    PluginGroom& operator=(const PluginGroom&) = delete;

    const Plugin& plugin() const { return plugin_; }
    const lancret_groom* handle() const { return groom_; }
    const lancret_groom_info& info() const { return info_; }
    CurveBasis basis() const;
    std::optional<CurveShape> shape() const;  ///< nullopt: the picture's choice
    /// Of the guides at rest, cm.
    Eigen::AlignedBox3f box() const;
    /// The JSON of lancret_groom_describe.
    std::string description() const;
    /// The visible head at a time; nullopt if the groom has none. Throws InputError.
    std::optional<TriangleMesh> head(double time) const;
    /// Whether guides and head are the same at all `times`. Throws InputError.
    bool is_still(std::span<const double> times) const;
    /// The tight box of a chunk at the groom's first time, cm; empty if the chunk grows
    /// no strand. Throws InputError.
    Eigen::AlignedBox3f chunk_box(lancret_u32 chunk) const;

    /// Call with the status of any call on this groom or its chunks, on the thread that
    /// made the call. Throws InputError for LANCRET_BAD_INPUT, std::bad_alloc, or
    /// std::runtime_error, with the error that the plugin logged for the call. No-op for
    /// LANCRET_OK.
    void throw_if_failed(lancret_status status) const;

  private:
    void open(const std::filesystem::path& file,
              std::span<const PluginParameter> parameters);
    static void receive_log(void* self, int level, const char* text);
    std::string take_error() const;

    Plugin plugin_;
    PluginLog log_;
    lancret_context* context_ = nullptr;
    lancret_groom* groom_ = nullptr;
    lancret_groom_info info_{};
    mutable std::mutex mutex_;  ///< guards calls of log_, and errors_
    /// The last error of each thread's calls on this groom.
    mutable std::map<std::thread::id, std::string> errors_;
};

}  // namespace lancret
