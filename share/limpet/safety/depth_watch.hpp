// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/message.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// For how long the vehicle has been told another depth and has come no nearer to it. Allocates
/// nothing.
class DepthWatch {
 public:
  /// Wanted [m], positive down: as long as it is said again.
  void Want(double depth, Seconds now) { wanted_ = {now, depth}; }
  /// Measured [m], positive down.
  void Hear(double depth, Seconds now);
  /// The vehicle cannot do what is wanted, for another reason: counts anew.
  void Excuse() { begin_.reset(); }
  /// [s]; 0 while it is near, absent while no depth is wanted.
  [[nodiscard]] std::optional<double> lacking_for() const { return lacking_; }

 private:
  /// The moment from which progress is counted.
  struct Begin {
    Seconds at;
    double wanted = 0.0;  ///< [m]
    double off = 0.0;     ///< from it [m]
  };
  std::optional<Stamped<double>> wanted_;
  std::optional<Begin> begin_;
  std::optional<double> lacking_;
};

}  // namespace limpet
