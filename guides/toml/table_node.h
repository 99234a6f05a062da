#pragma once
// The data of a TomlTable. Only its own sources include this.

#include <toml++/toml.h>

#include <algorithm>
#include <map>

#include "guides/toml/table.h"

namespace lancret {

/// The parsed file, shared by all of its tables.
struct TomlDocument {
    toml::table root;
    std::string name;
    std::filesystem::path folder;
};

struct TomlTable::Node {
    std::shared_ptr<TomlDocument> document;
    const toml::table* table = nullptr;  ///< null: the file lacks this table
    std::string title;                   ///< "[guides]"; empty for the root
    std::size_t line = 0;                ///< of a table in a list; otherwise 0
    std::vector<std::string> known;      ///< the keys that were read
    std::map<std::string, TomlTable, std::less<>> children;
    std::map<std::string, std::vector<TomlTable>, std::less<>> lists;

    /// The value under `key`, which is known from now on; null if it is missing.
    const toml::node* read(std::string_view key) {
        if (std::ranges::find(known, key) == known.end()) known.emplace_back(key);
        return table ? table->get(key) : nullptr;
    }
};

}  // namespace lancret
