// SPDX-License-Identifier: MIT
#include "limpet/console/scope_screen.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace limpet {
namespace {

using Code = Key::Code;
constexpr std::size_t kAroundRows = 3;  ///< lines that are no rows: title, head, help

std::size_t Moved(std::size_t from, const Key& key, std::size_t page) {
  switch (key.code) {
    case Code::kUp:
      return from - std::min<std::size_t>(from, 1);
    case Code::kDown:
      return from + 1;
    case Code::kPageUp:
      return from - std::min(from, page);
    case Code::kPageDown:
      return from + page;
    case Code::kHome:
      return 0;
    case Code::kEnd:
      return static_cast<std::size_t>(1) << 30U;  // drawing brings it back to the last row
    default:
      return from;
  }
}

bool Moves(const Key& key) {
  return key.code == Code::kUp || key.code == Code::kDown || key.code == Code::kPageUp ||
         key.code == Code::kPageDown || key.code == Code::kHome || key.code == Code::kEnd;
}

}  // namespace

ScopeScreen::ScopeScreen(Settings settings) : settings_(std::move(settings)) {
  if (!settings_.history_of.empty()) {
    chosen_ = settings_.history_of;
    mode_ = Mode::kHistory;
  }
}

void ScopeScreen::Press(const Key& key) {
  if (mode_ == Mode::kFilter) {
    PressInFilter(key);
  } else if (Moves(key)) {
    Move(key);
  } else if (key.code == Code::kCharacter) {
    PressCharacter(key.character);
  } else if (mode_ == Mode::kHistory && (key.code == Code::kEscape || key.code == Code::kEnter)) {
    mode_ = Mode::kTable;
  } else if (key.code == Code::kEnter && has_cursor_) {
    PressCharacter('h');
  } else if (key.code == Code::kEscape) {
    settings_.filter.typed.clear();
    has_cursor_ = false;
  }
}

void ScopeScreen::PressInFilter(const Key& key) {
  std::string& typed = settings_.filter.typed;
  if (key.code == Code::kCharacter && typed.size() < 200) {
    typed += key.character;
  } else if (key.code == Code::kBackspace && !typed.empty()) {
    typed.pop_back();
  } else if (key.code == Code::kEscape) {
    typed = typed_before_;
    mode_ = Mode::kTable;
  } else if (key.code == Code::kEnter) {
    mode_ = Mode::kTable;
  }
  top_ = 0;
}

void ScopeScreen::PressCharacter(char character) {
  switch (character) {
    case 'q':
      wants_to_quit_ = true;
      break;
    case ' ':
      is_paused_ = !is_paused_;
      break;
    case 'h':
      mode_ = mode_ == Mode::kHistory ? Mode::kTable : Mode::kHistory;
      history_top_ = 0;
      break;
    case 's':
      settings_.sort = static_cast<ScopeSort>((static_cast<int>(settings_.sort) + 1) % 4);
      break;
    case 'r':
      is_reversed_ = !is_reversed_;
      break;
    case 'c':
      settings_.filter.changed_only = !settings_.filter.changed_only;
      break;
    case '/':
      if (mode_ == Mode::kTable) {
        typed_before_ = settings_.filter.typed;
        mode_ = Mode::kFilter;
      }
      break;
    default:
      break;
  }
}

void ScopeScreen::Move(const Key& key) {
  if (mode_ == Mode::kHistory) {
    history_top_ = Moved(history_top_, key, page_);
  } else {
    cursor_ = has_cursor_ ? Moved(cursor_, key, page_) : top_;
    has_cursor_ = true;
    has_moved_ = true;
  }
}

/// Keeps the cursor on its variable while the order is one of names; in a list that is sorted by
/// what changes, the cursor stays where it is and variables pass under it.
void ScopeScreen::PlaceCursor(const std::vector<const VariableRow*>& rows, std::size_t lines) {
  const std::size_t last = rows.empty() ? 0 : rows.size() - 1;
  const bool is_steady = settings_.sort == ScopeSort::kName || settings_.sort == ScopeSort::kSource;
  if (has_cursor_ && is_steady && !has_moved_) {
    const auto found = std::ranges::find(rows, chosen_, &VariableRow::name);
    cursor_ = found == rows.end() ? cursor_ : static_cast<std::size_t>(found - rows.begin());
  }
  cursor_ = std::min(cursor_, last);
  has_moved_ = false;
  if (has_cursor_) {
    top_ = std::min(top_, cursor_);
    top_ = std::max(top_, cursor_ + 1 - std::min(cursor_ + 1, lines));
  }
  top_ = std::min(top_, rows.size() - std::min(rows.size(), lines));
  if (!rows.empty()) {
    chosen_ = rows[has_cursor_ ? cursor_ : top_]->name;
  }
}

Frame ScopeScreen::Draw(const VariableTable& table, const ScopeScene& scene, ScreenSize size) {
  Frame frame;
  page_ = size.lines - std::min(size.lines, kAroundRows);
  if (mode_ == Mode::kHistory) {
    DrawHistory(table, scene, size, frame);
  } else {
    const auto rows =
        Arranged(table, settings_.filter, settings_.sort, is_reversed_, scene.moment.now);
    const std::string right = fmt::format("{} of {} variables", rows.size(), table.rows().size());
    frame.push_back(Title(scene, right, size.columns));
    DrawTable(rows, scene, size, frame);
  }
  frame.resize(std::max<std::size_t>(size.lines, 1) - 1);
  frame.push_back(HelpLine(size.columns));
  return frame;
}

