#include "tools/rod/rod_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render_test/files/write_image.h"
#include "render_test/image/draw.h"
#include "tools/rod/plot.h"

namespace lancret {

namespace {

constexpr int kPanel = 640;

/// Points along the rod, as many per segment as its turn needs.
std::vector<Vec3> points_of(const HangingRod& rod, const Eigen::VectorXd& q) {
    const std::vector<HelixState<double>> joints = rod_joints(rod, q);
    std::vector<Vec3> out = {joints[0].position};
    for (std::size_t i = 0; i < rod.segments(); ++i) {
        const Vec3 k = q.segment<3>(3 * i);
        const double turn = k.norm() * rod.lengths[i];
        const int parts = int(std::clamp(std::ceil(turn * 20), 4., 5000.));
        for (int p = 1; p <= parts; ++p) {
            HelixState<double> state = joints[i];
            advance<double>(state, k, rod.lengths[i] * p / parts);
            out.push_back(state.position);
        }
    }
    return out;
}

/// A view: its horizontal axis, in world axes, and its frame in the picture.
struct View {
    Vec3 across = Vec3::UnitX();
    Frame frame;

    Line line(const std::vector<Vec3>& points) const {
        Line out;
        for (const Vec3& p : points) out.push_back(frame.pixel(across.dot(p), p.z()));
        return out;
    }
};

/// A curve and its style.
struct Stroke {
    std::vector<Vec3> points;
    double width;  ///< pixels
    Vec3f colour;
};

/// Draws the strokes from the side and, if they leave that plane, from the front. `below`
/// is the height of the space left free under the views, pixels.
Image draw_shapes(const Mat3& root, const std::vector<Stroke>& strokes, int below) {
    Vec3 side = root.col(0);
    side.z() = 0;
    if (side.norm() < 1e-3) side = root.col(1) - root.col(1).z() * Vec3::UnitZ();
    side.normalize();
    const Vec3 front = Vec3::UnitZ().cross(side);

    // One scale for all views: the longest extent and its margins fill a panel.
    std::vector<View> views(1);
    views[0].across = side;
    double off_plane = 0;
    for (const Stroke& stroke : strokes) {
        for (const Vec3& p : stroke.points) {
            off_plane = std::max(off_plane, std::abs(front.dot(p)));
        }
    }
    if (off_plane > 0.01) views.emplace_back().across = front;
    std::vector<Vec2> extents;
    double longest = 0.1;
    for (View& view : views) {
        Vec2 low(0, 0), high(0, 0);
        for (const Stroke& stroke : strokes) {
            for (const Vec3& p : stroke.points) {
                const Vec2 seen(view.across.dot(p), p.z());
                low = low.cwiseMin(seen);
                high = high.cwiseMax(seen);
            }
        }
        const Vec2 spare = Vec2::Constant(std::max(0.05 * (high - low).maxCoeff(), 0.02));
        view.frame.low = low - spare;
        extents.push_back(high - low + 2 * spare);
        longest = std::max(longest, extents.back().maxCoeff());
    }
    int width = 0, height = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        Frame& frame = views[i].frame;
        frame.scale.setConstant(kPanel / longest);
        frame.size = extents[i] * kPanel / longest;
        // Wide enough for the labels.
        frame.size.x() = std::max(frame.size.x(), 280.);
        frame.low.x() -= (frame.size.x() / frame.scale.x() - extents[i].x()) / 2;
        frame.left = width + kMargin;
        width += int(frame.size.x()) + kMargin + kMargin / 3;
        height = std::max(height, int(frame.size.y()) + 2 * kMargin);
    }

    Image image(width, height + below);
    for (auto& pixel : image.rgba) pixel.setOnes();
    for (std::size_t i = 0; i < views.size(); ++i) {
        const View& view = views[i];
        draw_grid(image, view.frame, i == 0 ? "from the side" : "from the front");
        for (const Stroke& stroke : strokes) {
            draw_line(image, view.line(stroke.points), stroke.width, stroke.colour);
        }
        const Vec2 root_pixel = view.frame.pixel(0, 0);
        draw_line(image, {root_pixel, root_pixel}, 12, kRed);
    }
    return image;
}

void draw_title(Image& image, const RodReport& report, const std::string& more) {
    const Vec3& n = report.setup.natural;
    draw_text(image, kMargin, 24,
              fmt::format("gamma {:g}, natural ({:.4g}, {:.4g}, {:.4g}){}",
                          report.setup.gamma, n.x(), n.y(), n.z(), more),
              kLetters, kInk);
}

/// Draws the energies over time.
void draw_energy(Image& image, const Frame& frame, const RodRelease& release) {
    const auto curve = [&](double ReleaseSample::*part) {
        Line out;
        for (const ReleaseSample& s : release.samples) {
            out.push_back(frame.pixel(s.time, part ? s.*part : s.total()));
        }
        return out;
    };
    draw_grid(image, frame,
              "energy: total black, kinetic red, elastic green, weight blue");
    draw_line(image, curve(&ReleaseSample::kinetic), 2, kRed);
    draw_line(image, curve(&ReleaseSample::elastic), 2, kGreen);
    draw_line(image, curve(&ReleaseSample::weight), 2, kBlue);
    draw_line(image, curve(nullptr), 3, kInk);
}

void write_release_plot(const std::filesystem::path& path, const RodReport& report,
                        const RodRelease& release) {
    std::vector<Stroke> strokes;
    strokes.push_back({points_of(report.rod, report.equilibrium.q), 2, kRed});
    const std::size_t count = release.shapes.size();
    for (std::size_t i = 0; i < count; ++i) {
        const float age = 1 - float(i + 1) / float(count);
        strokes.push_back({points_of(report.rod, release.shapes[i]), 3,
                           kInk + 0.75f * age * (Vec3f::Ones() - kInk)});
    }
    constexpr int kGraph = 360;
    Image image = draw_shapes(report.rod.root.frame, strokes, kGraph);
    draw_title(image, report,
               fmt::format(", released, to t = {:g}", release.samples.back().time));
    double low = 0, high = 0;
    for (const ReleaseSample& s : release.samples) {
        for (const double e : {s.kinetic, s.elastic, s.weight, s.total()}) {
            low = std::min(low, e);
            high = std::max(high, e);
        }
    }
    const double range = std::max(high - low, 1e-9);
    Frame frame;
    frame.left = kMargin + kMargin / 2;
    frame.top = image.height - kGraph + kMargin / 3;
    frame.size = {double(image.width - frame.left - kMargin / 3),
                  double(kGraph - kMargin)};
    frame.low = {0, low - 0.05 * range};
    frame.scale = {frame.size.x() / std::max(release.samples.back().time, 1e-300),
                   frame.size.y() / (1.1 * range)};
    draw_energy(image, frame, release);
    write_image(path, image, Vec3f(1, 1, 1));
}

}  // namespace

void write_rod_plot(const std::filesystem::path& path, const RodReport& report) {
    if (report.release) {
        write_release_plot(path, report, *report.release);
        return;
    }
    Image image =
        draw_shapes(report.rod.root.frame,
                    {{points_of(report.rod, natural_curvatures(report.rod)), 2, kGrey},
                     {points_of(report.rod, report.equilibrium.q), 4, kInk}},
                    0);
    draw_title(image, report, "");
    write_image(path, image, Vec3f(1, 1, 1));
}

}  // namespace lancret
