// SPDX-License-Identifier: MIT
#include "limpet/helm/flag_macros.hpp"

#include <bit>
#include <cstdint>

#include <fmt/format.h>

#include "limpet/core/decimal_text.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

/// Letters and digits that another time, behavior or use makes others of.
std::string HashOf(std::uint64_t bits, int length) {
  constexpr std::string_view kLetters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  std::string text;
  for (int i = 0; i < length; ++i) {
    text += kLetters[bits % kLetters.size()];
    bits /= kLetters.size();
  }
  return text;
}

/// The digit after `stem`, `otherwise` for the stem alone; nothing for any other name.
std::optional<int> DigitAfter(std::string_view name, std::string_view stem, int otherwise) {
  if (!name.starts_with(stem)) return std::nullopt;
  const std::string_view rest = name.substr(stem.size());
  if (rest.empty()) return otherwise;
  if (rest.size() != 1 || rest[0] < '0' || rest[0] > '9') return std::nullopt;
  return rest[0] - '0';
}

std::optional<std::string> OfVehicle(std::string_view name, const VehicleState& state) {
  if (name == "OWNSHIP") return std::string(state.ownship);
  if (name == "UTC") return MacroNumber(state.now.value());
  if (name == "OSX") return MacroNumber(state.nav.east);
  if (name == "OSY") return MacroNumber(state.nav.north);
  if (name == "OSH") return MacroNumber(MoosHeadingFromYaw(state.nav.yaw));
  if (name == "OSV") return MacroNumber(state.speed());
  return std::nullopt;
}

}  // namespace

std::string MacroNumber(double value) {
  constexpr int kDecimals = 4;
  return DecimalText(value, kDecimals);
}

std::optional<std::string> FlagMacros::Expand(std::string_view name, const FlagOwner& owner,
                                              const VehicleState& state) {
  if (name == "BHVNAME") return owner.name;
  if (name == "BHVTYPE") return owner.type;
  if (name == "PWT") return MacroNumber(owner.weight);
  if (name == "DUR_RUN_TIME") return MacroNumber(owner.clock.running().value());
  if (name == "DUR_IDLE_TIME") return MacroNumber(owner.clock.idle().value());
  if (name == "NOW") {
    first_now_ = first_now_.value_or(state.now);
    return MacroNumber((state.now - *first_now_).value());
  }
  if (const auto digit = DigitAfter(name, "CTR", 0); digit && *digit < 6) {
    return fmt::format("{}", ++counters_.at(static_cast<std::size_t>(*digit)));
  }
  constexpr int kUsualLength = 6;
  if (const auto length = DigitAfter(name, "HASH", kUsualLength); length && *length >= 2) {
    const auto time = std::bit_cast<std::uint64_t>(state.now.value());
    return HashOf(MixSeed(time + ++hashes_, owner.name), *length);
  }
  if (auto text = OfVehicle(name, state)) return text;
  return owner.behavior.Macro(name, state);
}

}  // namespace limpet
