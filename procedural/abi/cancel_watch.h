#pragma once
// Polls the host's `cancelled` callback while calls run.

#include <oneapi/tbb/task_group.h>

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "procedural/lancret_procedural.h"

namespace lancret::abi {

/// Calls the host's `cancelled` callback every few milliseconds while calls run, and
/// cancels all of them if it returns non-zero. Has no thread if there is no callback.
/// `host` must outlive it.
class CancelWatch {
  public:
    explicit CancelWatch(const lancret_host& host);
    ~CancelWatch();
    CancelWatch(const CancelWatch&) = delete;
    CancelWatch& operator=(const CancelWatch&) = delete;

    /// Calls the callback once, on this thread; false if there is none.
    bool cancelled() const;
    void add(tbb::task_group_context& call);
    void remove(tbb::task_group_context& call);

  private:
    void watch();

    const lancret_host& host_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<tbb::task_group_context*> calls_;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace lancret::abi
