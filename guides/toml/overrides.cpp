#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "guides/base/errors.h"
#include "guides/toml/table_node.h"
#include "guides/toml/text.h"

namespace lancret {

namespace {

bool was_laid_over(const toml::node& value) { return value.source().begin.line == 0; }

}  // namespace

bool TomlTable::is_overridden(std::string_view key) const {
    return has(key) && was_laid_over(*node_->table->get(key));
}

std::optional<bool> parameter_bit(const toml::node& value) {
    if (!was_laid_over(value) || !value.is_integer()) return std::nullopt;
    const std::int64_t number = value.as_integer()->get();
    if (number != 0 && number != 1) return std::nullopt;
    return number == 1;
}

std::optional<std::uint64_t> parameter_seed(const toml::node& value) {
    if (!was_laid_over(value) || !value.is_string()) return std::nullopt;
    const std::string& text = value.as_string()->get();
    const char* const end = text.data() + text.size();
    std::uint64_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end) return std::nullopt;
    return number;
}

template <class T>
void TomlTable::lay_value_over(std::string_view name, const T& value) {
    const auto refuse = [&](std::string_view what) {
        throw InputError(
            fmt::format("{}: parameter '{}': {}", node_->document->name, name, what));
    };
    if (std::ranges::count(name, '.') > kMaxTomlDots) {
        name = name.substr(0, 40);
        refuse(
            fmt::format("goes on with too many dots, expected at most {}", kMaxTomlDots));
    }
    toml::table* table = &node_->document->root;
    std::string_view rest = name;
    for (std::size_t dot; (dot = rest.find('.')) != std::string_view::npos;) {
        const std::string_view key = rest.substr(0, dot);
        if (key.empty()) refuse("is no name; expected one such as 'strands.count'");
        toml::node* inner = table->get(key);
        if (!inner) inner = &table->insert(key, toml::table{}).first->second;
        if (!inner->is_table()) refuse(fmt::format("'{}' is no table", key));
        table = inner->as_table();
        rest.remove_prefix(dot + 1);
    }
    if (rest.empty()) refuse("is no name; expected one such as 'strands.count'");
    // Gone first, so that its line is not taken for that of the value.
    table->erase(rest);
    table->insert(rest, value);
}

void TomlTable::set_override(std::string_view name, std::string_view text) {
    lay_value_over(name, std::string(text));
}

void TomlTable::set_override(std::string_view name, double number) {
    constexpr double kExact = 9007199254740992;  // 2^53
    if (number == std::floor(number) && std::abs(number) <= kExact) {
        lay_value_over(name, std::int64_t(number));
    } else {
        lay_value_over(name, number);
    }
}

void TomlTable::leave(std::string_view key) const { node_->ask(key); }

}  // namespace lancret
