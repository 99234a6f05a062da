#pragma once
// Files that are complete or absent: written to a temporary file, then renamed.

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string_view>

namespace lancret {

/// A file that is being written. The caller writes `temporary()`; `commit()` then puts it
/// in its place in one step. An older file of that name stays unchanged until then. The
/// destructor removes the temporary file if there was no commit.
class PendingFile {
  public:
    /// Throws InputError if `target` can never be written: its folder is missing, or it
    /// exists and is not a regular file. A symbolic link is followed: the file that it
    /// points to is replaced.
    explicit PendingFile(std::filesystem::path target);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// The file to write, in the folder of the target and with its extension, by which
    /// image libraries choose a format. No other PendingFile has the same, in this
    /// process or another.
    const std::filesystem::path& temporary() const { return temporary_; }
    const std::filesystem::path& target() const { return target_; }

    /// Renames the temporary file to the target. Throws InputError if that fails.
    void commit();

  private:
    std::filesystem::path target_, temporary_;
    bool committed_ = false;
};

/// Writes the file that `write` puts into the stream, in binary. Throws InputError if any
/// part of it fails (a full disk, too), and what `write` throws; an older file then stays
/// unchanged.
void write_beside_and_rename(const std::filesystem::path& target,
                             const std::function<void(std::ostream&)>& write);

/// Writes a file with these bytes.
void write_beside_and_rename(const std::filesystem::path& target,
                             std::string_view contents);

}  // namespace lancret
