#include "guides/base/atomic_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "guides/base/errors.h"

namespace lancret {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail_to_write(const fs::path& path, std::string_view what) {
    throw InputError(fmt::format("{}: cannot be written: {}", path.string(), what));
}

std::string_view last_error() {
    return errno != 0 ? std::strerror(errno) : "the stream failed";
}

}  // namespace

PendingFile::PendingFile(fs::path target) : target_(std::move(target)) {
    std::error_code error;
    if (target_.filename().empty()) fail_to_write(target_, "expected the name of a file");
    if (fs::is_symlink(target_, error)) {
        const fs::path behind = fs::weakly_canonical(target_, error);
        if (error) fail_to_write(target_, error.message());
        target_ = behind;
    }
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
    if (!fs::is_directory(folder, error)) {
        fail_to_write(target_, fmt::format("there is no folder '{}'", folder.string()));
    }
    if (fs::exists(target_, error) && !fs::is_regular_file(target_, error)) {
        fail_to_write(target_, fs::is_directory(target_, error)
                                   ? "it is a folder"
                                   : "it is not a regular file");
    }
    static std::atomic<unsigned> counter = 0;
    temporary_ = folder / fmt::format("{}.tmp-{}-{}{}", target_.stem().string(), getpid(),
                                      counter++, target_.extension().string());
}

PendingFile::~PendingFile() {
    std::error_code ignored;
    if (!committed_) fs::remove(temporary_, ignored);
}

void PendingFile::commit() {
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) fail_to_write(target_, error.message());
    committed_ = true;
}

void write_beside_and_rename(const fs::path& target,
                             const std::function<void(std::ostream&)>& write) {
    PendingFile file(target);
    errno = 0;
    std::ofstream stream(file.temporary(), std::ios::binary);
    if (!stream) fail_to_write(target, last_error());
    write(stream);
    stream.close();
    if (!stream) fail_to_write(target, last_error());
    file.commit();
}

void write_beside_and_rename(const fs::path& target, std::string_view contents) {
    write_beside_and_rename(target, [&](std::ostream& stream) {
        stream.write(contents.data(), std::streamsize(contents.size()));
    });
}

}  // namespace lancret
