#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tests/abi/plugin.h"

namespace lancret {
namespace {

std::string output_of(const std::string& command) {
    std::string out;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return out;
    char buffer[4096];
    while (std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) {
        out.append(buffer, n);
    }
    pclose(pipe);
    return out;
}

std::set<std::string> names_in(const std::string& text, const std::regex& pattern) {
    std::set<std::string> out;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end;
         ++match) {
        out.insert((*match)[1]);
    }
    return out;
}

TEST(PluginLibrary, ExportsItsHeaderAndNothingElse) {
    std::ifstream file(LANCRET_SOURCE_DIR "/procedural/lancret_procedural.h");
    std::stringstream header;
    header << file.rdbuf();
    const auto declared = names_in(
        header.str(), std::regex(R"(LANCRET_API [a-z_ \*]*?[ \*](lancret_\w+)\()"));
    const auto exported = names_in(output_of("nm -D --defined-only " LANCRET_PLUGIN),
                                   std::regex(R"( \w (\S+))"));
    EXPECT_EQ(declared.size(), 21u);
    EXPECT_EQ(exported, declared);
}

bool is_mapped(const std::string& name) {
    std::ifstream maps("/proc/self/maps");
    std::stringstream text;
    text << maps.rdbuf();
    return text.str().find(name) != std::string::npos;
}

/// Resident memory of this process, KiB.
long resident() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.find("VmRSS:") == 0) return std::stol(line.substr(6));
    }
    return 0;
}

/// A copy of the library with a name that the test program is not linked to.
class LibraryCopy {
  public:
    LibraryCopy() : path_(std::string(LANCRET_PLUGIN) + ".reload_test.so") {
        std::ifstream from(LANCRET_PLUGIN, std::ios::binary);
        std::ofstream to(path_, std::ios::binary);
        to << from.rdbuf();
    }
    ~LibraryCopy() { std::remove(path_.c_str()); }
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

/// Loads the library, opens, expands and closes a groom, and unloads the library.
void use_once(const std::string& path) {
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    ASSERT_TRUE(library) << dlerror();
    const auto get = [&]<class F>(F*, const char* name) {
        return reinterpret_cast<F*>(dlsym(library, name));
    };
    lancret_context* context = nullptr;
    lancret_groom* groom = nullptr;
    const auto source = text_source(kSmallGroom);
    ASSERT_EQ(get(&lancret_context_create, "lancret_context_create")(LANCRET_ABI_VERSION,
                                                                     nullptr, &context),
              LANCRET_OK);
    ASSERT_EQ(get(&lancret_groom_open, "lancret_groom_open")(context, &source, &groom,
                                                             nullptr, 0),
              LANCRET_OK);
    const auto options = make_options(LANCRET_BSPLINE);
    ASSERT_EQ(
        get(&lancret_groom_expand_chunk, "lancret_groom_expand_chunk")(
            groom, 0, &options,
            [](void*, const lancret_curves*) -> lancret_status { return LANCRET_OK; },
            nullptr),
        LANCRET_OK);
    get(&lancret_groom_close, "lancret_groom_close")(groom);
    get(&lancret_context_destroy, "lancret_context_destroy")(context);
    ASSERT_EQ(dlclose(library), 0);
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
// Sanitizers keep freed memory, and register a library's globals for seconds.
constexpr int kFirstUses = 1, kMoreUses = 1;
constexpr bool kFreedMemoryIsReturned = false;
#else
constexpr int kFirstUses = 5, kMoreUses = 15;
constexpr bool kFreedMemoryIsReturned = true;
#endif

TEST(PluginLibrary, UnloadsAndLoadsAgain) {
    const LibraryCopy copy;
    for (int i = 0; i < kFirstUses; ++i) use_once(copy.path());
    EXPECT_FALSE(is_mapped(copy.path()));
    const long before = resident();
    for (int i = 0; i < kMoreUses; ++i) use_once(copy.path());
    EXPECT_FALSE(is_mapped(copy.path()));
    if (kFreedMemoryIsReturned) {
        // A leaked library or groom would add 15 times several MiB.
        EXPECT_LT(resident() - before, kMoreUses * 1024);
    }
}

}  // namespace
}  // namespace lancret
