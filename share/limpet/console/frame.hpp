// SPDX-License-Identifier: MIT
// A picture of text for a terminal, before any escape code.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace limpet {

/// What a piece of text means; Paint decides how that looks.
enum class Ink { kPlain, kTitle, kHeader, kSource, kFresh, kLate, kFaint, kSelected, kBad, kGood };

struct Span {
  Ink ink = Ink::kPlain;
  std::string text;
};

/// One line. Its texts hold no control characters.
class FrameLine {
 public:
  FrameLine& Add(std::string_view text, Ink ink = Ink::kPlain);
  /// `text` cut or filled with blanks to `width` columns.
  FrameLine& AddCell(std::string_view text, std::size_t width, Ink ink = Ink::kPlain);
  /// `text` at the right end of a cell of `width` columns, cut or after blanks.
  FrameLine& AddNumber(std::string_view text, std::size_t width, Ink ink = Ink::kPlain);
  /// Cuts or fills to `width` columns in all.
  FrameLine& FitTo(std::size_t width);
  /// Writes characters beyond ASCII by their numbers, for a terminal that reads no UTF-8.
  FrameLine& MakeAscii();
  /// The whole line in one ink.
  FrameLine& PaintAll(Ink ink);

  [[nodiscard]] std::size_t columns() const;
  [[nodiscard]] const std::vector<Span>& spans() const { return spans_; }
  /// The line's text without ink and without blanks at its end.
  [[nodiscard]] std::string PlainText() const;

 private:
  std::vector<Span> spans_;
};

using Frame = std::vector<FrameLine>;

/// The lines, each with its end, without ink.
[[nodiscard]] std::string PlainText(const Frame& frame);
/// A line with escape codes for its inks; without colours (NO_COLOR) only weight and reversal.
[[nodiscard]] std::string Painted(const FrameLine& line, bool has_colors);

/// False if the environment has a NO_COLOR that is not empty, or TERM=dumb.
[[nodiscard]] bool ColorsAreWanted();

/// Text in columns as wide as their widest cell, for tables that are printed once; the last column
/// is not filled. `heads` is the first line.
class TextTable {
 public:
  struct Cell {
    std::string text;
    Ink ink = Ink::kPlain;
  };
  explicit TextTable(std::vector<std::string> heads) : heads_(std::move(heads)) {}
  void Add(std::vector<Cell> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] Frame Lines() const;

 private:
  std::vector<std::string> heads_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace limpet
