#pragma once
// How a call of the interface runs: threads, cancellation, errors.

#include <oneapi/tbb/task_group.h>

#include <cstddef>
#include <string>

#include "procedural/lancret_procedural.h"

namespace lancret::abi {

/// Calls back into the host, on this thread, before it returns. The host's own TBB loops
/// in the callback are not cancelled together with the call.
template <class Callback>
void call_host(const Callback& callback) {
    tbb::task_group_context isolated(tbb::task_group_context::isolated);
    tbb::task_group(isolated).run_and_wait(callback);
}

/// No-op if the host has no log.
void log(const lancret_context& context, int level, const std::string& text);

/// Copies `text` with a terminating null, truncated to `size` bytes at the boundary of a
/// UTF-8 character. No-op if `to` is null or `size` is 0.
void copy_text(const std::string& text, char* to, std::size_t size);

/// A reference to a callable, which must outlive it. Unlike std::function it never
/// allocates, since memory may be exhausted.
class WorkRef {
  public:
    template <class Work>
    WorkRef(const Work& work)
        : work_(&work), do_([](const void* w) { (*static_cast<const Work*>(w))(); }) {}
    void operator()() const { do_(work_); }

  private:
    const void* work_;
    void (*do_)(const void*);
};

/// Runs the work of one call until it is done or the host cancels: in a TBB arena of its
/// own with the host's number of threads, so that the waiting thread never takes a task
/// of the host, and with default floating-point settings. Returns the status for any
/// exception, logs its text and, if `error` is not null, stores it as one line.
lancret_status run(lancret_context& context, WorkRef work,
                   std::string* error = nullptr) noexcept;

/// Thrown if a host's sink returned a status other than LANCRET_OK.
struct SinkEnded {
    lancret_status status;
};

}  // namespace lancret::abi
