// SPDX-License-Identifier: MIT
#include "limpet/report/report.hpp"

#include "limpet/figures/figures.hpp"
#include "limpet/report/html_page.hpp"
#include "limpet/report/report_json.hpp"

namespace limpet {

ReportFiles RunDescriptionFiles(const ReportSettings& settings, const Scenario& scenario) {
  return {{"run.json", RunJson(settings, scenario)}};
}

ComposedReport ComposeReport(const std::vector<SessionRecord>& records, const Scenario& scenario,
                             const ReportSettings& settings) {
  ComposedReport report{ScoreRun(records, scenario, settings),
                        RunDescriptionFiles(settings, scenario)};
  report.files["report.json"] = ReportJson(report.score);
  std::vector<std::vector<Figure>> figures;
  for (std::size_t i = 0; i < records.size(); ++i) {
    figures.push_back(FiguresOf({records[i], report.score.sessions[i], settings, scenario}));
    for (const Figure& figure : figures.back())
      report.files["figures/" + figure.file] = figure.svg;
  }
  report.files["report.html"] = HtmlPage(report.score, figures);
  return report;
}

}  // namespace limpet
