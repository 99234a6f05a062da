#include "guides/files/guide_cache.h"
#include "guides/files/guide_cache_write.h"

#include <gmock/gmock.h>
#include <hdf5.h>

#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::vector<Guides> random_frames(int count, std::size_t size, int segments) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const auto vector = [&] {
        return Vec3(normal(random), normal(random), normal(random));
    };
    std::vector<Guides> frames;
    for (int f = 0; f < count; ++f) {
        Guides guides;
        guides.segments = segments;
        for (std::size_t g = 0; g < size; ++g) {
            guides.root_positions.push_back(vector());
            guides.root_frames.push_back(helix_step<double>(vector(), 1).rotation);
            for (int s = 0; s < segments; ++s) {
                guides.segment_lengths.push_back(0.1 + 0.01 * double(g) + s);
                guides.curvatures.push_back(vector());
            }
        }
        frames.push_back(guides);
    }
    return frames;
}

struct GuideCache : testing::Test {
    TemporaryFolder folder;
    std::filesystem::path path = folder / "guides.h5";
    std::vector<Guides> frames = random_frames(3, 5, 4);

    void SetUp() override {
        write_guide_cache(path, {30, 101, "grooms/löckchen.hair"}, frames);
    }

    /// Opens the cache with HDF5 directly, to damage it.
    void edit(const std::function<void(hid_t)>& change) {
        const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
        change(file);
        H5Fclose(file);
    }
    void set_value(const char* dataset, hsize_t index, double value) {
        edit([&](hid_t file) {
            const hid_t data = H5Dopen2(file, dataset, H5P_DEFAULT);
            const hid_t space = H5Dget_space(data);
            std::vector<double> all(std::size_t(H5Sget_simple_extent_npoints(space)));
            H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data());
            all[index] = value;
            H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data());
            H5Sclose(space);
            H5Dclose(data);
        });
    }
    /// Replaces a dataset by one of another shape or type, chunked and without data.
    void replace(const char* name, std::vector<hsize_t> shape,
                 hid_t type = H5T_NATIVE_DOUBLE) {
        edit([&](hid_t file) {
            H5Ldelete(file, name, H5P_DEFAULT);
            const hid_t space =
                H5Screate_simple(int(shape.size()), shape.data(), nullptr);
            const hid_t layout = H5Pcreate(H5P_DATASET_CREATE);
            const std::vector<hsize_t> chunk(shape.size(), 1);
            H5Pset_chunk(layout, int(chunk.size()), chunk.data());
            H5Dclose(
                H5Dcreate2(file, name, type, space, H5P_DEFAULT, layout, H5P_DEFAULT));
            H5Pclose(layout);
            H5Sclose(space);
        });
    }
    std::string error() const {
        return input_error([&] { read_guide_cache(path, 1); });
    }
};

TEST_F(GuideCache, ReturnsTheSameBits) {
    for (int f = 0; f < 3; ++f) {
        const Guides back = read_guide_cache(path, f);
        const Guides& frame = frames[std::size_t(f)];
        EXPECT_EQ(back.segments, 4);
        EXPECT_EQ(back.root_positions, frame.root_positions);
        EXPECT_EQ(back.root_frames, frame.root_frames);
        EXPECT_EQ(back.segment_lengths, frame.segment_lengths);
        EXPECT_EQ(back.curvatures, frame.curvatures);
    }
    EXPECT_EQ(folder.files(), 1u);
}

TEST_F(GuideCache, InfoHasItsContents) {
    const GuideCacheInfo info = guide_cache_info(path);
    EXPECT_EQ(info.frames, 3);
    EXPECT_EQ(info.guides, 5u);
    EXPECT_EQ(info.segments, 4);
    EXPECT_EQ(info.frames_per_second, 30);
    EXPECT_EQ(info.first_frame, 101);
    EXPECT_EQ(info.groom, "grooms/löckchen.hair");
    write_guide_cache(path, {}, frames);
    EXPECT_EQ(guide_cache_info(path).groom, "");
}

