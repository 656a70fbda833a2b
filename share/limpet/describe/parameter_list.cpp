// SPDX-License-Identifier: MIT
#include "limpet/describe/parameter_list.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "estimation/navigation/source_block.hpp"
#include "estimation/navigation/source_factory.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/describe/markdown_cell.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/mission/detector_settings.hpp"
#include "limpet/mission/shared_settings.hpp"
#include "limpet/mission/vehicle_settings.hpp"
#include "limpet/vision/detector_registry.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;
using Kind = ParameterOwner::Kind;

const char* NameOf(Kind kind) {
  switch (kind) {
    case Kind::kApp:
      return "app";
    case Kind::kBehavior:
      return "behavior";
    case Kind::kDetector:
      return "detector";
    case Kind::kSource:
      return "measurement source";
  }
  return "";
}

/// The app in whose block the keys of this kind stand beside its own; none of those that have one.
std::string_view HostOf(Kind kind) {
  return kind == Kind::kDetector ? "pDetect" : kind == Kind::kSource ? "pNav" : "";
}

/// Keys that all owners of a kind take, or that the block takes which this kind's keys stand in.
std::vector<std::string> CommonKeysOf(Kind kind) {
  if (HostOf(kind).empty()) {
    return kind == Kind::kApp ? CommonAppKeys() : CommonBehaviorKeys();
  }
  std::vector<std::string> keys;
  std::ranges::transform(AppRegistry().at(std::string(HostOf(kind))).describe(),
                         std::back_inserter(keys), &ParamSpec::name);
  return keys;
}

std::string DefaultOf(const ParamSpec& parameter) {
  if (parameter.is_required) return "required";
  if (!parameter.needed_unless.empty()) return "required unless " + parameter.needed_unless;
  const std::string text = parameter.default_text.empty() ? "(empty)" : parameter.default_text;
  return parameter.unit.empty() ? text : text + " " + parameter.unit;
}

std::string AllowedOf(const ParamSpec& parameter) {
  return parameter.allowed + (parameter.is_repeatable ? " (may repeat)" : "") +
         (parameter.otherwise.empty() ? "" : "; " + parameter.otherwise);
}

/// The global that a mission may say it by.
std::string GlobalOf(const ParameterOwner& owner, const ParamSpec& parameter) {
  return std::string(GlobalFor(owner.name, parameter.name));
}

/// The key of such a file that stands in for a parameter; "" if none does.
std::string KeyIn(const FactFile& kind, const ParameterOwner& owner, const ParamSpec& parameter) {
  const FactSource other = FactFor(owner.name, parameter.name);
  return other.kind == &kind ? std::string(other.fact) : "";
}

OrderedJson JsonOf(const ParameterOwner& owner) {
  OrderedJson parameters = OrderedJson::array();
  for (const ParamSpec& parameter : owner.parameters) {
    parameters.push_back({{"name", parameter.name},
                          {"unit", parameter.unit},
                          {"default", parameter.is_required ? OrderedJson(nullptr)
                                                            : OrderedJson(parameter.default_text)},
                          {"required", parameter.is_required},
                          {"example", parameter.example},
                          {"allowed", parameter.allowed},
                          {"otherwise", parameter.otherwise},
                          {"repeatable", parameter.is_repeatable},
                          {"aliases", parameter.aliases},
                          {"without_effect", parameter.is_without_effect},
                          {"global", GlobalOf(owner, parameter)},
                          {"vehicle_key", KeyIn(VehicleFacts(), owner, parameter)},
                          {"detector_key", KeyIn(DetectorFacts(), owner, parameter)},
                          {"meaning", parameter.help}});
  }
  OrderedJson out{{"name", owner.name}, {"kind", NameOf(owner.kind)}};
  if (owner.tick_hz) out["tick_hz"] = *owner.tick_hz;
  out["parameters"] = std::move(parameters);
  return out;
}

/// What follows the meaning: other names, and where else a mission may say it.
std::string RemarksOn(const ParameterOwner& owner, const ParamSpec& parameter) {
  std::string text;
  for (const std::string& alias : parameter.aliases) {
    text += fmt::format("{} `{}`", text.empty() ? "; also" : ",", alias);
  }
  const std::string global = GlobalOf(owner, parameter);
  if (!global.empty()) text += fmt::format("; global `{}`", global);
  const FactSource other = FactFor(owner.name, parameter.name);
  if (!other.fact.empty()) text += fmt::format("; {}'s file `{}`", other.kind->of, other.fact);
  return text;
}

