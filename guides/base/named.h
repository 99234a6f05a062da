#pragma once
// Tables of values and their names, as files and the command line spell them.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace lancret {

/// A row of such a table.
template <class T>
struct Named {
    T value;
    std::string_view name;
};

template <class T, std::size_t n>
constexpr std::array<std::string_view, n> names_of(const Named<T> (&table)[n]) {
    std::array<std::string_view, n> names;
    for (std::size_t i = 0; i < n; ++i) names[i] = table[i].name;
    return names;
}

/// nullopt if no row has this name.
template <class T, std::size_t n>
constexpr std::optional<T> value_named(const Named<T> (&table)[n],
                                       std::string_view name) {
    for (const Named<T>& row : table) {
        if (row.name == name) return row.value;
    }
    return std::nullopt;
}

}  // namespace lancret
