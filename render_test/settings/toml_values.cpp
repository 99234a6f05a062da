#include "render_test/settings/toml_values.h"

#include <fmt/format.h>

#include "guides/base/coordinates.h"

namespace lancret {
namespace {

std::optional<Vec3f> single(const std::optional<Vec3>& v) {
    if (!v) return std::nullopt;
    return v->cast<float>();
}

}  // namespace

std::optional<Vec3f> colour_value(const TomlTable& table, std::string_view key,
                                  double limit) {
    const auto v = table.vector(key);
    if (v && !(v->minCoeff() >= 0 && v->maxCoeff() <= limit)) {
        table.fail(key, fmt::format("'{}' must be a colour: three numbers from 0 to {}",
                                    key, limit));
    }
    return single(v);
}

std::optional<Vec3f> direction_value(const TomlTable& table, std::string_view key) {
    const auto v = table.vector(key);
    if (!v) return std::nullopt;
    if (v->stableNorm() < 1e-12) {
        table.fail(key, fmt::format("'{}' must be a direction other than zero", key));
    }
    return Vec3f(v->stableNormalized().cast<float>());
}

std::optional<Vec3f> place_value(const TomlTable& table, std::string_view key) {
    const auto v = single(table.vector(key));
    if (v && !is_place(*v)) {
        table.fail(key, fmt::format("'{}' must be a position within {:.0e} cm", key,
                                    kLargestCoordinate));
    }
    return v;
}

std::optional<float> angle_value(const TomlTable& table, std::string_view key, double low,
                                 double high) {
    const auto degrees = table.number(key, low, high);
    if (!degrees) return std::nullopt;
    return float(*degrees * kPi / 180);
}

}  // namespace lancret
