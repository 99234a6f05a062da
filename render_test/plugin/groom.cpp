#include "render_test/plugin/groom.h"

#include <fmt/format.h>

#include <new>
#include <stdexcept>
#include <utility>

#include "guides/base/errors.h"

namespace lancret {

namespace {

[[noreturn]] void fail(lancret_status status, const std::string& error) {
    if (status == LANCRET_BAD_INPUT) throw InputError(error);
    if (status == LANCRET_OUT_OF_MEMORY) throw std::bad_alloc();
    throw std::runtime_error(
        fmt::format("the plugin returned status {}: {}", status, error));
}

lancret_status copy_mesh(void* to, const lancret_mesh* mesh) {
    if (mesh->vertices == 0) return LANCRET_OK;
    TriangleMesh out;
    const auto row = [](const float* from, std::size_t i) {
        return Vec3f(from[3 * i], from[3 * i + 1], from[3 * i + 2]);
    };
    out.positions.reserve(mesh->vertices);
    out.triangles.reserve(mesh->triangles);
    for (std::size_t i = 0; i < mesh->vertices; ++i) {
        out.positions.push_back(row(mesh->positions, i));
    }
    for (std::size_t t = 0; t < mesh->triangles; ++t) {
        const lancret_u32* corners = mesh->corners + 3 * t;
        out.triangles.push_back({corners[0], corners[1], corners[2]});
        if (!mesh->uvs) continue;
        const float* uv = mesh->uvs + 6 * t;
        out.uvs.push_back(
            {Vec2f(uv[0], uv[1]), Vec2f(uv[2], uv[3]), Vec2f(uv[4], uv[5])});
    }
    *static_cast<std::optional<TriangleMesh>*>(to) = std::move(out);
    return LANCRET_OK;
}

Eigen::AlignedBox3f box_of(const float* box) {
    return {Vec3f(box[0], box[1], box[2]), Vec3f(box[3], box[4], box[5])};
}

}  // namespace

PluginGroom::PluginGroom(const std::filesystem::path& file,
                         std::span<const PluginParameter> parameters, PluginLog log)
    : log_(std::move(log)) {
    lancret_host host{};
    host.size = sizeof host;
    host.user = this;
    host.log = receive_log;
    throw_if_failed(plugin_->context_create(LANCRET_ABI_VERSION, &host, &context_));
    try {
        open(file, parameters);
        info_.size = sizeof info_;
        throw_if_failed(plugin_->groom_get_info(groom_, &info_));
    } catch (...) {
        plugin_->groom_close(groom_);
        plugin_->context_destroy(context_);
        throw;
    }
}

void PluginGroom::open(const std::filesystem::path& file,
                       std::span<const PluginParameter> parameters) {
    std::vector<lancret_parameter> given;
    for (const PluginParameter& p : parameters) {
        given.push_back({p.name.c_str(), p.text ? p.text->c_str() : nullptr, p.number});
    }
    const std::string path = file.string();
    lancret_source source{};
    source.size = sizeof source;
    source.path = path.c_str();
    source.parameters = given.data();
    source.parameter_count = given.size();
    char error[4096] = "";
    const lancret_status status =
        plugin_->groom_open(context_, &source, &groom_, error, sizeof error);
    take_error();  // the same text, logged
    if (status != LANCRET_OK) fail(status, error);
}

PluginGroom::~PluginGroom() {
    plugin_->groom_close(groom_);
    plugin_->context_destroy(context_);
}

CurveBasis PluginGroom::basis() const {
    return info_.basis == LANCRET_HERMITE ? CurveBasis::hermite : CurveBasis::bspline;
}

std::optional<CurveShape> PluginGroom::shape() const {
    switch (info_.shape) {
        case LANCRET_FLAT:
            return CurveShape::flat;
        case LANCRET_ROUND:
            return CurveShape::round;
        case LANCRET_RIBBON:
            return CurveShape::ribbon;
        default:
            return std::nullopt;
    }
}

Eigen::AlignedBox3f PluginGroom::box() const { return box_of(info_.box); }

std::string PluginGroom::description() const {
    std::string out;
    throw_if_failed(plugin_->groom_describe(
        groom_, [](void* to, const char* text) { *static_cast<std::string*>(to) = text; },
        &out));
    return out;
}

std::optional<TriangleMesh> PluginGroom::head(double time) const {
    std::optional<TriangleMesh> out;
    throw_if_failed(plugin_->groom_get_head(groom_, time, copy_mesh, &out));
    return out;
}

bool PluginGroom::is_still(std::span<const double> times) const {
    int still = 0;
    throw_if_failed(plugin_->groom_is_still(groom_, times.data(), times.size(), &still));
    return still != 0;
}

Eigen::AlignedBox3f PluginGroom::chunk_box(lancret_u32 chunk) const {
    lancret_options options{};
    options.size = sizeof options;
    options.basis = info_.basis;
    float box[6] = {};
    throw_if_failed(
        plugin_->groom_get_chunk_box(groom_, chunk, &options, LANCRET_TIGHT, box));
    return box_of(box);
}

void PluginGroom::receive_log(void* self, int level, const char* text) {
    auto& groom = *static_cast<PluginGroom*>(self);
    const std::lock_guard lock(groom.mutex_);
    if (level == LANCRET_LOG_ERROR) {
        groom.errors_[std::this_thread::get_id()] = text;
    } else if (level == LANCRET_LOG_WARNING) {
        if (groom.log_.warning) groom.log_.warning(text);
    } else if (groom.log_.stage) {
        groom.log_.stage(text);
    }
}

std::string PluginGroom::take_error() const {
    const std::lock_guard lock(mutex_);
    const auto error = errors_.extract(std::this_thread::get_id());
    return error ? error.mapped() : std::string();
}

void PluginGroom::throw_if_failed(lancret_status status) const {
    if (status != LANCRET_OK) fail(status, take_error());
}

}  // namespace lancret
