// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "limpet/core/require.hpp"

namespace limpet {

/// What went wrong, in words for a person.
struct Error {
  std::string text;
};

/// A value, or why there is none. `std::expected` is not in GCC 12.
template <class T, class E = Error>
class [[nodiscard]] Expected {
 public:
  Expected(T value)
      : state_(std::in_place_index<0>, std::move(value)) {}  // NOLINT(google-explicit-constructor)
  Expected(E error)
      : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool has_value() const { return state_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  /// REQUIRES: has_value().
  [[nodiscard]] const T& operator*() const& { return Value(); }
  [[nodiscard]] T& operator*() & { return MutableValue(); }
  [[nodiscard]] T&& operator*() && { return std::move(MutableValue()); }
  [[nodiscard]] const T* operator->() const { return &Value(); }
  [[nodiscard]] T* operator->() { return &MutableValue(); }
  /// REQUIRES: !has_value().
  [[nodiscard]] const E& error() const {
    LIMPET_REQUIRE(!has_value(), "error() of a value");
    return std::get<1>(state_);
  }

 private:
  [[nodiscard]] const T& Value() const {
    LIMPET_REQUIRE(has_value(), "value of an error");
    return std::get<0>(state_);
  }
  [[nodiscard]] T& MutableValue() {
    LIMPET_REQUIRE(has_value(), "value of an error");
    return std::get<0>(state_);
  }
  std::variant<T, E> state_;
};

}  // namespace limpet
