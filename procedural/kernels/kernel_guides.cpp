#include "procedural/kernels/kernel_guides.h"

#include <algorithm>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "procedural/curves/control_points.h"

namespace lancret {

namespace {

/// Rounded up to a whole number of the longest vectors.
std::size_t padded(std::size_t size) {
    return (size + kMaxLanes - 1) / kMaxLanes * kMaxLanes;
}

Buffer<float> zeros(std::size_t size) {
    Buffer<float> out(size);
    std::ranges::fill(out.span(), 0.0f);
    return out;
}

/// Writes the control points of guide g, as bspline_points computes them with
/// Ends::parabola, but in double precision until they are stored.
void write_points(const GuideProfiles<float>& profiles, std::size_t g,
                  KernelGuides& out) {
    const std::ptrdiff_t n = profiles.count;
    std::vector<Vec3> places(std::size_t(n) + 5);  // two beyond each end
    for (std::ptrdiff_t i = 0; i <= n; ++i) {
        places[i + 2] = profiles.position(g, i).cast<double>();
    }
    const auto extend = [&](std::ptrdiff_t end, std::ptrdiff_t way) {
        const Vec3 *const last = &places[end + 2], a = last[way] - last[0];
        const Vec3 b = n > 1 ? Vec3(last[2 * way] - last[way]) : a;
        places[end + 2 - way] = last[0] - 2 * a + b;
        places[end + 2 - 2 * way] = last[0] - 5 * a + 3 * b;
    };
    extend(0, 1);
    extend(n, -1);
    const auto smoothed = [&](std::ptrdiff_t i) -> Vec3 {
        const Vec3* p = &places[i + 2];
        return (54 * p[0] - 10 * (p[-1] + p[1]) + p[-2] + p[2]) / 36;
    };
    const Mat3 to_space = profiles.root_frames[g].cast<double>();
    for (std::ptrdiff_t j = 0; j < n + 3; ++j) {
        Vec3 c;
        if (j == 0) {
            c = 6 * places[2] - 4 * smoothed(0) - smoothed(1);
        } else if (j == n + 2) {
            c = 6 * places[n + 2] - 4 * smoothed(n) - smoothed(n - 1);
        } else {
            c = smoothed(j - 1);
        }
        c = to_space * c;
        for (int axis = 0; axis < 3; ++axis) {
            out.points[(g * 3 + axis) * out.point_stride + j] = float(c[axis]);
        }
    }
}

void write_curl(const GuideProfiles<float>& profiles, std::size_t g, const Vec3f& normal,
                KernelGuides& out) {
    const std::size_t n = out.count;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3f& u = profiles.curvatures[g * n + i];
        for (int axis = 0; axis < 3; ++axis) {
            out.curvatures[(g * 3 + axis) * out.place_stride + i] = u[axis];
        }
        out.most_curved[g] = std::max(out.most_curved[g], u.norm());
    }
    for (std::size_t i = 0; i <= n; ++i) {
        out.advances[g * out.place_stride + i] = profiles.advance(g, i);
    }
    GuideRecord& record = out.records[g];
    const Spine<float>& spine = profiles.spines[g];
    record.turns = spine.turns;
    for (int axis = 0; axis < 3; ++axis) record.normal[axis] = normal[axis];
    for (int j = 0; j < kSpineTerms; ++j) {
        const Vec3f term = profiles.root_frames[g] * spine.terms[j];
        for (int axis = 0; axis < 3; ++axis) record.spine[j][axis] = term[axis];
    }
    out.root_frames[g] = Eigen::Quaternionf(profiles.root_frames[g]).normalized();
}

void write_frenet(const GuideProfiles<float>& profiles, std::size_t g,
                  KernelGuides& out) {
    const Mat3f& to_space = profiles.root_frames[g];
    const ProfileInterval<float>* intervals = &profiles.intervals[g * out.count];
    const auto write3 = [](float* rows, std::size_t stride, const Vec3f& v) {
        for (int axis = 0; axis < 3; ++axis) rows[axis * stride] = v[axis];
    };
    for (std::size_t i = 0; i < out.count; ++i) {
        const ProfileInterval<float>& interval = intervals[i];
        const std::size_t stride = out.place_stride;
        float* rows = &out.frenet[g * 8 * stride + i];
        rows[0] = interval.kappa;
        rows[stride] = interval.tau;
        write3(rows + 2 * stride, stride, to_space * interval.tangent);
        write3(rows + 5 * stride, stride, to_space * interval.normal);
    }
    for (std::size_t j = 0; j < out.joint_places.size(); ++j) {
        const std::size_t i = out.joint_places[j], stride = out.joint_stride;
        float* rows = &out.joints[g * 11 * stride + j];
        write3(rows, stride, to_space * Vec3f(profiles.tangent(g, i)));
        if (i > 0) {
            write3(rows + 3 * stride, stride, to_space * intervals[i - 1].normal_after);
            rows[6 * stride] = intervals[i - 1].kappa;
        }
        write3(rows + 7 * stride, stride, to_space * intervals[i].normal_before);
        rows[10 * stride] = intervals[i].kappa;
    }
}

}  // namespace

KernelGuides kernel_guides(const GuideProfiles<float>& profiles,
                           std::span<const Vec3f> normals, Blend blend) {
    require(normals.size() == profiles.size(),
            "kernel_guides: expected one normal per guide");
    const BlendTraits& traits = traits_of(blend);
    const bool places = traits.kernel == BlendKernel::position;
    const bool frenet = traits.rates == BlendRates::blended;
    KernelGuides out;
    if (traits.kernel == BlendKernel::none) return out;
    out.size = profiles.size();
    out.count = std::size_t(profiles.count);
    out.point_stride = padded(out.count + 3);
    out.place_stride = padded(out.count + 1);
    if (places) {
        out.points = zeros(out.size * 3 * out.point_stride);
    } else {
        out.curvatures = zeros(out.size * 3 * out.place_stride);
        out.advances = zeros(out.size * out.place_stride);
        out.most_curved.resize(out.size);
        out.records.resize(out.size);
        out.root_frames.resize(out.size);
    }
    if (frenet) {
        out.joint_places.push_back(0);
        for (std::size_t i = 1; i < out.count; ++i) {
            if (profiles.joints[i]) out.joint_places.push_back(std::uint32_t(i));
        }
        out.joint_stride = padded(out.joint_places.size());
        out.frenet = zeros(out.size * 8 * out.place_stride);
        out.joints = zeros(out.size * 11 * out.joint_stride);
    }
    cancellable_for(std::size_t(0), out.size, [&](std::size_t g) {
        if (places) {
            write_points(profiles, g, out);
        } else {
            write_curl(profiles, g, normals[g], out);
        }
        if (frenet) write_frenet(profiles, g, out);
    });
    return out;
}

std::size_t KernelGuides::bytes() const {
    const std::size_t floats = points.size() + curvatures.size() + advances.size() +
                               most_curved.size() + frenet.size() + joints.size();
    return floats * sizeof(float) + joint_places.size() * sizeof(std::uint32_t) +
           records.size() * sizeof(GuideRecord) +
           root_frames.size() * sizeof(Eigen::Quaternionf);
}

}  // namespace lancret
