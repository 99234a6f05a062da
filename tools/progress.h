#pragma once
// Progress on stderr, shown only if stderr is a terminal.

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace lancret {

/// A line with the name of the current stage; the destructor clears it.
class StageLine {
  public:
    ~StageLine() { clear(); }
    void show(std::string_view stage);
    void clear();

  private:
    bool shown_ = false;
};

/// A bar with the completed fraction, the remaining time and, if rays were counted, the
/// rate in million rays per second. Appears after one second.
class ProgressBar {
  public:
    explicit ProgressBar(std::string title) : title_(std::move(title)) {}
    ~ProgressBar() { line_.clear(); }
    /// `done` is in [0, 1]. Not thread-safe.
    void show(double done, std::uint64_t rays = 0);

  private:
    using Clock = std::chrono::steady_clock;
    std::string title_;
    StageLine line_;
    Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace lancret
