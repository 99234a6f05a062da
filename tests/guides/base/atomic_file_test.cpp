#include "guides/base/atomic_file.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/guides/base/temporary_folder.h"

namespace lancret {
namespace {

using testing::HasSubstr;

TEST(AtomicFile, ContainsWhatWasWrittenAndLeavesNoOtherFile) {
    const TemporaryFolder folder;
    write_beside_and_rename(folder / "a.bin", std::string_view("old"));
    write_beside_and_rename(folder / "a.bin", std::string_view("a\0b\n", 4));
    EXPECT_EQ(read_bytes(folder / "a.bin"), std::string("a\0b\n", 4));
    EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, OldFileStaysWhenTheWriterThrows) {
    const TemporaryFolder folder;
    write_bytes(folder / "a.txt", "old");
    EXPECT_THROW(write_beside_and_rename(folder / "a.txt",
                                         [](std::ostream& stream) {
                                             stream << "half";
                                             throw std::runtime_error("stop");
                                         }),
                 std::runtime_error);
    EXPECT_EQ(read_bytes(folder / "a.txt"), "old");
    EXPECT_EQ(folder.files(), 1u);
}

TEST(AtomicFile, FailedStreamIsAnErrorAndLeavesNoFile) {
    const TemporaryFolder folder;
    const auto text = input_error([&] {
        write_beside_and_rename(folder / "a.txt", [](std::ostream& stream) {
            stream.setstate(std::ios::badbit);
        });
    });
    EXPECT_THAT(text, HasSubstr("a.txt: cannot be written"));
    EXPECT_EQ(folder.files(), 0u);
}

TEST(AtomicFile, MissingFolderIsNamed) {
    const TemporaryFolder folder;
    const auto text = input_error(
        [&] { write_beside_and_rename(folder / "none/a.txt", std::string_view("x")); });
    EXPECT_THAT(text, HasSubstr("there is no folder '" + (folder / "none").string()));
}

TEST(AtomicFile, FoldersAndDevicesAreNotReplaced) {
    const TemporaryFolder folder;
    EXPECT_THAT(input_error([&] { PendingFile file(folder.path); }),
                HasSubstr("it is a folder"));
    EXPECT_THAT(input_error([&] { PendingFile file("/dev/null"); }),
                HasSubstr("not a regular file"));
    EXPECT_THAT(input_error([&] { PendingFile file(folder.path / ""); }),
                HasSubstr("expected the name of a file"));
}

TEST(AtomicFile, SymbolicLinkStaysALink) {
    const TemporaryFolder folder;
    write_bytes(folder / "real.txt", "old");
    std::filesystem::create_symlink("real.txt", folder / "link.txt");
    write_beside_and_rename(folder / "link.txt", std::string_view("new"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(read_bytes(folder / "real.txt"), "new");
}

TEST(PendingFile, TemporaryNameIsUniqueAndKeepsFolderAndExtension) {
    const TemporaryFolder folder;
    PendingFile one(folder / "image.exr"), two(folder / "image.exr");
    EXPECT_EQ(one.temporary().extension(), ".exr");
    EXPECT_EQ(one.temporary().parent_path(), folder.path);
    EXPECT_NE(one.temporary(), one.target());
    EXPECT_NE(one.temporary(), two.temporary());
}

TEST(PendingFile, AppearsOnlyOnCommit) {
    const TemporaryFolder folder;
    {
        PendingFile file(folder / "a.txt");
        write_bytes(file.temporary(), "x");
        EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    }
    EXPECT_EQ(folder.files(), 0u);
    PendingFile file(folder / "a.txt");
    write_bytes(file.temporary(), "x");
    file.commit();
    EXPECT_EQ(read_bytes(folder / "a.txt"), "x");
    EXPECT_EQ(folder.files(), 1u);
}

TEST(PendingFile, CommitOfAFileThatWasNeverWrittenIsAnError) {
    const TemporaryFolder folder;
    PendingFile file(folder / "a.txt");
    EXPECT_THAT(input_error([&] { file.commit(); }),
                HasSubstr("a.txt: cannot be written"));
}

}  // namespace
}  // namespace lancret
