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

/// Where the chunk `part` of `parts` begins, of `count` children.
std::size_t cut(std::size_t count, std::size_t part, std::size_t parts) {
    return count * part / parts;  // below 2^32 times 2^32
}

/// Orders items so that those of each of the chunks [from, to) stand together. What a
/// chunk holds is decided by a total order, whatever nth_element does besides.
void split(std::span<Item> items, std::size_t from, std::size_t to, std::size_t parts) {
    const std::size_t first = cut(items.size(), from, parts),
                      last = cut(items.size(), to, parts);
    const std::span<Item> own = items.subspan(first, last - first);
    if (to - from == 1) {
        std::ranges::sort(own, {}, &Item::id);
        return;
    }
    Eigen::AlignedBox3f box;
    for (const Item& item : own) box.extend(item.root);
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = from + (to - from) / 2;
    const auto nth =
        own.begin() + std::ptrdiff_t(cut(items.size(), middle, parts) - first);
    std::nth_element(own.begin(), nth, own.end(), [axis](const Item& a, const Item& b) {
        return std::pair(a.root[axis], a.id) < std::pair(b.root[axis], b.id);
    });
    tbb::parallel_invoke([&] { split(items, from, middle, parts); },
                         [&] { split(items, middle, to, parts); });
    stop_if_cancelled();
}

}  // namespace

Chunks make_chunks(std::size_t count, const std::function<Vec3f(std::uint32_t)>& root,
                   std::uint32_t most) {
    if (most == 0 || count > std::numeric_limits<std::uint32_t>::max()) {
        throw std::invalid_argument("make_chunks: chunks of 1 or more, of up to 2^32");
    }
    Chunks out;
    if (count == 0) return out;
    const std::size_t parts = (count + most - 1) / most;
    std::vector<Item> items(count);
    const auto all = [&](auto&& of_one) {
        cancellable_for(tbb::blocked_range<std::size_t>(0, count, 4096),
                        [&](const auto& range) {
                            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                                of_one(i);
                            }
                        });
    };
    all([&](std::size_t i) { items[i] = {root(std::uint32_t(i)), std::uint32_t(i)}; });
    split(items, 0, parts, parts);
    out.children.resize(count);
    all([&](std::size_t i) { out.children[i] = items[i].id; });
    for (std::size_t part = 0; part <= parts; ++part) {
        out.first.push_back(std::uint32_t(cut(count, part, parts)));
    }
    return out;
}

}  // namespace lancret
