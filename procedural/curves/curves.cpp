#include "procedural/curves/curves.h"

#include <limits>
#include <stdexcept>

namespace lancret {

void Curves::add_class(std::uint32_t count, std::uint32_t intervals) {
    if (count == 0) return;
    const CurveClass added{strands,
                           std::uint32_t(segment_count()),
                           std::uint32_t(point_count()),
                           count,
                           intervals,
                           control_points_of(basis, intervals)};
    if (added.point + std::size_t(count) * added.points >
        std::numeric_limits<std::uint32_t>::max()) {
        throw std::invalid_argument("curves: more control points than 32 bits can count");
    }
    classes.push_back(added);
    strands += count;
}

std::size_t Curves::segment_count() const {
    if (classes.empty()) return 0;
    const CurveClass& last = classes.back();
    return last.segment + std::size_t(last.strands) * last.segments;
}

std::size_t Curves::point_count() const {
    if (classes.empty()) return 0;
    const CurveClass& last = classes.back();
    return last.point + std::size_t(last.strands) * last.points;
}

}  // namespace lancret
