// SPDX-License-Identifier: MIT
#include "behaviors/BHV_TestFailure.hpp"

#include <stdexcept>
#include <string_view>

#include "limpet/core/clock.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

/// `crash`, `burn` or `hang`, with seconds after a comma.
bool ReadFailure(std::string_view text, std::optional<Seconds>& burn) {
  constexpr double kUsual = 3.0, kMost = 3600.0;  // [s]
  const std::size_t comma = text.find(',');
  const std::string_view kind = Trim(text.substr(0, comma));
  burn.reset();
  if (EqualsIgnoringCase(kind, "crash")) return comma == std::string_view::npos;
  if (!EqualsIgnoringCase(kind, "burn") && !EqualsIgnoringCase(kind, "hang")) return false;
  burn = Seconds(kUsual);
  if (comma == std::string_view::npos) return true;
  const auto seconds = ParseNumber(Trim(text.substr(comma + 1)));
  if (!seconds || *seconds < 0.0 || *seconds > kMost) return false;
  burn = Seconds(*seconds);
  return true;
}

}  // namespace

void BHV_TestFailure::Params::Describe(ParamCollector& visit) {
  visit.Parsed("failure_type",
               "crash, burn or hang; burn and hang with seconds: burn,3 (0 to 3600)",
               "What it does as it completes: throw, or keep the helm for so much real time",
               "crash", [this](std::string_view text) { return ReadFailure(text, burn); });
}

void BHV_TestFailure::Complete(const VehicleState&) {
  if (!params_.burn) throw std::runtime_error("failure_type = crash");
  const Seconds begin = SteadyTime();
  while (SteadyTime() - begin < *params_.burn) {
  }
}

LIMPET_REGISTER_BEHAVIOR(BHV_TestFailure);

}  // namespace limpet
