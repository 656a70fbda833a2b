// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// Ids of messages that are no write of a client.
namespace limpet::message_id {

inline constexpr std::int32_t kLatest = -1;  ///< the latest value, sent because somebody registered
inline constexpr std::int32_t kAnswer = -2;  ///< a request of the database, and the answer to it

}  // namespace limpet::message_id
