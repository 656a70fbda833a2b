// SPDX-License-Identifier: MIT
// Flat records as `key=value,key=value` text. A record declares its fields once:
//   template <class V> void Describe(V& visit) { visit("north", north); visit("altitude",
//   altitude); }
// Fields: double, int, bool, std::string (commas only within braces; no '=' before the first
// brace), quantities in the unit of their text, and std::optional of double, bool and std::string
// (absent when unknown). Parameters are declared so, too, and may be fields of a record: what their
// declaration adds, help and range, is for blocks; a record holds any value.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/number_text.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

class RecordWriter {
 public:
  void operator()(const char* name, const double& field) { Append(name, TextOf(field)); }
  void operator()(const char* name, const int& field) { Append(name, std::to_string(field)); }
  void operator()(const char* name, const bool& field) { Append(name, field ? "true" : "false"); }
  void operator()(const char* name, const std::string& field) { Append(name, field); }
  template <class D>
  void operator()(const char* name, const Quantity<D>& field) {
    Append(name, TextOf(field.in_text_unit()));
  }
  void operator()(const char* name, const std::optional<double>& field) {
    if (field) Append(name, TextOf(*field));
  }
  void operator()(const char* name, const std::optional<bool>& field) {
    if (field) (*this)(name, *field);
  }
  void operator()(const char* name, const std::optional<std::string>& field) {
    if (field) Append(name, *field);
  }
  template <class Field, class... More>
  void operator()(const char* name, const Field& field, const char* /*help*/, const More&...) {
    (*this)(name, field);
  }
  [[nodiscard]] std::string& text() { return text_; }

 private:
  void Append(const char* name, std::string_view value);
  std::string text_;
};

/// Reads fields by name; a field that is missing or malformed makes the whole record bad (optional
/// ones may be missing).
class RecordReader {
 public:
  explicit RecordReader(std::string_view text);
  void operator()(const char* name, double& field);
  void operator()(const char* name, int& field);
  void operator()(const char* name, bool& field);
  void operator()(const char* name, std::string& field);
  template <class D>
  void operator()(const char* name, Quantity<D>& field) {
    double text = field.in_text_unit();
    (*this)(name, text);
    field = Quantity<D>::FromTextUnit(text);
  }
  void operator()(const char* name, std::optional<double>& field);
  void operator()(const char* name, std::optional<bool>& field);
  void operator()(const char* name, std::optional<std::string>& field);
  template <class Field, class... More>
  void operator()(const char* name, Field& field, const char* /*help*/, const More&...) {
    (*this)(name, field);
  }
  [[nodiscard]] bool is_good() const { return is_good_; }

 private:
  struct Pair {
    std::string_view key;
    std::string_view value;
  };
  [[nodiscard]] std::optional<std::string_view> Find(std::string_view name) const;
  std::vector<Pair> pairs_;
  bool is_good_ = true;
};

template <class R>
[[nodiscard]] std::string EncodeRecord(const R& record) {
  RecordWriter writer;
  R copy = record;  // Describe is not const, so that one declaration serves reading and writing
  copy.Describe(writer);
  return std::move(writer.text());
}

template <class R>
[[nodiscard]] std::optional<R> DecodeRecord(std::string_view text) {
  RecordReader reader(text);
  R record;
  record.Describe(reader);
  return reader.is_good() ? std::optional<R>(std::move(record)) : std::nullopt;
}

}  // namespace limpet