TEST_F(GuideCache, HasTheDocumentedLayout) {
    // Read with HDF5 directly: row r, column c of guide 2 in frame 1, whose columns are
    // n0, n1, n2.
    edit([&](hid_t file) {
        const hid_t data = H5Dopen2(file, "/root_frames", H5P_DEFAULT);
        double all[3][5][3][3];
        ASSERT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all),
                  0);
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 3; ++c) {
                EXPECT_EQ(all[1][2][r][c], frames[1].root_frames[2](r, c));
            }
        }
        const hid_t layout = H5Dget_create_plist(data);
        hsize_t chunk[4];
        EXPECT_EQ(H5Pget_chunk(layout, 4, chunk), 4);
        EXPECT_THAT(chunk, testing::ElementsAre(1, 5, 3, 3));
        H5Pclose(layout);
        H5Dclose(data);
    });
}

TEST_F(GuideCache, NoSuchFrameIsMisuse) {
    EXPECT_THROW(read_guide_cache(path, 3), std::invalid_argument);
    EXPECT_THROW(read_guide_cache(path, -1), std::invalid_argument);
}

TEST_F(GuideCache, RejectsOtherFiles) {
    EXPECT_THAT(input_error([&] { read_guide_cache(folder / "none.h5", 0); }),
                HasSubstr("none.h5: there is no such file"));
    EXPECT_THAT(input_error([&] { guide_cache_info(folder.path); }),
                HasSubstr("not a regular file"));
    write_bytes(path, "not HDF5");
    EXPECT_THAT(error(), HasSubstr("guides.h5: not an HDF5 file"));
    H5Fclose(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    EXPECT_THAT(error(), HasSubstr("no attribute 'format'"));
}

TEST_F(GuideCache, RejectsAnotherVersion) {
    edit([](hid_t file) {
        const hid_t attribute = H5Aopen(file, "version", H5P_DEFAULT);
        const int version = 2;
        H5Awrite(attribute, H5T_NATIVE_INT, &version);
        H5Aclose(attribute);
    });
    EXPECT_THAT(error(), HasSubstr("attribute 'version' is 2, expected 1"));
}

TEST_F(GuideCache, ReadsStringsAsH5pyWritesThem) {
    edit([](hid_t file) {
        H5Adelete(file, "groom");
        const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
        H5Tset_size(type, H5T_VARIABLE);
        const hid_t attribute =
            H5Acreate2(file, "groom", type, space, H5P_DEFAULT, H5P_DEFAULT);
        const char* text = "a groom";
        H5Awrite(attribute, type, &text);
        H5Aclose(attribute);
        H5Sclose(space);
        H5Tclose(type);
    });
    EXPECT_EQ(guide_cache_info(path).groom, "a groom");
}

TEST_F(GuideCache, RejectsMissingDatasets) {
    for (const char* name :
         {"/root_positions", "/root_frames", "/segment_lengths", "/curvatures"}) {
        write_guide_cache(path, {}, frames);
        edit([&](hid_t file) { H5Ldelete(file, name, H5P_DEFAULT); });
        EXPECT_THAT(error(), AllOf(HasSubstr("guides.h5: no dataset"), HasSubstr(name)));
    }
}

TEST_F(GuideCache, RejectsWrongRankShapeAndType) {
    replace("/root_positions", {3, 15});
    EXPECT_THAT(error(),
                HasSubstr("dataset '/root_positions' has 2 dimensions, expected 3"));
    replace("/root_positions", {3, 4, 3});
    EXPECT_THAT(error(), HasSubstr("'/root_positions' has the shape [3, 4, 3], expected "
                                   "[3, 5, 3]"));
    replace("/root_positions", {3, 5, 3}, H5T_NATIVE_INT);
    EXPECT_THAT(error(), HasSubstr("'/root_positions' does not hold 32- or"));
}

TEST_F(GuideCache, ShapesWithoutDataAllocateNothing) {
    replace("/curvatures", {3, 1u << 30, 1u << 20, 3});
    EXPECT_THAT(error(), HasSubstr("dataset '/curvatures' is shorter than its shape"));
    replace("/curvatures", {3, 5, 4, 3});
    EXPECT_THAT(error(), HasSubstr("dataset '/curvatures' is shorter than its shape"));
}

TEST_F(GuideCache, RejectsNumbersThatAreNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const char* name : {"/root_positions", "/root_frames", "/curvatures"}) {
        write_guide_cache(path, {}, frames);
        set_value(name, 0, nan);  // of frame 0
        EXPECT_EQ(error(), "");
        EXPECT_THAT(
            input_error([&] { read_guide_cache(path, 0); }),
            AllOf(HasSubstr(name), HasSubstr("value 0 of those read is not finite")));
    }
    write_guide_cache(path, {}, frames);
    set_value("/segment_lengths", 6, 0);
    EXPECT_THAT(error(), HasSubstr("'/segment_lengths' is 0 at guide 1, segment 2"));
}

