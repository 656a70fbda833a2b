// SPDX-License-Identifier: MIT
#include "limpet/explain/explanation_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "limpet/console/shown_text.hpp"
#include "limpet/core/decimal_text.hpp"
#include "limpet/decision/deciding_bid.hpp"
#include "limpet/decision/merit.hpp"
#include "limpet/explain/motion_difference.hpp"

namespace limpet {
namespace {

using Cell = TextTable::Cell;

/// Names come from other people's files.
std::string Shown(const std::string& name) { return OneLine(name, 24); }

void Append(const Frame& more, Frame& frame) {
  frame.insert(frame.end(), more.begin(), more.end());
}

FrameLine Line(const std::string& text, Ink ink = Ink::kPlain) {
  FrameLine line;
  line.Add(text, ink);
  return line;
}

/// Numbers of a column under its head, at the right.
class NumberColumn {
 public:
  explicit NumberColumn(const std::string& head)
      : width_(std::max<std::size_t>(8, ColumnsOf(head))) {
    head_ = std::string(width_ - ColumnsOf(head), ' ') + head;
  }
  [[nodiscard]] const std::string& head() const { return head_; }
  [[nodiscard]] std::string Of(double value, int decimals) const {
    return fmt::format("{:>{}.{}f}", value + 0.0, width_, decimals);  // no -0.00
  }
  [[nodiscard]] std::string None() const { return fmt::format("{:>{}}", "-", width_); }

 private:
  std::size_t width_;
  std::string head_;
};

/// `cover x 1`, by the first option on which it bid.
std::string HeadOf(const std::string& behavior, const Explanation& explanation) {
  for (const ExplainedOption& option : explanation.options) {
    if (const WeightedBid* bid = BidOf(option.bidden, behavior)) {
      return fmt::format("{} x {}", Shown(behavior), DecimalText(bid->weight, 3));
    }
  }
  return Shown(behavior);
}

Frame OptionTable(const Explanation& explanation) {
  const NumberColumn length("length"), total("worth"), rate("per metre");
  std::vector<NumberColumn> columns;
  for (const std::string& behavior : explanation.bidders) {
    columns.emplace_back(HeadOf(behavior, explanation));
  }
  std::vector<std::string> heads{"", " # option", length.head(), total.head(), rate.head()};
  for (const NumberColumn& column : columns) {
    heads.push_back(column.head());
  }
  heads.emplace_back("lost because");
  TextTable table(heads);
  for (std::size_t i = 0; i < explanation.options.size(); ++i) {
    const BiddenOption& option = explanation.options[i].bidden;
    const bool is_chosen = explanation.chosen == i;
    const Ink ink = is_chosen ? Ink::kGood : VetoOn(option) != nullptr ? Ink::kFaint : Ink::kPlain;
    std::vector<Cell> row{{is_chosen ? "->" : "  ", ink},
                          {fmt::format("{:>2} {}", i, Shown(option.source)), ink},
                          {length.Of(option.length, 1), ink},
                          {total.Of(option.total, 2), ink},
                          {rate.Of(option.rate, 3), ink}};
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const WeightedBid* bid = BidOf(option, explanation.bidders[column]);
      row.push_back(
          {bid == nullptr ? columns[column].None() : columns[column].Of(bid->Worth(), 2), ink});
    }
    row.push_back({OneLine(explanation.options[i].lost_because, 90), ink});
    table.Add(std::move(row));
  }
  return table.Lines();
}

Frame Reasons(const BiddenOption& chosen) {
  TextTable table({"  what bids on it say", "", ""});
  for (const WeightedBid& weighted : chosen.bids) {
    std::string parts;
    for (const Reason& reason : weighted.bid.why) {
      parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", OneLine(reason.name, 40),
                           DecimalText(reason.value, 2));
    }
    table.Add(
        {{"  " + Shown(weighted.behavior)},
         {fmt::format("{:>8.2f} x {}", weighted.bid.value + 0.0, DecimalText(weighted.weight, 3))},
         {parts}});
  }
  return table.Lines();
}

