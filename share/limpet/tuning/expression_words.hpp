// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace limpet {

/// Reads an expression word by word, from left to right; blanks between words do not count.
class ExpressionWords {
 public:
  explicit ExpressionWords(std::string_view text) : text_(text) { SkipBlanks(); }

  [[nodiscard]] bool IsAtEnd() const { return at_ == text_.size(); }
  /// Where the next word begins, from 0.
  [[nodiscard]] std::size_t position() const { return at_; }
  /// Takes the next word if it is `word`; letters must end where it ends.
  [[nodiscard]] bool Take(std::string_view word);
  /// An unsigned decimal number, `2`, `.5`, `1e-3`.
  [[nodiscard]] std::optional<double> TakeNumber();
  /// Letters, digits, `_`, and dots between them; "" if there is none.
  [[nodiscard]] std::string TakeName();

 private:
  void SkipBlanks();
  void Advance(std::size_t count);

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace limpet
