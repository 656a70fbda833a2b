// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace limpet {

using ByteBuffer = std::vector<std::byte>;
using ByteView = std::span<const std::byte>;

/// What a message is for; the letters of the MOOS V10 protocol. Other letters are legal and
/// ignored.
namespace wire_type {
inline constexpr char kHello = 'i';
inline constexpr char kWelcome = 'W';
inline constexpr char kPoison = 'K';  ///< refused
inline constexpr char kNotify = 'N';
inline constexpr char kRegister = 'R';
inline constexpr char kUnregister = 'U';
inline constexpr char kWildcardRegister = '*';
inline constexpr char kWildcardUnregister = '/';
inline constexpr char kRequest = 'Q';
inline constexpr char kTiming = 'T';
inline constexpr char kNull = '.';
}  // namespace wire_type

/// How a value is to be read.
namespace wire_data {
inline constexpr char kDouble = 'D';
inline constexpr char kString = 'S';
inline constexpr char kBinary = 'B';
inline constexpr char kUnset = '~';  ///< a variable nobody has written yet
}  // namespace wire_data

/// One record of a packet, as views into bytes that someone else owns. Unset numbers are -1.
struct WireMessage {
  std::int32_t id = -1;
  char type = wire_type::kNotify;
  char data_type = wire_data::kDouble;
  std::string_view source = {};
  std::string_view source_aux = {};
  std::string_view community = {};
  std::string_view key = {};
  double time = -1.0;  ///< MOOS time [s]
  double number = -1.0;
  double number2 = -1.0;
  std::string_view text = {};  ///< string or binary value; any bytes
};

}  // namespace limpet
