#pragma once
// What is behind the handles of the interface.

#include <string>

#include "procedural/abi/cancel_watch.h"
#include "procedural/abi/open_groom.h"
#include "procedural/abi/sized.h"
#include "procedural/abi/workspace.h"

struct lancret_context {
    explicit lancret_context(const lancret_host& given) : host(given) {}

    const lancret_host host;
    lancret::abi::Workspaces workspaces{host};
    lancret::abi::SharedByKey<std::string, lancret::abi::OpenGroom> grooms{0};
    lancret::abi::CancelWatch cancel{host};
};

struct lancret_groom {
    lancret_context& context;
    std::shared_ptr<const lancret::abi::OpenGroom> own;
};

namespace lancret::abi {

/// Calls back into the host: loops of its own in TBB are not cut short where the call
/// that they run in is cancelled. On this thread, before it returns.
template <class Callback>
void call_host(const Callback& callback) {
    tbb::task_group_context own(tbb::task_group_context::isolated);
    tbb::task_group(own).run_and_wait(callback);
}

void log(const lancret_context& context, int level, const std::string& text);

/// Copies `text`, cut to `size` bytes with its end, and not inside a letter of UTF-8.
void copy_text(const std::string& text, char* to, std::size_t size);

/// The work of one call, which outlives it. Unlike std::function it asks for no memory,
/// which there may be none of.
class WorkRef {
  public:
    template <class Work>
    WorkRef(const Work& work)
        : work_(&work), do_([](const void* w) { (*static_cast<const Work*>(w))(); }) {}
    void operator()() const { do_(work_); }

  private:
    const void* work_;
    void (*do_)(const void*);
};

/// Does the work of one call: in its own TBB arena of as many threads as the host gives,
/// so that none of the host's own tasks is taken up meanwhile, with the processor's
/// rounding as Lancret is used to, and until the host cancels. What is thrown becomes a
/// status and, where there is room for it, a line of text; nothing leaves.
lancret_status run(lancret_context& context, WorkRef work,
                   std::string* error = nullptr) noexcept;

/// Another status than LANCRET_OK that a host's sink returned.
struct SinkEnded {
    lancret_status status;
};

}  // namespace lancret::abi
