#pragma once
// Libraries that write to stderr by themselves: libpng does for a broken picture,
// whatever its caller makes of the error.

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace lancret {

/// While it lives, stderr goes nowhere, for all threads.
class QuietStderr {
  public:
    QuietStderr() {
        std::fflush(stderr);
        kept_ = dup(STDERR_FILENO);
        const int nowhere = open("/dev/null", O_WRONLY);
        if (kept_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
        if (nowhere >= 0) close(nowhere);
    }
    ~QuietStderr() {
        std::fflush(stderr);
        if (kept_ < 0) return;
        dup2(kept_, STDERR_FILENO);
        close(kept_);
    }
    QuietStderr(const QuietStderr&) = delete;
    QuietStderr& operator=(const QuietStderr&) = delete;

  private:
    int kept_ = -1;
};

}  // namespace lancret
