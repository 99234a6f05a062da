#include "tools/progress.h"

#include <fmt/format.h>
#include <unistd.h>

namespace lancret {

namespace {

bool on_terminal() {
    static const bool terminal = isatty(STDERR_FILENO) == 1;
    return terminal;
}

}  // namespace

void StageLine::show(std::string_view stage) {
    if (!on_terminal()) return;
    fmt::print(stderr, "\r\033[K{} ...", stage);
    std::fflush(stderr);
    shown_ = true;
}

void StageLine::clear() {
    if (!shown_) return;
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
    shown_ = false;
}

void ProgressBar::show(double done, std::uint64_t rays) {
    using Seconds = std::chrono::duration<double>;
    const Clock::time_point now = Clock::now();
    const double passed = Seconds(now - start_).count();
    if (passed < 1 || Seconds(now - last_).count() < 0.1) return;
    last_ = now;
    constexpr int kWidth = 30;
    const int full = int(done * kWidth);
    const double left = done > 0 ? passed * (1 - done) / done : 0;
    const std::string rate =
        rays > 0 ? fmt::format(", {:.2f} million rays/s", 1e-6 * double(rays) / passed)
                 : std::string();
    line_.show(fmt::format("{} [{}{}] {:3.0f} % {:.0f} s left{}", title_,
                           std::string(full, '='), std::string(kWidth - full, ' '),
                           100 * done, left, rate));
}

}  // namespace lancret
