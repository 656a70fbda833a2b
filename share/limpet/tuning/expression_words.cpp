// SPDX-License-Identifier: MIT
#include "limpet/tuning/expression_words.hpp"

#include <cctype>

#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

bool IsLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsOfName(char c) { return IsLetter(c) || IsDigit(c) || c == '.'; }

}  // namespace

void ExpressionWords::SkipBlanks() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t'))
    ++at_;
}

void ExpressionWords::Advance(std::size_t count) {
  at_ += count;
  SkipBlanks();
}

bool ExpressionWords::Take(std::string_view word) {
  const std::string_view rest = text_.substr(at_);
  if (!rest.starts_with(word)) return false;
  const bool goes_on = rest.size() > word.size() && IsOfName(rest[word.size()]);
  if (IsLetter(word.back()) && goes_on) return false;
  Advance(word.size());
  return true;
}

std::optional<double> ExpressionWords::TakeNumber() {
  const std::string_view rest = text_.substr(at_);
  if (rest.empty() || (!IsDigit(rest[0]) && rest[0] != '.')) return std::nullopt;
  std::size_t length = 0;
  while (length < rest.size() && (IsDigit(rest[length]) || rest[length] == '.'))
    ++length;
  if (length < rest.size() && (rest[length] == 'e' || rest[length] == 'E')) {
    std::size_t digit = length + 1;
    if (digit < rest.size() && (rest[digit] == '+' || rest[digit] == '-')) ++digit;
    const std::size_t first = digit;
    while (digit < rest.size() && IsDigit(rest[digit]))
      ++digit;
    if (digit > first) length = digit;
  }
  const std::optional<double> number = ParseNumber(rest.substr(0, length));
  const bool goes_on = length < rest.size() && IsLetter(rest[length]);
  if (!number || goes_on) return std::nullopt;
  Advance(length);
  return number;
}

std::string ExpressionWords::TakeName() {
  const std::string_view rest = text_.substr(at_);
  if (rest.empty() || !IsLetter(rest[0])) return "";
  std::size_t length = 0;
  while (length < rest.size() && IsOfName(rest[length]))
    ++length;
  std::string name(rest.substr(0, length));
  Advance(length);
  return name;
}

}  // namespace limpet
