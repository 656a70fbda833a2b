// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/topics/topic.hpp"

namespace limpet {

/// `value` as its topic says and hears it.
template <class T>
std::optional<T> RoundTrip(const T& value) {
  return TopicCodec<T>::Decode(TopicCodec<T>::Encode(value));
}

}  // namespace limpet
