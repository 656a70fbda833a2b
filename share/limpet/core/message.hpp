// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "limpet/core/units.hpp"

namespace limpet {

using Binary = std::vector<std::byte>;
/// MOOS's three data types, D, S and B, in this order.
using Value = std::variant<double, std::string, Binary>;

/// One write of one variable; the fields of a MOOS message.
struct Message {
  std::string name;
  Value value;
  Seconds time;            ///< MOOS time: seconds since 1970 times warp
  std::string source;      ///< app that wrote it
  std::string source_aux;  ///< which part of the app, e.g. a behavior; no blanks
  std::string community;
  std::int32_t id = -1;
};

/// Messages are immutable once written and shared by all their readers.
using MessagePtr = std::shared_ptr<const Message>;

/// A value with the time of its message.
template <class T>
struct Stamped {
  Seconds time;
  T value;
};

}  // namespace limpet
