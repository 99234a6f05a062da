#pragma once
// A groom held open for the procedurals that stand for its chunks.

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

/// What Lancret says while it works, from any thread: kept until `print`, since Ri is
/// called from the renderer's threads alone.
class Messages {
  public:
    void add(RtInt severity, std::string text);
    /// Hands warnings to the renderer.
    void print();
    /// The last error of a call on this thread, which the caller tells in its own words;
    /// then there is none.
    std::string take_error();

  private:
    std::mutex mutex_;
    std::vector<std::pair<RtInt, std::string>> texts_;
    std::map<std::thread::id, std::string> errors_;  ///< of calls on each thread
};

/// A context that grooms of as many threads share, for as long as one of them is open.
struct Context {
    Messages messages;
    lancret_context* handle = nullptr;

    explicit Context(int threads);
    ~Context() { lancret_context_destroy(handle); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

/// Kept by its root procedural and by those of its chunks, closed with the last.
struct SharedGroom {
    RendermanParameters parameters;
    std::shared_ptr<Context> context;
    std::unique_ptr<lancret_groom, decltype(&lancret_groom_close)> handle;
    lancret_groom_info info{};

    /// Throws std::runtime_error with the file and line at fault.
    explicit SharedGroom(RendermanParameters parameters);
};

/// What a chunk is asked for where it covers `detail` pixels.
lancret_options chunk_options(const RendermanParameters& parameters, RtFloat detail);

/// Holds a chunk at every detail: level of detail makes strands wider.
void chunk_box(const SharedGroom& groom, lancret_u32 chunk, RtBound bound);

/// Throws std::runtime_error that names `what` where `status` is not LANCRET_OK, with
/// what was said.
void expect_ok(lancret_status status, const std::string& what, Messages& messages);

}  // namespace lancret
