// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"

namespace limpet {

/// One value to be written.
struct Poke {
  std::string name;
  Value value;  ///< a number or a string
};

/// Reads a word as uPokeDB does: `VAR=3` a number if it looks like one, else a string; `VAR:=3` the
/// string as it stands; `VAR="3"` the string between the quotes. The value @MOOSTIME or @UTC is the
/// MOOS time `now`, and inside a longer value its text with two decimals. The name must hold no
/// blank, comma or control character.
[[nodiscard]] Expected<Poke> ParsePoke(std::string_view word, Seconds now);

/// What became of one poke.
struct PokeResult {
  enum class Outcome { kWritten, kRefused };
  Poke poke;
  Outcome outcome = Outcome::kRefused;
  std::optional<Message> before{};  ///< nothing: it had never been written
  std::optional<Message> after{};
};

/// Judges by the mail heard of the variables before and after `name` wrote them: a write that does
/// not come back was refused. Of several pokes of one variable the last counts.
[[nodiscard]] std::vector<PokeResult> PokeResults(const std::vector<Poke>& pokes,
                                                  const std::string& name,
                                                  const std::vector<Message>& before,
                                                  const std::vector<Message>& after);

/// Why a write was refused, and what to do; for a person.
[[nodiscard]] std::string WhyRefused(const PokeResult& result);

}  // namespace limpet
