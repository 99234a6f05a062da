#pragma once
// Runs the built `lancret` like a shell and captures its output.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "tests/guides/base/temporary_folder.h"

extern "C" char** environ;

namespace lancret {

struct CommandRun {
    int exit_code = -1;  ///< negative: the signal that ended it
    std::string out, err;
};

/// Runs the program and arguments in `words`, and kills it after `kill_after` if that is
/// not zero.
inline CommandRun run_words(const std::vector<std::string>& words,
                            std::chrono::microseconds kill_after = {}) {
    const TemporaryFolder captured;
    const std::string out = (captured / "out").string();
    const std::string err = (captured / "err").string();
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), flags, 0600);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err.c_str(), flags, 0600);
    std::vector<char*> arguments;
    for (const std::string& word : words) {
        arguments.push_back(const_cast<char*>(word.c_str()));
    }
    arguments.push_back(nullptr);
    CommandRun run;
    pid_t child = 0;
    const int failed =
        posix_spawnp(&child, arguments[0], &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (failed != 0) return run;
    if (kill_after.count() > 0) {
        std::this_thread::sleep_for(kill_after);
        kill(child, SIGKILL);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    run.out = read_bytes(out);
    run.err = read_bytes(err);
    return run;
}

/// Runs `lancret` with the arguments `words`.
inline CommandRun lancret(std::vector<std::string> words) {
    words.insert(words.begin(), LANCRET_COMMAND);
    return run_words(words);
}

/// Matches a run with exit code 2, an empty stdout and one line on stderr that begins
/// with "lancret: " and matches `message`.
inline testing::Matcher<const CommandRun&> refuses(
    testing::Matcher<const std::string&> message) {
    using testing::AllOf, testing::Field, testing::StartsWith, testing::EndsWith;
    const auto one_line = testing::ResultOf(
        "lines", [](const std::string& s) { return std::ranges::count(s, '\n'); }, 1);
    return AllOf(
        Field("exit code", &CommandRun::exit_code, 2),
        Field("stdout", &CommandRun::out, ""),
        Field("stderr", &CommandRun::err,
              AllOf(StartsWith("lancret: "), EndsWith("\n"), one_line, message)));
}

/// refuses, for a line that contains each of `parts`.
template <class... Parts>
testing::Matcher<const CommandRun&> refuses_with(const Parts&... parts) {
    return refuses(testing::AllOf(testing::HasSubstr(parts)...));
}

inline void PrintTo(const CommandRun& run, std::ostream* stream) {
    *stream << "exit code " << run.exit_code << "\nstdout: " << run.out
            << "\nstderr: " << run.err;
}

}  // namespace lancret
