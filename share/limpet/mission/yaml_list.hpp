// SPDX-License-Identifier: MIT
// Lists of scenario.yaml whose elements have names, for this library only.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <utility>

#include "limpet/mission/yaml_reader.hpp"

namespace limpet::internal {

/// Gives each element of the list `key` to `read`, with its path, e.g. `opis[2]`.
void ReadList(YamlReader& in, const YAML::Node& node, const std::string& key,
              const std::function<void(const YAML::Node& element, const std::string& path)>& read);

/// Stores a name: some text.
[[nodiscard]] YamlReader::Field NameField(YamlReader& in, const std::string& path,
                                          std::string& name);

/// The names in one list: none may come twice.
class DistinctNames {
 public:
  /// `bearers`: what has these names, e.g. objects. Complaints go to `in`, which must outlive this.
  DistinctNames(YamlReader& in, std::string bearers) : in_(in), bearers_(std::move(bearers)) {}
  /// `path` and `node` are of who bears the name; an empty one is no name.
  void Add(const YAML::Node& node, const std::string& path, const std::string& name);

 private:
  YamlReader& in_;
  std::string bearers_;
  std::set<std::string> names_;
};

}  // namespace limpet::internal
