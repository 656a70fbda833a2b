// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/change.hpp"

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "limpet/comparison/session_comparison.hpp"

namespace limpet {
namespace {

Command ChangeForm() {
  return {.name = "limpet change",
          .about =
              "What changed from session A to session B, from their saved frames and objects, "
              "as JSON: the vehicle's own judgement, made again. Which objects of B are objects "
              "of A is what B's pNav decided when it flew with A as its former session, else "
              "what it would decide. DIR is a session's run folder or the session folder in "
              "it. Each session is judged with pMap's parameters of the mission that it kept.",
          .options = {{.names = "--session-a",
                       .value = "DIR",
                       .meaning = "the earlier session",
                       .is_required = true},
                      {.names = "--session-b",
                       .value = "DIR",
                       .meaning = "the later session",
                       .is_required = true},
                      {.names = "--mission",
                       .value = "FILE",
                       .meaning = "judge both with pMap's parameters of this .moos file instead"},
                      {.names = "--json", .meaning = "as it always is"}},
          .takes = "--session-a DIR and --session-b DIR",
          .most_words = 0};
}

int PrintComparison(const Arguments& given) {
  const SavedSession a = LoadSavedSession(*given.Find("session-a"), "session A");
  const SavedSession b = LoadSavedSession(*given.Find("session-b"), "session B");
  fmt::print("{}", Json(CompareSessions(a, b, given.Find("mission"))));
  return kOk;
}

}  // namespace

int RunChange(std::span<const std::string> args) {
  return RunCommand(ChangeForm(), args, PrintComparison);
}

}  // namespace limpet
