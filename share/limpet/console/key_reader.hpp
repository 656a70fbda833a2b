// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace limpet {

/// One key press.
struct Key {
  enum class Code {
    kCharacter,
    kUp,
    kDown,
    kPageUp,
    kPageDown,
    kHome,
    kEnd,
    kEnter,
    kEscape,
    kBackspace,
    kOther,
  };
  Code code = Code::kOther;
  char character = '\0';  ///< printable ASCII, if kCharacter
  [[nodiscard]] bool operator==(const Key&) const = default;
};

/// Key presses from the bytes a terminal sends, in whatever pieces they come. An escape byte with
/// nothing behind it in its piece is the Escape key.
class KeyReader {
 public:
  [[nodiscard]] std::vector<Key> Feed(std::string_view bytes);

 private:
  [[nodiscard]] bool TakeSequence(Key& key);

  std::string pending_;
};

}  // namespace limpet