std::string MarkdownTable(const ParameterOwner& owner) {
  std::string page = fmt::format("\n### {}\n\n", owner.name);
  if (owner.tick_hz)
    page += fmt::format("Ticks at {} Hz unless AppTick says otherwise.\n\n", *owner.tick_hz);
  if (owner.parameters.empty()) return page + "No parameters of its own.\n";
  page += "| parameter | default | allowed | meaning |\n| --- | --- | --- | --- |\n";
  std::string ignored;
  for (const ParamSpec& parameter : owner.parameters) {
    if (parameter.is_without_effect) {
      ignored += fmt::format("{}`{}`", ignored.empty() ? "" : ", ", parameter.name);
      continue;
    }
    page += fmt::format("| `{}` | {} | {} | {}{} |\n", parameter.name,
                        MarkdownCell(DefaultOf(parameter)), MarkdownCell(AllowedOf(parameter)),
                        MarkdownCell(parameter.help), RemarksOn(owner, parameter));
  }
  if (!ignored.empty()) {
    page += fmt::format("\nOf existing missions, known and without effect: {}.\n", ignored);
  }
  return page;
}

}  // namespace

std::vector<ParameterOwner> AllParameterOwners() {
  std::vector<ParameterOwner> owners;
  for (const auto& [name, entry] : AppRegistry()) {
    owners.push_back(
        {.name = name, .tick_hz = entry.default_tick_hz, .parameters = entry.describe()});
  }
  for (const auto& [name, entry] : BehaviorRegistry()) {
    owners.push_back(
        {.name = name, .kind = Kind::kBehavior, .tick_hz = {}, .parameters = entry.describe()});
  }
  for (const std::string& name : DetectorNames()) {
    owners.push_back({.name = name,
                      .kind = Kind::kDetector,
                      .tick_hz = {},
                      .parameters = (*FindDetector(name))->Parameters()});
  }
  for (const std::string& name : SourceNames()) {
    std::vector<ParamSpec> parameters = (*FindSource(name))->Parameters();
    for (ParamSpec& parameter : parameters)
      parameter.name = name + "_" + parameter.name;
    owners.push_back(
        {.name = name, .kind = Kind::kSource, .tick_hz = {}, .parameters = std::move(parameters)});
  }
  return owners;
}

std::string PlainText(const ParameterOwner& owner) {
  std::string text = fmt::format("{}: {}", owner.name, NameOf(owner.kind));
  text += owner.tick_hz ? fmt::format(", ticks at {} Hz\n", *owner.tick_hz) : "\n";
  for (const ParamSpec& parameter : owner.parameters) {
    const std::string value = parameter.is_required ? ": required" : " = " + DefaultOf(parameter);
    text += fmt::format("\n  {}{}\n      {}\n      allowed: {}\n", parameter.name, value,
                        parameter.help, AllowedOf(parameter));
    if (const std::string global = GlobalOf(owner, parameter); !global.empty()) {
      text += fmt::format("      else the mission's global {}\n", global);
    }
    if (const auto other = FactFor(owner.name, parameter.name); !other.fact.empty()) {
      text += fmt::format("      else the {}'s file, {}\n", other.kind->of, other.fact);
    }
  }
  const std::string_view host = HostOf(owner.kind);
  const std::string beside = host.empty() ? fmt::format("and as every {}", NameOf(owner.kind))
                                          : fmt::format("in the block of {}, beside its own", host);
  return text + fmt::format("\n  {}: {}\n", beside, fmt::join(CommonKeysOf(owner.kind), ", "));
}

std::string Json(const std::vector<ParameterOwner>& owners) {
  OrderedJson list = OrderedJson::array();
  std::ranges::transform(owners, std::back_inserter(list), JsonOf);
  return list.dump(1) + "\n";
}

std::string Markdown(const std::vector<ParameterOwner>& owners) {
  std::string page =
      "# Parameters\n\nWhat the blocks of `mission.moos` (apps, the detector that pDetect "
      "uses, the measurement sources of pNav) "
      "and of `.bhv` files (behaviors) may set. Generated: `limpet describe parameters --markdown "
      "> "
      "docs/parameters.md`.\n\nA parameter with a global may be said once for the whole mission, "
      "outside of blocks: a block that does not say it takes the global; one that says something "
      "else is refused by `limpet check`. So it is with a parameter that the vehicle's file says "
      "(`docs/vehicle-file.md`).\n";
  const auto add = [&page, &owners](Kind kind, const char* heading, std::string_view takes) {
    if (std::ranges::find(owners, kind, &ParameterOwner::kind) == owners.end()) return;
    page +=
        fmt::format("\n## {}\n\n{}: {}.\n", heading, takes, fmt::join(CommonKeysOf(kind), ", "));
    for (const ParameterOwner& owner : owners) {
      if (owner.kind == kind) page += MarkdownTable(owner);
    }
  };
  add(Kind::kApp, "Apps", "Every app also takes MOOS's own keys");
  add(Kind::kBehavior, "Behaviors", "Every behavior also takes");
  add(Kind::kDetector, "Detectors",
      "Chosen by `detector` in the block of pDetect, which takes these keys beside its own");
  add(Kind::kSource, "Measurement sources",
      fmt::format("Sensors, heard if `sensors` in the block of pNav names them (those that dead "
                  "reckoning stands on: {}) or `sources` (any others); it takes these keys beside "
                  "its own",
                  kUsualSensors));
  return page;
}

}  // namespace limpet
