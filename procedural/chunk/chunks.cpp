#include "procedural/chunk/chunks.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "guides/base/cancel.h"

namespace lancret {

namespace {

struct Item {
    Vec3f root;
    std::uint32_t id;
};

/// Index of the first of `count` children that belongs to `chunk`.
std::size_t first_of(std::size_t count, std::size_t chunk, std::size_t chunks) {
    return count * chunk / chunks;  // no overflow: both factors are below 2^32
}

/// Sorts the items of the chunks [from, to) chunk by chunk. The contents of a chunk
/// follow from a total order, so they do not depend on how nth_element arranges the rest.
void split(std::span<Item> items, std::size_t from, std::size_t to, std::size_t chunks) {
    const std::size_t first = first_of(items.size(), from, chunks),
                      last = first_of(items.size(), to, chunks);
    const std::span<Item> range = items.subspan(first, last - first);
    if (to - from == 1) {
        std::ranges::sort(range, {}, &Item::id);
        return;
    }
    Eigen::AlignedBox3f box;
    for (const Item& item : range) box.extend(item.root);
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = from + (to - from) / 2;
    const auto nth =
        range.begin() + std::ptrdiff_t(first_of(items.size(), middle, chunks) - first);
    std::nth_element(
        range.begin(), nth, range.end(), [axis](const Item& a, const Item& b) {
            return std::pair(a.root[axis], a.id) < std::pair(b.root[axis], b.id);
        });
    tbb::parallel_invoke([&] { split(items, from, middle, chunks); },
                         [&] { split(items, middle, to, chunks); });
    stop_if_cancelled();
}

}  // namespace

Chunks make_chunks(std::size_t count, const std::function<Vec3f(std::uint32_t)>& root,
                   std::uint32_t max_strands) {
    if (max_strands == 0 || count > std::numeric_limits<std::uint32_t>::max()) {
        throw std::invalid_argument(
            "make_chunks: need at least 1 child per chunk and fewer than 2^32 children");
    }
    Chunks out;
    if (count == 0) return out;
    const std::size_t chunks = (count + max_strands - 1) / max_strands;
    std::vector<Item> items(count);
    const auto each = [&](auto&& visit) {
        cancellable_for(tbb::blocked_range<std::size_t>(0, count, 4096),
                        [&](const auto& range) {
                            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                                visit(i);
                            }
                        });
    };
    each([&](std::size_t i) { items[i] = {root(std::uint32_t(i)), std::uint32_t(i)}; });
    split(items, 0, chunks, chunks);
    out.children.resize(count);
    each([&](std::size_t i) { out.children[i] = items[i].id; });
    for (std::size_t chunk = 0; chunk <= chunks; ++chunk) {
        out.first.push_back(std::uint32_t(first_of(count, chunk, chunks)));
    }
    return out;
}

}  // namespace lancret
