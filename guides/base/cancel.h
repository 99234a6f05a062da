#pragma once
// Cooperative cancellation.

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_reduce.h>
#include <oneapi/tbb/task_group.h>

#include <exception>
#include <utility>

namespace lancret {

/// Thrown through work that was cancelled.
struct Cancelled : std::exception {
    const char* what() const noexcept override { return "cancelled"; }
};

/// Throws Cancelled if the TBB task group that this runs in, or one around it, was
/// cancelled: parallel loops then end before their work is done. No-op outside of any
/// group.
inline void stop_if_cancelled() {
    if (tbb::is_current_task_group_canceling()) throw Cancelled();
}

/// tbb::parallel_for that throws Cancelled if it was cut short: its results are then
/// incomplete.
template <class... Arguments>
void cancellable_for(Arguments&&... arguments) {
    tbb::parallel_for(std::forward<Arguments>(arguments)...);
    stop_if_cancelled();
}

/// tbb::parallel_reduce that throws Cancelled if it was cut short.
template <class... Arguments>
auto cancellable_reduce(Arguments&&... arguments) {
    auto out = tbb::parallel_reduce(std::forward<Arguments>(arguments)...);
    stop_if_cancelled();
    return out;
}

/// Runs `work` to completion even if the caller is cancelled, for libraries that do not
/// expect to be cut short. Throws Cancelled afterwards.
template <class Work>
void run_to_completion(const Work& work) {
    tbb::task_group_context isolated(tbb::task_group_context::isolated);
    tbb::task_group(isolated).run_and_wait(work);
    stop_if_cancelled();
}

}  // namespace lancret
