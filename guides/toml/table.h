#pragma once
// A TOML reader that rejects unknown keys: a key is known once it has been read.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "guides/base/named.h"
#include "guides/base/types.h"

namespace lancret {

/// A table of a TOML file. Every error is an InputError "<file>:<line>: ...". Copies
/// share the record of the keys that were read.
class TomlTable {
  public:
    /// The root table of a file, or of a text. `name` stands for the file in the text's
    /// errors, and its paths are relative to `folder`.
    static TomlTable from_file(const std::filesystem::path& path);
    static TomlTable from_text(std::string_view text, std::string name,
                               const std::filesystem::path& folder = {});

    /// Overrides a value, as if the file contained it. `name` is a dotted key such as
    /// "strands.count". A number 0 or 1 may be read as a boolean, a text as a seed. To be
    /// called on a root table before anything is read. Throws InputError if `name` is not
    /// a dotted key.
    void set_override(std::string_view name, std::string_view text);
    void set_override(std::string_view name, double number);
    /// Marks `key` as known without reading it.
    void leave(std::string_view key) const;

    /// The table under `key`; an empty one if the key is missing.
    TomlTable table(std::string_view key) const;
    /// The tables of the list under `key`, in the file's order: `[[key]]` or
    /// `key = [{...}, ...]`; empty if the key is missing. An error if the value is not a
    /// list, or an item of it is not a table.
    std::vector<TomlTable> tables(std::string_view key) const;
    bool has(std::string_view key) const;
    /// Whether the value under `key` is an override.
    bool is_overridden(std::string_view key) const;

    /// The value under `key`; nullopt if the key is missing. An error if the value has
    /// another type or is outside [low, high].
    std::optional<double> number(std::string_view key, double low = -1e30,
                                 double high = 1e30) const;
    std::optional<std::int64_t> integer(std::string_view key, std::int64_t low,
                                        std::int64_t high) const;
    /// A whole number from 0 to 2^63 - 1; to 2^64 - 1 in an override given as a text.
    std::optional<std::uint64_t> seed(std::string_view key) const;
    std::optional<bool> boolean(std::string_view key) const;
    std::optional<std::string> text(std::string_view key) const;
    /// A path, relative to the file's folder.
    std::optional<std::filesystem::path> path(std::string_view key) const;
    std::optional<Vec3> vector(std::string_view key) const;
    /// Two numbers.
    std::optional<Vec2> pair(std::string_view key) const;
    /// Four rows of four numbers.
    std::optional<Eigen::Matrix4d> matrix(std::string_view key) const;
    /// The list of [x, y, z] under `key`, of at least `min_size` items.
    std::optional<std::vector<Vec3>> vectors(std::string_view key,
                                             std::size_t min_size) const;
    /// The index in `names` of the text under `key`.
    std::optional<std::size_t> choice(std::string_view key,
                                      std::span<const std::string_view> names) const;
    /// The value in the row of `table` whose name is the text under `key`.
    template <class T, std::size_t n>
    std::optional<T> choice(std::string_view key, const Named<T> (&table)[n]) const {
        const auto index = choice(key, names_of(table));
        if (!index) return std::nullopt;
        return table[*index].value;
    }

    /// Throws for the first key that has not been read, in this table and the tables in
    /// it, and suggests the nearest key that has.
    void finish() const;

    /// Throws InputError "<file>:<line of key>: message", for readers that find a value
    /// invalid. If the key is missing in a table of a list, the line is the table's.
    [[noreturn]] void fail(std::string_view key, std::string_view message) const;

  private:
    struct Node;
    template <class T>
    void override_value(std::string_view name, const T& value);

    std::shared_ptr<Node> node_;
};

/// Assigns `value` if it is set.
template <class T, class U>
void assign_if(T& to, const std::optional<U>& value) {
    if (value) to = T(*value);
}

/// The one of `names` that `word` most likely stands for; nullopt if none is similar.
std::optional<std::string_view> nearest_name(std::string_view word,
                                             std::span<const std::string_view> names);

}  // namespace lancret
