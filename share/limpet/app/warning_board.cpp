// SPDX-License-Identifier: MIT
#include "limpet/app/warning_board.hpp"

namespace limpet {

WarningBoard::Change WarningBoard::Raise(const WarningId& id, const std::string& text,
                                         Seconds now) {
  const auto [known, is_new] =
      standing_.try_emplace(id.name(), StandingWarning{id.severity(), text, now});
  if (is_new) {
    has_change_ = true;
    return Change::kRaised;
  }
  if (known->second.text == text) {
    return Change::kNone;
  }
  known->second.text = text;
  has_new_text_ = true;
  return Change::kText;
}

bool WarningBoard::Clear(const WarningId& id) {
  const bool stood = standing_.erase(id.name()) > 0;
  has_change_ = has_change_ || stood;
  return stood;
}

std::optional<std::string> WarningBoard::TakeNews(Seconds now) {
  if (!has_change_ && !(has_new_text_ && now - told_ >= text_period_)) {
    return std::nullopt;
  }
  has_change_ = has_new_text_ = false;
  told_ = now;
  return EncodeWarnings(standing_);
}

}  // namespace limpet
