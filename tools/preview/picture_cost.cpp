#include "tools/preview/picture_cost.h"

#include <algorithm>

namespace lancret {

void add_cost(const PictureCost& cost, bool is_first, PictureCost& total) {
    total.bind += cost.bind;
    total.expand += cost.expand;
    total.bvh += cost.bvh;
    total.render += cost.render;
    total.rays += cost.rays;
    total.paths += cost.paths;
    if (is_first) total.first = cost.first;
    total.bvh_bytes = std::max(total.bvh_bytes, cost.bvh_bytes);
}

}  // namespace lancret
