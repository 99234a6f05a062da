#pragma once
// HDF5 for the sources of the guide cache, guide_cache*.cpp. Nothing else may include it.

#include <fmt/format.h>
#include <hdf5.h>

#include <filesystem>
#include <mutex>
#include <string_view>
#include <utility>

#include "guides/base/errors.h"

namespace lancret::hdf5 {

inline constexpr std::string_view kFormat = "lancret guide cache";
inline constexpr std::string_view kUnits = "cm g s rad";
inline constexpr int kVersion = 1;
inline constexpr const char* kPositions = "/root_positions";
inline constexpr const char* kFrames = "/root_frames";
inline constexpr const char* kLengths = "/segment_lengths";
inline constexpr const char* kCurvatures = "/curvatures";
inline constexpr const char* kRest = "/rest";        ///< the group of the rest pose
inline constexpr const char* kRestart = "/restart";  ///< the group of the restart state

/// Exclusive use of HDF5, which is not thread-safe, without its error messages.
class Session {
  public:
    Session() : lock_(mutex()) {
        H5Eget_auto2(H5E_DEFAULT, &print_, &to_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~Session() { H5Eset_auto2(H5E_DEFAULT, print_, to_); }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

  private:
    static std::mutex& mutex() {
        static std::mutex one;
        return one;
    }
    std::lock_guard<std::mutex> lock_;
    H5E_auto2_t print_ = nullptr;
    void* to_ = nullptr;
};

/// Owns an HDF5 object and closes it.
class Handle {
  public:
    Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), close_(closer) {}
    Handle(Handle&& other) noexcept
        : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    operator hid_t() const { return id_; }
    bool good() const { return id_ >= 0; }

    /// Closes the object; returns whether that succeeded.
    bool close() { return close_(std::exchange(id_, -1)) >= 0; }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

[[noreturn]] inline void fail(const std::filesystem::path& path, std::string_view what) {
    throw InputError(fmt::format("{}: {}", path.string(), what));
}

}  // namespace lancret::hdf5
