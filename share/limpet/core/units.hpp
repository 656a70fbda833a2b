// SPDX-License-Identifier: MIT
// Quantities at public edges. Inside a calculation use raw doubles in SI and radians.
#pragma once

#include <compare>
#include <numbers>

namespace limpet {

/// A double with a dimension. `Dimension::kSymbol` is the unit in text, and `Dimension::kPerText`
/// the SI value of one text unit (degrees are the only text unit that is not SI).
template <class Dimension>
class Quantity {
 public:
  constexpr Quantity() = default;
  constexpr explicit Quantity(double si) : value_(si) {}

  [[nodiscard]] constexpr double value() const { return value_; }
  [[nodiscard]] constexpr double in_text_unit() const { return value_ / Dimension::kPerText; }
  [[nodiscard]] static constexpr Quantity FromTextUnit(double text) {
    return Quantity(text * Dimension::kPerText);
  }

  constexpr auto operator<=>(const Quantity&) const = default;
  constexpr Quantity operator-() const { return Quantity(-value_); }
  constexpr Quantity& operator+=(Quantity other) {
    value_ += other.value_;
    return *this;
  }
  constexpr Quantity& operator-=(Quantity other) {
    value_ -= other.value_;
    return *this;
  }
  friend constexpr Quantity operator+(Quantity a, Quantity b) {
    return Quantity(a.value_ + b.value_);
  }
  friend constexpr Quantity operator-(Quantity a, Quantity b) {
    return Quantity(a.value_ - b.value_);
  }
  friend constexpr Quantity operator*(Quantity a, double k) { return Quantity(a.value_ * k); }
  friend constexpr Quantity operator*(double k, Quantity a) { return Quantity(k * a.value_); }
  friend constexpr Quantity operator/(Quantity a, double k) { return Quantity(a.value_ / k); }
  friend constexpr double operator/(Quantity a, Quantity b) { return a.value_ / b.value_; }

 private:
  double value_ = 0.0;
};

namespace dimension {
inline constexpr double kDegree = std::numbers::pi / 180.0;
struct Length {
  static constexpr const char* kSymbol = "m";
  static constexpr double kPerText = 1.0;
};
struct Time {
  static constexpr const char* kSymbol = "s";
  static constexpr double kPerText = 1.0;
};
struct Speed {
  static constexpr const char* kSymbol = "mps";
  static constexpr double kPerText = 1.0;
};
struct Frequency {
  static constexpr const char* kSymbol = "hz";
  static constexpr double kPerText = 1.0;
};
struct Force {
  static constexpr const char* kSymbol = "n";
  static constexpr double kPerText = 1.0;
};
struct Mass {
  static constexpr const char* kSymbol = "kg";
  static constexpr double kPerText = 1.0;
};
struct Angle {
  static constexpr const char* kSymbol = "deg";
  static constexpr double kPerText = kDegree;
};
struct AngularRate {
  static constexpr const char* kSymbol = "degps";
  static constexpr double kPerText = kDegree;
};
}  // namespace dimension

using Meters = Quantity<dimension::Length>;
using Seconds = Quantity<dimension::Time>;
using MetersPerSecond = Quantity<dimension::Speed>;
using Hertz = Quantity<dimension::Frequency>;
using Newtons = Quantity<dimension::Force>;
using Kilograms = Quantity<dimension::Mass>;
using Radians = Quantity<dimension::Angle>;
using RadiansPerSecond = Quantity<dimension::AngularRate>;

constexpr Meters operator*(MetersPerSecond v, Seconds t) { return Meters(v.value() * t.value()); }
constexpr Radians operator*(RadiansPerSecond w, Seconds t) {
  return Radians(w.value() * t.value());
}

namespace literals {
constexpr Meters operator""_m(long double v) { return Meters(static_cast<double>(v)); }
constexpr Seconds operator""_s(long double v) { return Seconds(static_cast<double>(v)); }
constexpr MetersPerSecond operator""_mps(long double v) {
  return MetersPerSecond(static_cast<double>(v));
}
constexpr Hertz operator""_hz(long double v) { return Hertz(static_cast<double>(v)); }
constexpr Newtons operator""_n(long double v) { return Newtons(static_cast<double>(v)); }
constexpr Kilograms operator""_kg(long double v) { return Kilograms(static_cast<double>(v)); }
constexpr Radians operator""_deg(long double v) {
  return Radians::FromTextUnit(static_cast<double>(v));
}
constexpr RadiansPerSecond operator""_degps(long double v) {
  return RadiansPerSecond::FromTextUnit(static_cast<double>(v));
}
}  // namespace literals

/// Degrees exist only in text and at the MOOS border.
constexpr double DegreesFromRadians(double radians) { return radians / dimension::kDegree; }
constexpr double RadiansFromDegrees(double degrees) { return degrees * dimension::kDegree; }

}  // namespace limpet
