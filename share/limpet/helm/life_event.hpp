// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace limpet {

/// A behavior was made or has ended.
struct LifeEvent {
  enum class Kind { kSpawn, kAbort, kDeath };
  Kind kind = Kind::kSpawn;
  std::string name, type;
  std::string seed{};    ///< what it was made from: an update, or helm_startup
  std::string reason{};  ///< why it has ended, if it said so
  bool operator==(const LifeEvent&) const = default;
};

}  // namespace limpet
