#include "guides/made/made_groom.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "guides/base/hash.h"
#include "guides/helix/helix.h"
#include "guides/mesh/scalp.h"
#include "guides/mesh/scalp_roots.h"

namespace lancret {

namespace {

constexpr std::uint32_t kAround = 72, kUp = 40;  ///< cells of the head

/// What a random number is for.
enum Salt : std::uint64_t {
    kLength = 1,
    kRadius,
    kWavelength,
    kPhase,
    kLayer,
    kLift,
    kOwnLength,
    kFrizz = 100,
    kField = 1000,
};

// The head.

TriangleMesh make_head() {
    TriangleMesh mesh;
    const auto uv_of = [](std::uint32_t i, std::uint32_t j) {
        return Vec2f(float(i) / kAround, float(j) / kUp);
    };
    for (std::uint32_t j = 0; j <= kUp; ++j) {
        for (std::uint32_t i = 0; i <= kAround; ++i) {
            // The last column equals the first, and a pole is one position, bit for bit.
            const double azimuth = (2 * kPi) * (i % kAround) / kAround;
            const double height = kPi * j / kUp;
            const double ring = j % kUp == 0 ? 0 : std::sin(height);
            const Vec3 p(ring * std::sin(azimuth), -std::cos(height),
                         ring * std::cos(azimuth));
            mesh.positions.emplace_back(p.cwiseProduct(kMadeHead).cast<float>());
        }
    }
    const auto add = [&](std::array<std::array<std::uint32_t, 2>, 3> corners) {
        auto& triangle = mesh.triangles.emplace_back();
        auto& uvs = mesh.uvs.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
            const auto [i, j] = corners[c];
            triangle[c] = j * (kAround + 1) + i;
            uvs[c] = uv_of(i, j);
        }
    };
    for (std::uint32_t j = 0; j < kUp; ++j) {
        for (std::uint32_t i = 0; i < kAround; ++i) {
            // At a pole one of the two triangles would have no area.
            if (j > 0) add({{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
            if (j + 1 < kUp) add({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
        }
    }
    return mesh;
}

/// Whether hair grows at a place of the head: above a line that runs from the forehead
/// over the ears to the nape.
bool within_hairline(const Vec3& p) {
    const Vec3 d = p.cwiseQuotient(kMadeHead).normalized();
    const double ring = std::hypot(d.x(), d.z());
    const double front = ring > 0 ? d.z() / ring : 0;  // 1 at the face, -1 at the nape
    const double line =
        front > 0 ? 0.60 * front * front * (3 - 2 * front) - 0.02 : 0.45 * front - 0.02;
    return d.y() > line;
}

TriangleMesh scalp_of(const TriangleMesh& head) {
    TriangleMesh scalp;
    constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> kept(head.positions.size(), kNone);
    for (std::size_t i = 0; i < head.triangles.size(); ++i) {
        Vec3f centre = Vec3f::Zero();
        for (const auto v : head.triangles[i]) centre += head.positions[v] / 3;
        if (!within_hairline(centre.cast<double>())) continue;
        auto& triangle = scalp.triangles.emplace_back(head.triangles[i]);
        scalp.uvs.push_back(head.uvs[i]);
        for (auto& v : triangle) {
            if (kept[v] == kNone) {
                kept[v] = std::uint32_t(scalp.positions.size());
                scalp.positions.push_back(head.positions[v]);
            }
            v = kept[v];
        }
    }
    return scalp;
}

/// Distance from the head enlarged by `clearance`, cm to first order; negative inside.
double height_above(const Vec3& p, double clearance) {
    const Vec3 axes = kMadeHead.array() + clearance;
    const Vec3 d = p.cwiseQuotient(axes);
    const double norm = d.norm();
    return norm * (norm - 1) / d.cwiseQuotient(axes).norm();
}

Vec3 outwards(const Vec3& p) {
    return p.cwiseQuotient(kMadeHead).cwiseQuotient(kMadeHead).normalized();
}

// The hair.

/// A number in about [-1, 1] that varies smoothly over the scalp, in waves of 9 to 18 cm.
double field(const Vec3& p, std::uint64_t seed, std::uint64_t salt) {
    double sum = 0;
    for (std::uint64_t k = 0; k < 4; ++k) {
        const auto random = [&](std::uint64_t j) {
            return unit_double(hash_bits(seed, 8 * k + j, kField + salt));
        };
        const Vec3 direction(random(0) - 0.5, random(1) - 0.5, random(2) - 0.5);
        const double wavelength = 9 + 9 * random(3);
        // The constant keeps the direction from being zero.
        const Vec3 unit = (direction + Vec3(1e-3, 0, 0)).normalized();
        sum += std::sin((2 * kPi) * (unit.dot(p) / wavelength + random(4)));
    }
    return std::clamp(sum / 2, -1.0, 1.0);
}

/// The direction in which hair is combed and falls at a place outside the head.
Vec3 combed(const Vec3& p, double parted) {
    const Vec3 n = outwards(p);
    // On top it is combed away from the parting and slightly back; on the sides it falls.
    const double top = std::pow(std::max(0.0, n.y()), 1.5);
    Vec3 way(2.2 * top * parted, -1, -1.1 * top * (1 - 0.4 * std::abs(parted)));
    // Off the cheeks, and towards the neck below the head.
    way.z() -= 0.35 * std::max(0.0, n.z());
    const double below = std::clamp((-p.y() - 3) / 8, 0.0, 1.0);
    way -= 0.22 * below * Vec3(p.x() / 9, 0, p.z() / 9);
    return way.normalized();
}

struct Strand {
    const MadeGroomSettings& settings;
    std::uint64_t id;
    Vec3 root, normal;

    double random(std::uint64_t salt) const {
        return unit_double(hash_bits(settings.seed, id, salt));
    }
    /// Variation in about [-1, 1]: smooth over the scalp, but `share` of it per strand.
    double vary(std::uint64_t salt, double share) const {
        return (1 - share) * field(root, settings.seed, salt) +
               share * (2 * random(salt) - 1);
    }
    double length() const {
        const double height =
            std::clamp(root.y() / kMadeHead.y() * 0.65 + 0.35, 0.0, 1.0);
        const double t =
            std::clamp(0.85 * height + 0.075 + 0.075 * vary(kLength, 0.5), 0.0, 1.0);
        const double spread = 1 + settings.length_spread * (2 * random(kOwnLength) - 1);
        return spread * (settings.shortest + t * (settings.longest - settings.shortest));
    }
    struct Curl {
        double wavelength;  ///< cm
        double phase;       ///< radian, at the root
        double slope;       ///< of the strand against its spine
    };
    Curl curl() const;
    Vec3 waved(const Curl& waves, double s, const Vec3& spine, const Vec3& across) const;
    std::vector<Vec3> points() const;
};

/// A direction near `direction` along which a step of `ds` from `p` ends outside the head
/// grown by `clearance`.
Vec3 kept_out(const Vec3& p, Vec3 direction, double ds, double clearance) {
    for (int i = 0; i < 40; ++i) {
        const Vec3 next = p + ds * direction;
        const double height = height_above(next, clearance);
        if (height >= 0) return direction;
        direction =
            (direction + outwards(next) * (0.01 - 1.05 * height / ds)).normalized();
    }
    return outwards(p);
}

Strand::Curl Strand::curl() const {
    const double radius = settings.curl_radius * (1 + 0.5 * vary(kRadius, 0.25));
    const double wavelength =
        settings.curl_wavelength * (1 + vary(kWavelength, 0.15) / 3);
    const double phase = (2 * kPi) * (0.9 * field(root, settings.seed, kPhase) +
                                      settings.phase_spread * (2 * random(kPhase) - 1));
    const double slope = wavelength > 0 ? (2 * kPi) * radius / wavelength : 0;
    return {wavelength, phase, slope};
}

/// The strand's direction at arc length `s`: its spine's, with the curl and the frizz.
Vec3 Strand::waved(const Curl& waves, double s, const Vec3& spine,
                   const Vec3& across) const {
    const Vec3 along = spine.cross(across);
    const double grown = 1 - std::exp(-s * s / 16);  // waves start away from the root
    const double turn =
        waves.wavelength > 0 ? (2 * kPi) * s / waves.wavelength + waves.phase : 0;
    Vec3 direction = spine + grown * waves.slope *
                                 (std::cos(turn) * across + 0.7 * std::sin(turn) * along);
    for (std::uint64_t k = 0; k < 3; ++k) {
        const double fine = 1.2 + 2.5 * random(kFrizz + 3 * k);
        const double angle = (2 * kPi) * random(kFrizz + 3 * k + 1);
        direction += settings.frizz * grown *
                     std::sin((2 * kPi) * (s / fine + random(kFrizz + 3 * k + 2))) *
                     (std::cos(angle) * across + std::sin(angle) * along);
    }
    direction.normalize();
    return direction;
}

/// In contact at `p` the spine slides along the head.
void slide_along_head(const Vec3& p, Vec3& spine, Vec3& across) {
    const Vec3 n = outwards(p);
    const double inwards = std::min(0.0, spine.dot(n));
    const Vec3 slid = spine - inwards * n;
    if (slid.norm() > 1e-3) {
        across = smallest_rotation<double>(spine, slid.normalized()) * across;
        spine = slid.normalized();
    }
}

std::vector<Vec3> Strand::points() const {
    const double ds = length() / (settings.points - 1);
    const Curl waves = curl();
    const double layer = 0.12 + 0.9 * std::pow(random(kLayer), 1.5);

    // Away from the parting, which is sharp in front and fades behind the crown.
    const double sharp = 0.15 + 3.5 * std::clamp((-root.z() - 1) / 6, 0.0, 1.0);
    const double parted = std::tanh(root.x() / sharp);

    Vec3 comb = combed(root, parted);
    comb -= normal * normal.dot(comb);
    Vec3 spine = (normal + (0.9 + 0.3 * random(kLift)) * comb).normalized();
    Vec3 across = normal.cross(spine);
    across = across.norm() > 1e-6 ? across.normalized() : spine.unitOrthogonal();

    std::vector<Vec3> points{root};
    for (int i = 1; i < settings.points; ++i) {
        const Vec3& p = points.back();
        const double s = (i - 0.5) * ds;
        // Over 1.9 cm the spine bends to the direction of the comb; it carries `across`.
        const Vec3 before = spine;
        spine = (spine + (1 - std::exp(-ds / 1.9)) * (combed(p, parted) - spine))
                    .normalized();
        across = smallest_rotation<double>(before, spine) * across;
        across = (across - spine * spine.dot(across)).normalized();
        const Vec3 direction = waved(waves, s, spine, across);
        const double clearance = 0.02 + layer * (1 - std::exp(-s / 2));
        const Vec3 kept = kept_out(p, direction, ds, clearance);
        if (kept != direction) slide_along_head(p, spine, across);
        points.push_back(p + ds * kept);
    }
    return points;
}

/// The line at which the combing changes sides, as far as that change is sharp.
std::vector<Vec3> middle_parting() {
    constexpr double kEnd = -0.16, kStart = 0.96;  // radian from the top, face positive
    constexpr int kPieces = 40;
    std::vector<Vec3> out;
    for (int i = 0; i <= kPieces; ++i) {
        const double angle = kStart + (kEnd - kStart) * i / kPieces;
        out.push_back(Vec3(0, std::cos(angle), std::sin(angle)).cwiseProduct(kMadeHead));
    }
    return out;
}

}  // namespace

void check_made(const MadeGroomSettings& s) {
    constexpr double kMax = 1e4;  // also false for a NaN
    require(s.strands > 0 && s.points >= 4 &&
                double(s.strands) * s.points <= std::numeric_limits<std::uint32_t>::max(),
            "make_groom: expected at least one strand, of at least four points");
    require(s.shortest > 0 && s.longest >= s.shortest && s.longest <= kMax,
            "make_groom: expected 0 < shortest <= longest");
    require(
        s.curl_radius >= 0 && s.curl_radius <= kMax && s.curl_wavelength >= 0 &&
            s.curl_wavelength <= kMax && s.frizz >= 0 && s.frizz <= kMax,
        "make_groom: expected a curl radius, curl wavelength and frizz of at least 0");
    require(s.phase_spread >= 0 && s.phase_spread <= kMax && s.length_spread >= 0 &&
                s.length_spread < 1,
            "make_groom: expected a phase spread of at least 0 and a length spread in "
            "[0, 1)");
}

MadeGroom make_groom(const MadeGroomSettings& settings) {
    check_made(settings);
    MadeGroom groom;
    groom.head = make_head();
    groom.scalp = scalp_of(groom.head);
    groom.parting = middle_parting();
    const Scalp scalp = make_scalp(groom.scalp);
    const auto count = std::size_t(settings.strands),
               points = std::size_t(settings.points);
    const auto roots = scalp_roots(scalp, count, settings.seed);

    Strands& strands = groom.strands;
    strands.default_thickness = 0.008f;
    strands.default_colour = {0.23f, 0.13f, 0.07f};
    strands.points.resize(count * points);
    for (std::size_t i = 1; i <= count; ++i) {
        strands.first.push_back(std::uint32_t(i * points));
    }
    cancellable_for(std::size_t(0), count, [&](std::size_t i) {
        const Strand strand{settings, i, scalp_position(scalp, roots[i]),
                            scalp_normal(scalp, roots[i])};
        const std::vector<Vec3> made = strand.points();
        std::transform(made.begin(), made.end(),
                       strands.points.begin() + std::ptrdiff_t(i * points),
                       [](const Vec3& p) { return p.cast<float>(); });
    });
    return groom;
}

}  // namespace lancret
