#include "render_test/material/blade.h"

namespace lancret {

Blade::Blade(const BladeMaterial& material, const Vec3f& colour, const Vec3f& wo)
    : near_((1 - material.translucency) * colour), far_(material.translucency * colour) {
    if (material.coat_roughness) {
        MeshMaterial mesh;
        mesh.colour = near_;
        mesh.coat_roughness = material.coat_roughness;
        coated_.emplace(mesh, Hit(), wo);
        enters_ = 1 - fresnel_dielectric(std::clamp(wo.z(), 1e-4f, 1.0f), kCoatEta);
    }
    far_chance_ = enters_ * material.translucency;
}

BsdfValue Blade::near_side(const Vec3f& wi) const {
    if (coated_) return coated_->evaluate(wi);
    return {near_ * (wi.z() / kPif), wi.z() / kPif};
}

BsdfValue Blade::evaluate(const Vec3f& wi) const {
    BsdfValue out;
    if (wi.z() > 0) {
        out = near_side(wi);
        out.pdf *= 1 - far_chance_;
    } else if (wi.z() < 0) {
        const float cosine = std::min(-wi.z(), 1.0f) / kPif;
        const float leaves =
            coated_ ? 1 - fresnel_dielectric(std::min(-wi.z(), 1.0f), kCoatEta) : 1.0f;
        out.value = far_ * (enters_ * leaves * cosine);
        out.pdf = far_chance_ * cosine;
    }
    return out;
}

std::optional<BsdfSample> Blade::sample(float pick, float, const Vec2f& random) const {
    BsdfSample sample;
    if (pick < far_chance_) {
        sample.direction = cosine_hemisphere(random);
        sample.direction.z() = -sample.direction.z();
    } else if (coated_) {
        const float rest = (pick - far_chance_) / (1 - far_chance_);
        const auto near = coated_->sample(std::min(rest, 0x1.fffffep-1f), 0, random);
        if (!near) return std::nullopt;
        sample.direction = near->direction;
    } else {
        sample.direction = cosine_hemisphere(random);
    }
    sample.at = evaluate(sample.direction);
    if (!(sample.at.pdf > 0)) return std::nullopt;
    return sample;
}

}  // namespace lancret
