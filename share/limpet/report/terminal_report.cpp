// SPDX-License-Identifier: MIT
#include "limpet/report/terminal_report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <unistd.h>

#include "limpet/console/frame.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/core/letter_case.hpp"
#include "limpet/figures/probability_text.hpp"
#include "limpet/report/bound_sentence.hpp"
#include "limpet/report/current_sentence.hpp"
#include "limpet/report/energy_sentence.hpp"
#include "limpet/report/fences_sentence.hpp"
#include "limpet/report/lanes_sentence.hpp"
#include "limpet/report/obstacles_sentence.hpp"
#include "limpet/report/open_change.hpp"
#include "limpet/report/phase_sentence.hpp"
#include "limpet/report/water_sentence.hpp"
#include "limpet/report/way_text.hpp"
#include "limpet/scoring/verdict.hpp"

namespace limpet {
namespace {

/// A name from a mission or a log, in the ten columns of a table's first.
std::string Name(const std::string& text) {
  constexpr std::size_t kColumns = 10;
  std::string shown = OneLine(text, 2 * kColumns);
  const std::size_t columns = ColumnsOf(shown);
  return shown + std::string(kColumns - std::min(columns, kColumns), ' ');
}

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

std::string Place(const std::optional<Eigen::Vector3d>& p_W) {
  if (!p_W) return fmt::format("{:>7} {:>7} {:>7}", "-", "-", "-");
  return fmt::format("{:7.2f} {:7.2f} {:7.2f}", p_W->x(), p_W->y(), p_W->z());
}

std::string Heading(const SessionScore& session, const Painter& paint) {
  const std::string speed = session.realtime_factor()
                                ? fmt::format(" in {:.1f} s: {:.0f} x real time", *session.wall_s,
                                              *session.realtime_factor())
                                : "";
  const std::string ended = OneLine(session.ended, 40);
  const std::string end = session.home_error_m ? fmt::format("{}, {:.2f} m from the start point",
                                                             ended, *session.home_error_m)
                                               : ended;
  const bool is_home = session.has_truth ? IsHome(session) : session.ended == "home";
  const std::string name = UpperCase(OneLine(session.name, 64));
  return fmt::format("{}  {}   {:.0f} m of way{}, {:.0f} s{}\n", paint.Bold(name),
                     paint.Verdict(is_home, end), session.path_m,
                     session.has_truth ? "" : " by its own estimate", session.duration_s, speed);
}

std::string Deviations(const ObjectEstimate& object) {
  const Eigen::Vector3d sd = object.sd_W();
  return fmt::format("{:5.2f} {:5.2f} {:5.2f}", sd.x(), sd.y(), sd.z());
}

std::string DiscoveryTable(const SessionScore& session, const Painter& paint) {
  std::string out =
      paint.Dim(fmt::format("  {:<10} {:>23}   {:>17}  {:>7}  {:>5} {:>6}\n", "object",
                            "north   east    down [m]", "sd [m]", "error", "looks", "sure"));
  for (const OpiScore& opi : session.opis.found) {
    out += fmt::format("  {} {}   {}  {:5.2f} m  {:>5} {:>6}  {}\n", Name(opi.truth),
                       Place(opi.belief.object.p_W), Deviations(opi.belief.object), opi.error_m,
                       opi.belief.looks, ProbabilityText(opi.belief.posterior.present()),
                       paint.Verdict(opi.error_m <= kGoodError, "found"));
  }
  return out;
}

/// What the vehicle says, where nobody can say whether it is right.
std::string ReportedTable(const SessionScore& session, const Painter& paint) {
  std::string out = paint.Dim(fmt::format("  {:<10} {:>23}   {:>17}  {:>5} {:>6}\n", "object",
                                          "north   east    down [m]", "sd [m]", "looks", "sure"));
  for (const OpiBelief& opi : session.opis.reported) {
    out += fmt::format("  {} {}   {}  {:>5} {:>6}  {}\n", Name(fmt::format("id {}", opi.id)),
                       Place(opi.object.p_W), Deviations(opi.object), opi.looks,
                       ProbabilityText(opi.posterior.present()), OneLine(opi.object.color, 20));
  }
  for (const ChangeScore& change : session.opis.changes) {
    out +=
        fmt::format("  {:<10} {}   {} {:>6}\n", "decided", Place(change.p_W),
                    Name(std::string(NameOf(change.decided))), ProbabilityText(change.probability));
  }
  return out +
         "  no truth in this session: nothing is judged, and what needs the truth is left out\n";
}

std::string OutcomeText(const ChangeScore& change, const Painter& paint) {
  if (change.is_open()) return paint.Dim(OpenText(change));
  return paint.Verdict(change.is_right(), change.is_right() ? "right" : "WRONG");
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
    out +=
        fmt::format("  {} {}   {:<10} {} {:>6} {:>7}  {}\n", Name(change.truth.value_or("nothing")),
                    Place(change.p_W), change.expected ? NameOf(*change.expected) : "-",
                    Name(std::string(NameOf(change.decided))), ProbabilityText(change.probability),
                    opi != found.end() ? fmt::format("{:.2f} m", opi->error_m) : "-",
                    OutcomeText(change, paint));
  }
  return out;
}

std::string Mistakes(const SessionScore& session, const Painter& paint) {
  std::string out;
  for (const std::string& name : session.opis.missed) {
    out += fmt::format("  {} {}\n", Name(name), paint.Verdict(false, "MISSED"));
  }
  for (const OpiBelief& opi : session.opis.invented) {
    out += fmt::format("  {:<10} {}   {} {}  {}\n", "nothing", Place(opi.object.p_W),
                       OneLine(opi.object.color, 20), ProbabilityText(opi.posterior.present()),
                       paint.Verdict(false, "INVENTED"));
  }
  return out;
}

std::string CoverageLine(const std::string& what, const std::vector<CoverageLevel>& levels,
                         double at_end) {
  std::string out = fmt::format("  {:<34}", what);
  for (const CoverageLevel& level : levels)
    out += fmt::format(" {:>8}", WayText(level.path_m));
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
  if (!session.former.empty()) {
    out += fmt::format("  {:<34} {:>8}\n", "all former objects' places seen",
                       WayText(session.coverage.prior_opis_seen_path_m));
  }
  return out;
}

std::string BoundLines(const SessionScore& session) {
  std::string out;
  for (const std::string& line : {BoundSentence(session), LanesSentence(session),
                                  WinsSentence(session), UnseenSentence(session.coverage.unseen),
                                  ObstaclesSentence(session), FencesSentence(session)}) {
    if (!line.empty()) out += "  " + line + "\n";
  }
  return out;
}

std::string NavigationLine(const NavScore& nav) {
  return fmt::format(
      "  position {} rms ({} aligned), at the end {}; dead reckoning {}; NEES {} (ideal 3)\n",
      MetresText(nav.position_rmse_m), MetresText(nav.aligned_rmse_m),
      MetresText(nav.final_error_m), MetresText(nav.dead_reckoning_final_error_m),
      NumberText(nav.nees_mean));
}

std::string PhaseLine(const SessionScore& session) {
  const std::string times = PhaseSentence(session);
  return times.empty() ? "" : fmt::format("  time [s]: {}\n", times);
}

std::string WaterLine(const SessionScore& session) {
  if (!session.water) return "";
  return fmt::format("  {}\n", WaterSentence(*session.water));
}

std::string CurrentLine(const SessionScore& session) {
  if (!session.current) return "";
  return fmt::format("  current: {}\n", CurrentSentence(*session.current));
}

std::string EnergyLine(const SessionScore& session) {
  if (!session.energy) return "";
  return fmt::format("  energy: {}\n", EnergySentence(*session.energy));
}

std::string SessionText(const SessionScore& session, const ReportSettings& settings,
                        const Painter& paint) {
  std::string out = "\n" + Heading(session, paint);
  if (!session.former.empty()) {
    out += paint.Dim(fmt::format("  compared with {}\n", OneLine(session.former, 64)));
  }
  out += PhaseLine(session) + WaterLine(session) + CurrentLine(session) + EnergyLine(session);
  if (!session.has_truth) return out + ReportedTable(session, paint);
  out += session.former.empty() ? DiscoveryTable(session, paint) : ChangeTable(session, paint);
  out += Mistakes(session, paint);
  out += CoverageTable(session, settings, paint) + BoundLines(session);
  return out + NavigationLine(session.nav);
}

}  // namespace

std::string TerminalReport(const RunScore& run, bool has_color) {
  const Painter paint(has_color);
  const ReportSettings& settings = run.settings;
  const auto footprint = settings.footprint_m();
  std::string out = fmt::format(
      "{}  seed {}  planner {} ({})  camera {}, {:.2f} x {:.2f} m on the bottom at {:g} m\n",
      paint.Bold(OneLine(settings.mission, 64)), settings.seed, OneLine(settings.planner, 20),
      OneLine(settings.gain, 20), OneLine(settings.camera, 20), footprint[0], footprint[1],
      settings.altitude_m);
  for (const SessionScore& session : run.sessions) {
    out += SessionText(session, settings, paint);
  }
  const Verdict verdict = VerdictOf(run);
  return out + "\n" +
         (verdict.is_judged ? paint.Verdict(verdict.is_good, verdict.text) : verdict.text) + "\n";
}

void PrintReport(const RunScore& run, std::FILE* out) {
  const bool has_color = isatty(fileno(out)) != 0 && ColorsAreWanted();
  std::fputs(TerminalReport(run, has_color).c_str(), out);
  std::fflush(out);
}

}  // namespace limpet
