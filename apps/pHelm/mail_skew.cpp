// SPDX-License-Identifier: MIT
#include "apps/pHelm/mail_skew.hpp"

#include <cmath>

#include <fmt/format.h>

namespace limpet {

std::optional<std::string> MailSkew::Refuse(const std::string& variable, Seconds stamp,
                                            Seconds now) {
  if (!limit_) return std::nullopt;
  const Seconds skew = now - stamp;
  const auto begun = begun_.find(variable);
  const bool is_young = begun != begun_.end() && now - begun->second <= *limit_;
  const bool is_old_value = is_young && skew > Seconds(0.0);
  if (is_old_value || std::abs(skew.value()) <= limit_->value()) {
    refused_.erase(variable);
    return std::nullopt;
  }
  refused_.insert_or_assign(variable, skew);
  return fmt::format("{} of {:.1f} s {}", variable, std::abs(skew.value()),
                     skew > Seconds(0.0) ? "ago" : "ahead");
}

}  // namespace limpet
