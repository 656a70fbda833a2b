// SPDX-License-Identifier: MIT
#include "limpet/console/community_status.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/console/shown_text.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/letter_case.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr const char* kLauncher = "pLaunch";

std::size_t CountNames(std::string_view list) {
  const std::vector<std::string> names = Split(list, ',');
  return static_cast<std::size_t>(
      std::ranges::count_if(names, [](const std::string& name) { return !Trim(name).empty(); }));
}

bool IsDatabase(const LaunchEntry& entry) {
  return entry.binary == "MOOSDB" || entry.binary == "LimpetDB";
}

std::string NoteOf(const ProcessRow& row) {
  std::string note;
  if (row.launch && row.launch->state != "running") {
    note =
        row.launch->state == "given_up" ? "given up by pLaunch" : "pLaunch: " + row.launch->state;
  }
  if (row.launch && !row.launch->last.empty()) {
    note += (note.empty() ? "it " : "; it ") + row.launch->last;
  }
  if (!row.warnings.empty()) {
    note += (note.empty() ? "" : "; ") + row.warnings;
  }
  return note;
}

}  // namespace

std::map<std::string, LaunchWord> ParseLaunchStatus(std::string_view text) {
  std::map<std::string, LaunchWord> words;
  for (const std::string& part : Split(text, '#')) {
    std::string name;
    LaunchWord word;
    for (const std::string& field : Split(part, ',')) {
      const std::size_t equals = std::min(field.find('='), field.size());
      const std::string key(Trim(std::string_view(field).substr(0, equals)));
      const std::string value(
          Trim(std::string_view(field).substr(std::min(equals + 1, field.size()))));
      if (key == "app") {
        name = value;
      } else if (key == "state") {
        word.state = value;
      } else if (key == "restarts") {
        word.restarts = value;
      } else if (key == "last") {
        word.last = value;
      } else if (key == "database") {
        word.is_database = value == "true";
      }
    }
    if (!name.empty() && !word.state.empty()) {
      words[name] = word;
    }
  }
  return words;
}

void CommunityStatus::Expect(const MissionFile& mission) {
  for (const LaunchEntry& entry : mission.launches) {
    if (!IsDatabase(entry)) {
      expected_.push_back(entry.moos_name);
    }
  }
}

void CommunityStatus::Hear(const Message& message) {
  if (const auto* number = std::get_if<double>(&message.value)) {
    if (message.name == "DB_UPTIME") {
      uptime_ = Seconds(*number);
    }
    return;
  }
  const auto* text = std::get_if<std::string>(&message.value);
  if (text == nullptr) {
    return;
  }
  if (message.name == "PROC_SUMMARY") {
    HearProcess(*text);
  } else if (message.name == "DB_QOS") {
    HearQuality(*text);
  } else if (message.name == "DB_DROPPED") {
    dropped_ = *text;
  } else if (message.name == "DB_REFUSED") {
    refused_ = *text;
  } else if (message.name == "PLAUNCH_STATUS") {
    launched_ = ParseLaunchStatus(*text);
  } else if (message.name.ends_with("_WARNINGS")) {
    health_[message.name] = *text == "none" ? "" : *text;
  } else if (message.name.ends_with("_STATUS") &&
             text->find("AppErrorFlag=true") != std::string::npos) {
    health_[message.name] = "reports an error";
  }
}

/// `name:SUBSCRIBED=,A,B,PUBLISHED=,C`
void CommunityStatus::HearProcess(std::string_view summary) {
  constexpr std::string_view kReads = ":SUBSCRIBED=";
  constexpr std::string_view kWrites = "PUBLISHED=";
  const std::size_t reads = summary.find(kReads);
  const std::size_t writes = summary.rfind(kWrites);
  if (reads == std::string_view::npos || writes == std::string_view::npos || writes < reads) {
    return;
  }
  const std::size_t begin = reads + kReads.size();
  present_[std::string(summary.substr(0, reads))] = {
      .reads = CountNames(summary.substr(begin, writes - std::min(begin, writes))),
      .writes = CountNames(summary.substr(writes + kWrites.size()))};
}

