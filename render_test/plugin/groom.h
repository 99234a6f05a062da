#pragma once
// A groom that a plugin has opened: what a picture needs besides its strands.

#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "guides/mesh/triangle_mesh.h"
#include "procedural/curves/curves.h"
#include "render_test/plugin/plugin.h"

namespace lancret {

/// A value laid over the groom's own: lancret_parameter.
struct PluginParameter {
    std::string name;
    std::optional<std::string> text;
    double number = 0;
};

/// Takes what the plugin tells: the stages of its work, and warnings. Called from any
/// thread.
struct PluginLog {
    std::function<void(const std::string&)> stage, warning;
};

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
    std::optional<CurveShape> shape() const;  ///< none: as is best for a picture
    /// Of the guides at rest, cm.
    Eigen::AlignedBox3f box() const;
    /// lancret_groom_describe's JSON.
    std::string description() const;
    /// What is seen of the head at a time, if there is one. Throws InputError.
    std::optional<TriangleMesh> head(double time) const;
    /// Whether guides and head stand at all `times` where they do at the first. Throws
    /// InputError.
    bool is_still(std::span<const double> times) const;
    /// A tight box of a chunk at the groom's first time, cm; empty where it grows
    /// nothing. Throws InputError.
    Eigen::AlignedBox3f bound(lancret_u32 chunk) const;

    /// Throws what the plugin has told of a call of this thread that failed: InputError
    /// where the input is at fault, else std::runtime_error.
    void must(lancret_status status) const;

  private:
    static void take(void* self, int level, const char* text);

    Plugin plugin_;
    PluginLog log_;
    lancret_context* context_ = nullptr;
    lancret_groom* groom_ = nullptr;
    lancret_groom_info info_{};
    std::mutex mutex_;  ///< of the log
};

}  // namespace lancret
