#pragma once
// Memory for the arrays of one call.

#include <memory>
#include <mutex>
#include <vector>

#include "procedural/lancret_procedural.h"

namespace lancret::abi {

/// Memory blocks for one call. Blocks of the host's allocator are released when the call
/// ends. Without an allocator they are reused by the next call, which takes blocks of
/// similar sizes in the same order.
class Workspace {
  public:
    explicit Workspace(const lancret_host& host) : host_(host) {}
    ~Workspace() { clear(); }
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    /// The next block, uninitialised, aligned to 64 bytes. Throws std::bad_alloc.
    void* take(std::size_t bytes);
    template <class T>
    T* take_array(std::size_t size) {
        return static_cast<T*>(take(size * sizeof(T)));
    }
    /// Ends the use of all blocks.
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

/// A pool of idle workspaces, as many as there were calls at once.
class Workspaces {
  public:
    explicit Workspaces(const lancret_host& host) : host_(host) {}

    /// Throws std::bad_alloc.
    std::unique_ptr<Workspace> take();
    void give(std::unique_ptr<Workspace> workspace) noexcept;

  private:
    const lancret_host& host_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Workspace>> idle_;
};

/// A workspace of the pool for the lifetime of this object.
class WorkspaceLoan {
  public:
    explicit WorkspaceLoan(Workspaces& pool) : pool_(pool), workspace_(pool.take()) {}
    ~WorkspaceLoan() { pool_.give(std::move(workspace_)); }
    WorkspaceLoan(const WorkspaceLoan&) = delete;
    WorkspaceLoan& operator=(const WorkspaceLoan&) = delete;
    Workspace& operator*() const { return *workspace_; }

  private:
    Workspaces& pool_;
    std::unique_ptr<Workspace> workspace_;
};

}  // namespace lancret::abi
