#include "procedural/abi/cancel_watch.h"

#include <algorithm>
#include <chrono>

namespace lancret::abi {

namespace {

constexpr std::chrono::milliseconds kPollInterval{2};

}  // namespace

CancelWatch::CancelWatch(const lancret_host& host) : host_(host) {
    if (host_.cancelled) thread_ = std::thread([this] { watch(); });
}

CancelWatch::~CancelWatch() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

bool CancelWatch::cancelled() const {
    return host_.cancelled && host_.cancelled(host_.user) != 0;
}

void CancelWatch::add(tbb::task_group_context& call) {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        calls_.push_back(&call);
    }
    changed_.notify_all();
}

void CancelWatch::remove(tbb::task_group_context& call) {
    if (!thread_.joinable()) return;
    const std::lock_guard lock(mutex_);
    std::erase(calls_, &call);
}

void CancelWatch::watch() {
    std::unique_lock lock(mutex_);
    while (!ending_) {
        if (calls_.empty()) {
            changed_.wait(lock);
            continue;
        }
        changed_.wait_for(lock, kPollInterval);
        if (ending_ || calls_.empty()) continue;
        // The host may be slow to answer, or may call this library.
        lock.unlock();
        const bool cancel = cancelled();
        lock.lock();
        if (!cancel) continue;
        for (tbb::task_group_context* call : calls_) call->cancel_group_execution();
    }
}

}  // namespace lancret::abi
