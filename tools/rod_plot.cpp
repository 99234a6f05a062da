#include "tools/rod_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render_test/image.h"

namespace lancret {

namespace {

const Vec3f kInk(0.01f, 0.015f, 0.04f), kGrey(0.45f, 0.45f, 0.45f),
    kGrid(0.85f, 0.85f, 0.85f), kAxis(0.3f, 0.3f, 0.3f), kRed(0.6f, 0.03f, 0.02f);
constexpr int kPanel = 640, kMargin = 70, kLetters = 18;

using Line = std::vector<Vec2>;  ///< pixels, y down

/// Points along the rod, with those of each segment enough for its turn.
std::vector<Vec3> points_of(const HangingRod& rod, const Eigen::VectorXd& q) {
    const std::vector<HelixState<double>> joints = rod_joints(rod, q);
    std::vector<Vec3> out = {joints[0].position};
    for (std::size_t i = 0; i < rod.segments(); ++i) {
        const Vec3 k = q.segment<3>(3 * i);
        const double turn = k.norm() * rod.lengths[i];
        const int parts = int(std::clamp(std::ceil(turn * 20), 4., 5000.));
        for (int p = 1; p <= parts; ++p) {
            HelixState<double> at = joints[i];
            advance<double>(at, k, rod.lengths[i] * p / parts);
            out.push_back(at.position);
        }
    }
    return out;
}

/// A line of round ends, `width` pixels thick, with smooth edges.
void draw_line(Image& image, const Line& line, double width, const Vec3f& colour) {
    std::vector<float> cover(image.rgba.size(), 0);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec2 a = line[i], along = line[i + 1] - a;
        const double reach = width / 2 + 1, square = along.squaredNorm();
        const Vec2 low = a.cwiseMin(line[i + 1]), high = a.cwiseMax(line[i + 1]);
        const auto clip = [&](double x, int most) {
            return int(std::clamp(x, 0., double(most - 1)));
        };
        for (int y = clip(low.y() - reach, image.height);
             y <= clip(high.y() + reach, image.height); ++y) {
            for (int x = clip(low.x() - reach, image.width);
                 x <= clip(high.x() + reach, image.width); ++x) {
                const Vec2 to = Vec2(x + 0.5, y + 0.5) - a;
                const double t =
                    square > 0 ? std::clamp(to.dot(along) / square, 0., 1.) : 0;
                const double inside = width / 2 + 0.5 - (to - t * along).norm();
                float& pixel = cover[std::size_t(y) * image.width + x];
                pixel = std::max(pixel, float(std::clamp(inside, 0., 1.)));
            }
        }
    }
    for (std::size_t i = 0; i < cover.size(); ++i) {
        auto pixel = image.rgba[i].head<3>();
        pixel += cover[i] * (colour - Vec3f(pixel));
    }
}

/// 1, 2 or 5 times a power of ten, so that `range` has at most 7 steps.
double tick_step(double range) {
    double step = std::pow(10, std::floor(std::log10(range / 7)));
    for (const double factor : {2., 2.5, 2.}) {
        if (range / step > 7) step *= factor;
    }
    return step;
}

/// One view: what is across it, in world axes, and where it stands in the picture.
struct View {
    Vec3 across = Vec3::UnitX();
    Vec2 low = Vec2::Zero();   ///< the world's corner at the lower left
    double scale = 1;          ///< pixels for a length
    int left = 0;              ///< pixels
    Vec2 size = Vec2::Zero();  ///< pixels

