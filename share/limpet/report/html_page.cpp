// SPDX-License-Identifier: MIT
#include "limpet/report/html_page.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "limpet/figures/probability_text.hpp"
#include "limpet/figures/svg_canvas.hpp"
#include "limpet/report/bound_sentence.hpp"
#include "limpet/report/current_sentence.hpp"
#include "limpet/report/energy_sentence.hpp"
#include "limpet/report/fences_sentence.hpp"
#include "limpet/report/html_explanations.hpp"
#include "limpet/report/html_pictures.hpp"
#include "limpet/report/html_style.hpp"
#include "limpet/report/html_warnings.hpp"
#include "limpet/report/lanes_sentence.hpp"
#include "limpet/report/obstacles_sentence.hpp"
#include "limpet/report/open_change.hpp"
#include "limpet/report/phase_sentence.hpp"
#include "limpet/report/water_sentence.hpp"
#include "limpet/report/way_text.hpp"
#include "limpet/scoring/verdict.hpp"

namespace limpet {
namespace {

std::string Title(std::string name) {
  if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return EscapedMarkup(name);
}

std::string PlaceCells(const Eigen::Vector3d& p) {
  const auto cell = [](double x) {
    return fmt::format("<td>{}{:.2f}</td>", x < -0.005 ? "\u2212" : "", std::abs(x));
  };
  return cell(p.x()) + cell(p.y()) + cell(p.z());
}

std::string Judged(bool is_good, const std::string& text) {
  return fmt::format("<span class=\"{}\">{} {}</span>", is_good ? "ok" : "no",
                     is_good ? "\u2713" : "\u2717", text);
}

std::string Card(const std::string& value, const std::string& meaning) {
  return fmt::format("<div class=\"card\"><b>{}</b><span>{}</span></div>\n", value, meaning);
}

std::string EndCard(const SessionScore& session) {
  return Card(session.home_error_m ? fmt::format("{:.2f} m", *session.home_error_m) : "unknown",
              "from the start point at the end; ended: " + EscapedMarkup(session.ended));
}

std::string TruthCards(const SessionScore& session) {
  const auto way = [](const std::vector<CoverageLevel>& levels, double wanted) {
    const auto level = std::find_if(levels.begin(), levels.end(), [&](const CoverageLevel& entry) {
      return entry.level == wanted;
    });
    return level != levels.end() ? WayText(level->path_m) : std::string("never");
  };
  std::string out = Card(way(session.coverage.seabed, 0.95), "of way to see 95 % of the bottom");
  out += Card(way(session.coverage.band, 0.95), "of way to see 95 % of the band of heights");
  if (!session.former.empty()) {
    out += Card(WayText(session.coverage.prior_opis_seen_path_m),
                "until all former objects\u2019 places were seen");
  }
  return out + Card(MetresText(session.nav.position_rmse_m),
                    fmt::format("position error, rms; at the end {}, dead reckoning {}",
                                MetresText(session.nav.final_error_m),
                                MetresText(session.nav.dead_reckoning_final_error_m)));
}

std::string Cards(const SessionScore& session) {
  std::string out = "<div class=\"cards\">\n";
  if (session.has_truth) {
    out += TruthCards(session) + EndCard(session);
  } else {
    out += Card(std::to_string(session.opis.reported.size()), "objects reported; not judged");
    out += Card(EscapedMarkup(session.ended), "how it ended");
  }
  if (session.energy) {
    out += Card(fmt::format("{:.0f} Wh", session.energy->last.used_wh),
                "energy, by its own account: " + EnergySentence(*session.energy));
  }
  if (!session.phases.empty()) {
    out += Card(fmt::format("{:.0f} s", session.duration_s),
                "of time [s]: " + EscapedMarkup(PhaseSentence(session)));
  }
  if (session.water) {
    out += Card(fmt::format("{:.1f} m", session.water->visibility.visibility.value()),
                "how far it could see, by its own account: " + WaterSentence(*session.water));
  }
  if (session.current) {
    out +=
        Card(fmt::format("{:.2f} m/s", std::hypot(session.current->north, session.current->east)),
             "current, by its own account: " + CurrentSentence(*session.current));
  }
  if (session.realtime_factor()) {
    out +=
        Card(fmt::format("{:.0f} \u00d7", *session.realtime_factor()),
             fmt::format("real time: {:.0f} s in {:.1f} s", session.duration_s, *session.wall_s));
  }
  return out + "</div>\n";
}

std::string ObjectsTable(const SessionScore& session) {
  std::string out =
      "<h3>Objects</h3>\n<div class=\"scroll\"><table><tr><th>object<th>north [m]<th>east "
      "[m]<th>down [m]"
      "<th>sd north<th>sd east<th>sd down<th>error [m]<th>aligned<th>looks<th>P<th "
      "class=\"left\">verdict</tr>\n";
  for (const OpiScore& opi : session.opis.found) {
    out += fmt::format(
        "<tr><td>{}</td>{}{}<td>{:.2f}</td><td>{:.2f}</td><td>{}</td><td>{}</td><td "
        "class=\"left\">{}</td></tr>\n",
        EscapedMarkup(opi.truth), PlaceCells(opi.belief.object.p_W),
        PlaceCells(opi.belief.object.sd_W()), opi.error_m, opi.aligned_error_m, opi.belief.looks,
        EscapedMarkup(ProbabilityText(opi.belief.posterior.present())),
        Judged(opi.error_m <= kGoodError,
               opi.error_m <= kGoodError ? "found" : "found, misplaced"));
  }
  for (const std::string& name : session.opis.missed) {
    out += fmt::format("<tr><td>{}</td><td colspan=\"10\"></td><td class=\"left\">{}</td></tr>\n",
                       EscapedMarkup(name), Judged(false, "missed"));
  }
  for (const OpiBelief& opi : session.opis.invented) {
    out += fmt::format(
        "<tr><td>nothing</td>{}<td colspan=\"6\"></td><td>{}</td><td "
        "class=\"left\">{}</td></tr>\n",
        PlaceCells(opi.object.p_W), EscapedMarkup(ProbabilityText(opi.posterior.present())),
        Judged(false, "invented"));
  }
  return out + "</table></div>\n";
}

/// What the vehicle says, where nobody can say whether it is right.
std::string ReportedObjectsTable(const SessionScore& session) {
  std::string out =
      "<h3>Objects as reported</h3>\n<p>There is no truth for this session: nothing is judged, and "
      "what needs the truth is left out.</p>\n<div class=\"scroll\"><table><tr><th>object<th>north "
      "[m]<th>east [m]<th>down [m]<th>sd north<th>sd east<th>sd down<th>looks<th>P</tr>\n";
  for (const OpiBelief& opi : session.opis.reported) {
    out += fmt::format("<tr><td>{}</td>{}{}<td>{}</td><td>{}</td></tr>\n",
                       EscapedMarkup(fmt::format("id {}, {}", opi.id, opi.object.color)),
                       PlaceCells(opi.object.p_W), PlaceCells(opi.object.sd_W()), opi.looks,
                       EscapedMarkup(ProbabilityText(opi.posterior.present())));
  }
  return out + "</table></div>\n";
}

std::string FigureMarkup(const Figure& figure) {
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", figure.svg,
                     EscapedMarkup(figure.caption));
}

std::string DecisionsTable(const SessionScore& session) {
  std::string out =
      "<div class=\"scroll\"><table><tr><th>north [m]<th>east [m]<th>down [m]<th "
      "class=\"left\">decided<th>P</tr>\n";
  for (const ChangeScore& change : session.opis.changes) {
    out += fmt::format("<tr>{}<td class=\"left\">{}</td><td>{}</td></tr>\n",
                       change.p_W ? PlaceCells(*change.p_W) : "<td colspan=\"3\"></td>",
                       NameOf(change.decided), EscapedMarkup(ProbabilityText(change.probability)));
  }
  return out + "</table></div>\n<p>There is no truth for this session: nothing is judged.</p>\n";
}

std::string ChangeVerdict(const ChangeScore& change) {
  if (change.is_open()) {
    return fmt::format("<span class=\"muted\">{}</span>", EscapedMarkup(OpenText(change)));
  }
  return Judged(change.is_right(), change.is_right() ? "right" : "wrong");
}

std::string ChangesTable(const SessionScore& session) {
  std::string out =
      "<div class=\"scroll\"><table><tr><th>object<th>north [m]"
      "<th>east [m]<th>down [m]<th class=\"left\">truth<th class=\"left\">decided<th>P<th "
      "class=\"left\">verdict</tr>\n";
  for (const ChangeScore& change : session.opis.changes) {
    out += fmt::format(
        "<tr><td>{}</td>{}<td class=\"left\">{}</td><td class=\"left\">{}</td><td>{}</td><td "
        "class=\"left\">{}</td></tr>\n",
        EscapedMarkup(change.truth.value_or("nothing")),
        change.p_W ? PlaceCells(*change.p_W) : "<td colspan=\"3\">not known to the vehicle</td>",
        change.expected ? NameOf(*change.expected) : "nothing there", NameOf(change.decided),
        EscapedMarkup(ProbabilityText(change.probability)), ChangeVerdict(change));
  }
  return out + "</table></div>\n";
}

std::string Paragraph(const std::string& sentence) {
  return sentence.empty() ? ""
                          : fmt::format("<p class=\"muted\">{}</p>\n", EscapedMarkup(sentence));
}

std::string WayTable(const SessionScore& session, const ReportSettings& settings) {
  const auto row = [](const std::string& what, const std::vector<CoverageLevel>& levels,
                      double at_end) {
    std::string cells;
    for (const CoverageLevel& level : levels) {
      cells += level.path_m ? fmt::format("<td>{:.1f} m</td>", *level.path_m) : "<td>never</td>";
    }
    return fmt::format("<tr><td>{}</td>{}<td>{:.2f} %</td></tr>\n", what, cells, 100.0 * at_end);
  };
  return "<h3>Way to cover</h3>\n<div class=\"scroll\"><table><tr><th>what<th>90 %<th>95 %<th>99 "
         "%<th>at the end</tr>\n" +
         row("bottom inside the image", session.coverage.seabed, session.coverage.covered) +
         row(fmt::format("objects {:g} to {:g} m above the bottom, seen well",
                         settings.object_radius_m, settings.object_height_max_m),
             session.coverage.band, session.coverage.detected_band) +
         "</table></div>\n" + Paragraph(BoundSentence(session)) +
         Paragraph(LanesSentence(session)) + Paragraph(WinsSentence(session)) +
         Paragraph(UnseenSentence(session.coverage.unseen)) +
         Paragraph(ObstaclesSentence(session)) + Paragraph(FencesSentence(session));
}

/// What the reader came for, before anything else: the statuses, in a table and on the map.
std::string ChangesSection(const SessionScore& session, const std::vector<Figure>& figures) {
  std::string out = fmt::format(
      "<section id=\"changes-{0}\">\n<h2>What changed</h2>\n<p class=\"muted\">{0}, compared with "
      "{1}.</p>\n",
      EscapedMarkup(session.name), EscapedMarkup(session.former));
  out += session.has_truth ? ChangesTable(session) : DecisionsTable(session);
  for (const Figure& figure : figures) {
    if (figure.file.ends_with("_status.svg")) out += FigureMarkup(figure);
  }
  return out + "</section>\n";
}

std::string SessionSection(const SessionScore& session, const ReportSettings& settings,
                           const std::vector<Figure>& figures) {
  std::string out = fmt::format(
      "<section id=\"{0}\">\n<h2>{1} session</h2>\n<p class=\"muted\">{2:.0f} m of way{4} in "
      "{3:.0f} s, the dive and the way home included.</p>\n",
      EscapedMarkup(session.name), Title(session.name), session.path_m, session.duration_s,
      session.has_truth ? "" : ", by the vehicle\u2019s own estimate,");
  out += Cards(session);
  out += session.has_truth ? ObjectsTable(session) + WayTable(session, settings)
                           : ReportedObjectsTable(session);
  const Seconds begun = session.begun.value_or(Seconds(0.0));
  out += PicturesOf(session.pictured, begun);
  out += WarningsTable(session.warnings, begun, begun + Seconds(session.duration_s));
  for (const Figure& figure : figures) {
    if (!figure.file.ends_with("_status.svg")) out += FigureMarkup(figure);
  }
  return out + "</section>\n";
}

std::string SettingsSection(const ReportSettings& settings) {
  const auto footprint = settings.footprint_m();
  const auto& camera = settings.camera_geometry;
  std::string out =
      "<section id=\"run\">\n<h2>How it was run</h2>\n<div class=\"scroll\"><table>\n";
  const auto row = [&](const std::string& what, const std::string& value) {
    out += fmt::format("<tr><td>{}</td><td class=\"left\">{}</td></tr>\n", what, value);
  };
  row("Mission, seed", fmt::format("{}, {}", EscapedMarkup(settings.mission), settings.seed));
  row("Planner, gain", EscapedMarkup(settings.planner + ", " + settings.gain));
  row("Camera", fmt::format("{}; {:.0f} \u00d7 {:.0f} deg, {:.2f} \u00d7 {:.2f} m on the bottom "
                            "from {:g} m, {:g} per second",
                            EscapedMarkup(settings.camera), DegreesFromRadians(camera.fov_across()),
                            DegreesFromRadians(camera.fov_along()), footprint[0], footprint[1],
                            settings.altitude_m, settings.frame_rate_hz));
  row("Objects", fmt::format("radius {:g} m, centres up to {:g} m above the bottom",
                             settings.object_radius_m, settings.object_height_max_m));
  row("Limpet", EscapedMarkup(settings.version));
  out += "</table></div>\n";
  if (!settings.command.empty()) {
    out += fmt::format("<p>The same run again, bit for bit:</p>\n<pre><code>{}</code></pre>\n",
                       EscapedMarkup(settings.command));
  }
  return out + "</section>\n";
}

}  // namespace

