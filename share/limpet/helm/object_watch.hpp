// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/helm/look_ledger.hpp"
#include "limpet/helm/situation.hpp"
#include "limpet/survey/survey_grid.hpp"

namespace limpet {

/// The objects of MAP_OPIS as the helm weighs them: from where a pass at survey altitude would look
/// at each (by the map's own model, MAP_LOOK), and how many such passes told nothing.
class ObjectWatch {
 public:
  /// Paths are followed to within `allowance`.
  ObjectWatch(Meters survey_altitude, Meters allowance)
      : altitude_(survey_altitude.value()), allowance_(allowance.value()) {}

  void SetModel(const MapLook& look) { model_ = ToLookModel(look); }
  void SetBeliefs(const std::vector<OpiBelief>& beliefs);
  [[nodiscard]] const std::vector<OpiBelief>& beliefs() const { return beliefs_; }
  [[nodiscard]] LookLedger& ledger() { return ledger_; }

  /// `grid` (may be null) knows the seabed where it has been seen; elsewhere it is taken to be as
  /// deep as below the vehicle, `seabed_down` [m].
  [[nodiscard]] std::vector<WatchedObject> Objects(const SurveyGrid* grid,
                                                   std::optional<double> seabed_down) const;

 private:
  [[nodiscard]] std::optional<LookWindow> WindowOf(const OpiBelief& belief,
                                                   std::optional<double> seabed_down) const;

  double altitude_, allowance_;
  std::optional<LookModel> model_;
  std::vector<OpiBelief> beliefs_;
  LookLedger ledger_;
};

}  // namespace limpet
