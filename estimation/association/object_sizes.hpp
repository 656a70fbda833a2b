// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "estimation/smoothing/smoother.hpp"

namespace limpet {

/// Where the smoother keeps an object's size: one of the three numbers of a border variable, the
/// natural logarithm of its share of what is believed of it.
struct SizeSlot {
  int slot = 0;
  int index = 0;
  double believed = 0.0;  ///< natural logarithm of its class's share of the usual radius
};

/// Sizes of the mapped objects, as natural logarithms of their shares of the usual radius.
class ObjectSizes {
 public:
  /// `spread`: 1-sigma of that logarithm; 0 if all are as believed. `smoother` must outlive it.
  ObjectSizes(double spread, Smoother& smoother)
      : stated_spread_(spread), spread_(std::make_shared<double>(spread)), smoother_(&smoother) {}

  /// A place for the size of one more object; nothing if sizes are not in doubt.
  [[nodiscard]] std::optional<SizeSlot> Take(double believed);
  [[nodiscard]] double LogSizeAt(const SizeSlot& size) const {
    return size.believed + smoother_->BorderAt(size.slot)(size.index);
  }
  /// Variance of the size's logarithm; for an object far from the vehicle, what it was when sizes
  /// were last learnt.
  [[nodiscard]] double VarianceOf(const SizeSlot& size) const;
  /// How much sizes differ, from those seen so far; nothing new if these are as many as before.
  void Learn(const std::vector<SizeSlot>& seen);
  /// 1-sigma of the logarithm, as learnt.
  [[nodiscard]] double spread() const { return *spread_; }

 private:
  [[nodiscard]] Eigen::Vector3d Variances(int slot) const;

  double stated_spread_;
  std::shared_ptr<double> spread_;  ///< the priors read it
  std::size_t learnt_from_ = 0;     ///< objects
  /// Variances of the logarithms of each slot's three sizes, as of the last time that sizes were
  /// learnt while it was at hand.
  std::map<int, Eigen::Vector3d> variances_;
  Smoother* smoother_;
  std::optional<SizeSlot> next_;  ///< of the last variable; nothing before the first
};

}  // namespace limpet