TEST_F(GuideCache, RejectsFramesThatAreNotRotations) {
    const double was = frames[1].root_frames[2](0, 0);
    // Index of [frame 1, guide 2, row 0, column 0].
    set_value("/root_frames", (1 * 5 + 2) * 9, was + 1e-8);
    EXPECT_EQ(error(), "");
    set_value("/root_frames", (1 * 5 + 2) * 9, was + 0.01);
    EXPECT_THAT(error(),
                HasSubstr("'/root_frames' is not a rotation at frame 1, guide 2"));
    // A reflection is orthonormal but not a rotation.
    frames[1].root_frames[2].col(0) *= -1;
    write_guide_cache(path, {}, frames);
    EXPECT_THAT(error(), HasSubstr("is not a rotation at frame 1, guide 2"));
}

TEST_F(GuideCache, EveryTruncationIsAnInputError) {
    const std::string good = read_bytes(path);
    for (std::size_t length = 0; length < good.size(); length += 97) {
        write_bytes(path, std::string_view(good).substr(0, length));
        EXPECT_THAT(error(), HasSubstr("guides.h5: ")) << length;
    }
}

TEST_F(GuideCache, DamagedBytesAreFoundOrHarmless) {
    const std::string good = read_bytes(path);
    std::mt19937 random(4);
    int found = 0;
    for (int i = 0; i < 1000; ++i) {
        std::string bytes = good;
        const std::size_t at = random() % bytes.size();
        bytes[at] = char(bytes[at] ^ char(1 + random() % 255));
        write_bytes(path, bytes);
        try {
            // A byte between the structures, or of another frame, does not matter here.
            EXPECT_EQ(read_guide_cache(path, 1).curvatures, frames[1].curvatures) << at;
        } catch (const InputError&) {
            ++found;
        }
    }
    EXPECT_GT(found, 200);
}

TEST_F(GuideCache, RestPoseIsTheFirstFrameIfNoneIsStored) {
    EXPECT_FALSE(guide_cache_info(path).has_rest);
    EXPECT_EQ(read_rest_guides(path).curvatures, frames[0].curvatures);
    GuideCacheWriter writer(path, {}, 1, &frames[2]);
    Guides frame = frames[1];
    frame.segment_lengths = frames[2].segment_lengths;
    writer.add(frame);
    writer.finish();
    EXPECT_TRUE(guide_cache_info(path).has_rest);
    EXPECT_EQ(read_rest_guides(path).curvatures, frames[2].curvatures);
    EXPECT_EQ(read_guide_cache(path, 0).curvatures, frames[1].curvatures);
    edit([](hid_t file) { H5Ldelete(file, "/rest/root_frames", H5P_DEFAULT); });
    EXPECT_THAT(input_error([&] { read_rest_guides(path); }),
                HasSubstr("no dataset '/rest/root_frames'"));
}