void ScopeScreen::DrawTable(const std::vector<const VariableRow*>& rows, const ScopeScene& scene,
                            ScreenSize size, Frame& frame) {
  PlaceCursor(rows, page_);
  const ScopeColumns columns(rows, size.columns, scene.moment.keeps_utf8);
  frame.push_back(columns.Head().FitTo(size.columns));
  for (std::size_t i = top_; i < rows.size() && i < top_ + page_; ++i) {
    FrameLine line = columns.Row(*rows[i], scene.moment).FitTo(size.columns);
    if (has_cursor_ && i == cursor_) {
      line.PaintAll(Ink::kSelected);
    }
    frame.push_back(std::move(line));
  }
  if (rows.empty()) {
    const bool has_any = settings_.filter.typed.empty() && !settings_.filter.changed_only;
    frame.push_back(FrameLine().Add(
        has_any ? "nothing heard yet" : "nothing passes the filter; Esc clears it", Ink::kFaint));
  }
}

void ScopeScreen::DrawHistory(const VariableTable& table, const ScopeScene& scene, ScreenSize size,
                              Frame& frame) {
  const bool keeps = scene.moment.keeps_utf8;
  const VariableRow* row = table.Find(chosen_);
  const std::string name = OneLine(chosen_, 40, keeps);
  if (row == nullptr) {
    frame.push_back(Title(scene, name, size.columns));
    frame.push_back(FrameLine().Add("nothing heard of it yet", Ink::kFaint));
    return;
  }
  const std::size_t count = row->history.size();
  frame.push_back(Title(
      scene,
      fmt::format("{}: {} kept, {} Hz", name, count, ShownRate(row->RateAt(scene.moment.now))),
      size.columns));
  const std::size_t source = std::min<std::size_t>(16, size.columns / 5);
  FrameLine head;
  head.AddNumber("AGE", 6, Ink::kHeader).Add("  ").AddNumber("STEP s", 8, Ink::kHeader).Add("  ");
  frame.push_back(head.AddCell("SOURCE", source, Ink::kHeader)
                      .Add("  ")
                      .Add("T VALUE", Ink::kHeader)
                      .FitTo(size.columns));
  history_top_ = std::min(history_top_, count - std::min(count, page_));
  for (std::size_t i = history_top_; i < count && i < history_top_ + page_; ++i) {
    const std::size_t at = count - 1 - i;  // newest first
    const HeardWrite& write = row->history[at];
    const std::string step =
        at == 0 ? "" : fmt::format("{:.3f}", (write.time - row->history[at - 1].time).value());
    FrameLine line;
    line.AddNumber(ShownAge(scene.moment.now - write.time), 6).Add("  ");
    line.AddNumber(step, 8, Ink::kFaint).Add("  ");
    line.AddCell(OneLine(write.source, kAnyWidth, keeps), source, Ink::kSource).Add("  ");
    line.Add(std::string(1, write.value.type), Ink::kFaint).Add(" ");
    const std::size_t taken = std::min(size.columns, line.columns());
    line.Add(ShownValue(write.value, size.columns - taken, keeps));
    frame.push_back(line.FitTo(size.columns));
  }
}

FrameLine ScopeScreen::Title(const ScopeScene& scene, const std::string& right,
                             std::size_t width) const {
  std::string left =
      fmt::format("{} at {}", OneLine(scene.community, 24, scene.moment.keeps_utf8), scene.place);
  left += scene.moment.warp != 1.0 ? fmt::format("  warp {:g}", scene.moment.warp) : "";
  FrameLine line;
  line.Add(left, Ink::kTitle);
  if (!scene.trouble.empty()) {
    line.Add(" ").Add(fmt::format("NO CONNECTION: {}", OneLine(scene.trouble)), Ink::kBad);
  }
  if (is_paused_) {
    line.Add(" ").Add("PAUSED", Ink::kLate);
  }
  if (scene.lost > 0) {
    line.Add(" ").Add(fmt::format("{} lost here", scene.lost), Ink::kBad);
  }
  const std::size_t taken = line.columns() + 2;
  if (taken + ColumnsOf(right) <= width) {
    line.Add(std::string(width - taken - ColumnsOf(right) + 2, ' ')).Add(right);
  }
  return line.FitTo(width);
}

FrameLine ScopeScreen::HelpLine(std::size_t width) const {
  if (mode_ == Mode::kFilter) {
    return FrameLine()
        .Add("filter: ", Ink::kHeader)
        .Add(settings_.filter.typed + "_")
        .Add("   Enter keep  Esc back", Ink::kFaint)
        .FitTo(width);
  }
  if (mode_ == Mode::kHistory) {
    return FrameLine()
        .Add("q quit  Esc back  space pause  arrows scroll", Ink::kFaint)
        .FitTo(width);
  }
  FrameLine line;
  const ScopeFilter& filter = settings_.filter;
  line.Add("q quit  s sort:", Ink::kFaint)
      .Add(NameOf(settings_.sort) + std::string(is_reversed_ ? " (reversed)" : ""))
      .Add("  r reverse  / filter", Ink::kFaint)
      .Add(filter.typed.empty() ? "" : ":" + filter.typed)
      .Add("  c changed", Ink::kFaint)
      .Add(filter.changed_only ? " only" : "")
      .Add("  space pause  h history", Ink::kFaint);
  return line.FitTo(width);
}

}  // namespace limpet
