// SPDX-License-Identifier: MIT
#include "apps/pHelm/led_answers.hpp"

#include <fmt/format.h>

namespace limpet {
namespace {

/// The text behind `key=` up to the next comma; the value of `val` may have commas and comes last.
std::string FieldOf(const std::string& result, const std::string& key) {
  const std::string head = "," + key + "=";
  const std::string whole = "," + result;
  const std::size_t at = whole.find(head);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + head.size();
  return whole.substr(begin, whole.find(',', begin) - begin);
}

}  // namespace

void LedAnswers::Sent(const std::string& variable, Seconds now) {
  Line& line = lines_[variable];
  line.unanswered_since = line.unanswered_since.value_or(now);
}

void LedAnswers::Hear(const std::string& result) {
  const auto line = lines_.find(FieldOf(result, "var"));
  if (line == lines_.end()) return;  // somebody else's update
  line->second.unanswered_since.reset();
  const bool is_refused = FieldOf(result, "result") == "param_error";
  line->second.refusal = is_refused ? fmt::format("its behavior {} does not take {}",
                                                  FieldOf(result, "bhv"), line->first)
                                    : "";
}

std::optional<std::string> LedAnswers::Complaint(Seconds now) const {
  constexpr Seconds kPatience(10.0);
  std::string text;
  for (const auto& [variable, line] : lines_) {
    const auto add = [&text](const std::string& complaint) {
      text += (text.empty() ? "" : "; ") + complaint;
    };
    if (!line.refusal.empty()) add(line.refusal);
    if (line.unanswered_since && now - *line.unanswered_since > kPatience) {
      add(fmt::format("nobody answers to {}", variable));
    }
  }
  return text.empty() ? std::nullopt : std::optional(text);
}

}  // namespace limpet
