#pragma once
// Giving up in the middle, when whoever asked for the work no longer wants it.

#include <oneapi/tbb/task_group.h>

#include <exception>

namespace lancret {

/// Thrown through work that was cancelled.
struct Cancelled : std::exception {
    const char* what() const noexcept override { return "cancelled"; }
};

/// Throws Cancelled where the TBB task group that this runs in, or one around it, was
/// cancelled: parallel loops then end before their work is done. Outside of any it does
/// nothing.
inline void stop_if_cancelled() {
    if (tbb::is_current_task_group_canceling()) throw Cancelled();
}

}  // namespace lancret
