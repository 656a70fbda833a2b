// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include "limpet/core/config.hpp"
#include "limpet/core/decimal_text.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

int DecimalsOf(std::string_view key) {
  if (key == "LAT" || key == "LON") {
    return 8;
  }
  return key == "YAW" ? 7 : 2;
}

/// Text that would end a field, or that a brace-wrapped form would swallow, has no place here.
std::string Safe(std::string_view text) {
  std::string safe(text);
  for (char& c : safe) {
    if (c == ',' || c == '=' || static_cast<unsigned char>(c) < ' ') {
      c = '_';
    }
  }
  return safe;
}

class ReportWriter {
 public:
  void operator()(const char* key, const std::string& field) {
    if (!field.empty()) Put(key, Safe(field));
  }
  void operator()(const char* key, double& field) { Put(key, DecimalText(field, DecimalsOf(key))); }
  void operator()(const char* key, std::optional<double>& field) {
    if (field) (*this)(key, *field);
  }
  std::string text;

 private:
  void Put(const char* key, const std::string& value) {
    text += (text.empty() ? "" : ",") + std::string(key) + "=" + value;
  }
};

using Pair = std::pair<std::string, std::string>;

std::string CanonicalKey(std::string_view key) {
  constexpr std::array<std::pair<std::string_view, const char*>, 6> kAliases{
      {{"SPEED", "SPD"},
       {"HEADING", "HDG"},
       {"DEPTH", "DEP"},
       {"LEN", "LENGTH"},
       {"ALT", "ALTITUDE"},
       {"UTC_TIME", "TIME"}}};
  for (const auto& [alias, name] : kAliases) {
    if (EqualsIgnoringCase(key, alias)) return name;
  }
  return std::string(key);
}

class ReportReader {
 public:
  explicit ReportReader(const std::string& text) {
    for (const std::string& part : Split(text, ',')) {
      const std::size_t equals = part.find('=');
      if (equals == std::string::npos) continue;
      pairs_.emplace_back(CanonicalKey(Trim(std::string_view(part).substr(0, equals))),
                          Trim(std::string_view(part).substr(equals + 1)));
    }
  }
  void operator()(const char* key, std::string& field) {
    if (const std::string* value = Find(key)) field = *value;
  }
  void operator()(const char* key, double& field) {
    const std::string* value = Find(key);
    const std::optional<double> number = value != nullptr ? ParseNumber(*value) : std::nullopt;
    is_good = is_good && number;
    field = number.value_or(0.0);
  }
  void operator()(const char* key, std::optional<double>& field) {
    if (const std::string* value = Find(key)) field = ParseNumber(*value);
  }
  bool is_good = true;

 private:
  [[nodiscard]] const std::string* Find(std::string_view key) const {
    for (const Pair& pair : pairs_) {
      if (EqualsIgnoringCase(pair.first, key)) return &pair.second;
    }
    return nullptr;
  }
  std::vector<Pair> pairs_;
};

}  // namespace

Value TopicCodec<NodeReport>::Encode(const NodeReport& report) {
  ReportWriter writer;
  NodeReport copy = report;
  copy.Describe(writer);
  return std::move(writer.text);
}

std::optional<NodeReport> TopicCodec<NodeReport>::Decode(const Value& value) {
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) {
    return std::nullopt;
  }
  ReportReader reader(*text);
  NodeReport report;
  report.Describe(reader);
  const bool is_good = reader.is_good && !report.name.empty();
  return is_good ? std::optional<NodeReport>(std::move(report)) : std::nullopt;
}

}  // namespace limpet
