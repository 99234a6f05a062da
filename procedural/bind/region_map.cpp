#include "procedural/bind/region_map.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <unordered_map>

#include "guides/base/errors.h"

namespace lancret {

namespace {

/// The texel of a coordinate; the map repeats outside 0..1, where both ends are inside.
int texel(double x, int size) {
    const double part = x >= 0 && x <= 1 ? x : x - std::floor(x);
    return std::min(int(part * size), size - 1);
}

}  // namespace

RegionMap read_region_map(const std::filesystem::path& path) {
    const auto fail = [&](const std::string& why) {
        return InputError(fmt::format("{}: {}", path.string(), why));
    };
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        throw fail("there is no such image");
    }
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path.string(), &as_stored);
    if (!input) throw fail("not a readable image: " + OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    constexpr std::int64_t kMaxTexels = std::int64_t(1) << 26;
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 ||
        std::int64_t(spec.width) * spec.height > kMaxTexels) {
        throw fail(
            fmt::format("an image of {} x {} x {} with {} channels, expected a "
                        "flat one of at most 2^26 texels",
                        spec.width, spec.height, spec.depth, spec.nchannels));
    }
    const int channels = std::min(spec.nchannels, 4);
    RegionMap map{spec.width, spec.height, {}, 0};
    const std::size_t size = std::size_t(map.width) * std::size_t(map.height);
    std::vector<std::uint8_t> values(size * std::size_t(channels));
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, values.data())) {
        throw fail("broken image: " + input->geterror());
    }
    std::unordered_map<std::uint32_t, std::uint32_t> numbers;
    map.regions.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
        std::uint32_t colour = 0;
        for (int c = 0; c < channels; ++c) {
            colour = colour << 8 | values[i * std::size_t(channels) + std::size_t(c)];
        }
        const auto number = std::uint32_t(numbers.size());
        map.regions[i] = numbers.try_emplace(colour, number).first->second;
        if (numbers.size() > kMaxRegions) {
            throw fail(
                fmt::format("more than {} colours, each of which would be a region: "
                            "expected flat colours without noise or soft borders",
                            kMaxRegions));
        }
    }
    map.count = numbers.size();
    return map;
}

std::uint32_t region_at(const RegionMap& map, const Vec2& uv) {
    const int x = texel(uv.x(), map.width), y = texel(1 - uv.y(), map.height);
    return map.regions[std::size_t(y) * std::size_t(map.width) + std::size_t(x)];
}

std::vector<std::uint32_t> read_region_ids(const std::filesystem::path& path,
                                           std::size_t strands) {
    std::error_code ignored;
    std::ifstream file(path);
    if (!file || !std::filesystem::is_regular_file(path, ignored)) {
        throw InputError(fmt::format("{}: cannot be opened", path.string()));
    }
    constexpr std::string_view kSpace = " \t\r\v\f";
    std::vector<std::uint32_t> out;
    std::string text;
    std::size_t line = 0;
    while (std::getline(file, text)) {
        ++line;
        std::string_view word = text;
        word = word.substr(0, word.find('#'));
        word.remove_prefix(std::min(word.find_first_not_of(kSpace), word.size()));
        word = word.substr(0, word.find_last_not_of(kSpace) + 1);
        if (word.empty()) continue;
        std::uint32_t id = 0;
        const auto end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, id);
        if (error != std::errc() || stop != end) {
            throw InputError(
                fmt::format("{}:{}: '{}' is not a region, expected a whole "
                            "number from 0 to 4294967295",
                            path.string(), line, word.substr(0, 40)));
        }
        if (out.size() == strands) {
            throw InputError(
                fmt::format("{}:{}: more regions than the {} strands of the groom",
                            path.string(), line, strands));
        }
        out.push_back(id);
    }
    if (out.size() < strands) {
        throw InputError(
            fmt::format("{}:{}: the file ends after {} regions, expected one "
                        "for each of the {} strands of the groom",
                        path.string(), line + 1, out.size(), strands));
    }
    return out;
}

}  // namespace lancret
