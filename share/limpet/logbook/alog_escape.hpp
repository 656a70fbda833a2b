// SPDX-License-Identifier: MIT
// How strings travel in one line of an .alog file.
#pragma once

#include <string>
#include <string_view>

namespace limpet {

/// The banner line that announces escapes.
inline constexpr std::string_view kAlogEscapeNotice =
    R"(%% STRINGS ESCAPED: line feed \n, carriage return \r, backslash \\, leading blank '\ ')";

/// Appends `text` escaped: a line feed as \n, a carriage return as \r, a NUL as \0, a backslash as
/// \\, and a backslash before a leading blank. So a NUL in a log is always damage.
void AppendEscaped(std::string& out, std::string_view text);

/// The inverse; unknown escapes stay as they are.
void AppendUnescaped(std::string& out, std::string_view text);

}  // namespace limpet
