#pragma once
// Values that are made once and shared by all who ask for the same.

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

/// One value a key, made by whoever asks first while others wait. A value lives as long
/// as somebody holds it; the last few live longer, up to `most` of them.
template <class Key, class Value>
class SharedByKey {
  public:
    explicit SharedByKey(std::size_t most) : most_(most) {}

    /// From now on no fewer than so many live longer.
    void keep_at_least(std::size_t most) {
        const std::lock_guard lock(mutex_);
        most_ = std::max(most_, most);
    }

    /// The value of `key`; `make()` returns it as a std::shared_ptr<const Value> where
    /// there is none, and may throw. Who waits stops, with Cancelled, when cancelled.
    template <class Make>
    std::shared_ptr<const Value> get(const Key& key, const Make& make) {
        std::unique_lock lock(mutex_);
        for (;;) {
            const auto at = slots_.find(key);
            if (at == slots_.end()) break;
            if (auto value = at->second.value.lock()) return keep(key, value, lock);
            if (!at->second.making) break;
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
        // What is let go ends after the lock does: a value may be large.
        std::deque<std::pair<Key, Held>> gone;
        if (most_ > 0) {
            std::erase_if(recent_, [&](const auto& entry) { return entry.first == key; });
            recent_.emplace_back(key, value);
            while (recent_.size() > most_) {
                gone.push_back(std::move(recent_.front()));
                recent_.pop_front();
            }
        }
        lock.unlock();
        return value;
    }

    std::size_t most_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<Key, Slot> slots_;
    std::deque<std::pair<Key, Held>> recent_;
};

}  // namespace lancret::abi