/// `name=recent:max:min:mean,...` [ms]
void CommunityStatus::HearQuality(std::string_view text) {
  for (const std::string& part : Split(text, ',')) {
    const std::size_t equals = part.rfind('=');
    if (equals == std::string::npos) {
      continue;
    }
    const std::string numbers = part.substr(equals + 1);
    if (const auto recent = ParseNumber(numbers.substr(0, numbers.find(':')))) {
      delays_[part.substr(0, equals)] = *recent;
    }
  }
}

std::vector<std::string> CommunityStatus::Expected() const {
  std::vector<std::string> names = expected_;
  // The last word of a launcher that has gone is no word.
  if (present_.contains(kLauncher)) {
    for (const auto& [name, word] : launched_) {
      if (std::ranges::find(names, name) == names.end() && !word.is_database) {
        names.push_back(name);
      }
    }
  }
  return names;
}

ProcessRow CommunityStatus::RowOf(const std::string& name) const {
  ProcessRow row{.name = name};
  if (const auto found = present_.find(name); found != present_.end()) {
    row.is_present = true;
    row.reads = found->second.reads;
    row.writes = found->second.writes;
  }
  if (const auto found = delays_.find(name); found != delays_.end()) {
    row.delay_ms = found->second;
  }
  if (const auto found = launched_.find(name);
      found != launched_.end() && present_.contains(kLauncher)) {
    row.launch = found->second;
  }
  for (const char* kind : {"_WARNINGS", "_STATUS"}) {
    const auto found = health_.find(UpperCase(name) + kind);
    if (row.is_present && found != health_.end() && !found->second.empty()) {
      row.warnings += (row.warnings.empty() ? "" : "; ") + found->second;
    }
  }
  return row;
}

std::vector<ProcessRow> CommunityStatus::Rows() const {
  std::vector<ProcessRow> rows;
  const std::vector<std::string> expected = Expected();
  for (const std::string& name : expected) {
    rows.push_back(RowOf(name));
    rows.back().is_expected = true;
  }
  for (const auto& [name, traffic] : present_) {
    if (name != ignored_ && std::ranges::find(expected, name) == expected.end()) {
      rows.push_back(RowOf(name));
    }
  }
  return rows;
}

std::vector<std::string> CommunityStatus::Losses() const {
  std::vector<std::string> lines;
  const auto add = [&lines](const char* what, const std::string& counts) {
    std::string told;
    for (const std::string& count : Split(counts, ',')) {
      if (!Trim(count).empty() && !count.ends_with("=0")) {
        told += (told.empty() ? "" : ", ") + count;
      }
    }
    if (!told.empty()) {
      lines.push_back(fmt::format("{}: {}", what, told));
    }
  };
  add("mail lost by slow readers", dropped_);
  add("refused by the database", refused_);
  return lines;
}

Frame StatusTable(const std::vector<ProcessRow>& rows) {
  TextTable table({"PROCESS", "STATE", "READS", "WRITES", "DELAY ms", "RESTARTS", "NOTE"});
  for (const ProcessRow& row : rows) {
    const char* state = !row.is_present ? "AWOL" : row.is_expected ? "up" : "guest";
    const auto if_present = [&row](const std::string& text) { return row.is_present ? text : "-"; };
    const std::string delay = row.delay_ms ? fmt::format("{:.1f}", *row.delay_ms) : "-";
    const bool is_bad = !row.is_present;
    table.Add({{OneLine(row.name, 40), is_bad ? Ink::kBad : Ink::kPlain},
               {state, is_bad            ? Ink::kBad
                       : row.is_expected ? Ink::kGood
                                         : Ink::kFaint},
               {if_present(fmt::format("{}", row.reads))},
               {if_present(fmt::format("{}", row.writes))},
               {if_present(delay)},
               {row.launch ? OneLine(row.launch->restarts, 8) : "-"},
               {OneLine(NoteOf(row), 400), Ink::kLate}});
  }
  return table.Lines();
}

std::vector<std::string> MissingOf(const std::vector<ProcessRow>& rows) {
  std::vector<std::string> names;
  for (const ProcessRow& row : rows) {
    if (row.is_expected && !row.is_present) {
      names.push_back(row.name);
    }
  }
  return names;
}

}  // namespace limpet
