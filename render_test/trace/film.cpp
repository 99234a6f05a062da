#include "render_test/trace/film.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace lancret {
namespace {

std::uint32_t id_of(const PathResult& path) {
    if (!path.first) return kNothingId;
    return path.first->kind == Hit::Kind::strand ? path.first->strand.id : kMeshId;
}

void add_hit(Film& film, std::size_t pixel, const Sighting& sighting) {
    Image& sums = film.sums;
    const Hit& hit = *sighting.path.first;
    const bool strand = hit.kind == Hit::Kind::strand;
    float& depth = sums.depth[pixel];
    depth = film.hits[pixel] == 0 ? sighting.depth : std::min(depth, sighting.depth);
    ++film.hits[pixel];
    const bool away = hit.normal.dot(sighting.direction) > 0;
    sums.normal[pixel] += away ? Vec3f(-hit.normal) : hit.normal;
    if (strand) sums.tangent[pixel] += hit.tangent;
    if (!sums.motion.empty()) sums.motion[pixel] += sighting.motion;
    if (sums.objects.empty()) return;
    sums.objects[pixel].add(id_of(sighting.path), sighting.path.coverage);
    if (!strand) sums.body[pixel] += sighting.path.coverage;
}

}  // namespace

Film::Film(int width, int height, const Channels& channels)
    : sums(width, height), hits(sums.rgba.size()), samples(sums.rgba.size()) {
    const std::size_t pixels = hits.size();
    if (channels.variance) squares.resize(pixels, Eigen::Vector4f::Zero());
    if (channels.motion) sums.motion.resize(pixels, Vec2f::Zero());
    if (channels.mattes) sums.objects.resize(pixels), sums.body.resize(pixels);
    if (channels.deep) sums.deep.resize(pixels);
    if (channels.value) sums.value.resize(pixels);
}

void add_sample(Film& film, std::size_t pixel, const Sighting& sighting) {
    const std::uint32_t before = film.samples[pixel]++;
    const PathResult& path = sighting.path;
    Eigen::Vector4f sample;
    sample << path.radiance, path.coverage;
    Eigen::Vector4f& sum = film.sums.rgba[pixel];
    sum += sample;
    if (!film.squares.empty() && before > 0) {
        // [Youngs and Cramer 1971]: no difference of large numbers, never negative.
        const auto n = float(before + 1);
        film.squares[pixel] += (n * sample - sum).cwiseAbs2() / (n * float(before));
    }
    if (path.first) add_hit(film, pixel, sighting);
    if (before > 0) return;
    film.sums.id[pixel] = id_of(path);
    if (!film.sums.value.empty()) film.sums.value[pixel] = path.value;
}

void gather_deep(const Sighting& sighting, std::vector<DeepSample>& gathered) {
    const PathResult& path = sighting.path;
    if (!path.first) return;
    gathered.push_back({id_of(path), sighting.depth, path.coverage, path.radiance});
}

void add_deep(Film& film, std::size_t pixel, std::vector<DeepSample>& gathered) {
    std::vector<DeepSample>& kept = film.sums.deep[pixel];
    gathered.insert(gathered.end(), kept.begin(), kept.end());
    merge(gathered, film.deep_gap);
    kept.assign(gathered.begin(), gathered.end());
    gathered.clear();
}

Eigen::Vector4f variance_of_mean(const Film& film, std::size_t pixel) {
    const auto samples = float(film.samples[pixel]);
    if (samples < 2) return Eigen::Vector4f::Zero();
    return film.squares[pixel] / (samples * (samples - 1));
}

void finish_pixel(const Film& film, std::size_t pixel, Image& image) {
    const float share = 1 / float(film.samples[pixel]);
    image.rgba[pixel] *= share;
    if (!image.rgba[pixel].allFinite()) {
        throw std::runtime_error("pixel " + std::to_string(pixel % image.width) + ", " +
                                 std::to_string(pixel / image.width) +
                                 " is not a finite number: please report this");
    }
    if (!image.variance.empty()) image.variance[pixel] = variance_of_mean(film, pixel);
    if (!image.objects.empty()) {
        image.objects[pixel].scale(share);
        image.body[pixel] *= share;
    }
    if (!image.deep.empty()) {
        for (DeepSample& s : image.deep[pixel]) s.coverage *= share, s.radiance *= share;
    }
    if (film.hits[pixel] == 0) return;
    const auto hits = float(film.hits[pixel]);
    image.normal[pixel] /= hits;
    image.tangent[pixel] /= hits;
    if (!image.motion.empty()) image.motion[pixel] /= hits;
}

}  // namespace lancret
