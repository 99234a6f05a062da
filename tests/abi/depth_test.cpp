// Names and values nested so deeply that a recursive parser would exhaust the stack.

#include <gtest/gtest.h>
#include <pthread.h>

#include "tests/abi/plugin.h"

namespace lancret {
namespace {

/// The error of opening `source` on a thread with a small stack, as hosts may have.
std::string error_of(const lancret_source& source) {
    struct Call {
        const lancret_source* source;
        std::string error;
    } job{&source, {}};
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, 512 << 10);
    pthread_t thread;
    const auto work = [](void* user) -> void* {
        Call& opening = *static_cast<Call*>(user);
        const lancret_host host = make_host(1);
        const auto context = make_context(&host);
        opening.error = open(context.get(), *opening.source).error;
        return nullptr;
    };
    EXPECT_EQ(pthread_create(&thread, &attributes, work, &job), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return job.error;
}

std::string error_of(const std::string& text) { return error_of(text_source(text)); }

std::string repeated(const std::string& text, int times) {
    std::string out;
    for (int i = 0; i < times; ++i) out += text;
    return out;
}

constexpr int kDeep = 200'000;

TEST(PluginDepth, NamesAreRefusedBeforeParsing) {
    const std::string name = repeated("a.", kDeep) + "b";
    const std::string dots = "groom:3: a key has too many dots, expected at most 16";
    EXPECT_EQ(error_of("\n\n" + name + " = 1\n"), dots);
    EXPECT_EQ(error_of("\n\n[camera." + name + "]\n"), dots);
    EXPECT_EQ(error_of("\n\n[[camera." + name + "]]\n"), dots);
    EXPECT_EQ(error_of("\n\nx = { " + repeated("\"a\" . ", kDeep) + "b = 1 }\n"), dots);
    // After strings that contain quotation marks at their end.
    EXPECT_EQ(error_of("x = \"\"\"\"a\"\"\"\"\"\ny = ''''''''\n" + name + " = 1"), dots);
}

TEST(PluginDepth, ValuesAreRefusedBeforeParsing) {
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
                                    "': has too many dots, expected at most 16");
}

TEST(PluginDepth, TheDeepestAllowedNamesAreRead) {
    const std::string name = repeated("a.", 15) + "a";
    EXPECT_EQ(error_of("[camera." + name + "]\n" + name + " = " +
                       repeated("{" + name + " = ", 16) + "1" + repeated("}", 16) + "\n" +
                       kSmallGroom),
              "");
}

TEST(PluginDepth, DotsOutsideOfNamesAreAllowed) {
    const std::string dots = repeated(".", 1000);
    EXPECT_EQ(error_of("# " + dots + "\n[camera] # \"" + dots + "\nx = '" + dots +
                       "'\ny = \"\\\"" + dots + "\"\nz = \"\"\"\n\\\"\"\"" + dots +
                       "\n\"\"\"\"\nw = [" + repeated("[0.5, 1.5], ", 100) + "]\n" +
                       kSmallGroom),
              "");
}

}  // namespace
}  // namespace lancret
