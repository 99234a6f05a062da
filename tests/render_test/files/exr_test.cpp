#include "render_test/files/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <map>

#include "guides/base/errors.h"
#include "render_test/files/write_image.h"
#include "render_test/image/cryptomatte.h"

namespace lancret {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 5, kHeight = 3, kPixels = kWidth * kHeight;

/// Every value is exact in half precision: sixteenths, eighths and thirty-seconds below
/// 2.
Image small_image() {
    Image image(kWidth, kHeight);
    for (std::size_t i = 0; i < kPixels; ++i) {
        const float x = float(i);
        image.rgba[i] << x / 16, x / 32, 1 - x / 16, 0.5f;
        image.depth[i] = i == 3 ? 0 : 10 + x / 3;
        image.normal[i] = Vec3f(x / 16, -x / 16, 1);
        image.tangent[i] = Vec3f(1, x / 8, -1);
        image.id[i] = 4000000000u - std::uint32_t(i);
    }
    return image;
}

Image full_image() {
    Image image = small_image();
    image.motion.resize(kPixels, Vec2f(3, -1));
    image.variance.resize(kPixels, Eigen::Vector4f(1, 2, 3, 4));
    image.objects.resize(kPixels);
    image.body.resize(kPixels);
    image.objects[7].add(41, 0.125f);
    image.objects[7].add(kMeshId, 0.25f);
    image.objects[7].add(41, 0.0625f);
    image.body[7] = 0.25f;
    return image;
}

fs::path written_parts(const Image& image) {
    const fs::path path = fs::path(testing::TempDir()) / "lancret_parts.exr";
    write_image(path, image);
    return path;
}

/// One channel of one part, as floats.
std::vector<float> channel(const Imf::MultiPartInputFile& file, int part,
                           const std::string& name) {
    Imf::InputPart input(const_cast<Imf::MultiPartInputFile&>(file), part);
    EXPECT_TRUE(input.header().channels().findChannel(name)) << name;
    std::vector<float> out(kPixels);
    Imf::FrameBuffer frame;
    frame.insert(
        name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(out.data()), 4, 4 * kWidth));
    input.setFrameBuffer(frame);
    input.readPixels(0, kHeight - 1);
    return out;
}

std::map<std::string, int> parts_of(const Imf::MultiPartInputFile& file) {
    std::map<std::string, int> out;
    for (int p = 0; p < file.parts(); ++p) out[file.header(p).name()] = p;
    return out;
}

TEST(ImageExr, AMinimalPictureHasFivePartsAndColourFirst) {
    const Image image = small_image();
    const Imf::MultiPartInputFile file(written_parts(image).c_str());
    auto parts = parts_of(file);
    ASSERT_EQ(file.parts(), 5);
    EXPECT_EQ(file.header(0).name(), "rgba");
    EXPECT_EQ(file.header(0).compression(), Imf::ZIP_COMPRESSION);
    const auto green = channel(file, 0, "G"), depth = channel(file, parts["depth"], "Z");
    const auto normal = channel(file, parts["N"], "N.Y");
    const auto tangent = channel(file, parts["T"], "T.Y");
    Imf::InputPart ids(const_cast<Imf::MultiPartInputFile&>(file), parts["id"]);
    std::vector<std::uint32_t> id(kPixels);
    Imf::FrameBuffer frame;
    frame.insert(
        "id", Imf::Slice(Imf::UINT, reinterpret_cast<char*>(id.data()), 4, 4 * kWidth));
    ids.setFrameBuffer(frame);
    ids.readPixels(0, kHeight - 1);
    for (std::size_t i = 0; i < kPixels; ++i) {
        EXPECT_EQ(green[i], image.rgba[i].y());
        EXPECT_EQ(depth[i],
                  i == 3 ? std::numeric_limits<float>::infinity() : image.depth[i]);
        EXPECT_EQ(normal[i], image.normal[i].y());
        EXPECT_EQ(tangent[i], image.tangent[i].y());
        EXPECT_EQ(id[i], image.id[i]);
    }
}

TEST(ImageExr, AFullPictureHasNineParts) {
    const Imf::MultiPartInputFile file(written_parts(full_image()).c_str());
    auto parts = parts_of(file);
    EXPECT_EQ(file.parts(), 9);
    EXPECT_EQ(channel(file, parts["motion"], "motion.X")[4], 3);
    EXPECT_EQ(channel(file, parts["motion"], "motion.Y")[4], -1);
    EXPECT_EQ(channel(file, parts["variance"], "variance.A")[4], 4);
}

