// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/core/record.hpp"
#include "limpet/topics/variable.hpp"

namespace limpet {

/// A variable: its name, its C++ type and, in words, what it means. Constants live in the topics
/// folder, one file per owner, and come from Declare; a name that a mission file supplies makes a
/// Topic on the spot.
template <class T>
struct Topic {
  std::string name;
  std::string meaning;
  bool is_command = false;  ///< see TopicFacts
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

template <>
struct TopicCodec<Binary> {
  [[nodiscard]] static Value Encode(const Binary& value) { return value; }
  [[nodiscard]] static std::optional<Binary> Decode(const Value& value) {
    const auto* bytes = std::get_if<Binary>(&value);
    return bytes != nullptr ? std::optional<Binary>(*bytes) : std::nullopt;
  }
};

namespace internal {

struct FieldNames {
  template <class T, class... More>
  void operator()(const char* name, const T&, const More&...) {
    names.emplace_back(name);
  }
  std::vector<std::string> names;
};

template <class T>
[[nodiscard]] std::string WireType() {
  if constexpr (std::same_as<T, double>) {
    return "double";
  } else if constexpr (std::same_as<T, std::string>) {
    return "string";
  } else if constexpr (std::same_as<T, bool>) {
    return "string, true or false";
  } else if constexpr (requires(T record, FieldNames visit) { record.Describe(visit); }) {
    return "string, key=value";
  } else if constexpr (std::derived_from<TopicCodec<T>, JsonCodec<T>>) {
    return "string, JSON";
  } else if constexpr (requires { TopicCodec<T>::kWireType; }) {
    return TopicCodec<T>::kWireType;
  } else {
    return "binary";
  }
}

}  // namespace internal

/// A topic that `limpet describe variables` lists. For constants, which are made before main.
template <class T>
[[nodiscard]] Topic<T> Declare(std::string name, std::string meaning, const TopicFacts& facts) {
  internal::FieldNames fields;
  if constexpr (requires(T record) { record.Describe(fields); }) {
    T record;
    record.Describe(fields);
  }
  AddToVariableCatalog({.name = name,
                        .meaning = meaning,
                        .type = internal::WireType<T>(),
                        .fields = std::move(fields.names),
                        .facts = facts});
  return {std::move(name), std::move(meaning), facts.is_command};
}

}  // namespace limpet
