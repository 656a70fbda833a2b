// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "limpet/app/app.hpp"
#include "limpet/app/mail_journal.hpp"
#include "limpet/app/registry.hpp"

namespace limpet {

/// What became of a life that a power cut, or the death of the whole community, had ended.
struct CutLife {
  std::int64_t messages = 0;
  Seconds end;                                      ///< MOOS time of the last that it heard
  std::map<std::string, StandingWarning> warnings;  ///< that the app has at its end, by id
  std::vector<Message> last_words;                  ///< what it said after all that it had heard
};

/// Leads an app through all that the journal of its cut life holds, gives it `last_mail`, stamped
/// anew, on top, and brings it to an orderly end, at which it saves what it would have saved. What
/// it publishes goes nowhere. Of `context` name, globals and folders count. REQUIRES:
/// entry.replays_mail.
[[nodiscard]] CutLife EndCutLife(const AppEntry& entry, AppContext context,
                                 const ConfigBlock& block, const MailJournal& journal,
                                 std::span<const Message> last_mail = {});

}  // namespace limpet
