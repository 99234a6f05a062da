#include "render_test/files/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <deque>
#include <limits>

#include "render_test/image/cryptomatte.h"
#include "render_test/image/half_values.h"

namespace lancret {
namespace {

using Metadata = std::map<std::string, std::string>;

/// The parts of a file to be written, and the buffers that they refer to.
struct Parts {
    int width, height;
    std::deque<Imf::Header> headers;
    std::deque<Imf::FrameBuffer> frames;
    std::deque<std::vector<half>> halves;
    std::deque<std::vector<float>> floats;

    void begin(const char* name) {
        Imf::Header& header = headers.emplace_back(width, height);
        header.compression() = Imf::ZIP_COMPRESSION;
        header.setName(name);
        header.setType(Imf::SCANLINEIMAGE);
        frames.emplace_back();
    }
    /// Adds a channel to the last part; its values are `stride` bytes apart.
    void add(const std::string& name, Imf::PixelType type, const void* data,
             std::size_t stride) {
        headers.back().channels().insert(name, Imf::Channel(type));
        char* base = const_cast<char*>(static_cast<const char*>(data));
        frames.back().insert(name, Imf::Slice(type, base, stride, stride * width));
    }
    /// Adds interleaved channels to the last part.
    template <class T>
    void add(std::initializer_list<const char*> names, Imf::PixelType type,
             const T* data) {
        std::size_t c = 0;
        for (const char* name : names) {
            add(name, type, data + c++, names.size() * sizeof(T));
        }
    }
    /// The same for vectors, stored as halves.
    template <class Vector>
    void add_halves(std::initializer_list<const char*> names,
                    const std::vector<Vector>& layer) {
        std::vector<half>& out = halves.emplace_back();
        out.reserve(layer.size() * names.size());
        for (const Vector& values : layer) {
            for (const float value : values) out.push_back(half(rounded_to_half(value)));
        }
        add(names, Imf::HALF, out.data());
    }
    /// Adds the layers of a Cryptomatte: `Ranks` ids with shares per pixel, two per
    /// layer.
    template <std::size_t Ranks, class Function>
    void add_matte(const std::string& name, const Metadata& metadata,
                   const Function& ranks_of) {
        begin(name.c_str());
        for (Imf::Header* header : {&headers.front(), &headers.back()}) {
            for (const auto& [key, text] : metadata) {
                header->insert(key, Imf::StringAttribute(text));
            }
        }
        std::vector<float>& out = floats.emplace_back();
        const std::size_t pixels = std::size_t(width) * height;
        out.reserve(pixels * Ranks * 2);
        for (std::size_t i = 0; i < pixels; ++i) {
            for (const auto& [id, share] : ranks_of(i)) {
                out.push_back(share > 0 ? cryptomatte_float(id) : 0.0f);
                out.push_back(share);
            }
        }
        for (std::size_t c = 0; c < Ranks * 2; ++c) {
            add(name + "0" + std::to_string(c / 4) + "." + "RGBA"[c % 4], Imf::FLOAT,
                out.data() + c, Ranks * 2 * sizeof(float));
        }
    }
};

void add_depth(const Image& image, Parts& parts) {
    std::vector<float>& depth = parts.floats.emplace_back(image.depth);
    // Depth 0 marks pixels without a hit: no hit is as near as the camera itself.
    std::ranges::replace(depth, 0.0f, std::numeric_limits<float>::infinity());
    parts.begin("depth");
    parts.add({"Z"}, Imf::FLOAT, depth.data());
}

struct NamedShare {
    std::string id;
    float share = 0;
};

void add_mattes(const Image& image, Parts& parts) {
    constexpr std::size_t kRanks = 6;
    parts.add_matte<kRanks>(
        "CryptoObject", cryptomatte_metadata("CryptoObject", {"head"}),
        [&](std::size_t i) {
            std::array<NamedShare, kRanks> out;
            std::size_t rank = 0;
            for (const auto& [id, share] : image.objects[i].ranks<kRanks>()) {
                out[rank++] = {share > 0 ? object_name(id) : "", share};
            }
            return out;
        });
    parts.add_matte<2>("CryptoMaterial",
                       cryptomatte_metadata("CryptoMaterial", {"hair", "head"}),
                       [&](std::size_t i) {
                           const float body = image.body[i];
                           const float hair = std::max(0.0f, image.rgba[i].w() - body);
                           std::array<NamedShare, 2> out{NamedShare{"hair", hair},
                                                         NamedShare{"head", body}};
                           if (body > hair) std::swap(out[0], out[1]);
                           return out;
                       });
}

}  // namespace

void write_exr(const std::filesystem::path& path, const Image& image) {
    Parts parts{image.width, image.height, {}, {}, {}, {}};
    parts.begin("rgba");
    parts.add_halves({"R", "G", "B", "A"}, image.rgba);
    add_depth(image, parts);
    parts.begin("N");
    parts.add_halves({"N.X", "N.Y", "N.Z"}, image.normal);
    parts.begin("T");
    parts.add_halves({"T.X", "T.Y", "T.Z"}, image.tangent);
    parts.begin("id");
    parts.add({"id"}, Imf::UINT, image.id.data());
    if (!image.value.empty()) {
        parts.begin("value");
        parts.add({"value"}, Imf::FLOAT, image.value.data());
    }
    if (!image.motion.empty()) {
        parts.begin("motion");
        parts.add({"motion.X", "motion.Y"}, Imf::FLOAT, image.motion.data()->data());
    }
    if (!image.variance.empty()) {
        parts.begin("variance");
        parts.add({"variance.R", "variance.G", "variance.B", "variance.A"}, Imf::FLOAT,
                  image.variance.data()->data());
    }
    if (!image.objects.empty()) add_mattes(image, parts);

    const std::vector<Imf::Header> headers(parts.headers.begin(), parts.headers.end());
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), int(headers.size()));
    for (std::size_t p = 0; p < headers.size(); ++p) {
        Imf::OutputPart part(file, int(p));
        part.setFrameBuffer(parts.frames[p]);
        part.writePixels(image.height);
    }
}

}  // namespace lancret
