#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace lancret {

/// A file or an option that cannot be used. The message is one line with the file and the
/// place in it: "groom.toml:12: unknown key 'widht', did you mean 'width'?".
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws std::invalid_argument(what) if `holds` is false.
inline void require(bool holds, std::string_view what) {
    if (!holds) throw std::invalid_argument(std::string(what));
}

}  // namespace lancret
