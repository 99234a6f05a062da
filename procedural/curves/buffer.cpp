#include "procedural/curves/buffer.h"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace lancret {

void* untouched_memory(std::size_t bytes) {
    constexpr std::size_t kLine = 64, kHuge = std::size_t(2) << 20;
    const bool large = bytes >= 2 * kHuge;
    const std::size_t alignment = large ? kHuge : kLine;
    const std::size_t size = (bytes + kLine - 1) / kLine * kLine;
    // Unlike std::aligned_alloc, posix_memalign takes sizes that are no multiple of the
    // alignment.
    void* memory = nullptr;
    if (size < bytes || posix_memalign(&memory, alignment, size) != 0) {
        throw std::bad_alloc();
    }
#ifdef MADV_HUGEPAGE
    // Whole pages only: a huge page for the rest would waste memory. A refusal only costs
    // speed.
    if (large) (void)madvise(memory, size / kHuge * kHuge, MADV_HUGEPAGE);
#endif
    return memory;
}

}  // namespace lancret
