#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <span>
#include <type_traits>

namespace lancret {

/// Uninitialised memory, aligned to 64 bytes; release it with std::free. Large blocks use
/// huge pages if the system has them, because the first touch of every page faults.
/// Throws std::bad_alloc.
void* untouched_memory(std::size_t bytes);

/// An array of fixed size. Unlike std::vector it leaves its elements uninitialised, so
/// its memory is not written twice.
template <class T>
class Buffer {
    static_assert(std::is_trivial_v<T> && alignof(T) <= 64);

  public:
    Buffer() = default;
    explicit Buffer(std::size_t size)
        : data_(size > 0 ? static_cast<T*>(untouched_memory(size * sizeof(T))) : nullptr),
          size_(size) {}

    /// A view of memory that the caller owns; `data` must be aligned for T.
    static Buffer over(T* data, std::size_t size) {
        Buffer out;
        out.data_ = {data, Free{false}};
        out.size_ = size;
        return out;
    }

    T* data() { return data_.get(); }
    const T* data() const { return data_.get(); }
    std::size_t size() const { return size_; }
    std::size_t bytes() const { return size_ * sizeof(T); }
    T& operator[](std::size_t i) { return data_[i]; }
    const T& operator[](std::size_t i) const { return data_[i]; }
    std::span<T> span() { return {data_.get(), size_}; }
    std::span<const T> span() const { return {data_.get(), size_}; }

  private:
    struct Free {
        bool owned = true;
        void operator()(T* data) const {
            if (owned) std::free(data);
        }
    };
    std::unique_ptr<T[], Free> data_;
    std::size_t size_ = 0;
};

}  // namespace lancret
