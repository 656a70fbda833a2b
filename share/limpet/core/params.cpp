// SPDX-License-Identifier: MIT
#include "limpet/core/params.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limpet {
namespace {

std::string AllowedText(const Range<double>& range, std::string_view unit) {
  const std::string suffix = unit.empty() ? "" : fmt::format(" {}", unit);
  if (range.low && range.high) {
    return fmt::format("{} to {}{}", TextOf(*range.low), TextOf(*range.high), suffix);
  }
  if (range.low) {
    return fmt::format("at least {}{}", TextOf(*range.low), suffix);
  }
  return unit.empty() ? "a number" : fmt::format("a number in {}", unit);
}

ConfigProblem Missing(const ConfigBlock& block, const ParamSpec& spec) {
  return {block.where, spec.name,
          fmt::format("is missing in {} and has no default; allowed: {}{}", block.name,
                      spec.allowed, spec.is_repeatable ? " (may repeat)" : "")};
}

ConfigProblem MissingBoth(const ConfigBlock& block, const ParamSpec& spec) {
  return {block.where, spec.name,
          fmt::format("is missing in {}, and so is `{}`, which could bring it; allowed: {}",
                      block.name, spec.needed_unless, spec.allowed)};
}

/// `[1, 2, 3]`, `1, 2, 3` or `1 2 3`.
template <int N>
std::optional<Eigen::Matrix<double, N, 1>> ParseNumbers(std::string_view text) {
  std::string numbers(text);
  std::ranges::replace_if(
      numbers, [](char c) { return c == '[' || c == ']' || c == ','; }, ' ');
  Eigen::Matrix<double, N, 1> vector;
  std::string_view rest = numbers;
  for (Eigen::Index i = 0; i < N; ++i) {
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    const std::optional<double> value = ParseNumber(rest.substr(0, rest.find(' ')));
    if (!value) return std::nullopt;
    vector(i) = *value;
    rest.remove_prefix(std::min(rest.find(' '), rest.size()));
  }
  return rest.find_first_not_of(' ') == std::string_view::npos ? std::optional(vector)
                                                               : std::nullopt;
}

bool IsInside(double value, const Range<double>& range) {
  // A bound that went through degrees and back may miss itself by an ulp.
  constexpr double kSlack = 1e-12;
  return (!range.low || value >= *range.low - kSlack) &&
         (!range.high || value <= *range.high + kSlack);
}

/// True if `key` is the parameter's name or one of its aliases.
bool Names(const ParamSpec& spec, std::string_view key) {
  return EqualsIgnoringCase(spec.name, key) ||
         std::ranges::any_of(spec.aliases, [key](const std::string& alias) {
           return EqualsIgnoringCase(alias, key);
         });
}

/// What the value of a line stands for, if that is not what it says.
std::optional<std::string> ReadInstead(const ParamSpec& spec, std::string_view text) {
  return spec.taken_as ? spec.taken_as(text) : std::nullopt;
}

}  // namespace

void ParamCollector::Add(ParamSpec spec) {
  if (spec.example.empty()) {
    spec.example.push_back(spec.default_text);
  }
  specs_.push_back(std::move(spec));
}

void ParamCollector::DeclareNumber(const char* name, const char* unit, double default_value,
                                   const char* help, const Range<double>& range,
                                   std::function<void(double)> store) {
  ParamSpec spec{.name = name,
                 .unit = unit,
                 .default_text = fmt::format("{:.10g}", default_value),
                 .allowed = AllowedText(range, unit),
                 .help = help,
                 .is_repeatable = false,
                 .bounds = range,
                 .set = nullptr};
  spec.set = [range, store = std::move(store),
              allowed = spec.allowed](std::string_view text) -> std::optional<std::string> {
    const std::optional<double> value = ParseNumber(text);
    if (!value || !IsInside(*value, range)) {
      return fmt::format("`{}` is not allowed; allowed: {}", text, allowed);
    }
    store(*value);
    return std::nullopt;
  };
  Add(std::move(spec));
}

void ParamCollector::Number(const char* name, double default_value, const char* help,
                            Range<double> range, std::function<void(double)> store) {
  DeclareNumber(name, "", default_value, help, range, std::move(store));
}

void ParamCollector::operator()(const char* name, double& field, const char* help,
                                Range<double> range) {
  DeclareNumber(name, "", field, help, range, [&field](double value) { field = value; });
}

void ParamCollector::operator()(const char* name, int& field, const char* help, Range<int> range) {
  Range<double> as_double;
  if (range.low) as_double.low = *range.low;
  if (range.high) as_double.high = *range.high;
  DeclareNumber(name, "", field, help, as_double, [](double) {});
  ParamSpec& spec = specs_.back();
  spec.is_whole = true;
  spec.set = [&field, check = spec.set,
              allowed = spec.allowed](std::string_view text) -> std::optional<std::string> {
    if (auto complaint = check(text)) {
      return complaint;
    }
    const std::optional<std::int64_t> value = ParseInteger(text);
    if (!value || *value != static_cast<int>(*value)) {
      return fmt::format("`{}` is not a whole number; allowed: {}", text, allowed);
    }
    field = static_cast<int>(*value);
    return std::nullopt;
  };
}

