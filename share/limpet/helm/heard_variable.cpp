// SPDX-License-Identifier: MIT
#include "limpet/helm/heard_variable.hpp"

#include <cstddef>

namespace limpet {

void HeardVariable::Hear(Stamped<Value> mail) {
  // A helm that is parked hears on and iterates no more.
  constexpr std::size_t kMostRecent = 256;
  if (recent_.size() == kMostRecent) {
    recent_.erase(recent_.begin(), recent_.begin() + kMostRecent / 2);
  }
  recent_.push_back(mail);
  last_ = std::move(mail);
}

}  // namespace limpet
