// SPDX-License-Identifier: MIT
#include "limpet/describe/markdown_cell.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "limpet/core/config.hpp"
#include "limpet/core/random.hpp"
#include "tests/unit/describe/markdown_rows.hpp"

namespace limpet {
namespace {

TEST(MarkdownCell, StaysOneCellWhateverItHolds) {
  Random random(1, "cells");
  for (int run = 0; run < 500; ++run) {
    std::string text;
    for (std::uint64_t i = random.Index(20); i > 0; --i)
      text += "ab|\n "[random.Index(5)];
    const std::string row = "| " + MarkdownCell(text) + " | end |";
    EXPECT_EQ(row.find('\n'), std::string::npos);
    const auto cells = MarkdownCells(row);
    ASSERT_EQ(cells.size(), 2U) << text;
    std::ranges::replace(text, '\n', ' ');
    EXPECT_EQ(cells[0], Trim(text));
  }
}

}  // namespace
}  // namespace limpet
