// SPDX-License-Identifier: MIT
#include "apps/limpet/report/report.hpp"

#include <fstream>
#include <stdexcept>

#include "apps/limpet/report/figures.hpp"
#include "apps/limpet/report/html_page.hpp"
#include "apps/limpet/report/report_json.hpp"

namespace limpet {
namespace {

/// Written aside and renamed, so that a reader never meets half a file.
void WriteFile(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path aside = path.string() + ".part";
  std::ofstream file(aside, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + aside.string());
  std::filesystem::rename(aside, path);
}

}  // namespace

void WriteRunDescription(const ReportSettings& settings, const Scenario& scenario,
                         const std::filesystem::path& out) {
  std::filesystem::create_directories(out);
  WriteFile(out / "run.json", RunJson(settings, scenario));
}

RunScore WriteReport(const std::vector<SessionRecord>& records, const Scenario& scenario,
                     const ReportSettings& settings, const std::filesystem::path& out) {
  RunScore run = ScoreRun(records, scenario, settings);
  WriteRunDescription(settings, scenario, out);
  WriteFile(out / "report.json", ReportJson(run));
  std::filesystem::create_directories(out / "figures");
  std::vector<std::vector<Figure>> figures;
  for (std::size_t i = 0; i < records.size(); ++i) {
    figures.push_back(FiguresOf({records[i], run.sessions[i], settings, scenario}));
    for (const Figure& figure : figures.back())
      WriteFile(out / "figures" / figure.file, figure.svg);
  }
  WriteFile(out / "report.html", HtmlPage(run, figures));
  return run;
}

}  // namespace limpet