TEST_F(GuideCache, RejectsInvalidRestarts) {
    const auto restart_error = [&] { return input_error([&] { read_restart(path); }); };
    EXPECT_FALSE(guide_cache_info(path).has_restart);
    EXPECT_THAT(restart_error(), HasSubstr("guides.h5: no group '/restart'"));
    const auto write = [&] {
        GuideCacheWriter writer(path, {}, 1);
        writer.add(frames[0]);
        const Restart restart{"job", {{"a", {1, 2}}, {"b", {3}}}};
        writer.finish(&restart);
    };
    write();
    EXPECT_EQ(read_restart(path).arrays, (RestartArrays{{"a", {1, 2}}, {"b", {3}}}));
    set_value("/restart/a", 1, std::numeric_limits<double>::infinity());
    EXPECT_THAT(restart_error(), HasSubstr("'a': value 1 of those read is not finite"));
    write();
    replace("/restart/b", {3, 3});
    EXPECT_THAT(restart_error(), HasSubstr("'b' has 2 dimensions, expected 1"));
    write();
    replace("/restart/b", {1u << 30});
    EXPECT_THAT(restart_error(), HasSubstr("'b' is shorter than its shape"));
    write();
    edit([](hid_t file) { H5Adelete_by_name(file, "/restart", "job", H5P_DEFAULT); });
    EXPECT_THAT(restart_error(), HasSubstr("no attribute 'job'"));
    edit([](hid_t file) {
        H5Ldelete(file, "/restart", H5P_DEFAULT);
        H5Lcreate_hard(file, "/curvatures", file, "/restart", H5P_DEFAULT, H5P_DEFAULT);
    });
    EXPECT_THAT(restart_error(), HasSubstr("'/restart' is not a group"));
}

TEST_F(GuideCache, WriterRequiresTheDeclaredNumberOfFrames) {
    GuideCacheWriter writer(path, {}, 2);
    writer.add(frames[0]);
    EXPECT_THROW(writer.finish(), std::invalid_argument);
    writer.add(frames[1]);
    EXPECT_THROW(writer.add(frames[2]), std::invalid_argument);
    writer.finish();
    EXPECT_EQ(guide_cache_info(path).frames, 2);
}

TEST_F(GuideCache, RejectsFrameNumbersBeyondInt) {
    const int most = std::numeric_limits<int>::max();
    write_guide_cache(path, {24, most - 2, ""}, frames);
    EXPECT_EQ(error(), "");
    write_guide_cache(path, {24, most - 1, ""}, frames);
    EXPECT_THAT(error(), HasSubstr("'first_frame' is 2147483646, too large"));
}

TEST_F(GuideCache, WriterRejectsFramesThatDiffer) {
    EXPECT_THROW(write_guide_cache(path, {}, {}), std::invalid_argument);
    frames[1].segment_lengths[0] += 1;
    EXPECT_THROW(write_guide_cache(path, {}, frames), std::invalid_argument);
    frames[1] = random_frames(1, 4, 4)[0];
    EXPECT_THROW(write_guide_cache(path, {}, frames), std::invalid_argument);
    EXPECT_EQ(guide_cache_info(path).first_frame, 101);  // the older file stays
}

TEST_F(GuideCache, MissingFolderIsAnInputError) {
    EXPECT_THAT(input_error([&] { write_guide_cache(folder / "none/a.h5", {}, frames); }),
                HasSubstr("there is no folder"));
}

TEST_F(GuideCache, IsReadByH5dump) {
    if (std::system("h5dump --version > /dev/null 2>&1") != 0) {
        GTEST_SKIP() << "h5dump is not installed";
    }
    const auto dump = folder / "dump.txt";
    ASSERT_EQ(std::system(("h5dump -H " + path.string() + " > " + dump.string()).c_str()),
              0);
    EXPECT_THAT(read_bytes(dump), HasSubstr("SIMPLE { ( 3, 5, 4, 3 )"));
}

}  // namespace
}  // namespace lancret
