#pragma once
// The frames of a run in progress, safe against a kill at any moment.
//
// HDF5 files that are open for writing are lost if the process is killed. So while a run
// to cache.h5 is in progress each of its frames is a file, cache.h5.frames/000042.h5: a
// guide cache of one frame, written to a temporary file and renamed, with the state for a
// restart in its group /restart. `finish` makes cache.h5 of them. It has the same bytes
// no matter how often the run was killed and continued, and it also has a /restart, from
// which a longer run continues.

#include <filesystem>
#include <string>

#include "guides/files/guide_cache.h"
#include "guides/files/guide_cache_restart.h"

namespace lancret {

/// The last frame of a run, and the state to continue from it.
struct LastFrame {
    int number = 0;  ///< frame number
    Guides guides;
    RestartArrays arrays;
};

/// The frames of one run. Only one store may use a cache at a time.
class FrameStore {
  public:
    /// Finds the frames of the run `job` to `cache` that are done: those of a finished
    /// cache, then those of the folder, consecutive from `header.first_frame` on. Removes
    /// the frames after a damaged or missing one. `job` identifies everything that
    /// determines a frame (groom, guides, settings), but not the number of frames. `rest`
    /// are the guides at rest.
    ///
    /// With `restart`, removes the frames in the folder and starts from the first frame.
    /// Otherwise throws InputError if the folder contains frames of another run. Throws
    /// InputError if the cache can never be written.
    FrameStore(std::filesystem::path cache, GuideCacheHeader header, std::string job,
               Guides rest, bool restart = false);

    int frames_done() const { return done_; }
    /// Throws std::logic_error if no frame is done, InputError if it cannot be read.
    LastFrame last() const;

    /// Stores the next frame, number header.first_frame + frames_done(). Throws
    /// InputError if it cannot be written; std::invalid_argument if the guides differ
    /// from the rest pose in number or lengths, a number is not finite, or a root frame
    /// is not a rotation: such a frame would not count as done.
    void add(const Guides& frame, const RestartArrays& arrays);

    /// Writes the cache of all frames that are done, with one at a time in memory, then
    /// removes the folder. A finished cache without new frames stays unchanged. Throws
    /// InputError; std::logic_error if no frame is done.
    void finish();

    /// The folder of the frames during the run, and the file of frame k, counted from 0.
    static std::filesystem::path folder_of(const std::filesystem::path& cache);
    std::filesystem::path frame_file(int k) const;

  private:
    int number(int k) const;
    int finished_frames() const;
    bool is_whole(int k) const;
    Guides frame(int k) const;
    void refuse_other_runs() const;
    void remove_from(int k) const;

    std::filesystem::path cache_, folder_;
    GuideCacheHeader header_;
    std::string job_;
    Guides rest_;
    int base_ = 0;  ///< frames in the finished cache
    int done_ = 0;
};

}  // namespace lancret