/// Weights to four digits, away from the one in force: what is shown does change the choice.
std::string ShownWeight(const Flip& flip) {
  if (flip.new_weight <= 0.0) {
    return "0";
  }
  const double unit = std::pow(10.0, std::floor(std::log10(flip.new_weight)) - 3.0);
  const double shown = flip.new_weight > flip.weight ? std::ceil(flip.new_weight / unit) * unit
                                                     : std::floor(flip.new_weight / unit) * unit;
  return fmt::format("{:.4g}", shown);
}

Frame FlipTable(const Explanation& explanation) {
  TextTable table({"  what would have changed it, all else as it was", "", ""});
  for (const std::string& behavior : explanation.bidders) {
    const auto flip = std::ranges::find(explanation.flips, behavior, &Flip::behavior);
    if (flip == explanation.flips.end()) {
      table.Add({{"  " + Shown(behavior)}, {"no weight would"}, {""}});
      continue;
    }
    const bool is_more = flip->new_weight > flip->weight;
    table.Add({{"  " + Shown(behavior)},
               {fmt::format("pwt {} or {}", ShownWeight(*flip), is_more ? "more" : "less")},
               {fmt::format("(is {}): then {} {}", DecimalText(flip->weight, 3), flip->to,
                            Shown(explanation.options[flip->to].bidden.source))}});
  }
  return table.Lines();
}

std::string Shown(const std::optional<double>& value, const char* unit) {
  return value ? DecimalText(*value, 2) + unit : "nobody's";
}

/// `course 92.8 deg`, or which variables it judges together.
std::string ShownWish(const HelmMotion& motion, std::size_t i, int digits) {
  const MotionOpinion& opinion = motion.opinions[i];
  std::string wish = OneLine(opinion.variables, 24);
  if (opinion.summit) {
    wish += " " + DecimalText(*opinion.summit, digits) + UnitOf(opinion.variables);
  }
  return wish + (IsPresentCourse(motion, i) ? " (present course)" : "");
}

Frame MotionTable(const LoggedMotion& logged) {
  const HelmMotion& motion = logged.motion;
  const std::string state =
      logged.stopped
          ? fmt::format("  stopped since {:.1f} s: {}", logged.time, OneLine(*logged.stopped, 60))
          : fmt::format("  moving now ({:.1f} s): course {}, speed {}, depth {}", logged.time,
                        Shown(motion.course_deg, " deg"), Shown(motion.speed_mps, " m/s"),
                        Shown(motion.depth_m, " m"));
  Frame frame{Line(state)};
  if (logged.stopped && motion.opinions.empty()) return frame;
  TextTable table({"  how it moved", "wants", "gets"});
  for (std::size_t i = 0; i < motion.opinions.size(); ++i) {
    const MotionOpinion& opinion = motion.opinions[i];
    table.Add({{fmt::format("  {}", Shown(opinion.behavior))},
               {ShownWish(motion, i, 2) + (opinion.summit ? "" : " a function of all of these")},
               {logged.stopped
                    ? "-"
                    : fmt::format("{:.2f} x {}", opinion.value, DecimalText(opinion.weight, 3))}});
  }
  Append(table.Lines(), frame);
  return frame;
}

std::string WantOf(const WaitingBehavior& waiting) {
  const std::string what = OneLine(waiting.what, 90);
  if (waiting.is_done) return what.empty() ? "nothing: it has completed" : "nothing: " + what;
  return what.empty() ? "the helm, which has asked nobody yet" : what;
}

void AppendWaiting(const Explanation& explanation, Frame& frame) {
  if (explanation.waiting.empty()) return;
  TextTable table({"  who does not run", "waits for", "since"});
  for (const WaitingBehavior& waiting : explanation.waiting) {
    table.Add({{"  " + Shown(waiting.name)},
               {WantOf(waiting)},
               {fmt::format("{:.1f} s", waiting.since)}});
  }
  frame.emplace_back();
  Append(table.Lines(), frame);
}

}  // namespace

