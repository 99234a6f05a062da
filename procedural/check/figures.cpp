#include "procedural/check/figures.h"

#include <cmath>

#include "guides/base/worst.h"

namespace lancret {

StrandCheck largest_figures(const CheckReport& report) {
    StrandCheck out;
    for (const StrandCheck& strand : report.strands) {
        for (const Figure& figure : kFigures) {
            float& largest = out.*figure.value;
            largest = worst_of(largest, std::abs(strand.*figure.value));
        }
    }
    return out;
}

}  // namespace lancret
