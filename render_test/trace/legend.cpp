#include "render_test/trace/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render_test/image/draw.h"

namespace lancret {

namespace {

const Vec3f kInk = Vec3f::Constant(0.8f);

/// Approximate width of a text, pixels.
int width_of(const std::string& text, int letters) {
    return int(std::ceil(0.55f * float(letters) * float(text.size())));
}

void write(Image& image, const LegendLayout& layout, int x, int y,
           const std::string& text) {
    if (image.height < 100) return;
    draw_text(image, x, y, text, layout.letters, kInk);
}

void fill(Image& image, int x, int y, int width, int height, const Vec3f& colour) {
    for (int v = std::max(y, 0); v < std::min(y + height, image.height); ++v) {
        for (int u = std::max(x, 0); u < std::min(x + width, image.width); ++u) {
            image.rgba[std::size_t(v) * image.width + u] << colour, 1;
        }
    }
}

/// The labelled values of a scale.
std::vector<float> ticks(const ColourScale& scale) {
    if (scale.kind != ColourScale::Kind::logarithmic) {
        return {scale.low, (scale.low + scale.high) / 2, scale.high};
    }
    std::vector<float> out;
    const int first = int(std::ceil(std::log10(scale.low) - 1e-4f)),
              last = int(std::floor(std::log10(scale.high) + 1e-4f));
    const int step = std::max(1, (last - first + 3) / 4);
    for (int e = first; e <= last; e += step) out.push_back(float(std::pow(10.0, e)));
    return out.size() < 2 ? std::vector{scale.low, scale.high} : out;
}

void draw_scale(Image& image, const LegendLayout& layout, const CheckView& view) {
    const ColourScale& scale = view.scale;
    for (int i = 0; i < layout.bar_width; ++i) {
        const float place = (float(i) + 0.5f) / float(layout.bar_width);
        fill(image, layout.bar_x + i, layout.bar_y, 1, layout.bar_height,
             scale_colour_at(scale, place));
    }
    const bool more =
        std::ranges::any_of(view.values.values, [&](float v) { return v > scale.high; });
    int free = 0;  // x from which there is room
    for (const float value : ticks(scale)) {
        const bool end = value == scale.high && more && scale.over.empty();
        std::string text = fmt::format("{:.3g}{}", value + 0.0f, end ? "+" : "");
        // Writes 1e-09 as 1e-9.
        for (const char* sign : {"e-0", "e+0"}) {
            const std::size_t zero = text.find(sign);
            if (zero != std::string::npos) text.erase(zero + 2, 1);
        }
        const int wide = width_of(text, layout.letters);
        const int middle =
            layout.bar_x + int(scale_place(scale, value) * float(layout.bar_width));
        const int x = std::max(middle - wide / 2, layout.bar_x);
        if (x < free) continue;
        write(image, layout, x, layout.labels, text);
        free = x + wide + layout.letters / 2;
    }
    int x = layout.bar_x + layout.bar_width + 2 * layout.letters;
    const auto extra = [&](const Vec3f& colour, const std::string& name) {
        fill(image, x, layout.bar_y, layout.bar_height, layout.bar_height, colour);
        x += layout.bar_height + layout.letters / 2;
        write(image, layout, x, layout.bar_y + layout.bar_height, name);
        x += width_of(name, layout.letters) + layout.letters;
    };
    if (!scale.over.empty()) extra(kFailColour, scale.over);
    if (scale.clean) extra(kCleanColour, fmt::format("up to {:.3g}", *scale.clean));
}

void draw_swatches(Image& image, const LegendLayout& layout,
                   const std::vector<Swatch>& swatches) {
    int x = layout.bar_x, y = layout.bar_y;
    for (const Swatch& swatch : swatches) {
        const int wide = layout.bar_height + layout.letters / 2 +
                         width_of(swatch.name, layout.letters);
        if (x > layout.bar_x && x + wide > image.width - layout.letters) {
            x = layout.bar_x;
            y += layout.letters + layout.letters / 3;
        }
        fill(image, x, y, layout.bar_height, layout.bar_height, swatch.colour);
        write(image, layout, x + layout.bar_height + layout.letters / 2,
              y + layout.bar_height, swatch.name);
        x += wide + layout.letters;
    }
}

}  // namespace

LegendLayout legend_layout(int width, int height) {
    LegendLayout out;
    out.letters = std::clamp(std::min(width, height) / 36, 9, 28);
    const int unit = height < 100 ? std::max(height / 16, 1) : out.letters;
    out.top = std::max(height - 4 * unit - unit / 2, 0);
    out.title = out.top + unit + unit / 3;
    out.bar_x = std::min(unit, width / 8);
    out.bar_y = out.title + unit / 2;
    out.bar_width = std::max(width * 9 / 20, 1);
    out.bar_height = std::max(unit * 5 / 6, 1);
    out.labels = out.bar_y + out.bar_height + unit + unit / 6;
    return out;
}

void draw_legend(Image& image, const CheckView& view) {
    const LegendLayout layout = legend_layout(image.width, image.height);
    constexpr float kShown = 0.15f;  // opacity of the picture under the band
    const Eigen::Vector4f band =
        (1 - kShown) * Eigen::Vector4f(0.012f, 0.012f, 0.012f, 1);
    for (int y = layout.top; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            auto& pixel = image.rgba[std::size_t(y) * image.width + x];
            pixel = kShown * pixel + band;
        }
    }
    write(image, layout, layout.bar_x, layout.title, view.title);
    if (view.colours.empty()) {
        draw_scale(image, layout, view);
    } else {
        draw_swatches(image, layout, view.swatches);
    }
}

}  // namespace lancret