TEST(ImageExr, CryptomatteRanksIdsByTheirShare) {
    const Imf::MultiPartInputFile file(written_parts(full_image()).c_str());
    auto parts = parts_of(file);
    const auto object = [&](const char* name) {
        return channel(file, parts["CryptoObject"], name)[7];
    };
    EXPECT_EQ(object("CryptoObject00.R"), cryptomatte_float("head"));
    EXPECT_EQ(object("CryptoObject00.G"), 0.25f);
    EXPECT_EQ(object("CryptoObject00.B"), cryptomatte_float("strand_41"));
    EXPECT_EQ(object("CryptoObject00.A"), 0.1875f);
    EXPECT_EQ(object("CryptoObject01.R"), 0);
    EXPECT_EQ(object("CryptoObject02.A"), 0);
    const auto material = [&](const char* name) {
        return channel(file, parts["CryptoMaterial"], name)[7];
    };
    // Coverage is one half, that of the head a quarter: hair has the rest.
    EXPECT_EQ(material("CryptoMaterial00.R"), cryptomatte_float("hair"));
    EXPECT_EQ(material("CryptoMaterial00.G"), 0.25f);
    EXPECT_EQ(material("CryptoMaterial00.B"), cryptomatte_float("head"));
    EXPECT_EQ(material("CryptoMaterial00.A"), 0.25f);
}

TEST(ImageExr, TheFirstPartDescribesEveryCryptomatte) {
    const Imf::MultiPartInputFile file(written_parts(full_image()).c_str());
    const auto text = [&](const char* key) {
        const auto* found = file.header(0).findTypedAttribute<Imf::StringAttribute>(key);
        return found ? found->value() : "missing";
    };
    // MurmurHash3 of CryptoObject is 3ae39a58.
    EXPECT_EQ(text("cryptomatte/3ae39a5/name"), "CryptoObject");
    EXPECT_EQ(text("cryptomatte/3ae39a5/hash"), "MurmurHash3_32");
    EXPECT_EQ(text("cryptomatte/3ae39a5/conversion"), "uint32_to_float32");
    EXPECT_EQ(text("cryptomatte/3ae39a5/manifest"), R"({"head":"95a53fc9"})");
}

TEST(Cryptomatte, HashesAreMurmurs) {
    // Known results of MurmurHash3_x86_32: no bytes, then tails of 1, 0 and 3 bytes.
    EXPECT_EQ(murmur_hash3(""), 0u);
    EXPECT_EQ(murmur_hash3("", 1), 0x514e28b7u);
    EXPECT_EQ(murmur_hash3("hello"), 0x248bfa47u);
    EXPECT_EQ(murmur_hash3("hello, world"), 0x149bbb7fu);
    EXPECT_EQ(murmur_hash3("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

TEST(Cryptomatte, IdsAreThoseOfThePublishedPictures) {
    EXPECT_EQ(cryptomatte_id("bunny"), 0x13851a76u);
    EXPECT_EQ(cryptomatte_id("default"), 0x42c9679fu);
}

TEST(Cryptomatte, EveryIdIsANormalFloat) {
    // Its hash, 7fcdfb30, would be NaN.
    EXPECT_EQ(cryptomatte_id("strand_139"), 0x7f4dfb30u);
    for (std::uint32_t strand = 0; strand < 5000; ++strand) {
        EXPECT_TRUE(std::isnormal(cryptomatte_float(object_name(strand))));
    }
}

TEST(RankedIds, FewIdsAreExact) {
    RankedIds ids;
    for (int round = 0; round < 5; ++round) {
        for (std::uint32_t id = 1; id <= RankedIds::kSlots; ++id) {
            ids.add(id, float(id) / 8);
        }
    }
    const auto ranks = ids.ranks<3>();
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(ranks[i].id, RankedIds::kSlots - i);
        EXPECT_EQ(ranks[i].weight, 5 * float(RankedIds::kSlots - i) / 8);
    }
}

TEST(RankedIds, OfManyAHeavyOneIsKeptAndNoneIsOverestimated) {
    // Total weight 1200, 150 of it for id 7: more than a twelfth, so it must stay; at
    // most a twelfth of the total may be missed.
    RankedIds ids;
    for (std::uint32_t i = 0; i < 1200; ++i) ids.add(i % 8 == 3 ? 7 : 1000 + i, 1);
    const auto first = ids.ranks<1>()[0];
    EXPECT_EQ(first.id, 7u);
    EXPECT_LE(first.weight, 150);
    EXPECT_GE(first.weight, 150 - 1200 / RankedIds::kSlots);
    EXPECT_LE(ids.ranks<2>()[1].weight, 1);
}

}  // namespace
}  // namespace lancret
