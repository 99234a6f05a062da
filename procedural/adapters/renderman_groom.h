#pragma once
// A groom that is held open for the procedurals of its chunks.

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "procedural/adapters/renderman_parameters.h"
#include "procedural/adapters/ri.h"

namespace lancret {

/// The log of Lancret, from any thread. Kept until `print`, since Ri may be called from
/// threads of the renderer only.
class Messages {
  public:
    void add(RtInt severity, std::string text);
    /// Passes all warnings and infos to the renderer and forgets them.
    void print();
    /// Returns the last error of a call on this thread, for the caller to report, and
    /// forgets it; empty if there is none.
    std::string take_error();

  private:
    std::mutex mutex_;
    std::vector<std::pair<RtInt, std::string>> texts_;
    std::map<std::thread::id, std::string> errors_;  ///< by calling thread
};

/// The context of all open grooms with the same number of threads.
struct Context {
    Messages messages;
    lancret_context* handle = nullptr;

    explicit Context(int threads);
    ~Context() { lancret_context_destroy(handle); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

/// An open groom, owned by its root procedural and those of its chunks.
struct SharedGroom {
    RendermanParameters parameters;
    std::shared_ptr<Context> context;
    std::unique_ptr<lancret_groom, decltype(&lancret_groom_close)> handle;
    lancret_groom_info info{};

    /// Throws std::runtime_error with file and line.
    explicit SharedGroom(RendermanParameters parameters);
};

/// Options for a chunk whose bound covers `detail` pixels.
lancret_options chunk_options(const RendermanParameters& parameters, RtFloat detail);

/// The bound of a chunk at any detail: level of detail makes strands wider. Throws
/// std::runtime_error.
void chunk_bound(const SharedGroom& groom, lancret_u32 chunk, RtBound bound);

/// Throws std::runtime_error with `what` and the error of this thread's last call if
/// `status` is not LANCRET_OK.
void expect_ok(lancret_status status, const std::string& what, Messages& messages);

}  // namespace lancret
