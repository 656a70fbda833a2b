// SPDX-License-Identifier: MIT
#include "limpet/mission/fault_reading.hpp"

#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "limpet/mission/condition.hpp"
#include "limpet/mission/yaml_list.hpp"

namespace limpet::internal {
namespace {

constexpr double kLongestFault_s = 1e6;

std::vector<std::string> KnownFaults() {
  std::vector<std::string> names;
  for (const FaultKind& kind : FaultKinds()) {
    names.emplace_back(kind.what);
  }
  return names;
}

YamlReader::Field WordField(YamlReader& in, const std::string& path, const char* key,
                            std::string& word) {
  return {key, [&in, &word, name = path + "." + key](const YAML::Node& value) {
            if (value.IsScalar() && !value.Scalar().empty()) {
              word = value.Scalar();
            } else {
              in.Complain(value, name, fmt::format("{} is no word", TextOfNode(value)));
            }
          }};
}

/// What goes together: a size where the kind has one, an app where it is about one.
void CheckFault(YamlReader& in, const YAML::Node& node, const std::string& path,
                const ScenarioFault& fault, std::optional<double> size) {
  const FaultKind& kind = *FindFaultKind(fault.what);
  if (size && kind.size_meaning.empty()) {
    in.Complain(node, path + ".size", fmt::format("`{}` has no size", fault.what));
  } else if (size && (*size < kind.least || *size > kind.most)) {
    in.Complain(node, path + ".size",
                fmt::format("`{:g}` is not allowed; allowed for `{}`: {:g} to {:g}, {}", *size,
                            fault.what, kind.least, kind.most, kind.size_meaning));
  }
  if (kind.is_about_app == fault.app.empty()) {
    in.Complain(node, path + ".app",
                kind.is_about_app ? "is missing: which app"
                                  : fmt::format("`{}` is about no app", fault.what));
  }
  if (fault.when.empty()) return;
  const auto condition = Condition::Parse(fault.when);
  if (!condition) in.Complain(node, path + ".when", condition.error().text);
}

void ReadFault(YamlReader& in, const YAML::Node& node, const std::string& path,
               std::vector<ScenarioFault>& faults) {
  ScenarioFault fault;
  double at = 0.0;
  std::optional<double> lasts, size;
  in.ReadMap(
      node, path,
      {in.Choice(path, "what", fault.what, KnownFaults()), WordField(in, path, "when", fault.when),
       in.Number(path, "at_s", at, InRange(0.0, kLongestFault_s)),
       in.Number(path, "for_s", lasts, InRange(0.0, kLongestFault_s)),
       in.Number(path, "size", size, InRange(-1e9, 1e9)), WordField(in, path, "app", fault.app)});
  const FaultKind* kind = FindFaultKind(fault.what);
  if (kind == nullptr) {
    if (fault.what.empty()) in.Complain(node, path + ".what", "is missing: what fails");
    return;
  }
  CheckFault(in, node, path, fault, size);
  fault.at = Seconds(at);
  if (lasts) fault.lasts = Seconds(*lasts);
  fault.size = size.value_or(kind->size);
  faults.push_back(std::move(fault));
}

}  // namespace

void ReadFaults(YamlReader& in, const YAML::Node& node, std::vector<ScenarioFault>& faults) {
  ReadList(in, node, "faults", [&](const YAML::Node& element, const std::string& path) {
    ReadFault(in, element, path, faults);
  });
}

}  // namespace limpet::internal
