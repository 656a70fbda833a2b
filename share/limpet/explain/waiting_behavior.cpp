// SPDX-License-Identifier: MIT
#include "limpet/explain/waiting_behavior.hpp"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

/// What stands between `key` and the first of `ends` after it, or the text's end. A condition may
/// have commas of its own.
std::string Between(std::string_view text, std::string_view key,
                    std::initializer_list<std::string_view> ends) {
  const std::size_t begin = text.find(key);
  if (begin == std::string_view::npos) return "";
  text.remove_prefix(begin + key.size());
  std::size_t end = text.size();
  for (const std::string_view mark : ends)
    end = std::min(end, text.find(mark));
  return std::string(text.substr(0, end));
}

}  // namespace

void WaitingBehaviors::Take(std::string_view variable, std::string_view value, double time) {
  // A log's entries may be a little out of order: what was written before counts as before.
  const double now = words_.empty() ? time : std::max(time, words_.back().time);
  if (variable == topics::kHelmRestarted.name) {
    words_.push_back({.time = now, .name = {}, .waits = false, .waiting = {}});
  }
  if (variable != topics::kBehaviorStatus.name || !value.starts_with("name=")) return;
  Word word{.time = now,
            .name = Between(value, "name=", {",pc=", ",pwt=", ",state="}),
            .waits = false,
            .waiting = {}};
  const std::string state = Between(value, ",state=", {",updates="});
  word.waits = state == "idle" || state == "completed";
  word.waiting = {.name = word.name,
                  .what = Between(value, ",pc=", {",pwt=", ",state="}),
                  .since = now,
                  .is_done = state == "completed"};
  if (!word.name.empty()) words_.push_back(std::move(word));
}

std::vector<WaitingBehavior> WaitingBehaviors::At(double time) const {
  std::vector<const Word*> last;
  for (const Word& word : words_) {
    if (word.time > time) break;
    if (word.name.empty()) {
      last.clear();
      continue;
    }
    const auto known = std::ranges::find(last, word.name, &Word::name);
    if (known == last.end()) {
      last.push_back(&word);
    } else {
      *known = &word;
    }
  }
  std::vector<WaitingBehavior> waiting;
  for (const Word* word : last) {
    if (word->waits) waiting.push_back(word->waiting);
  }
  return waiting;
}

}  // namespace limpet
