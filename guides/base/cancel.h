#pragma once
// Giving up in the middle, when whoever asked for the work no longer wants it.

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

/// Throws Cancelled where the TBB task group that this runs in, or one around it, was
/// cancelled: parallel loops then end before their work is done. Outside of any it does
/// nothing.
inline void stop_if_cancelled() {
    if (tbb::is_current_task_group_canceling()) throw Cancelled();
}

/// tbb::parallel_for, but that it throws Cancelled where it was cut short: what it should
/// have written is not there.
template <class... Arguments>
void cancellable_for(Arguments&&... arguments) {
    tbb::parallel_for(std::forward<Arguments>(arguments)...);
    stop_if_cancelled();
}

/// The same of tbb::parallel_reduce.
template <class... Arguments>
auto cancellable_reduce(Arguments&&... arguments) {
    auto out = tbb::parallel_reduce(std::forward<Arguments>(arguments)...);
    stop_if_cancelled();
    return out;
}

/// Work that is done to its end whether or not what it is for is cancelled: that of a
/// library which does not expect to be cut short. Then throws Cancelled.
template <class Work>
void run_to_completion(const Work& work) {
    tbb::task_group_context own(tbb::task_group_context::isolated);
    tbb::task_group(own).run_and_wait(work);
    stop_if_cancelled();
}

}  // namespace lancret
