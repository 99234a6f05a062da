#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "guides/base/errors.h"

namespace lancret {

/// A new folder, removed with its contents by the destructor.
struct TemporaryFolder {
    std::filesystem::path path;

    TemporaryFolder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "lancret-XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path / name; }
    std::size_t files() const {
        return std::size_t(std::distance(std::filesystem::directory_iterator(path), {}));
    }
};

inline std::string read_bytes(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_bytes(const std::filesystem::path& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary)
        .write(bytes.data(), std::streamsize(bytes.size()));
}

/// The message of the InputError that `f` throws; empty if it throws none.
template <class F>
std::string input_error(F&& f) {
    try {
        f();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace lancret
