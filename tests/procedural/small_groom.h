#pragma once
// Settings of a small made groom.

#include "procedural/groom/groom.h"

namespace lancret::test {

/// The numbers that a small groom is made of.
struct SmallGroom {
    std::uint32_t made = 40;    ///< strands of the made groom
    std::size_t guides = 12;    ///< of them
    int segments = 4;           ///< per guide
    std::uint32_t strands = 1;  ///< children
};

inline GroomSettings small_groom(const SmallGroom& numbers) {
    GroomSettings groom;
    groom.name = "small";
    groom.made.strands = numbers.made;
    groom.guides.number = numbers.guides;
    groom.fit.segments = numbers.segments;
    groom.strands = numbers.strands;
    return groom;
}

}  // namespace lancret::test
