// SPDX-License-Identifier: MIT
#include "limpet/mission/yaml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "limpet/core/number_text.hpp"

namespace limpet::internal {
namespace {

std::string RangeText(const Range<double>& range) {
  if (range.low && range.high) {
    return fmt::format("{} to {}", TextOf(*range.low), TextOf(*range.high));
  }
  return range.low ? fmt::format("at least {}", TextOf(*range.low)) : "a number";
}

bool IsInside(double value, const Range<double>& range) {
  return (!range.low || value >= *range.low) && (!range.high || value <= *range.high);
}

std::string PathOf(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

int LineOf(const YAML::Node& node) { return std::max(node.Mark().line + 1, 0); }

/// The line `---` behind which another document has something to say; the library's own reading of
/// several documents does not end for some damaged ones.
std::optional<int> LineOfSecondDocument(const std::string& text) {
  std::optional<int> mark;
  bool has_content = false;
  int number = 0;
  for (const std::string& line : Split(text, '\n')) {
    ++number;
    const std::string_view said = Trim(line);
    const bool is_mark =
        line.starts_with("---") && (line.size() == 3 || line[3] == ' ' || line[3] == '\r');
    if (is_mark) {
      if (has_content && !mark) mark = number;
      if (mark && said.size() > 3) return mark;
    } else if (!said.empty() && !said.starts_with('#') && said != "...") {
      if (mark) return mark;
      has_content = true;
    }
  }
  return std::nullopt;
}

}  // namespace

std::string TextOfNode(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Scalar:
      return "`" + node.Scalar() + "`";
    case YAML::NodeType::Sequence:
      return fmt::format("a list of {}", node.size());
    case YAML::NodeType::Map:
      return "a map";
    default:
      return "nothing";
  }
}

std::string ValueText(const YAML::Node& node) {
  if (!node.IsSequence()) return node.IsScalar() ? node.Scalar() : TextOfNode(node);
  std::vector<std::string> parts;
  for (const YAML::Node& part : node) {
    parts.push_back(part.IsScalar() ? part.Scalar() : TextOfNode(part));
  }
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

void YamlReader::Complain(int line, const std::string& key, std::string text) {
  problems_.push_back({{file_, line}, key, std::move(text)});
}

void YamlReader::Complain(const YAML::Node& node, const std::string& key, std::string text) {
  Complain(LineOf(node), key, std::move(text));
}

void YamlReader::ReadMap(
    const YAML::Node& map, const std::string& path, const std::vector<Field>& fields,
    const std::function<void(const std::string& key, const YAML::Node&)>& other) {
  if (!map.IsMap()) {
    Complain(map, path, fmt::format("{} is not allowed; allowed: a map", TextOfNode(map)));
    return;
  }
  std::vector<std::string> known;
  std::ranges::transform(fields, std::back_inserter(known), &Field::key);
  std::set<std::string> seen;
  for (const auto& pair : map) {
    if (!pair.first.IsScalar()) {
      Complain(pair.first, path, "a key must be a word");
      continue;
    }
    const std::string& key = pair.first.Scalar();
    const auto field = std::ranges::find(fields, key, &Field::key);
    if (!seen.insert(key).second) {
      Complain(pair.first, PathOf(path, key), "is given twice");
    } else if (field != fields.end()) {
      field->read(pair.second);
    } else if (other) {
      other(key, pair.second);
    } else {
      const std::string nearest = NearestWord(key, known);
      Complain(pair.first, PathOf(path, key),
               fmt::format("unknown key; {}", nearest.empty()
                                                  ? fmt::format("known: {}", fmt::join(known, ", "))
                                                  : fmt::format("did you mean `{}`?", nearest)));
    }
  }
}

std::vector<YamlReader::Field> YamlReader::Declared(const std::string& path,
                                                    const std::vector<ParamSpec>& specs) {
  std::vector<Field> fields;
  fields.reserve(specs.size());
  for (const ParamSpec& spec : specs) {
    fields.push_back({spec.name, [this, path, spec](const YAML::Node& node) {
                        if (auto complaint = spec.set(ValueText(node))) {
                          Complain(node, PathOf(path, spec.name), *std::move(complaint));
                        }
                      }});
  }
  return fields;
}

std::optional<double> YamlReader::NumberIn(const YAML::Node& node) {
  return node.IsScalar() ? ParseNumber(node.Scalar()) : std::nullopt;
}

YamlReader::Field YamlReader::Number(const std::string& path, const char* key, double& field,
                                     Range<double> range) {
  return {key, [this, path, key, &field, range](const YAML::Node& node) {
            std::optional<double> value;
            Number(path, key, value, range).read(node);
            field = value.value_or(field);
          }};
}

YamlReader::Field YamlReader::Number(const std::string& path, const char* key,
                                     std::optional<double>& field, Range<double> range) {
  return {key, [this, path, key, &field, range](const YAML::Node& node) {
            const std::optional<double> value = NumberIn(node);
            if (value && IsInside(*value, range)) {
              field = *value;
            } else {
              Complain(node, PathOf(path, key),
                       fmt::format("{} is not allowed; allowed: {}", TextOfNode(node),
                                   RangeText(range)));
            }
          }};
}

YamlReader::Field YamlReader::Integer(const std::string& path, const char* key, int& field,
                                      Range<double> range) {
  return {key, [this, path, key, &field, range](const YAML::Node& node) {
            const std::optional<double> value = NumberIn(node);
            if (value && IsInside(*value, range) && *value == std::floor(*value)) {
              field = static_cast<int>(*value);
            } else {
              Complain(node, PathOf(path, key),
                       fmt::format("{} is not allowed; allowed: a whole number, {}",
                                   TextOfNode(node), RangeText(range)));
            }
          }};
}

YAML::Node YamlReader::OnlyDocument(const std::string& text) {
  if (const std::optional<int> line = LineOfSecondDocument(text)) {
    Complain(*line, "", "a second document (behind a line `---`), which is not read");
  }
  return YAML::Load(text);
}

void YamlReader::ReadDocument(const std::string& text,
                              const std::function<void(const YAML::Node& root)>& read) {
  try {
    read(OnlyDocument(text));
  } catch (const YAML::Exception& error) {
    Complain(error.mark.line + 1, "", "not YAML: " + error.msg);
  }
  if (!problems_.empty()) throw ConfigError(problems_);
}

YamlReader::Field YamlReader::Choice(const std::string& path, const char* key, std::string& field,
                                     std::vector<std::string> choices) {
  return {key, [this, path, key, &field, choices = std::move(choices)](const YAML::Node& node) {
            if (node.IsScalar() && std::ranges::find(choices, node.Scalar()) != choices.end()) {
              field = node.Scalar();
              return;
            }
            const std::string nearest =
                node.IsScalar() ? NearestWord(node.Scalar(), choices) : std::string();
            Complain(node, PathOf(path, key),
                     fmt::format("{} is not allowed; allowed: {}{}", TextOfNode(node),
                                 fmt::join(choices, ", "),
                                 nearest.empty() ? "" : "; did you mean `" + nearest + "`?"));
          }};
}

}  // namespace limpet::internal
