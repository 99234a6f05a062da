#include "guides/toml/table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "guides/base/errors.h"
#include "guides/toml/overrides.h"
#include "guides/toml/table_node.h"
#include "guides/toml/text.h"

namespace lancret {

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::optional<std::string_view> nearest_name(std::string_view word,
                                             std::span<const std::string_view> names) {
    std::optional<std::string_view> best;
    std::size_t distance = 1 + word.size() / 2;
    for (const std::string_view name : names) {
        const std::size_t d = edit_distance(word, name);
        if (d < distance) {
            distance = d;
            best = name;
        }
    }
    return best;
}

TomlTable TomlTable::from_text(std::string_view text, std::string name,
                               const std::filesystem::path& folder) {
    check_toml_depth(text, name);
    auto document = std::make_shared<TomlDocument>();
    document->name = std::move(name);
    document->folder = folder;
    try {
        document->root = toml::parse(text, document->name);
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}:{}: {}", document->name,
                                     error.source().begin.line, error.description()));
    }
    TomlTable out;
    out.node_ = std::make_shared<Node>();
    out.node_->table = &document->root;
    out.node_->document = std::move(document);
    return out;
}

TomlTable TomlTable::from_file(const std::filesystem::path& path) {
    return from_text(toml_file_text(path), path.string(), path.parent_path());
}

TomlTable TomlTable::table(std::string_view key) const {
    if (const auto known = node_->children.find(key); known != node_->children.end()) {
        return known->second;
    }
    const toml::node* value = node_->read(key);
    if (value && !value->is_table()) fail(key, fmt::format("'{}' must be a table", key));
    TomlTable out;
    out.node_ = std::make_shared<Node>();
    out.node_->document = node_->document;
    out.node_->table = value ? value->as_table() : nullptr;
    out.node_->title = fmt::format("[{}]", key);
    node_->children.emplace(key, out);
    return out;
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
    if (const auto known = node_->lists.find(key); known != node_->lists.end()) {
        return known->second;
    }
    std::vector<TomlTable> out;
    const toml::node* value = node_->read(key);
    if (!value) return out;
    const toml::array* list = value->as_array();
    if (!list) {
        fail(key, fmt::format("'{0}' must be a list of tables, [[{0}]]", key));
    }
    for (const toml::node& item : *list) {
        if (!item.is_table()) {
            fail(key, fmt::format("'{}' must contain only tables, but item {} is none",
                                  key, out.size() + 1));
        }
        TomlTable table;
        table.node_ = std::make_shared<Node>();
        table.node_->document = node_->document;
        table.node_->table = item.as_table();
        table.node_->title = fmt::format("[[{}]]", key);
        table.node_->line = item.source().begin.line;
        out.push_back(std::move(table));
    }
    node_->lists.emplace(key, out);
    return out;
}

bool TomlTable::has(std::string_view key) const {
    return node_->table && node_->table->contains(key);
}

std::optional<double> TomlTable::number(std::string_view key, double low,
                                        double high) const {
    const toml::node* value = node_->read(key);
    if (!value) return std::nullopt;
    const auto number = value->value<double>();
    if (!value->is_number() || !number || !std::isfinite(*number)) {
        fail(key, fmt::format("'{}' must be a number", key));
    }
    if (*number < low || *number > high) {
        fail(key, fmt::format("'{}' is {}, but must be between {} and {}", key, *number,
                              low, high));
    }
    return number;
}

std::optional<std::int64_t> TomlTable::integer(std::string_view key, std::int64_t low,
                                               std::int64_t high) const {
    const toml::node* value = node_->read(key);
    if (!value) return std::nullopt;
    if (!value->is_integer()) fail(key, fmt::format("'{}' must be a whole number", key));
    const std::int64_t number = value->as_integer()->get();
    if (number < low || number > high) {
        fail(key, fmt::format("'{}' is {}, but must be between {} and {}", key, number,
                              low, high));
    }
    return number;
}

std::optional<std::uint64_t> TomlTable::seed(std::string_view key) const {
    const toml::node* value = node_->read(key);
    if (value && override_seed(*value)) return override_seed(*value);
    return integer(key, 0, std::numeric_limits<std::int64_t>::max());
}

std::optional<bool> TomlTable::boolean(std::string_view key) const {
    const toml::node* value = node_->read(key);
    if (!value) return std::nullopt;
    if (const auto bit = override_bit(*value)) return bit;
    if (!value->is_boolean()) fail(key, fmt::format("'{}' must be true or false", key));
    return value->as_boolean()->get();
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
    const toml::node* value = node_->read(key);
    if (!value) return std::nullopt;
    if (!value->is_string()) {
        fail(key, fmt::format("'{}' must be a string in quotes", key));
    }
    return value->as_string()->get();
}

std::optional<std::filesystem::path> TomlTable::path(std::string_view key) const {
    const auto value = text(key);
    if (!value) return std::nullopt;
    return node_->document->folder / *value;
}

