// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// A leap ahead of a sensor's time that one sample alone does not prove [s]: its stamp may be
/// corrupt.
inline constexpr double kTimeLeap = 30.0;
/// Between samples that prove it together [s].
inline constexpr double kLeapAgreement = 1.0;
/// So many of them in a row prove it.
inline constexpr int kLeapSamples = 3;

}  // namespace limpet
