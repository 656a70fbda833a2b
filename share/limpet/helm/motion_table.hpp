// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "limpet/helm/motion_domain.hpp"

namespace limpet {

/// A course [rad, in (-pi, pi]], a speed [m/s] and a depth [m] that the helm may choose.
struct MotionPoint {
  double course = 0.0, speed = 0.0, depth = 0.0;
};

/// A preference over several decision variables together: a number in [0, 1] for each of the
/// domain's points, e.g. which courses at which speeds keep clear of an obstacle. Made once, by the
/// behavior's `Start`; filling it anew allocates nothing.
class MotionTable {
 public:
  /// Values of 0 over `variables`. One that the domain lacks is left out: the table is then the
  /// same for all its values, and points have 0 there.
  MotionTable(const MotionDomain& domain, std::span<const MotionVariable> variables);
  MotionTable(const MotionDomain& domain, std::initializer_list<MotionVariable> variables)
      : MotionTable(domain, std::span(variables.begin(), variables.size())) {}

  /// Sets the value of every point to `value(point)`, which must be in [0, 1]: a table with other
  /// numbers is not heard (see `Problem`).
  template <class Function>
  void Fill(const Function& value) {
    unfit_.reset();
    std::size_t next = 0;
    MotionPoint point;
    for (const double course : coordinates_[0]) {
      point.course = course;
      for (const double speed : coordinates_[1]) {
        point.speed = speed;
        for (const double depth : coordinates_[2]) {
          point.depth = depth;
          const double number = value(static_cast<const MotionPoint&>(point));
          if (!(number >= 0.0 && number <= 1.0) && !unfit_) {
            unfit_ = Unfit{point, number};
          }
          values_[next++] = static_cast<float>(number);
        }
      }
    }
  }

  [[nodiscard]] const MotionDomain& domain() const { return domain_; }
  [[nodiscard]] bool Covers(MotionVariable variable) const {
    return coordinates_[IndexOf(variable)].size() > 1;
  }
  /// All values; the later variables run faster.
  [[nodiscard]] std::span<const float> values() const { return values_; }
  /// How far apart in `values` neighbours along a variable are; 0 if the table does not cover it.
  [[nodiscard]] std::size_t stride(MotionVariable variable) const {
    return strides_[IndexOf(variable)];
  }
  /// Why nobody may hear it, or nothing.
  [[nodiscard]] std::optional<std::string> Problem() const;

 private:
  struct Unfit {
    MotionPoint point;
    double value = 0.0;
  };
  MotionDomain domain_;
  std::array<std::vector<double>, 3> coordinates_;  ///< by variable; one 0 if it is not covered
  std::array<std::size_t, 3> strides_{};
  std::vector<float> values_;
  std::optional<Unfit> unfit_;  ///< the first value that is none
};

}  // namespace limpet
