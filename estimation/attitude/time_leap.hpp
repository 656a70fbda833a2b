// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// A leap ahead of a sensor's time that one sample alone does not prove [s]: its stamp may be
/// corrupt.
inline constexpr double kTimeLeap = 30.0;
/// Longest time between two samples that prove a leap together [s].
inline constexpr double kLeapAgreement = 1.0;
/// How many samples in a row prove a leap.
inline constexpr int kLeapSamples = 3;

}  // namespace limpet
