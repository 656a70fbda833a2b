// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "limpet/core/message.hpp"
#include "limpet/core/record.hpp"

namespace limpet {

/// A variable: its name, its C++ type and, in words, what it means. Constants live in the topics
/// folder, one file per owner; a name that a mission file supplies makes a Topic on the spot.
template <class T>
struct Topic {
  std::string name;
  std::string meaning;
};

/// How a type travels in a Value. Records with Describe travel as `key=value` text; other types
/// specialise this.
template <class T>
struct TopicCodec {
  [[nodiscard]] static Value Encode(const T& value) { return EncodeRecord(value); }
  [[nodiscard]] static std::optional<T> Decode(const Value& value) {
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? DecodeRecord<T>(*text) : std::nullopt;
  }
};

template <>
struct TopicCodec<double> {
  [[nodiscard]] static Value Encode(double value) { return value; }
  [[nodiscard]] static std::optional<double> Decode(const Value& value) {
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? std::optional<double>(*number) : std::nullopt;
  }
};

template <>
struct TopicCodec<std::string> {
  [[nodiscard]] static Value Encode(const std::string& value) { return value; }
  [[nodiscard]] static std::optional<std::string> Decode(const Value& value) {
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? std::optional<std::string>(*text) : std::nullopt;
  }
};

/// MOOS's convention: the words true and false, any case on input.
template <>
struct TopicCodec<bool> {
  [[nodiscard]] static Value Encode(bool value) { return std::string(value ? "true" : "false"); }
  [[nodiscard]] static std::optional<bool> Decode(const Value& value) {
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? ParseFlag(*text) : std::nullopt;
  }
};

/// Declares that `T` travels as JSON text; Encode and Decode are defined in the topic's .cpp, where
/// the JSON library is.
template <class T>
struct JsonCodec {
  [[nodiscard]] static Value Encode(const T& value);
  [[nodiscard]] static std::optional<T> Decode(const Value& value);
};

}  // namespace limpet
