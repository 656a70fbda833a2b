// SPDX-License-Identifier: MIT
// Checked reading of YAML maps, for this library only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/core/params.hpp"

namespace YAML {
class Node;
}

namespace limpet::internal {

/// Reads YAML maps by known keys and collects every problem: unknown or repeated keys, wrong types,
/// values out of range.
class YamlReader {
 public:
  explicit YamlReader(std::string file) : file_(std::move(file)) {}

  /// Gives the text's document to `read`. Throws ConfigError with every problem, `read`'s too.
  void ReadDocument(const std::string& text,
                    const std::function<void(const YAML::Node& root)>& read);
  /// The text's document; a second one, which nobody would read, is a problem. Throws
  /// YAML::Exception.
  [[nodiscard]] YAML::Node OnlyDocument(const std::string& text);

  using Handler = std::function<void(const YAML::Node& value)>;
  struct Field {
    std::string key;
    Handler read;
  };
  /// Calls the handler of each key of `map`; `other` takes unknown keys, which are problems without
  /// it. Keys in problems are shown below `path`, e.g. `seabed.depth_m`.
  void ReadMap(const YAML::Node& map, const std::string& path, const std::vector<Field>& fields,
               const std::function<void(const std::string& key, const YAML::Node&)>& other = {});

  /// Stores a number in range.
  [[nodiscard]] Field Number(const std::string& path, const char* key, double& field,
                             Range<double> range);
  [[nodiscard]] Field Number(const std::string& path, const char* key, std::optional<double>& field,
                             Range<double> range);
  [[nodiscard]] Field Integer(const std::string& path, const char* key, int& field,
                              Range<double> range);
  [[nodiscard]] Field Choice(const std::string& path, const char* key, std::string& field,
                             std::vector<std::string> choices);

  /// A field for each declared key; their values are text to them, a list is `[a, b, c]`.
  [[nodiscard]] std::vector<Field> Declared(const std::string& path,
                                            const std::vector<ParamSpec>& specs);

  /// A finite number, or nothing.
  [[nodiscard]] static std::optional<double> NumberIn(const YAML::Node& node);
  void Complain(const YAML::Node& node, const std::string& key, std::string text);
  void Complain(int line, const std::string& key, std::string text);
  [[nodiscard]] const std::vector<ConfigProblem>& problems() const { return problems_; }

 private:
  std::string file_;
  std::vector<ConfigProblem> problems_;
};

/// A scalar as it stands, a list as `[a, b, c]`.
[[nodiscard]] std::string ValueText(const YAML::Node& node);

/// How a node reads in a complaint.
[[nodiscard]] std::string TextOfNode(const YAML::Node& node);

}  // namespace limpet::internal
