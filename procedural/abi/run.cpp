#include "procedural/abi/run.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cfenv>
#include <cstring>
#include <exception>
#include <new>

#include "guides/base/cancel.h"
#include "guides/base/errors.h"
#include "procedural/abi/handles.h"

namespace lancret::abi {

namespace {

/// Default rounding, traps and handling of denormals for the lifetime of this object,
/// whatever the host has set.
class PlainArithmetic {
  public:
    PlainArithmetic() {
        std::fegetenv(&before_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~PlainArithmetic() { std::fesetenv(&before_); }
    PlainArithmetic(const PlainArithmetic&) = delete;
    PlainArithmetic& operator=(const PlainArithmetic&) = delete;

  private:
    std::fenv_t before_;
};

/// One call, which the host may cancel.
class Call {
  public:
    explicit Call(CancelWatch& watch) : watch_(watch) {
        if (watch_.cancelled()) throw Cancelled();
        watch_.add(group_);
    }
    ~Call() { watch_.remove(group_); }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    void run(WorkRef work, int threads) {
        // TBB prints a warning if an arena has more threads than the machine.
        tbb::task_arena arena(threads > 0
                                  ? std::min(threads, tbb::info::default_concurrency())
                                  : tbb::task_arena::automatic);
        std::exception_ptr thrown;
        bool done = false;
        arena.execute([&] {
            // A loop of one iteration, on this thread. A task group would reset its
            // cancelled state when it ends.
            tbb::parallel_for(
                tbb::blocked_range<int>(0, 1),
                [&](const tbb::blocked_range<int>&) {
                    // TBB drops an exception of a loop that was cancelled before.
                    try {
                        work();
                        done = true;
                    } catch (const SinkEnded&) {  // the host's status, kept as it is
                        thrown = std::current_exception();
                        done = true;
                    } catch (...) {
                        thrown = std::current_exception();
                    }
                },
                tbb::simple_partitioner(), group_);
        });
        // The result of cancelled work is meaningless, and so is its exception. Work that
        // never began was cancelled.
        if (!done && (!thrown || group_.is_group_execution_cancelled())) {
            throw Cancelled();
        }
        if (thrown) std::rethrow_exception(thrown);
    }

  private:
    CancelWatch& watch_;
    tbb::task_group_context group_{tbb::task_group_context::isolated,
                                   tbb::task_group_context::fp_settings};
};

}  // namespace

void copy_text(const std::string& text, char* to, std::size_t size) {
    if (!to || size == 0) return;
    std::size_t length = std::min(text.size(), size - 1);
    while (length > 0 && length < text.size() && (text[length] & 0xc0) == 0x80) --length;
    std::memcpy(to, text.data(), length);
    to[length] = 0;
}

void log(const lancret_context& context, int level, const std::string& text) {
    if (!context.host.log) return;
    call_host([&] { context.host.log(context.host.user, level, text.c_str()); });
}

lancret_status run(lancret_context& context, WorkRef work, std::string* error) noexcept {
    const auto report = [&](lancret_status status, const char* what) noexcept {
        try {
            std::string text = what;
            // One line, even if it quotes names with control characters.
            std::ranges::replace_if(
                text, [](unsigned char c) { return c < ' ' || c == 127; }, ' ');
            if (error) *error = text;
            if (status != LANCRET_CANCELLED) log(context, LANCRET_LOG_ERROR, text);
        } catch (...) {  // out of memory for the text: the status has to do
        }
        return status;
    };
    try {
        const PlainArithmetic plain;
        Call(context.cancel).run(work, context.host.threads);
        return LANCRET_OK;
    } catch (const SinkEnded& ended) {
        return ended.status;
    } catch (const InputError& fault) {
        return report(LANCRET_BAD_INPUT, fault.what());
    } catch (const BadCall& fault) {
        return report(LANCRET_BAD_CALL, fault.what);
    } catch (const Cancelled& cancelled) {
        return report(LANCRET_CANCELLED, cancelled.what());
    } catch (const std::bad_alloc&) {
        return report(LANCRET_OUT_OF_MEMORY, "out of memory");
    } catch (const std::exception& fault) {
        return report(LANCRET_FAILED, fault.what());
    } catch (...) {
        return report(LANCRET_FAILED, "unknown exception");
    }
}

}  // namespace lancret::abi
