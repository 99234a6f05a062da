#pragma once
// Asking a host, while it waits for us, whether it still wants the result.

#include <oneapi/tbb/task_group.h>

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "procedural/lancret_procedural.h"

namespace lancret::abi {

/// Asks a host's cancel callback every few milliseconds while calls run, and cancels them
/// all when it says so. Without a callback it does nothing and has no thread.
class CancelWatch {
  public:
    explicit CancelWatch(const lancret_host& host);
    ~CancelWatch();
    CancelWatch(const CancelWatch&) = delete;
    CancelWatch& operator=(const CancelWatch&) = delete;

    /// Whether the host says so now.
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