std::string HtmlPage(const RunScore& run, const std::vector<std::vector<Figure>>& figures) {
  const Verdict verdict = VerdictOf(run);
  const std::string mission = EscapedMarkup(run.settings.mission);
  std::string links, change_links, changes, sections;
  for (std::size_t i = 0; i < run.sessions.size(); ++i) {
    const SessionScore& session = run.sessions[i];
    links +=
        fmt::format("<a href=\"#{}\">{}</a>", EscapedMarkup(session.name), Title(session.name));
    const std::vector<Figure> drawn = i < figures.size() ? figures[i] : std::vector<Figure>{};
    if (!session.former.empty()) {
      change_links += fmt::format("<a href=\"#changes-{0}\">What changed: {0}</a>",
                                  EscapedMarkup(session.name));
      changes += ChangesSection(session, drawn);
    }
    sections += SessionSection(session, run.settings, drawn);
  }
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n"
      "<title>Limpet: {0}, seed {1}</title>\n<style>{2}</style>\n</head>\n<body>\n<header>\n"
      "<p class=\"eyebrow\">Limpet survey report</p>\n<h1>{0}, seed {1}</h1>\n<nav>{3}<a "
      "href=\"#run\">How it was run</a>"
      "<a href=\"#meaning\">What the numbers mean</a></nav>\n<div "
      "class=\"verdict{4}\">{5}</div>\n</header>\n<main>\n"
      "{6}{7}{8}</main>\n<footer>Written by limpet {9}. Everything here is also in "
      "<code>report.json</code>; the "
      "figures are in <code>figures/</code>.</footer>\n</body>\n</html>\n",
      mission, run.settings.seed, PageStyle(), change_links + links,
      verdict.is_judged && !verdict.is_good ? " bad" : "", EscapedMarkup(verdict.text),
      changes + sections, SettingsSection(run.settings), Explanations(),
      EscapedMarkup(run.settings.version));
}

}  // namespace limpet
