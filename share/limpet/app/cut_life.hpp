// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "limpet/app/app.hpp"
#include "limpet/app/mail_journal.hpp"
#include "limpet/app/registry.hpp"

namespace limpet {

/// What became of a life that a power cut, or the death of the whole community, had ended.
struct CutLife {
  std::int64_t messages = 0;
  Seconds end;                                      ///< MOOS time of the last that it heard
  std::map<std::string, StandingWarning> warnings;  ///< that the app has at its end, by id
};

/// Leads an app through all that the journal of its cut life holds, and to an orderly end, at
/// which it saves what it would have saved. What it publishes goes nowhere. Of `context` the
/// folders count. REQUIRES: entry.replays_mail.
[[nodiscard]] CutLife EndCutLife(const AppEntry& entry, AppContext context,
                                 const ConfigBlock& block, const MailJournal& journal);

}  // namespace limpet