namespace {

/// The numbers of an array; nullopt unless `value` is an array of `size` <= 4 finite
/// numbers.
std::optional<std::array<double, 4>> numbers_of(const toml::node& value,
                                                std::size_t size) {
    const toml::array* array = value.as_array();
    if (!array || array->size() != size) return std::nullopt;
    std::array<double, 4> out{};
    for (std::size_t i = 0; i < size; ++i) {
        const auto number = (*array)[i].value<double>();
        if (!(*array)[i].is_number() || !number || !std::isfinite(*number)) {
            return std::nullopt;
        }
        out[i] = *number;
    }
    return out;
}

}  // namespace

std::optional<Vec3> TomlTable::vector(std::string_view key) const {
    const toml::node* value = node_->read(key);
    if (!value) return std::nullopt;
    const toml::array* array = value->as_array();
    if (!array || array->size() != 3) {
        fail(key, fmt::format("'{}' must be [x, y, z]", key));
    }
    const auto numbers = numbers_of(*value, 3);
    if (!numbers) fail(key, fmt::format("'{}' must be three numbers", key));
    return Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

std::optional<Vec2> TomlTable::pair(std::string_view key) const {
    const toml::node* value = node_->read(key);
    if (!value) return std::nullopt;
    const auto numbers = numbers_of(*value, 2);
    if (!numbers) fail(key, fmt::format("'{}' must be [a, b], two numbers", key));
    return Vec2((*numbers)[0], (*numbers)[1]);
}

std::optional<Eigen::Matrix4d> TomlTable::matrix(std::string_view key) const {
    const toml::node* value = node_->read(key);
    if (!value) return std::nullopt;
    const toml::array* rows = value->as_array();
    Eigen::Matrix4d out;
    for (int r = 0; r < 4; ++r) {
        const auto row =
            rows && rows->size() == 4 ? numbers_of((*rows)[r], 4) : std::nullopt;
        if (!row) fail(key, fmt::format("'{}' must be four rows of four numbers", key));
        for (int c = 0; c < 4; ++c) out(r, c) = (*row)[c];
    }
    return out;
}

std::optional<std::vector<Vec3>> TomlTable::vectors(std::string_view key,
                                                    std::size_t min_size) const {
    const toml::node* value = node_->read(key);
    if (!value) return std::nullopt;
    const toml::array* list = value->as_array();
    if (!list || list->size() < min_size) {
        fail(key,
             fmt::format("'{}' must be a list of {} or more [x, y, z]", key, min_size));
    }
    std::vector<Vec3> out;
    for (const toml::node& item : *list) {
        const auto v = numbers_of(item, 3);
        if (!v) {
            fail(key, fmt::format("item {} of '{}' must be [x, y, z], three numbers",
                                  out.size() + 1, key));
        }
        out.emplace_back((*v)[0], (*v)[1], (*v)[2]);
    }
    return out;
}

std::optional<std::size_t> TomlTable::choice(
    std::string_view key, std::span<const std::string_view> names) const {
    const auto word = text(key);
    if (!word) return std::nullopt;
    const auto found = std::ranges::find(names, *word);
    if (found != names.end()) return std::size_t(found - names.begin());
    const auto meant = nearest_name(*word, names);
    fail(key, fmt::format("unknown {} '{}'{}; one of: {}", key, *word,
                          meant ? fmt::format(", did you mean '{}'?", *meant) : "",
                          fmt::join(names, ", ")));
}

void TomlTable::finish() const {
    if (!node_->table) return;
    for (const auto& [key, value] : *node_->table) {
        const std::string_view name = key.str();
        if (std::ranges::find(node_->known, name) != node_->known.end()) continue;
        const std::vector<std::string_view> names(node_->known.begin(),
                                                  node_->known.end());
        const auto meant = nearest_name(name, names);
        fail(name,
             fmt::format("unknown key '{}'{}{}{}", name,
                         node_->title.empty() ? "" : " in ", node_->title,
                         meant ? fmt::format(", did you mean '{}'?", *meant)
                               : fmt::format("; known: {}", fmt::join(names, ", "))));
    }
    for (const auto& [key, child] : node_->children) child.finish();
    for (const auto& [key, list] : node_->lists) {
        for (const TomlTable& item : list) item.finish();
    }
}

void TomlTable::fail(std::string_view key, std::string_view message) const {
    std::size_t line = node_->line;
    if (node_->table) {
        for (const auto& [name, value] : *node_->table) {
            if (name.str() != key) continue;
            line = name.source().begin.line;
            if (line == 0) {
                throw InputError(fmt::format("{}: parameter {}: {}",
                                             node_->document->name, key, message));
            }
        }
    }
    throw InputError(line > 0
                         ? fmt::format("{}:{}: {}", node_->document->name, line, message)
                         : fmt::format("{}: {}", node_->document->name, message));
}

}  // namespace lancret
