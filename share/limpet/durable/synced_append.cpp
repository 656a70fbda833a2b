// SPDX-License-Identifier: MIT
#include "limpet/durable/synced_append.hpp"

namespace limpet {

bool SyncedAppend::Write(std::string_view bytes, Time now) {
  if (!bytes.empty()) {
    if (!file_.Append(bytes)) {
      return false;
    }
    timer_.NoteWrite();
  }
  if (timer_.IsDue(now)) {
    if (!file_.Sync()) {
      return false;
    }
    timer_.NoteSync(now);
  }
  return true;
}

}  // namespace limpet
