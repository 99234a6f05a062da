#pragma once
// The layers of a picture of a check view, read with OpenEXR.

#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace lancret {

struct Layers {
    int width = 0;
    std::vector<float> value;
    std::vector<std::uint32_t> id;
};

/// Reads the part whose name is that of its only channel.
inline void read_part(Imf::MultiPartInputFile& file, const std::string& name,
                      Imf::PixelType type, void* data, std::size_t width) {
    int part = 0;
    while (part < file.parts() && file.header(part).name() != name) ++part;
    ASSERT_LT(part, file.parts()) << name;
    Imf::InputPart input(file, part);
    Imf::FrameBuffer frame;
    frame.insert(name, Imf::Slice(type, static_cast<char*>(data), 4, 4 * width));
    input.setFrameBuffer(frame);
    const Imath::Box2i window = input.header().dataWindow();
    input.readPixels(window.min.y, window.max.y);
}

inline Layers read_layers(const std::string& path) {
    Imf::MultiPartInputFile file(path.c_str());
    EXPECT_EQ(file.parts(), 6);
    const Imath::Box2i window = file.header(0).dataWindow();
    Layers out;
    out.width = window.max.x + 1;
    out.value.resize(std::size_t(out.width) * (window.max.y + 1));
    out.id.resize(out.value.size());
    read_part(file, "value", Imf::FLOAT, out.value.data(), std::size_t(out.width));
    read_part(file, "id", Imf::UINT, out.id.data(), std::size_t(out.width));
    return out;
}

}  // namespace lancret
