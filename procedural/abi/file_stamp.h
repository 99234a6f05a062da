#pragma once
// Whether a file is still the one that was seen.

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace lancret::abi {

/// Of a file that is not there the size is none.
struct FileStamp {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;

    bool operator==(const FileStamp&) const = default;
};

inline FileStamp stamp_of(const std::filesystem::path& file) {
    std::error_code unknown;
    return {std::filesystem::file_size(file, unknown),
            std::filesystem::last_write_time(file, unknown)};
}

}  // namespace lancret::abi
