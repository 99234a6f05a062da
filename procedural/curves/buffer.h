#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <span>
#include <type_traits>

namespace lancret {

/// Memory that nothing has been written to, aligned to 64 bytes; a large block in huge
/// pages where the system has them, since a first touch costs a fault a page. Throws
/// std::bad_alloc. Give it back by std::free.
void* untouched_memory(std::size_t bytes);

/// An array that is allocated once and written by its maker: unlike std::vector it does
/// not pass over its memory to zero it first.
template <class T>
class Buffer {
    static_assert(std::is_trivial_v<T> && alignof(T) <= 64);

  public:
    Buffer() = default;
    explicit Buffer(std::size_t size)
        : data_(size > 0 ? static_cast<T*>(untouched_memory(size * sizeof(T))) : nullptr),
          size_(size) {}

    /// Over somebody else's memory, aligned as T is, which is not given back.
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
        bool own = true;
        void operator()(T* data) const {
            if (own) std::free(data);
        }
    };
    std::unique_ptr<T[], Free> data_;
    std::size_t size_ = 0;
};

}  // namespace lancret