void ParamCollector::operator()(const char* name, bool& field, const char* help) {
  ParamSpec spec{.name = name,
                 .unit = "",
                 .default_text = field ? "true" : "false",
                 .allowed = "true or false",
                 .help = help,
                 .is_repeatable = false,
                 .set = nullptr};
  spec.set = [&field](std::string_view text) -> std::optional<std::string> {
    const std::optional<bool> value = ParseFlag(text);
    if (!value) {
      return fmt::format("`{}` is not allowed; allowed: true or false", text);
    }
    field = *value;
    return std::nullopt;
  };
  Add(std::move(spec));
}

void ParamCollector::operator()(const char* name, std::string& field, const char* help) {
  ParamSpec spec{.name = name,
                 .unit = "",
                 .default_text = field,
                 .allowed = "text",
                 .help = help,
                 .is_repeatable = false,
                 .set = nullptr};
  spec.set = [&field](std::string_view text) -> std::optional<std::string> {
    field = std::string(text);
    return std::nullopt;
  };
  Add(std::move(spec));
}

void ParamCollector::operator()(const char* name, Eigen::Vector3d& field, const char* unit,
                                const char* help, Range<double> each) {
  ParamSpec spec{
      .name = name,
      .unit = unit,
      .default_text = fmt::format("[{:.10g}, {:.10g}, {:.10g}]", field.x(), field.y(), field.z()),
      .allowed = fmt::format("[x, y, z], each {}", AllowedText(each, unit)),
      .help = help,
      .is_repeatable = false,
      .set = nullptr};
  spec.set = [&field, each,
              allowed = spec.allowed](std::string_view text) -> std::optional<std::string> {
    const auto value = ParseNumbers<3>(text);
    if (!value || !IsInside(value->minCoeff(), each) || !IsInside(value->maxCoeff(), each)) {
      return fmt::format("`{}` is not allowed; allowed: {}", text, allowed);
    }
    field = *value;
    return std::nullopt;
  };
  Add(std::move(spec));
}

void ParamCollector::operator()(const char* name, std::array<double, 5>& field, const char* form,
                                const char* help, Range<double> each) {
  ParamSpec spec{.name = name,
                 .unit = "",
                 .default_text = fmt::format("[{:.10g}]", fmt::join(field, ", ")),
                 .allowed = fmt::format("{}, each {}", form, AllowedText(each, "")),
                 .help = help,
                 .is_repeatable = false,
                 .set = nullptr};
  spec.set = [&field, each,
              allowed = spec.allowed](std::string_view text) -> std::optional<std::string> {
    const auto value = ParseNumbers<5>(text);
    if (!value || !IsInside(value->minCoeff(), each) || !IsInside(value->maxCoeff(), each)) {
      return fmt::format("`{}` is not allowed; allowed: {}", text, allowed);
    }
    std::ranges::copy(*value, field.begin());
    return std::nullopt;
  };
  Add(std::move(spec));
}

void ParamCollector::operator()(const char* name, std::vector<std::string>& field,
                                const char* help) {
  ParamSpec spec{.name = name,
                 .unit = "",
                 .default_text = fmt::format("{}", fmt::join(field, ", ")),
                 .allowed = "text, one per line",
                 .help = help,
                 .is_repeatable = true,
                 .example = field,
                 .set = nullptr};
  spec.set = [&field,
              is_default = true](std::string_view text) mutable -> std::optional<std::string> {
    if (std::exchange(is_default, false)) {
      field.clear();  // the first line replaces the defaults, the next ones add
    }
    field.emplace_back(text);
    return std::nullopt;
  };
  Add(std::move(spec));
}

void ParamCollector::Choice(const char* name, std::string& field, const char* help,
                            std::vector<std::string> choices) {
  ParamSpec spec{.name = name,
                 .unit = "",
                 .default_text = field,
                 .allowed = fmt::format("{}", fmt::join(choices, ", ")),
                 .help = help,
                 .is_repeatable = false,
                 .set = nullptr};
  spec.set = [&field, choices = std::move(choices),
              allowed = spec.allowed](std::string_view text) -> std::optional<std::string> {
    if (std::ranges::find(choices, text) == choices.end()) {
      const std::string nearest = NearestWord(text, choices);
      return fmt::format("`{}` is not allowed; allowed: {}{}", text, allowed,
                         nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest));
    }
    field = std::string(text);
    return std::nullopt;
  };
  Add(std::move(spec));
}

