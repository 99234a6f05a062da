#pragma once
// Files that are whole or not there: written beside their place, then renamed into it.

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string_view>

namespace lancret {

/// A file that is being written. Whoever writes it writes `temporary()`; `commit()` puts
/// it in its place in one step. Until then an older file of that name stays as it was,
/// and a PendingFile that goes away without a commit takes its temporary file with it.
class PendingFile {
  public:
    /// Throws InputError where `target` can never be written: its folder is missing, or
    /// it names something that is not a regular file. A symbolic link is followed, so it
    /// is the file behind it that is replaced.
    explicit PendingFile(std::filesystem::path target);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// Where to write: in the folder of the target and with its extension, by which image
    /// libraries choose a format. Of no other PendingFile, in this process or another.
    const std::filesystem::path& temporary() const { return temporary_; }
    const std::filesystem::path& target() const { return target_; }

    /// Renames the temporary file to the target. Throws InputError where that fails.
    void commit();

  private:
    std::filesystem::path target_, temporary_;
    bool committed_ = false;
};

/// Writes a file, in binary, by what `write` puts into the stream. Throws InputError
/// where anything of it fails (a full disk, too), and lets through what `write` throws;
/// the file that was there before then stays as it was.
void write_beside_and_rename(const std::filesystem::path& target,
                             const std::function<void(std::ostream&)>& write);

/// Writes a file of these bytes.
void write_beside_and_rename(const std::filesystem::path& target,
                             std::string_view contents);

}  // namespace lancret
