#pragma once

#include <string>
#include <string_view>

namespace base {

/// Returns `text` in quotation marks for a message: shortened, and with `?` for what is not printable ASCII,
/// so that no file can put anything else on a page or a terminal.
std::string quoted(std::string_view text);

} // namespace base
