// SPDX-License-Identifier: MIT
#include "apps/limpet/report/terminal_report.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

#include "apps/limpet/report/probability_text.hpp"
#include "apps/limpet/report/verdict.hpp"

namespace limpet {
namespace {

class Painter {
 public:
  explicit Painter(bool has_color) : has_color_(has_color) {}
  [[nodiscard]] std::string Bold(const std::string& text) const { return Wrap("1", text); }
  [[nodiscard]] std::string Dim(const std::string& text) const { return Wrap("2", text); }
  [[nodiscard]] std::string Verdict(bool is_good, const std::string& text) const {
    return Wrap(is_good ? "32" : "1;31", text);
  }

 private:
  [[nodiscard]] std::string Wrap(const char* code, const std::string& text) const {
    return has_color_ ? fmt::format("\033[{}m{}\033[0m", code, text) : text;
  }
  bool has_color_;
};

std::string Metres(const std::optional<double>& metres) {
  return metres ? fmt::format("{:.0f} m", *metres) : "never";
}

std::string Place(const std::optional<Eigen::Vector3d>& ned) {
  if (!ned) return fmt::format("{:>7} {:>7} {:>7}", "-", "-", "-");
  return fmt::format("{:7.2f} {:7.2f} {:7.2f}", ned->x(), ned->y(), ned->z());
}

std::string Heading(const SessionScore& session, const Painter& paint) {
  const std::string speed = session.realtime_factor()
                                ? fmt::format(" in {:.1f} s: {:.0f} x real time", *session.wall_s,
                                              *session.realtime_factor())
                                : "";
  const bool is_home = IsHome(session);
  const std::string end = session.home_error_m ? fmt::format("{}, {:.2f} m from the start point",
                                                             session.ended, *session.home_error_m)
                                               : session.ended;
  std::string name = session.name;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return fmt::format("{}  {}   {:.0f} m of way, {:.0f} s{}\n", paint.Bold(name),
                     paint.Verdict(is_home, end), session.path_m, session.duration_s, speed);
}

std::string DiscoveryTable(const SessionScore& session, const Painter& paint) {
  std::string out =
      paint.Dim(fmt::format("  {:<10} {:>23}   {:>17}  {:>7}  {:>5} {:>6}\n", "object",
                            "north   east    down [m]", "sd [m]", "error", "looks", "sure"));
  for (const OpiScore& opi : session.opis.found) {
    out += fmt::format("  {:<10} {}   {:5.2f} {:5.2f} {:5.2f}  {:5.2f} m  {:>5} {:>6}  {}\n",
                       opi.truth, Place(opi.slam_ned), opi.slam_sd.x(), opi.slam_sd.y(),
                       opi.slam_sd.z(), opi.error_m, opi.looks, ProbabilityText(opi.probability),
                       paint.Verdict(opi.error_m <= kGoodError, "found"));
  }
  return out;
}

std::string ChangeTable(const SessionScore& session, const Painter& paint) {
  std::string out =
      paint.Dim(fmt::format("  {:<10} {:>23}   {:<10} {:<10} {:>6} {:>7}\n", "object",
                            "north   east    down [m]", "truth", "decided", "sure", "error"));
  for (const ChangeScore& change : session.opis.changes) {
    const auto& found = session.opis.found;
    const auto opi = std::find_if(found.begin(), found.end(), [&](const OpiScore& score) {
      return change.truth && score.truth == *change.truth;
    });
    out += fmt::format("  {:<10} {}   {:<10} {:<10} {:>6} {:>7}  {}\n",
                       change.truth.value_or("nothing"), Place(change.ned),
                       change.expected.value_or("-"), change.decided,
                       ProbabilityText(change.probability),
                       opi != found.end() ? fmt::format("{:.2f} m", opi->error_m) : "-",
                       paint.Verdict(change.is_right(), change.is_right() ? "right" : "WRONG"));
  }
  return out;
}

std::string Mistakes(const SessionScore& session, const Painter& paint) {
  std::string out;
  for (const std::string& name : session.opis.missed) {
    out += fmt::format("  {:<10} {}\n", name, paint.Verdict(false, "MISSED"));
  }
  for (const FalseOpi& opi : session.opis.invented) {
    out += fmt::format("  {:<10} {}   {} {}  {}\n", "nothing", Place(opi.ned), opi.color,
                       ProbabilityText(opi.probability), paint.Verdict(false, "INVENTED"));
  }
  return out;
}

std::string CoverageLine(const std::string& what, const std::vector<CoverageLevel>& levels,
                         double at_end) {
  std::string out = fmt::format("  {:<34}", what);
  for (const CoverageLevel& level : levels)
    out += fmt::format(" {:>8}", Metres(level.path_m));
  return out + fmt::format(" {:>8.1f} %\n", 100.0 * at_end);
}

std::string CoverageTable(const SessionScore& session, const ReportSettings& settings,
                          const Painter& paint) {
  std::string out = paint.Dim(fmt::format("  {:<34} {:>8} {:>8} {:>8} {:>10}\n", "way to cover",
                                          "90 %", "95 %", "99 %", "at the end"));
  out += CoverageLine("the bottom", session.coverage.seabed, session.coverage.covered);
  out += CoverageLine(fmt::format("objects {:.1f} to {:.1f} m above it", settings.object_radius_m,
                                  settings.object_height_max_m),
                      session.coverage.band, session.coverage.detected_band);
  if (session.name == "change") {
    out += fmt::format("  {:<34} {:>8}\n", "all former objects' places seen",
                       Metres(session.coverage.prior_opis_seen_path_m));
  }
  return out;
}

std::string NavigationLine(const NavScore& nav) {
  return fmt::format(
      "  position {:.2f} m rms ({:.2f} m aligned), at the end {:.2f} m; dead reckoning {:.2f} m; "
      "NEES {:.1f} (ideal 3)\n",
      nav.position_rmse_m, nav.aligned_rmse_m, nav.final_error_m, nav.dead_reckoning_final_error_m,
      nav.nees_mean);
}

}  // namespace

std::string TerminalReport(const RunScore& run, bool has_color) {
  const Painter paint(has_color);
  const ReportSettings& settings = run.settings;
  const auto footprint = settings.footprint_m();
  std::string out = fmt::format(
      "{}  seed {}  planner {} ({})  camera {}, {:.2f} x {:.2f} m on the bottom at {:g} m\n",
      paint.Bold(settings.mission), settings.seed, settings.planner, settings.gain, settings.camera,
      footprint[0], footprint[1], settings.altitude_m);
  for (const SessionScore& session : run.sessions) {
    out += "\n" + Heading(session, paint);
    out += session.name == "change" ? ChangeTable(session, paint) : DiscoveryTable(session, paint);
    out += Mistakes(session, paint);
    out += CoverageTable(session, settings, paint);
    out += NavigationLine(session.nav);
  }
  const Verdict verdict = VerdictOf(run);
  return out + "\n" + paint.Verdict(verdict.is_good, verdict.text) + "\n";
}

void PrintReport(const RunScore& run, std::FILE* out) {
  const bool has_color = isatty(fileno(out)) != 0 && std::getenv("NO_COLOR") == nullptr;
  std::fputs(TerminalReport(run, has_color).c_str(), out);
  std::fflush(out);
}

}  // namespace limpet