Frame FrameOf(const Explanation& explanation) {
  const char* ranking =
      explanation.order == OptionOrder::kPerMetre ? "worth per metre" : "worth in total";
  Frame frame{
      Line(fmt::format("{:.1f} s: path {}, decided because: {}; ranked by {}", explanation.time,
                       explanation.path_id, OneLine(explanation.cause, 60), ranking),
           Ink::kTitle)};
  Append(OptionTable(explanation), frame);
  if (explanation.chosen) {
    frame.emplace_back();
    Append(Reasons(explanation.options[*explanation.chosen].bidden), frame);
    frame.emplace_back();
    Append(FlipTable(explanation), frame);
  } else {
    frame.push_back(Line(explanation.options.empty()
                             ? "  Nothing was chosen: nobody offered anything."
                             : "  Nothing was chosen: every option is vetoed."));
  }
  if (explanation.motion) {
    frame.emplace_back();
    Append(MotionTable(*explanation.motion), frame);
  }
  AppendWaiting(explanation, frame);
  return frame;
}

Frame FrameOfMotion(const Explanation& explanation) {
  Frame frame{Line(fmt::format("{:.1f} s: {}", explanation.time, OneLine(explanation.cause, 60)),
                   Ink::kTitle)};
  if (explanation.motion) Append(MotionTable(*explanation.motion), frame);
  AppendWaiting(explanation, frame);
  return frame;
}

Frame FrameOfMotions(std::span<const MotionChange> changes) {
  TextTable table({"     time", "cause", "course", "speed", "depth", "wanted by"});
  for (const MotionChange& change : changes) {
    const HelmMotion& motion = change.motion.motion;
    const bool is_stopped = change.motion.stopped.has_value();
    std::string wanted;
    for (std::size_t i = 0; i < motion.opinions.size(); ++i) {
      wanted += fmt::format("{}{}: {}", wanted.empty() ? "" : ", ",
                            Shown(motion.opinions[i].behavior), ShownWish(motion, i, 1));
    }
    table.Add({{fmt::format("{:>9.1f}", change.time)},
               {OneLine(change.cause, 60)},
               {is_stopped ? "-" : Shown(motion.course_deg, " deg")},
               {is_stopped ? "-" : Shown(motion.speed_mps, " m/s")},
               {is_stopped ? "-" : Shown(motion.depth_m, " m")},
               {!wanted.empty() ? wanted
                : is_stopped    ? "-"
                                : "nobody"}});
  }
  return table.Lines();
}

Frame ChangesOf(std::span<const LoggedDecision> decisions, std::span<const MotionChange> stops) {
  TextTable table({"     time", "path", "cause", "chosen", "decided by"});
  auto stop = stops.begin();
  const auto add_stops_until = [&](double time) {
    for (; stop != stops.end() && stop->time <= time; ++stop) {
      table.Add({{fmt::format("{:>9.1f}", stop->time)},
                 {"   -"},
                 {OneLine(stop->cause, 40)},
                 {"-"},
                 {"-"}});
    }
  };
  for (const LoggedDecision& decision : decisions) {
    add_stops_until(decision.time);
    const Explanation explanation = Explain(decision);
    const std::optional<DecidingBid> deciding = DecidingBidOf(decision.bids);
    table.Add({{fmt::format("{:>9.1f}", explanation.time)},
               {fmt::format("{:>4}", explanation.path_id)},
               {OneLine(explanation.cause, 40)},
               {OneLine(SummaryOf(explanation), 60)},
               {deciding ? Shown(deciding->behavior) : "-"}});
  }
  add_stops_until(std::numeric_limits<double>::infinity());
  return table.Lines();
}

}  // namespace limpet
