// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/core/expected.hpp"
#include "limpet/core/require.hpp"

namespace limpet {

/// Lower-case words joined by underscores, as a mission file names what is registered.
[[nodiscard]] constexpr bool IsLowerCaseName(std::string_view name) {
  return !name.empty() && name.front() >= 'a' && name.front() <= 'z' &&
         std::ranges::all_of(name, [](char letter) {
           return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') ||
                  letter == '_';
         });
}

/// Factories of one kind of thing by name, as registration lines add them before main.
template <class Factory>
class FactoryRegistry {
 public:
  using Maker = std::function<std::unique_ptr<Factory>()>;

  /// `kind`: what they make, as complaints call one of it.
  explicit FactoryRegistry(std::string kind) : kind_(std::move(kind)) {}

  /// REQUIRES: the name is new.
  void Add(const std::string& name, Maker make) {
    const bool is_new = makers_.emplace(name, std::move(make)).second;
    LIMPET_REQUIRE(is_new, "two " + kind_ + "s are registered as " + name);
  }

  /// Every name, in alphabetical order.
  [[nodiscard]] std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& [name, make] : makers_)
      names.push_back(name);
    return names;
  }

  /// A new factory; for an unknown name the nearest known one is named.
  [[nodiscard]] Expected<std::unique_ptr<Factory>> Find(const std::string& name) const {
    if (const auto found = makers_.find(name); found != makers_.end()) return found->second();
    const std::string nearest = NearestWord(name, Names());
    const std::string advice = nearest.empty() ? "" : "; did you mean `" + nearest + "`?";
    return Error{"no " + kind_ + " `" + name + "`" + advice};
  }

 private:
  std::string kind_;
  std::map<std::string, Maker> makers_;
};

}  // namespace limpet
