#pragma once
// Detects that a file was replaced or rewritten.

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace lancret::abi {

/// Size and modification time of a file.
struct FileStamp {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;

    bool operator==(const FileStamp&) const = default;
};

/// Throws nothing: all files that cannot be read have the same stamp.
inline FileStamp stamp_of(const std::filesystem::path& file) {
    std::error_code ignored;
    return {std::filesystem::file_size(file, ignored),
            std::filesystem::last_write_time(file, ignored)};
}

}  // namespace lancret::abi