void ParamCollector::Parsed(const char* name, const char* form, const char* help,
                            const char* default_text, std::function<bool(std::string_view)> store) {
  ParamSpec spec{.name = name,
                 .unit = "",
                 .default_text = default_text,
                 .allowed = form,
                 .help = help,
                 .is_repeatable = false,
                 .set = nullptr};
  spec.set = [store = std::move(store),
              allowed = spec.allowed](std::string_view text) -> std::optional<std::string> {
    if (!store(text)) {
      return fmt::format("`{}` is not allowed; allowed: {}", text, allowed);
    }
    return std::nullopt;
  };
  Add(std::move(spec));
}

void ParamCollector::ParsedLines(const char* name, const char* form, const char* help,
                                 std::function<bool(std::string_view)> store) {
  // Without a line there is nothing to read, and so it is of one that is empty.
  Parsed(name, form, help, "",
         [store = std::move(store)](std::string_view text) { return text.empty() || store(text); });
  specs_.back().is_repeatable = true;
}

void ParamCollector::Also(std::initializer_list<const char*> aliases) {
  specs_.back().aliases.assign(aliases.begin(), aliases.end());
}

void ParamCollector::Clipped() {
  const ParamSpec& spec = specs_.back();
  const auto nearest = [bounds = spec.bounds, is_whole = spec.is_whole](
                           std::string_view text) -> std::optional<std::string> {
    const std::optional<double> value = ParseNumber(text);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    double inside = is_whole ? std::trunc(*value) : *value;
    if (bounds.low) inside = std::max(inside, *bounds.low);
    if (bounds.high) inside = std::min(inside, *bounds.high);
    return inside == *value ? std::nullopt : std::optional(TextOf(inside));
  };
  TakenAs("else the nearest", nearest);
}

void ParamCollector::TakenAs(const char* rule,
                             std::function<std::optional<std::string>(std::string_view)> taken_as) {
  specs_.back().otherwise = rule;
  specs_.back().taken_as = std::move(taken_as);
}

void ParamCollector::WithoutEffect(std::initializer_list<const char*> names) {
  for (const char* name : names) {
    Parsed(name, "text", "Of existing missions; has no effect here", "",
           [](std::string_view) { return true; });
    specs_.back().is_without_effect = true;
  }
}

std::vector<ConfigProblem> IgnoredKeys(const ConfigBlock& block,
                                       const std::vector<ParamSpec>& specs) {
  std::vector<ConfigProblem> notes;
  for (const ConfigEntry& entry : block.entries) {
    const auto spec = std::ranges::find_if(
        specs, [&entry](const ParamSpec& known) { return Names(known, entry.key); });
    if (spec != specs.end() && spec->is_without_effect) {
      notes.push_back({entry.where, entry.key, "has no effect in " + block.name});
    }
  }
  return notes;
}

std::vector<ConfigProblem> AlteredValues(const ConfigBlock& block,
                                         const std::vector<ParamSpec>& specs) {
  std::vector<ConfigProblem> notes;
  for (const ConfigEntry& entry : block.entries) {
    const auto spec = std::ranges::find_if(
        specs, [&entry](const ParamSpec& known) { return Names(known, entry.key); });
    if (spec == specs.end()) continue;
    if (const auto other = ReadInstead(*spec, entry.value)) {
      notes.push_back(
          {entry.where, entry.key,
           fmt::format("`{}` is taken as {}; allowed: {}", entry.value, *other, spec->allowed)});
    }
  }
  return notes;
}

std::vector<ConfigProblem> ApplyBlock(const ConfigBlock& block, const std::vector<ParamSpec>& specs,
                                      const std::vector<std::string>& also_known) {
  std::vector<std::string> known = also_known;
  for (const ParamSpec& spec : specs) {
    known.push_back(spec.name);
    known.insert(known.end(), spec.aliases.begin(), spec.aliases.end());
  }
  std::vector<ConfigProblem> problems = block.problems;
  std::vector<std::string> given;  // also what was meant: one slip is one problem
  for (const ConfigEntry& entry : block.entries) {
    const auto matches = [&entry](const std::string& name) {
      return EqualsIgnoringCase(name, entry.key);
    };
    const auto spec = std::ranges::find_if(
        specs, [&entry](const ParamSpec& known_spec) { return Names(known_spec, entry.key); });
    if (spec != specs.end()) {
      given.push_back(spec->name);
      if (const auto complaint = spec->set(ReadInstead(*spec, entry.value).value_or(entry.value))) {
        problems.push_back({entry.where, entry.key, *complaint});
      }
      continue;
    }
    if (std::ranges::any_of(also_known, matches)) {
      continue;
    }
    const std::string nearest = NearestWord(entry.key, known);
    given.push_back(nearest);
    problems.push_back(
        {entry.where, entry.key,
         fmt::format("unknown key in {}{}", block.name,
                     nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest))});
  }
  for (const ParamSpec& spec : specs) {
    if (std::ranges::find(given, spec.name) != given.end()) continue;
    if (spec.is_required) problems.push_back(Missing(block, spec));
    if (!spec.needed_unless.empty() && block.Find(spec.needed_unless) == nullptr) {
      problems.push_back(MissingBoth(block, spec));
    }
  }
  return problems;
}

}  // namespace limpet
