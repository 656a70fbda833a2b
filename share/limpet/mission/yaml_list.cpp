// SPDX-License-Identifier: MIT
#include "limpet/mission/yaml_list.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

namespace limpet::internal {

void ReadList(YamlReader& in, const YAML::Node& node, const std::string& key,
              const std::function<void(const YAML::Node& element, const std::string& path)>& read) {
  if (!node.IsSequence() && !node.IsNull()) {
    in.Complain(node, key, fmt::format("{} is not allowed; allowed: a list", TextOfNode(node)));
    return;
  }
  for (std::size_t i = 0; i < node.size(); ++i) {
    read(node[i], fmt::format("{}[{}]", key, i));
  }
}

YamlReader::Field NameField(YamlReader& in, const std::string& path, std::string& name) {
  return {"name", [&in, &name, key = path + ".name"](const YAML::Node& node) {
            if (!node.IsScalar() || node.Scalar().empty()) {
              in.Complain(node, key, fmt::format("{} is no name", TextOfNode(node)));
              return;
            }
            name = node.Scalar();
          }};
}

void DistinctNames::Add(const YAML::Node& node, const std::string& path, const std::string& name) {
  if (!name.empty() && !names_.insert(name).second) {
    in_.Complain(node, path + ".name", fmt::format("`{}` is the name of two {}", name, bearers_));
  }
}

}  // namespace limpet::internal
