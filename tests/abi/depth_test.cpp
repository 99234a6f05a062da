// Names and values that go so deep that what reads them would run out of stack.

#include <gtest/gtest.h>
#include <pthread.h>

#include "tests/abi/plugin.h"

namespace lancret {
namespace {

/// The error of a source on a thread of a small stack, as hosts have them.
std::string error_of(const lancret_source& source) {
    struct Call {
        const lancret_source* source;
        std::string error;
    } call{&source, {}};
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, 512 << 10);
    pthread_t thread;
    const auto work = [](void* user) -> void* {
        Call& own = *static_cast<Call*>(user);
        const lancret_host host = a_host(1);
        const auto context = a_context(&host);
        own.error = open(context.get(), *own.source).error;
        return nullptr;
    };
    EXPECT_EQ(pthread_create(&thread, &attributes, work, &call), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return call.error;
}

std::string error_of(const std::string& text) { return error_of(text_source(text)); }

std::string repeated(const std::string& text, int times) {
    std::string out;
    for (int i = 0; i < times; ++i) out += text;
    return out;
}

constexpr int kDeep = 200'000;

TEST(PluginDepth, NamesAreRefusedBeforeTheyAreRead) {
    const std::string name = repeated("a.", kDeep) + "b";
    const std::string dots = "groom:3: a name has too many dots, expected at most 16";
    EXPECT_EQ(error_of("\n\n" + name + " = 1\n"), dots);
    EXPECT_EQ(error_of("\n\n[camera." + name + "]\n"), dots);
    EXPECT_EQ(error_of("\n\n[[camera." + name + "]]\n"), dots);
    EXPECT_EQ(error_of("\n\nx = { " + repeated("\"a\" . ", kDeep) + "b = 1 }\n"), dots);
    // Behind strings that end in quotation marks of their own.
    EXPECT_EQ(error_of("x = \"\"\"\"a\"\"\"\"\"\ny = ''''''''\n" + name + " = 1"), dots);
}

TEST(PluginDepth, ValuesAreRefusedBeforeTheyAreRead) {
    const std::string nested =
        "groom:1: values are nested too deeply, expected at most 16";
    EXPECT_EQ(error_of("x = " + repeated("[", kDeep)), nested);
    EXPECT_EQ(error_of("x = " + repeated("{a.a.a.a.a = ", kDeep)), nested);
}

TEST(PluginDepth, NamesOfParametersAreRefused) {
    const std::string name = repeated("a.", kDeep) + "b";
    const lancret_parameter parameter{name.c_str(), nullptr, 1};
    lancret_source source = text_source(kSmallGroom);
    source.parameters = &parameter;
    source.parameter_count = 1;
    EXPECT_EQ(error_of(source), "groom: parameter '" + name.substr(0, 40) +
                                    "': goes on with too many dots, expected at most 16");
}

TEST(PluginDepth, TheDeepestThatIsReadDoesNoHarm) {
    const std::string name = repeated("a.", 15) + "a";
    EXPECT_EQ(error_of("[camera." + name + "]\n" + name + " = " +
                       repeated("{" + name + " = ", 16) + "1" + repeated("}", 16) + "\n" +
                       kSmallGroom),
              "");
}

TEST(PluginDepth, DotsThatNameNothingAreLetBe) {
    const std::string dots = repeated(".", 1000);
    EXPECT_EQ(error_of("# " + dots + "\n[camera] # \"" + dots + "\nx = '" + dots +
                       "'\ny = \"\\\"" + dots + "\"\nz = \"\"\"\n\\\"\"\"" + dots +
                       "\n\"\"\"\"\nw = [" + repeated("[0.5, 1.5], ", 100) + "]\n" +
                       kSmallGroom),
              "");
}

}  // namespace
}  // namespace lancret