    Vec2 pixel(double h, double z) const {
        return {left + (h - low.x()) * scale, kMargin + size.y() - (z - low.y()) * scale};
    }
    Line line(const std::vector<Vec3>& points) const {
        Line out;
        for (const Vec3& p : points) out.push_back(pixel(across.dot(p), p.z()));
        return out;
    }
};

void draw_grid(Image& image, const View& view, const char* name) {
    const Vec2 range = view.size / view.scale;
    const double step = tick_step(range.maxCoeff());
    const auto text = [&](const Vec2& at, const std::string& words) {
        draw_text(image, int(at.x()), int(at.y()), words, kLetters, kAxis);
    };
    const auto label = [](double x) { return fmt::format("{:.3g}", x + 0.0); };
    for (int axis = 0; axis < 2; ++axis) {
        const double first = std::ceil(view.low[axis] / step - 1e-9);
        for (double i = first; i * step < view.low[axis] + range[axis] * (1 + 1e-9);
             ++i) {
            Vec2 a = view.low, b = view.low + range;
            a[axis] = b[axis] = i * step;
            const Vec2 from = view.pixel(a.x(), a.y()), to = view.pixel(b.x(), b.y());
            draw_line(image, {from, to}, 1, i == 0 ? kGrey : kGrid);
            const Vec2 outwards = axis == 0 ? Vec2(0, 6) : Vec2(-6, 0);
            draw_line(image, {from, from + outwards}, 1, kAxis);
            const std::string words = label(i == 0 ? 0 : i * step);
            text(from + (axis == 0 ? Vec2(-4. * words.size(), 24)
                                   : Vec2(-10 - 10. * words.size(), 6)),
                 words);
        }
    }
    const Vec2 a = view.pixel(view.low.x(), view.low.y());
    const Vec2 b = a + Vec2(view.size.x(), -view.size.y());
    draw_line(image, {a, {b.x(), a.y()}, b, {a.x(), b.y()}, a}, 1, kAxis);
    text({a.x(), b.y() - 12}, name);
}

}  // namespace

void write_rod_plot(const std::filesystem::path& path, const RodReport& report) {
    const std::vector<Vec3> hanging = points_of(report.rod, report.hung.q);
    const std::vector<Vec3> natural =
        points_of(report.rod, natural_curvatures(report.rod));
    const Mat3& root = report.rod.root.frame;
    Vec3 side = root.col(0);
    side.z() = 0;
    if (side.norm() < 1e-3) side = root.col(1) - root.col(1).z() * Vec3::UnitZ();
    side.normalize();
    const Vec3 front = Vec3::UnitZ().cross(side);

    // One scale for all: the longest extent fills a panel, with a twentieth to spare.
    std::vector<View> views(1);
    views[0].across = side;
    double off_plane = 0;
    for (const Vec3& p : hanging) off_plane = std::max(off_plane, std::abs(front.dot(p)));
    for (const Vec3& p : natural) off_plane = std::max(off_plane, std::abs(front.dot(p)));
    if (off_plane > 0.01) views.emplace_back().across = front;
    std::vector<Vec2> extents;
    double longest = 0.1;
    for (View& view : views) {
        Vec2 low(0, 0), high(0, 0);
        for (const auto* shape : {&hanging, &natural}) {
            for (const Vec3& p : *shape) {
                const Vec2 at(view.across.dot(p), p.z());
                low = low.cwiseMin(at);
                high = high.cwiseMax(at);
            }
        }
        const Vec2 spare = Vec2::Constant(std::max(0.05 * (high - low).maxCoeff(), 0.02));
        view.low = low - spare;
        extents.push_back(high - low + 2 * spare);
        longest = std::max(longest, extents.back().maxCoeff());
    }
    int width = 0, height = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        View& view = views[i];
        view.scale = kPanel / longest;
        view.size = extents[i] * view.scale;
        // Wide enough for its words.
        view.size.x() = std::max(view.size.x(), 280.);
        view.low.x() -= (view.size.x() / view.scale - extents[i].x()) / 2;
        view.left = width + kMargin;
        width += int(view.size.x()) + kMargin + kMargin / 3;
        height = std::max(height, int(view.size.y()) + 2 * kMargin);
    }

    Image image(width, height);
    for (auto& pixel : image.rgba) pixel.setOnes();
    for (std::size_t i = 0; i < views.size(); ++i) {
        const View& view = views[i];
        draw_grid(image, view, i == 0 ? "from the side" : "from the front");
        draw_line(image, view.line(natural), 2, kGrey);
        draw_line(image, view.line(hanging), 4, kInk);
        const Vec2 at = view.pixel(0, 0);
        draw_line(image, {at, at}, 12, kRed);
    }
    const Vec3& n = report.setup.natural;
    draw_text(image, kMargin, 24,
              fmt::format("gamma {:g}, natural ({:.4g}, {:.4g}, {:.4g})",
                          report.setup.gamma, n.x(), n.y(), n.z()),
              kLetters, kInk);
    write_image(path, image, Vec3f(1, 1, 1));
}

}  // namespace lancret
