// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/report/run_statistics.hpp"

namespace limpet {

/// A table of text with a header row; the first column is set left, the others right.
struct PaperTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::string note;  ///< below the table
};

/// The paper's Tables 2 to 5 (7 and 8 for the mission `basin`) beside the runs', then how often
/// runs went well.
[[nodiscard]] std::vector<PaperTable> PaperTables(const RunStatistics& runs);

/// The tables for a terminal and as Markdown.
[[nodiscard]] std::string PlainText(const std::vector<PaperTable>& tables);
[[nodiscard]] std::string Markdown(const std::vector<PaperTable>& tables);

/// tables.json: every statistic with mean, sd, count and how often it was asked for; every rate.
[[nodiscard]] std::string TablesJson(const RunStatistics& runs, const std::string& options);

}  // namespace limpet
