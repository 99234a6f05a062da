#include "procedural/abi/workspace.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#include "procedural/curves/buffer.h"

namespace lancret::abi {

namespace {

constexpr std::size_t kCacheLine = 64;
/// Idle workspaces beyond these are freed.
constexpr std::size_t kMaxIdle = 64;

}  // namespace

void* Workspace::take(std::size_t bytes) {
    if (next_ == blocks_.size()) blocks_.emplace_back();
    Block& block = blocks_[next_++];
    // Replaced if it is too small, or larger than 8 times the request.
    if (block.data && block.bytes >= bytes && block.bytes / 8 <= bytes) return block.data;
    release(block);
    // An eighth more, so that chunks of similar size can reuse it.
    const std::size_t wanted =
        host_.allocate ? std::max(bytes, kCacheLine) : bytes + bytes / 8 + kCacheLine;
    block.data = host_.allocate ? host_.allocate(host_.user, wanted, kCacheLine)
                                : untouched_memory(wanted);
    if (!block.data) throw std::bad_alloc();
    block.bytes = wanted;
    return block.data;
}

void Workspace::rewind() {
    next_ = 0;
    if (host_.allocate) clear();
}

void Workspace::release(Block& block) {
    if (!block.data) return;
    if (host_.release) {
        host_.release(host_.user, block.data, block.bytes);
    } else {
        std::free(block.data);
    }
    block = {};
}

void Workspace::clear() {
    for (Block& block : blocks_) release(block);
    blocks_.clear();
}

std::unique_ptr<Workspace> Workspaces::take() {
    {
        const std::lock_guard lock(mutex_);
        idle_.reserve(kMaxIdle);  // here, since `give` must not throw
        if (!idle_.empty()) {
            auto out = std::move(idle_.back());
            idle_.pop_back();
            return out;
        }
    }
    return std::make_unique<Workspace>(host_);
}

void Workspaces::give(std::unique_ptr<Workspace> workspace) noexcept {
    workspace->rewind();
    const std::lock_guard lock(mutex_);
    if (idle_.size() < kMaxIdle) idle_.push_back(std::move(workspace));
}

}  // namespace lancret::abi
