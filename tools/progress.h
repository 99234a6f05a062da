#pragma once
// What a person at a terminal sees while waiting: on stderr, and only where that is a
// terminal.

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace lancret {

/// One line that names the stage at work, and is gone when done.
class StageLine {
  public:
    ~StageLine() { clear(); }
    void show(std::string_view stage);
    void clear();

  private:
    bool shown_ = false;
};

/// A bar with the share done, the time left and, where any were counted, million rays a
/// second; appears after a second.
class ProgressBar {
  public:
    explicit ProgressBar(std::string title) : title_(std::move(title)) {}
    ~ProgressBar() { line_.clear(); }
    /// `done` in [0, 1]. One thread at a time.
    void show(double done, std::uint64_t rays = 0);

  private:
    using Clock = std::chrono::steady_clock;
    std::string title_;
    StageLine line_;
    Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace lancret
