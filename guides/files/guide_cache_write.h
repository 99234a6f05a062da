#pragma once
// Writing guide caches (guide_cache.h has the layout).

#include <memory>
#include <span>

#include "guides/files/guide_cache.h"
#include "guides/files/guide_cache_restart.h"

namespace lancret {

/// Writes a cache of these frames. Throws InputError if the file cannot be written, and
/// std::invalid_argument if there are no frames or no guides, or if the frames differ in
/// the number of guides or segments or in segment lengths.
void write_guide_cache(const std::filesystem::path& path, const GuideCacheHeader& header,
                       std::span<const Guides> frames);

/// Writes a cache frame by frame, with one frame in memory at a time. `finish` puts the
/// file in its place; an older file stays there until then. Equal contents give equal
/// bytes.
class GuideCacheWriter {
  public:
    /// A cache of `frames` frames and, if `rest` is not null, the rest pose. Throws
    /// InputError if the file cannot be written, std::invalid_argument without frames.
    GuideCacheWriter(const std::filesystem::path& path, const GuideCacheHeader& header,
                     int frames, const Guides* rest = nullptr);
    ~GuideCacheWriter();
    GuideCacheWriter(const GuideCacheWriter&) = delete;
    GuideCacheWriter& operator=(const GuideCacheWriter&) = delete;

    /// Adds the next frame. Throws as write_guide_cache does.
    void add(const Guides& frame);
    /// To be called after the last frame. Throws InputError if the disk is full, and
    /// std::invalid_argument if frames are missing or `restart` breaks its rules.
    void finish(const Restart* restart = nullptr);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lancret
