#include "sim/restart_arrays.h"

#include <algorithm>
#include <cmath>

#include "guides/base/errors.h"

namespace lancret {

void write(const Vec3& v, std::vector<double>& out) {
    out.insert(out.end(), v.begin(), v.end());
}

void write(const RodPast& past, int segments, std::vector<double>& out) {
    out.push_back(past.size);
    out.push_back(past.eps);
    for (const RodPose& pose : past.poses) {
        // Poses beyond the size may hold old values, which must not reach the file.
        const bool used = &pose - past.poses < past.size;
        write(used ? pose.root.position : Vec3::Zero(), out);
        for (int c = 0; c < 3; ++c) {
            write(used ? Vec3(pose.root.frame.col(c)) : Vec3::Unit(c), out);
        }
        for (int q = 0; q < segments; ++q) {
            write(used ? pose.curvatures[std::size_t(q)] : Vec3::Zero(), out);
        }
    }
}

void write(const ContactAnchor& anchor, std::vector<double>& out) {
    // Without a body the distance is infinite, which is not a number for a file.
    const SurfaceSample body = anchor.touches() ? anchor.body : SurfaceSample{0};
    for (const double x :
         {body.distance, double(body.collider), double(body.triangle), anchor.pressure}) {
        out.push_back(x);
    }
    for (const Vec3& v : {body.normal, body.point, anchor.position}) write(v, out);
}

ArrayReader::ArrayReader(const RestartArrays& arrays, const char* name) {
    const auto found = arrays.find(name);
    require(found != arrays.end(), "restart: an array is missing");
    left_ = found->second;
}

double ArrayReader::number() {
    require(!left_.empty(), "restart: an array is too short");
    const double out = left_.front();
    require(std::isfinite(out), "restart: expected a finite number");
    left_ = left_.subspan(1);
    return out;
}

int ArrayReader::whole(int low, int high) {
    const double x = number();
    require(x >= low && x <= high && x == std::floor(x),
            "restart: expected a whole number within its range");
    return int(x);
}

Vec3 ArrayReader::vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
}

void read(ArrayReader& from, int segments, RodPast& past) {
    past.size = from.whole(0, RodPast::kMax);
    past.eps = from.number();
    require(past.size == 0 || past.eps > 0,
            "restart: the step of a past must be above 0");
    for (RodPose& pose : past.poses) {
        pose.root.position = from.vector();
        for (int c = 0; c < 3; ++c) pose.root.frame.col(c) = from.vector();
        pose.curvatures.resize(std::size_t(segments));
        for (Vec3& k : pose.curvatures) k = from.vector();
    }
}

void read(ArrayReader& from, const Colliders& colliders, ContactAnchor& anchor) {
    anchor = {};
    SurfaceSample& body = anchor.body;
    body.distance = from.number();
    body.collider = from.whole(-1, colliders.size() - 1);
    const std::size_t triangles =
        body.collider < 0 ? 0 : colliders.triangles(body.collider);
    body.triangle = std::uint32_t(from.whole(0, std::max(int(triangles), 1) - 1));
    anchor.pressure = from.number();
    body.normal = from.vector();
    body.point = from.vector();
    anchor.position = from.vector();
}

}  // namespace lancret
