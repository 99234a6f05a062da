#pragma once
// What is behind a TomlTable: for its own sources alone.

#include <toml++/toml.h>

#include <algorithm>
#include <map>

#include "guides/toml/table.h"

namespace lancret {

/// The document a table belongs to: what keeps the parsed file alive.
struct TomlDocument {
    toml::table root;
    std::string name;
    std::filesystem::path folder;
};

/// The truth value of 0 or 1 that a caller laid over the file, who has no booleans.
std::optional<bool> parameter_bit(const toml::node& value);
/// The number of a text that a caller laid over the file: doubles do not hold all seeds.
std::optional<std::uint64_t> parameter_seed(const toml::node& value);

struct TomlTable::Node {
    std::shared_ptr<TomlDocument> document;
    const toml::table* table = nullptr;  // null: an absent table
    std::string title;                   // "[guides]", or empty for the root
    std::size_t line = 0;                // of a table in a list; else 0
    std::vector<std::string> asked;
    std::map<std::string, TomlTable, std::less<>> children;
    std::map<std::string, std::vector<TomlTable>, std::less<>> lists;

    /// The value under `key`, which is from now on asked for.
    const toml::node* ask(std::string_view key) {
        if (std::ranges::find(asked, key) == asked.end()) asked.emplace_back(key);
        return table ? table->get(key) : nullptr;
    }
};

}  // namespace lancret
