#pragma once
// A cache of shared values, each made once.

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "guides/base/cancel.h"

namespace lancret::abi {

/// One value per key, made by the first caller while others wait for it. A value lives as
/// long as it is held; in addition the `kept` most recent values are held here.
template <class Key, class Value>
class SharedByKey {
  public:
    explicit SharedByKey(std::size_t kept) : kept_(kept) {}

    /// Raises the number of recent values that are held.
    void keep_at_least(std::size_t kept) {
        const std::lock_guard lock(mutex_);
        kept_ = std::max(kept_, kept);
    }

    /// The value of `key`. Calls `make()` if there is none, which returns a
    /// std::shared_ptr<const Value> and may throw. Throws Cancelled while it waits.
    template <class Make>
    std::shared_ptr<const Value> get(const Key& key, const Make& make) {
        std::unique_lock lock(mutex_);
        for (;;) {
            const auto slot = slots_.find(key);
            if (slot == slots_.end()) break;
            if (auto value = slot->second.value.lock()) return keep(key, value, lock);
            if (!slot->second.making) break;
            changed_.wait_for(lock, std::chrono::milliseconds(2));
            stop_if_cancelled();
        }
        std::erase_if(slots_, [](const auto& entry) {
            return !entry.second.making && entry.second.value.expired();
        });
        slots_[key].making = true;
        lock.unlock();
        std::shared_ptr<const Value> value;
        try {
            value = make();
        } catch (...) {
            lock.lock();
            slots_.erase(key);
            changed_.notify_all();
            throw;
        }
        lock.lock();
        slots_[key] = {false, value};
        changed_.notify_all();
        return keep(key, value, lock);
    }

  private:
    using Held = std::shared_ptr<const Value>;
    struct Slot {
        bool making = false;
        std::weak_ptr<const Value> value;
    };

    Held keep(const Key& key, const Held& value, std::unique_lock<std::mutex>& lock) {
        // Destroyed after the lock is released, since a value may be large.
        std::deque<std::pair<Key, Held>> gone;
        if (kept_ > 0) {
            std::erase_if(recent_, [&](const auto& entry) { return entry.first == key; });
            recent_.emplace_back(key, value);
            while (recent_.size() > kept_) {
                gone.push_back(std::move(recent_.front()));
                recent_.pop_front();
            }
        }
        lock.unlock();
        return value;
    }

    std::size_t kept_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<Key, Slot> slots_;
    std::deque<std::pair<Key, Held>> recent_;
};

}  // namespace lancret::abi
