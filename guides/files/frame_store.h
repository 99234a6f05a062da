#pragma once
// The frames of a run as it goes, safe against a kill at any moment.
//
// HDF5 files that are open for writing do not outlive a kill. So while a run to cache.h5
// is under way each of its frames is a file of its own, cache.h5.frames/000042.h5: a
// guide cache of one frame, written beside and renamed, with what a restart needs in its
// group /restart. `finish` makes cache.h5 of them. It has the same bytes however often
// the run was killed and continued, and it too ends in a /restart, so that a longer run
// goes on from it.

#include <filesystem>
#include <string>

#include "guides/files/guide_cache.h"
#include "guides/files/guide_cache_restart.h"

namespace lancret {

/// The last frame of a run, and what going on from it needs.
struct LastFrame {
    int number = 0;  ///< as an artist counts
    Guides guides;
    RestartArrays arrays;
};

/// One run's frames. No two stores may work on one cache at a time.
class FrameStore {
  public:
    /// Looks at what is there of the run to `cache` that calls itself `job`: the frames
    /// of a finished cache, then those of the folder, as far as they are whole, one after
    /// another from `header.first_frame` on. What comes after a damaged or missing frame
    /// is removed. `job` names all that decides a frame (groom, guides, settings), but
    /// not how many there are to be. `rest` are the guides at rest.
    ///
    /// Throws InputError where the folder holds frames of another run; not where `anew`,
    /// which removes what is in the folder and begins from the first frame. Throws
    /// InputError where the cache can never be written, too.
    FrameStore(std::filesystem::path cache, GuideCacheHeader header, std::string job,
               Guides rest, bool anew = false);

    int frames_done() const { return done_; }
    /// Throws std::logic_error where no frame is done, InputError where it cannot be
    /// read.
    LastFrame last() const;

    /// Keeps the next frame, number header.first_frame + frames_done(). Throws InputError
    /// where it cannot be written; std::invalid_argument where the guides are not those
    /// of the rest pose in number and lengths, and where a number is not finite or a root
    /// frame not a rotation: such a frame would not count as done.
    void add(const Guides& frame, const RestartArrays& arrays);

    /// Makes the cache of all frames that are done, one at a time in memory, puts it in
    /// its place and then removes the folder. A finished cache to which nothing was added
    /// stays as it is. Throws InputError; std::logic_error where no frame is done.
    void finish();

    /// Where the frames are while the run lasts, and the file of frame k, counted from 0.
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
    int base_ = 0;  ///< frames that the finished cache holds
    int done_ = 0;
};

}  // namespace lancret
