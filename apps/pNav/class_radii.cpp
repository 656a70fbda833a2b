// SPDX-License-Identifier: MIT
#include "apps/pNav/class_radii.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {

Expected<std::map<std::string, double>> ParseClassRadii(std::string_view text) {
  constexpr double kLargest_m = 20.0;
  std::map<std::string, double> radii;
  if (EqualsIgnoringCase(Trim(text), "none")) return radii;
  for (const std::string& part : Split(text, ',')) {
    const auto colon = part.rfind(':');
    const std::string name(Trim(part.substr(0, colon)));
    const std::optional<double> radius =
        colon == std::string::npos ? std::nullopt : ParseNumber(Trim(part.substr(colon + 1)));
    if (name.empty() || !radius || !(*radius > 0.0) || *radius > kLargest_m) {
      return Error{
          fmt::format("`{}` is no class and its radius, as in yellow:0.5 (above 0, up to {:g} m)",
                      Trim(part), kLargest_m)};
    }
    if (!radii.emplace(name, *radius).second)
      return Error{fmt::format("the class `{}` stands there twice", name)};
  }
  return radii;
}

}  // namespace limpet
