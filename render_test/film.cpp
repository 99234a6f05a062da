#include "render_test/film.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace lancret {
namespace {

void add_hit(Film& film, std::size_t pixel, const Hit& hit, const Ray& ray,
             const Vec3f& view) {
    Image& sums = film.sums;
    const float depth = hit.distance * ray.direction.dot(view);
    sums.depth[pixel] =
        film.hits[pixel] == 0 ? depth : std::min(sums.depth[pixel], depth);
    ++film.hits[pixel];
    const bool away = hit.normal.dot(ray.direction) > 0;
    sums.normal[pixel] += away ? Vec3f(-hit.normal) : hit.normal;
    if (hit.kind == Hit::Kind::strand) sums.tangent[pixel] += hit.tangent;
}

std::uint32_t id_of(const PathResult& path) {
    if (!path.first) return kNothingId;
    return path.first->kind == Hit::Kind::strand ? path.first->strand : kMeshId;
}

}  // namespace

Film::Film(int width, int height, const Channels& channels)
    : sums(width, height), hits(sums.rgba.size()) {
    if (channels.variance) squares.resize(sums.rgba.size(), Eigen::Vector4f::Zero());
}

void add_sample(Film& film, std::size_t pixel, int before, const PathResult& path,
                const Ray& ray, const Vec3f& view) {
    Eigen::Vector4f sample;
    sample << path.radiance, path.coverage;
    Eigen::Vector4f& sum = film.sums.rgba[pixel];
    sum += sample;
    if (!film.squares.empty() && before > 0) {
        // [Youngs and Cramer 1971]: no difference of large numbers, never below zero.
        const auto n = float(before + 1);
        film.squares[pixel] += (n * sample - sum).cwiseAbs2() / (n * float(before));
    }
    if (path.first) add_hit(film, pixel, *path.first, ray, view);
    if (before == 0) film.sums.id[pixel] = id_of(path);
}

Eigen::Vector4f variance_of_mean(const Film& film, std::size_t pixel, int samples) {
    if (samples < 2) return Eigen::Vector4f::Zero();
    return film.squares[pixel] / (float(samples) * float(samples - 1));
}

void finish_pixel(const Film& film, std::size_t pixel, int samples, Image& image) {
    image.rgba[pixel] *= 1 / float(samples);
    if (!image.rgba[pixel].allFinite())
        throw std::runtime_error("pixel " + std::to_string(pixel % image.width) + ", " +
                                 std::to_string(pixel / image.width) +
                                 " is not a finite number: please report this");
    if (!film.squares.empty())
        image.variance[pixel] = variance_of_mean(film, pixel, samples);
    if (film.hits[pixel] == 0) return;
    const auto hits = float(film.hits[pixel]);
    image.normal[pixel] /= hits;
    image.tangent[pixel] /= hits;
}

}  // namespace lancret
