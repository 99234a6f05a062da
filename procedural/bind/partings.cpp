#include "procedural/bind/partings.h"

#include <algorithm>
#include <cmath>

#include "guides/base/errors.h"

namespace lancret {

namespace {

constexpr double kMaxPieces = 20000;

/// The height above or below the line of sight from which a parting has no effect, cm.
double height_limit(double length) { return 0.5 + 0.5 * length; }

/// A line of sight of `length` cm along x, whose end is `rise` cm above its start.
struct Line {
    double length, rise;

    /// How much of the line a parting blocks, 0 to 1: at `x` along the line, `y` beside
    /// it and `z` above the child's plane.
    double blocked(double x, double y, double z) const {
        const double ends = std::min(x, length - x);
        if (!(ends > 0)) return 0;
        const double beside = 1 - std::abs(y) / (kSightSlope * ends);
        if (!(beside > 0)) return 0;
        const double height = std::abs(z - rise * x / length) / height_limit(length);
        return beside * std::clamp(2 - 2 * height, 0.0, 1.0);
    }
};

}  // namespace

std::vector<Polyline> divided(std::span<const Polyline> lines, double longest) {
    double length = 0;
    for (const Polyline& line : lines) {
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            length += (line[i + 1] - line[i]).norm();
        }
    }
    longest = std::max(longest, length / kMaxPieces);
    std::vector<Polyline> out;
    for (const Polyline& line : lines) {
        Polyline& points = out.emplace_back();
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (i > 0) {
                const Vec3 from = line[i - 1], step = line[i] - from;
                const int parts = std::max(1, int(std::ceil(step.norm() / longest)));
                for (int p = 1; p < parts; ++p) {
                    points.push_back(from + step * (double(p) / parts));
                }
            }
            points.push_back(line[i]);
        }
    }
    return out;
}

Partings::Partings(std::span<const Polyline> lines) {
    for (const Polyline& line : lines) {
        const auto finite = [](const Vec3& p) { return p.allFinite(); };
        require(line.size() >= 2 && std::ranges::all_of(line, finite),
                "Partings: expected two or more finite points per line");
    }
    for (const Polyline& line : divided(lines)) {
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            pieces_.emplace_back(line[i], line[i + 1]);
        }
    }
    for (const auto& [a, b] : pieces_) {
        middles_.push_back((a + b) / 2);
        half_longest_ = std::max(half_longest_, (b - a).norm() / 2);
    }
    if (!pieces_.empty()) tree_ = std::make_unique<PointTree>(middles_);
}

void Partings::seen_from(const Vec3& child, const Vec3& up, double radius,
                         std::vector<SeenPiece>& seen,
                         std::vector<std::pair<std::uint32_t, double>>& scratch) const {
    seen.clear();
    if (pieces_.empty()) return;
    // A point on a line of sight is within `radius` of the child. A piece that blocks it
    // is beside it by at most kSightSlope / 2 of its length, and above or below it by at
    // most the height limit.
    const double ball =
        radius * (1 + kSightSlope / 2) + height_limit(radius) + half_longest_;
    if (tree_->nearest_squared(child) > ball * ball) return;
    tree_->within(child, ball, scratch);
    // The order of the results is not defined, but `sight` takes their maximum.
    for (const auto& [piece, squared] : scratch) {
        seen.push_back({seen_place(child, up, pieces_[piece].first),
                        seen_place(child, up, pieces_[piece].second)});
    }
}

Vec3 seen_place(const Vec3& child, const Vec3& up, const Vec3& place) {
    const Vec3 across = up.unitOrthogonal(), from = place - child;
    return {from.dot(across), from.dot(up.cross(across)), from.dot(up)};
}

double sight(const Vec3& guide, std::span<const SeenPiece> pieces) {
    const double length = std::hypot(guide.x(), guide.y());
    if (!(length > 1e-9)) return 1;
    const Line line{length, guide.z()};
    const double cosine = guide.x() / length, sine = guide.y() / length;
    double blocked = 0;
    for (const SeenPiece& piece : pieces) {
        const double ax = cosine * piece.from.x() + sine * piece.from.y();
        const double bx = cosine * piece.to.x() + sine * piece.to.y();
        if ((ax <= 0 && bx <= 0) || (ax >= length && bx >= length)) continue;
        const double ay = cosine * piece.from.y() - sine * piece.from.x();
        const double by = cosine * piece.to.y() - sine * piece.to.x();
        const double wide = kSightSlope * length / 2;
        if (std::min(ay, by) >= wide || std::max(ay, by) <= -wide) continue;
        const auto try_at = [&](double t) {
            const double z = piece.from.z() + t * (piece.to.z() - piece.from.z());
            blocked = std::max(blocked,
                               line.blocked(ax + t * (bx - ax), ay + t * (by - ay), z));
        };
        // On each side of the middle, |y| over the width is a quotient of linear
        // functions: its minimum is at an end, in the middle, or where the piece crosses
        // the line. The height of a piece hardly changes along its quarter of a
        // centimetre.
        try_at(0);
        try_at(1);
        const double middle = length / 2;
        if ((ax < middle) != (bx < middle)) try_at((middle - ax) / (bx - ax));
        if ((ay < 0) != (by < 0)) {
            const double t = ay / (ay - by), x = ax + t * (bx - ax);
            const double z = piece.from.z() + t * (piece.to.z() - piece.from.z());
            blocked = std::max(blocked, line.blocked(x, 0, z));
        }
        if (blocked >= 1) return 0;
    }
    return 1 - blocked;
}

}  // namespace lancret
