#include "render_test/files/deep_exr.h"

#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfHeader.h>
#include <ImfPartType.h>
#include <half.h>

#include <algorithm>
#include <stdexcept>

#include "guides/base/atomic_file.h"
#include "guides/base/errors.h"

namespace lancret {
namespace {

/// A deep sample in memory while its line is written.
struct Stored {
    half rgba[4];
    float depth = 0;
    std::uint32_t id = 0;
};

/// The samples of one line, and where those of each pixel begin.
struct Line {
    std::vector<Stored> samples;
    std::vector<unsigned> counts;                ///< [width]
    std::vector<std::array<char*, 6>> channels;  ///< [width] R, G, B, A, Z, id
    std::vector<DeepPoint> points;               ///< scratch space of one pixel

    void gather(const Image& image, int y) {
        samples.clear();
        for (int x = 0; x < image.width; ++x) {
            composited(image.deep[std::size_t(y) * image.width + x], points);
            counts[x] = unsigned(points.size());
            for (const DeepPoint& p : points) {
                Stored& out = samples.emplace_back();
                for (int c = 0; c < 4; ++c) out.rgba[c] = half(p.rgba[c]);
                out.depth = p.depth;
                out.id = p.id;
            }
        }
        std::size_t first = 0;
        for (int x = 0; x < image.width; ++x) {
            Stored* const stored = samples.data() + first;
            const auto bytes = [](auto* p) { return reinterpret_cast<char*>(p); };
            channels[x].fill(nullptr);
            if (counts[x] > 0) {
                for (int c = 0; c < 4; ++c) channels[x][c] = bytes(&stored->rgba[c]);
                channels[x][4] = bytes(&stored->depth);
                channels[x][5] = bytes(&stored->id);
            }
            first += counts[x];
        }
    }
};

void write_lines(const std::filesystem::path& path, const Image& image) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIPS_COMPRESSION;
    header.setName("deep");
    header.setType(Imf::DEEPSCANLINE);
    Line line;
    line.counts.resize(image.width);
    line.channels.resize(image.width);
    Imf::DeepFrameBuffer frame;
    // The buffer holds one line: no stride from line to line.
    frame.insertSampleCountSlice(Imf::Slice(
        Imf::UINT, reinterpret_cast<char*>(line.counts.data()), sizeof(unsigned), 0));
    const auto add = [&](const char* name, Imf::PixelType type, std::size_t channel) {
        header.channels().insert(name, Imf::Channel(type));
        frame.insert(name, Imf::DeepSlice(
                               type, reinterpret_cast<char*>(&line.channels[0][channel]),
                               sizeof(line.channels[0]), 0, sizeof(Stored)));
    };
    const char* const colours[] = {"R", "G", "B", "A"};
    for (std::size_t c = 0; c < 4; ++c) add(colours[c], Imf::HALF, c);
    add("Z", Imf::FLOAT, 4);
    add("ZBack", Imf::FLOAT, 4);
    add("id", Imf::UINT, 5);
    Imf::DeepScanLineOutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    for (int y = 0; y < image.height; ++y) {
        line.gather(image, y);
        file.writePixels(1);
    }
}

}  // namespace

void write_deep_exr(const std::filesystem::path& path, const Image& image) {
    if (path.extension() != ".exr") {
        throw InputError(path.string() + ": deep images can only be written as .exr");
    }
    if (image.deep.empty()) throw std::invalid_argument("a picture without deep samples");
    PendingFile file(path);
    try {
        write_lines(file.temporary(), image);
    } catch (const std::exception& error) {
        throw InputError(path.string() + ": cannot be written: " + error.what());
    }
    file.commit();
}

}  // namespace lancret
