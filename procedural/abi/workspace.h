#pragma once
// Memory for the arrays of one call.

#include <memory>
#include <mutex>
#include <vector>

#include "procedural/lancret_procedural.h"

namespace lancret::abi {

/// Blocks for one call, asked for in the same order by each: the host's, given back when
/// the call ends; without its allocator our own, which wait for the next call.
class Workspace {
  public:
    explicit Workspace(const lancret_host& host) : host_(host) {}
    ~Workspace() { clear(); }
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    /// The next block, aligned to 64 bytes; what is in it is undefined. Throws
    /// std::bad_alloc.
    void* take(std::size_t bytes);
    template <class T>
    T* take_array(std::size_t size) {
        return static_cast<T*>(take(size * sizeof(T)));
    }
    /// Takes all blocks back.
    void rewind();

  private:
    struct Block {
        void* data = nullptr;
        std::size_t bytes = 0;
    };
    void release(Block& block);
    void clear();

    const lancret_host& host_;
    std::vector<Block> blocks_;
    std::size_t next_ = 0;
};

/// Workspaces that wait for a call: as many as there were calls at once.
class Workspaces {
  public:
    explicit Workspaces(const lancret_host& host) : host_(host) {}

    /// Throws std::bad_alloc; giving back throws nothing.
    std::unique_ptr<Workspace> take();
    void give(std::unique_ptr<Workspace> workspace) noexcept;

  private:
    const lancret_host& host_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Workspace>> idle_;
};

/// One of them for as long as this lives.
class WorkspaceLoan {
  public:
    explicit WorkspaceLoan(Workspaces& from) : from_(from), own_(from.take()) {}
    ~WorkspaceLoan() { from_.give(std::move(own_)); }
    WorkspaceLoan(const WorkspaceLoan&) = delete;
    WorkspaceLoan& operator=(const WorkspaceLoan&) = delete;
    Workspace& operator*() const { return *own_; }

  private:
    Workspaces& from_;
    std::unique_ptr<Workspace> own_;
};

}  // namespace lancret::abi
