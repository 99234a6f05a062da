#include "render_test/material/glossy.h"

namespace lancret {
namespace {

/// GGX: the density of facets with unit normal `m`, by projected area.
float facets(const Vec3f& m, float alpha) {
    const float t = (square(m.x()) + square(m.y())) / square(alpha) + square(m.z());
    return 1 / (kPif * square(alpha) * square(t));
}

/// Smith's Lambda: the ratio of hidden to visible facets in direction `w`.
float hidden(const Vec3f& w, float alpha) {
    const float tangent2 = (square(w.x()) + square(w.y())) / square(w.z());
    return (std::sqrt(1 + square(alpha) * tangent2) - 1) / 2;
}

/// Samples a facet by its area visible from `wo` [Dupuy and Benyoub 2023].
Vec3f seen_facet(const Vec3f& wo, float alpha, const Vec2f& random) {
    const Vec3f o = Vec3f(alpha * wo.x(), alpha * wo.y(), wo.z()).normalized();
    const float z = (1 - random.y()) * (1 + o.z()) - o.z(), phi = 2 * kPif * random.x();
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    const Vec3f h = Vec3f(r * std::cos(phi), r * std::sin(phi), z) + o;
    return Vec3f(alpha * h.x(), alpha * h.y(), std::max(h.z(), 1e-7f)).normalized();
}

}  // namespace

Glossy::Glossy(const MeshMaterial& material, const Hit& hit, const Vec3f& wo)
    : colour_(surface_colour(material, hit)),
      wo_(wo),
      alpha_(square(std::max(*material.coat_roughness, 0.05f))) {
    wo_.z() = std::max(wo_.z(), 1e-4f);
    wo_.normalize();
    fresnel_ = fresnel_dielectric(wo_.z(), kCoatEta);
    coat_ = fresnel_ / (fresnel_ + (1 - fresnel_) * luminance(colour_));
}

BsdfValue Glossy::evaluate(const Vec3f& wi) const {
    if (wi.z() <= 1e-6f) return {};
    const Vec3f m = (wi + wo_).normalized();
    const float d = facets(m, alpha_) / (4 * wo_.z());
    const float hidden_o = hidden(wo_, alpha_), hidden_i = hidden(wi, alpha_);
    const float f = fresnel_dielectric(std::min(m.dot(wo_), 1.0f), kCoatEta);
    const float through = (1 - fresnel_) * (1 - fresnel_dielectric(wi.z(), kCoatEta));
    BsdfValue out;
    out.value = Vec3f::Constant(f * d / (1 + hidden_o + hidden_i)) +
                colour_ * (through * wi.z() / kPif);
    out.pdf = coat_ * d / (1 + hidden_o) + (1 - coat_) * wi.z() / kPif;
    return out;
}

std::optional<BsdfSample> Glossy::sample(float pick, float, const Vec2f& random) const {
    BsdfSample sample;
    if (pick < coat_) {
        const Vec3f m = seen_facet(wo_, alpha_, random);
        sample.direction = (2 * m.dot(wo_) * m - wo_).normalized();
    } else {
        sample.direction = cosine_hemisphere(random);
    }
    sample.at = evaluate(sample.direction);
    if (!(sample.at.pdf > 0)) return std::nullopt;
    return sample;
}

}  // namespace lancret
