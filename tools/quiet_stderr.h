#pragma once
// Silences libraries that write to stderr themselves, such as libpng for a damaged file.

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace lancret {

/// Discards stderr of all threads during its lifetime.
class QuietStderr {
  public:
    QuietStderr() {
        std::fflush(stderr);
        saved_ = dup(STDERR_FILENO);
        const int null_device = open("/dev/null", O_WRONLY);
        if (saved_ >= 0 && null_device >= 0) dup2(null_device, STDERR_FILENO);
        if (null_device >= 0) close(null_device);
    }
    ~QuietStderr() {
        std::fflush(stderr);
        if (saved_ < 0) return;
        dup2(saved_, STDERR_FILENO);
        close(saved_);
    }
    QuietStderr(const QuietStderr&) = delete;
    QuietStderr& operator=(const QuietStderr&) = delete;

  private:
    int saved_ = -1;
};

}  // namespace lancret
