#include "guides/toml/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "guides/base/errors.h"
#include "guides/toml/table_node.h"
#include "guides/toml/text.h"

namespace lancret {

bool is_override(const toml::node& value) { return value.source().begin.line == 0; }

bool TomlTable::is_overridden(std::string_view key) const {
    return has(key) && is_override(*node_->table->get(key));
}

std::optional<bool> override_bit(const toml::node& value) {
    if (!is_override(value) || !value.is_integer()) return std::nullopt;
    const std::int64_t number = value.as_integer()->get();
    if (number != 0 && number != 1) return std::nullopt;
    return number == 1;
}

std::optional<std::uint64_t> override_seed(const toml::node& value) {
    if (!is_override(value) || !value.is_string()) return std::nullopt;
    const std::string& text = value.as_string()->get();
    const char* const end = text.data() + text.size();
    std::uint64_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end) return std::nullopt;
    return number;
}

template <class T>
void TomlTable::override_value(std::string_view name, const T& value) {
    const auto refuse = [&](std::string_view what) {
        throw InputError(
            fmt::format("{}: parameter '{}': {}", node_->document->name, name, what));
    };
    if (std::ranges::count(name, '.') > kMaxTomlDots) {
        name = name.substr(0, 40);
        refuse(fmt::format("has too many dots, expected at most {}", kMaxTomlDots));
    }
    toml::table* table = &node_->document->root;
    std::string_view rest = name;
    for (std::size_t dot; (dot = rest.find('.')) != std::string_view::npos;) {
        const std::string_view key = rest.substr(0, dot);
        if (key.empty()) refuse("is not a dotted key such as 'strands.count'");
        toml::node* inner = table->get(key);
        if (!inner) inner = &table->insert(key, toml::table{}).first->second;
        if (!inner->is_table()) refuse(fmt::format("'{}' is not a table", key));
        table = inner->as_table();
        rest.remove_prefix(dot + 1);
    }
    if (rest.empty()) refuse("is not a dotted key such as 'strands.count'");
    // Erased first, so that the new value does not inherit the old key's line.
    table->erase(rest);
    table->insert(rest, value);
}

void TomlTable::set_override(std::string_view name, std::string_view text) {
    override_value(name, std::string(text));
}

void TomlTable::set_override(std::string_view name, double number) {
    constexpr double kExact = 9007199254740992;  // 2^53
    if (number == std::floor(number) && std::abs(number) <= kExact) {
        override_value(name, std::int64_t(number));
    } else {
        override_value(name, number);
    }
}

void TomlTable::leave(std::string_view key) const { node_->read(key); }

}  // namespace lancret
