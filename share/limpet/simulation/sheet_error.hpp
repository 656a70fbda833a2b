// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"

namespace limpet {

/// How much worse, or better, a sensor is than its data sheet says. What it says of itself with
/// each sample stays the sheet's.
struct SheetErrorParams {
  double noise_factor = 1.0;
  double bias_factor = 1.0;

  template <class V>
  void Describe(V& visit) {
    visit("noise_factor", noise_factor,
          "Errors that differ from sample to sample, over what the vehicle's file says",
          InRange(0.0, 20.0));
    visit("bias_factor", bias_factor,
          "Errors that stay the same over a session, over what the vehicle's file says",
          InRange(0.0, 20.0));
  }
};

}  // namespace limpet
