#include "tools/rod/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render_test/image/draw.h"

namespace lancret {

namespace {

/// 1, 2 or 5 times a power of ten, such that `range` has at most 7 steps.
double tick_step(double range) {
    double step = std::pow(10, std::floor(std::log10(range / 7)));
    for (const double factor : {2., 2.5, 2.}) {
        if (range / step > 7) step *= factor;
    }
    return step;
}

}  // namespace

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

void draw_grid(Image& image, const Frame& frame, const char* name) {
    const Vec2 range = frame.size.cwiseQuotient(frame.scale);
    Vec2 steps(tick_step(range.x()), tick_step(range.y()));
    if (frame.scale.x() == frame.scale.y()) steps.setConstant(steps.maxCoeff());
    const auto text = [&](const Vec2& at, const std::string& words) {
        draw_text(image, int(at.x()), int(at.y()), words, kLetters, kAxis);
    };
    const auto label = [](double x) { return fmt::format("{:.3g}", x + 0.0); };
    for (int axis = 0; axis < 2; ++axis) {
        const double step = steps[axis];
        const double first = std::ceil(frame.low[axis] / step - 1e-9);
        for (double i = first; i * step < frame.low[axis] + range[axis] * (1 + 1e-9);
             ++i) {
            Vec2 a = frame.low, b = frame.low + range;
            a[axis] = b[axis] = i * step;
            const Vec2 from = frame.pixel(a.x(), a.y()), to = frame.pixel(b.x(), b.y());
            draw_line(image, {from, to}, 1, i == 0 ? kGrey : kGrid);
            const Vec2 outwards = axis == 0 ? Vec2(0, 6) : Vec2(-6, 0);
            draw_line(image, {from, from + outwards}, 1, kAxis);
            const std::string words = label(i == 0 ? 0 : i * step);
            text(from + (axis == 0 ? Vec2(-4. * words.size(), 24)
                                   : Vec2(-10 - 10. * words.size(), 6)),
                 words);
        }
    }
    const Vec2 a = frame.pixel(frame.low.x(), frame.low.y());
    const Vec2 b = a + Vec2(frame.size.x(), -frame.size.y());
    draw_line(image, {a, {b.x(), a.y()}, b, {a.x(), b.y()}, a}, 1, kAxis);
    text({a.x(), b.y() - 12}, name);
}

}  // namespace lancret
