// SPDX-License-Identifier: MIT
#include "limpet/helm/behavior_names.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/word_distance.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

constexpr std::string_view kBehaviorPrefix = "BHV_";

bool IsDigit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }

/// `AvdColregs` of `BHV_AvdColregsV19`.
std::string_view Stem(std::string_view name) {
  if (EqualsIgnoringCase(name.substr(0, kBehaviorPrefix.size()), kBehaviorPrefix)) {
    name.remove_prefix(kBehaviorPrefix.size());
  }
  std::string_view stem = name;
  while (!stem.empty() && IsDigit(stem.back()))
    stem.remove_suffix(1);
  const bool is_version = stem.size() < name.size() && stem.size() > 1 && stem.ends_with('V');
  return is_version ? stem.substr(0, stem.size() - 1) : name;
}

/// Letters of the longest piece that both words have.
std::size_t SharedLetters(std::string_view a, std::string_view b) {
  std::size_t most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      std::size_t run = 0;
      while (i + run < a.size() && j + run < b.size() &&
             EqualsIgnoringCase(a.substr(i + run, 1), b.substr(j + run, 1)))
        ++run;
      most = std::max(most, run);
    }
  }
  return most;
}

/// Share of the letters that are wrong, up to 1. Of unlike words one that shares a word of the name
/// is nearer than one with as many letters: less 1.
double FarnessOf(std::string_view a, std::string_view b) {
  constexpr std::size_t kWord = 5;  // letters
  const std::size_t shared = SharedLetters(a, b);
  const auto longest = static_cast<double>(std::max({a.size(), b.size(), std::size_t{1}}));
  const double distance = static_cast<double>(WordDistance(a, b)) / longest;
  return shared >= kWord ? distance - 1.0 : distance;
}

/// Names farther apart than this nobody would call near.
constexpr double kFarthest = 1.0 / 3.0;

std::string NearestBehavior(std::string_view name) {
  std::vector<std::string> known;
  std::ranges::transform(BehaviorRegistry(), std::back_inserter(known),
                         [](const auto& registered) { return registered.first; });
  if (known.empty()) return "";
  constexpr std::size_t kLongest = 64;  // comparing takes the product of both lengths
  name = name.substr(0, kLongest);
  const auto farness = [stem = Stem(name)](const std::string& other) {
    return FarnessOf(stem, Stem(other));
  };
  const std::string& nearest = *std::ranges::min_element(known, {}, farness);
  return farness(nearest) <= kFarthest ? nearest : "";
}

/// A word of its own begins so: `X`, `V2`, `_deep`.
bool BeginsWord(std::string_view text) {
  return !text.empty() && (text[0] == '_' || IsDigit(text[0]) ||
                           std::isupper(static_cast<unsigned char>(text[0])) != 0);
}

}  // namespace

std::string MisnamedBehavior(std::string_view name) {
  for (const auto& [known, entry] : BehaviorRegistry()) {
    if (name == known) return "";
    const std::string_view bare =
        std::string_view(known).substr(std::min(kBehaviorPrefix.size(), known.size()));
    if (EqualsIgnoringCase(name, known) || EqualsIgnoringCase(name, bare)) return known;
  }
  return "";
}

bool IsVariantOfBehavior(std::string_view name, std::string_view known) {
  if (!name.starts_with(kBehaviorPrefix) || !known.starts_with(kBehaviorPrefix) || name == known)
    return false;
  if (Stem(name) == Stem(known)) return true;
  name.remove_prefix(kBehaviorPrefix.size());
  known.remove_prefix(kBehaviorPrefix.size());
  if (name.starts_with(known)) return BeginsWord(name.substr(known.size()));
  return name.ends_with(known) && BeginsWord(name);
}

std::string NearestBehaviorText(std::string_view name) {
  constexpr std::string_view kAltitude = "BHV_MinAltitudeX";
  if (name == "BHV_MinAltitude" && BehaviorRegistry().contains(std::string(kAltitude))) {
    return fmt::format("it is called `{}`", kAltitude);
  }
  if (const std::string meant = MisnamedBehavior(name); !meant.empty()) {
    return fmt::format("it is called `{}`: case counts, and so does `{}`", meant, kBehaviorPrefix);
  }
  // A short form of a word that is written out here.
  if (EqualsIgnoringCase(Stem(name), "AvdColregs")) name = "BHV_AvoidCollision";
  const std::string nearest = NearestBehavior(name);
  return nearest.empty() ? "none that is known has a name near it"
                         : fmt::format("nearest known: `{}`", nearest);
}

bool IsAskedForDuration(std::string_view name) {
  return name == "BHV_ConstantDepth" || name == "BHV_ConstantHeading" ||
         name == "BHV_ConstantSpeed";
}

}  // namespace limpet
