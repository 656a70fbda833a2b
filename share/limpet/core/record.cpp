// SPDX-License-Identifier: MIT
#include "limpet/core/record.hpp"

#include "limpet/core/config.hpp"

namespace limpet {
namespace {

/// The first comma that no brace holds.
std::size_t EndOfPart(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '{' ? 1 : 0;
    depth -= text[i] == '}' && depth > 0 ? 1 : 0;
    if (text[i] == ',' && depth == 0) {
      return i;
    }
  }
  // A brace that nothing closes holds nothing.
  return depth == 0 ? std::string_view::npos : text.find(',');
}

}  // namespace

void RecordWriter::Append(const char* name, std::string_view value) {
  if (!text_.empty()) {
    text_ += ',';
  }
  text_ += name;
  text_ += '=';
  text_ += value;
}

RecordReader::RecordReader(std::string_view text) {
  while (!text.empty()) {
    const std::size_t comma = EndOfPart(text);
    const std::string_view part = text.substr(0, comma);
    const std::size_t equals = part.find('=');
    if (equals != std::string_view::npos) {
      pairs_.push_back({Trim(part.substr(0, equals)), Trim(part.substr(equals + 1))});
    }
    text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  }
}

std::optional<std::string_view> RecordReader::Find(std::string_view name) const {
  for (const Pair& pair : pairs_) {
    if (pair.key == name) {
      return pair.value;
    }
  }
  return std::nullopt;
}

void RecordReader::operator()(const char* name, double& field) {
  std::optional<double> value;
  (*this)(name, value);
  is_good_ = is_good_ && value.has_value();
  field = value.value_or(field);
}

void RecordReader::operator()(const char* name, int& field) {
  const auto text = Find(name);
  const auto value = text ? ParseInteger(*text) : std::nullopt;
  is_good_ = is_good_ && value && *value == static_cast<int>(*value);
  if (is_good_) {
    field = static_cast<int>(*value);
  }
}

void RecordReader::operator()(const char* name, bool& field) {
  const auto text = Find(name);
  const auto value = text ? ParseFlag(*text) : std::nullopt;
  is_good_ = is_good_ && value.has_value();
  field = value.value_or(field);
}

void RecordReader::operator()(const char* name, std::string& field) {
  const auto text = Find(name);
  is_good_ = is_good_ && text.has_value();
  if (text) {
    field = std::string(*text);
  }
}

void RecordReader::operator()(const char* name, std::optional<double>& field) {
  field.reset();
  const auto text = Find(name);
  if (text) {
    field = ParseNumber(*text);
    is_good_ = is_good_ && field.has_value();
  }
}

void RecordReader::operator()(const char* name, std::optional<bool>& field) {
  field.reset();
  const auto text = Find(name);
  if (text) {
    field = ParseFlag(*text);
    is_good_ = is_good_ && field.has_value();
  }
}

void RecordReader::operator()(const char* name, std::optional<std::string>& field) {
  field.reset();
  if (const auto text = Find(name)) {
    field = std::string(*text);
  }
}

}  // namespace limpet
