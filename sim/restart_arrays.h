#pragma once
// Serialisation of the state that a simulation needs to continue from a frame, as the
// arrays of numbers that a cache stores.

#include <span>
#include <vector>

#include "guides/files/guide_cache_restart.h"
#include "sim/contact/contact.h"

namespace lancret {

void write(const Vec3& v, std::vector<double>& out);
/// Writes all kMax poses; those beyond `past.size` as zeros and identities.
void write(const RodPast& past, int segments, std::vector<double>& out);
void write(const ContactAnchor& anchor, std::vector<double>& out);

/// Reads one of the arrays from its beginning. Every function throws
/// std::invalid_argument if the array is missing or too short, or if a number is not of
/// the requested kind.
class ArrayReader {
  public:
    ArrayReader(const RestartArrays& arrays, const char* name);
    double number();
    /// A whole number in [low, high].
    int whole(int low, int high);
    Vec3 vector();
    /// Whether everything has been read.
    bool done() const { return left_.empty(); }

  private:
    std::span<const double> left_;
};

void read(ArrayReader& from, int segments, RodPast& past);
/// Reads an anchor on one of `colliders`.
void read(ArrayReader& from, const Colliders& colliders, ContactAnchor& anchor);

}  // namespace lancret
