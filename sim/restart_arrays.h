#pragma once
// What a simulation writes to go on from a frame, and how it is read back: rows of
// numbers that a cache keeps.

#include <span>
#include <vector>

#include "guides/files/guide_cache.h"
#include "sim/contact/contact.h"

namespace lancret {

void write(const Vec3& v, std::vector<double>& out);
/// The poses that are in use; zeros and identities in the place of the others.
void write(const RodPast& past, int segments, std::vector<double>& out);
void write(const ContactAnchor& anchor, std::vector<double>& out);

/// Reads one of the arrays from its begin. Everything throws std::invalid_argument where
/// the array is missing or too short, and where a number cannot be what is asked for.
class ArrayReader {
  public:
    ArrayReader(const RestartArrays& arrays, const char* name);
    double number();
    int whole(int low, int high);
    Vec3 vector();
    bool done() const { return left_.empty(); }

  private:
    std::span<const double> left_;
};

void read(ArrayReader& from, int segments, RodPast& past);
/// An anchor on one of `colliders`.
void read(ArrayReader& from, const Colliders& colliders, ContactAnchor& anchor);

}  // namespace lancret
