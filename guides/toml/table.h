#pragma once
// Reading TOML so that nothing in it goes unread: every key is asked for by name and
// type, and one that nobody asked for is an error.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "guides/base/types.h"

namespace lancret {

/// A table of a TOML file. Every error is an InputError "<file>:<line>: ...". A copy
/// shares what has been asked for.
class TomlTable {
  public:
    /// The whole of a file, or of a text that calls itself `name` in errors and whose
    /// paths start from `folder`.
    static TomlTable from_file(const std::filesystem::path& path);
    static TomlTable from_text(std::string_view text, std::string name,
                               const std::filesystem::path& folder = {});

    /// Lays a value over what the file says, as if it stood there: `name` is
    /// "strands.count", of this table. Numbers also serve as booleans, 0 and 1, texts as
    /// seeds. To be done before anything is read. Throws InputError where the name is
    /// none.
    void set_override(std::string_view name, std::string_view text);
    void set_override(std::string_view name, double number);
    /// Leaves the table or list under `key` to somebody else.
    void leave(std::string_view key) const;

    /// The table under `key`; an empty one where there is none.
    TomlTable table(std::string_view key) const;
    /// The tables of the list under `key`, in the file's order: `[[key]]` or
    /// `key = [{...}, ...]`; none where there is none. An error where it is something
    /// else, or where not all that it holds are tables.
    std::vector<TomlTable> tables(std::string_view key) const;
    bool has(std::string_view key) const;
    /// Whether the value under `key` was laid over what the file says.
    bool is_overridden(std::string_view key) const;

    /// The value under `key`, nothing where there is none. An error where it is of
    /// another type or outside [low, high].
    std::optional<double> number(std::string_view key, double low = -1e30,
                                 double high = 1e30) const;
    std::optional<std::int64_t> integer(std::string_view key, std::int64_t low,
                                        std::int64_t high) const;
    /// A whole number from 0 to 2^63 - 1; laid over as a text, to 2^64 - 1.
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
    /// The list of [x, y, z] under `key`, of `fewest` or more.
    std::optional<std::vector<Vec3>> vectors(std::string_view key,
                                             std::size_t fewest) const;
    /// The index in `names` of the text under `key`.
    std::optional<std::size_t> choice(std::string_view key,
                                      std::span<const std::string_view> names) const;

    /// Throws for the first key, in this table and those under it, that nobody asked for,
    /// with the nearest key that somebody did ask for.
    void finish() const;

    /// "<file>:<line of key>: message", to be thrown by who finds a value wrong. Where
    /// the key is missing in a table of a list, the line is that of the table.
    [[noreturn]] void fail(std::string_view key, std::string_view message) const;

  private:
    struct Node;
    template <class T>
    void lay_value_over(std::string_view name, const T& value);

    std::shared_ptr<Node> node_;
};

/// Assigns the value, if there is one.
template <class T, class U>
void assign_if(T& to, const std::optional<U>& value) {
    if (value) to = T(*value);
}

/// The one of `names` that `word` was most likely meant to be; nothing where none is
/// near.
std::optional<std::string_view> nearest_name(std::string_view word,
                                             std::span<const std::string_view> names);

}  // namespace lancret
