// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Fails as it completes, to see what the helm makes of it: throws, or keeps a processor busy.
/// Parameters are spelled as existing MOOS-IvP missions spell them; docs/everyday.md.
class BHV_TestFailure final : public Behavior {
 public:
  struct Params {
    /// How long it keeps the helm [s of real time]; absent: it throws.
    std::optional<Seconds> burn{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_TestFailure(const Params& params) : params_(params) {}

  void Complete(const VehicleState& state) override;

 private:
  Params params_;
};

}  // namespace limpet
