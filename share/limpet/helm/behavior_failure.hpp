// SPDX-License-Identifier: MIT
// A behavior may be anybody's code: what it throws goes no further than the one call.
#pragma once

#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace limpet {

/// A behavior that could not be heard, and why.
struct BehaviorFailure {
  std::string owner;
  std::string text;
  bool operator==(const BehaviorFailure&) const = default;
};

/// Runs `work`, which calls the behavior `owner`. Nothing, or what it threw.
template <class Work>
[[nodiscard]] std::optional<BehaviorFailure> FailureOf(const std::string& owner, const Work& work) {
  try {
    work();
    return std::nullopt;
  } catch (const std::exception& error) {
    return BehaviorFailure{owner, std::string("it has thrown: ") + error.what()};
  } catch (...) {
    return BehaviorFailure{owner, "it has thrown what is no exception of C++"};
  }
}

/// Runs `work`, which calls the behavior `owner`; what it threw goes to `failures`. True if it
/// threw nothing.
template <class Work>
bool Heard(const std::string& owner, std::vector<BehaviorFailure>& failures, const Work& work) {
  std::optional<BehaviorFailure> failure = FailureOf(owner, work);
  if (!failure) return true;
  failures.push_back(*std::move(failure));
  return false;
}

}  // namespace limpet
