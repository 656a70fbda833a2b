// SPDX-License-Identifier: MIT
// A parameter is declared once, in its struct's Describe: name, type, default, unit, meaning,
// range. The parser, the checks, --example, --interface and the docs all come from that. What only
// a mission can know is declared with Required: it has no default, and a block without it is
// refused.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// Inclusive bounds of a parameter.
template <class T>
struct Range {
  std::optional<T> low;
  std::optional<T> high;
};
template <class T>
[[nodiscard]] Range<T> InRange(T low, T high) {
  return {low, high};
}
template <class T>
[[nodiscard]] Range<T> AtLeast(T low) {
  return {low, std::nullopt};
}

/// One declared parameter, free of its type.
struct ParamSpec {
  std::string name;
  std::string unit;          ///< symbol of the text unit, "" if none
  std::string default_text;  ///< "" if required
  std::string allowed;       ///< e.g. "1 to 6000 m"
  std::string help;
  bool is_repeatable = false;
  bool is_required = false;     ///< a block must say it
  std::string needed_unless{};  ///< a block must say it, or this key, which may bring it later
  /// Values as a block may give them, one per line: the default, or of a required parameter what
  /// the struct is initialised with.
  std::vector<std::string> example{};
  std::vector<std::string> aliases{};  ///< other names of it that blocks may use
  bool is_without_effect = false;      ///< a key of existing missions that is read and not heeded
  Range<double> bounds{};              ///< of a number, in its unit
  bool is_whole = false;               ///< a number without a fraction
  /// What a text stands for that is not allowed and that existing missions may hold, e.g. the
  /// nearest bound; nothing for others.
  std::function<std::optional<std::string>(std::string_view)> taken_as{};
  std::string otherwise{};  ///< that in words, e.g. "else the nearest"
  /// Parses and stores; the complaint if the text is no allowed value.
  std::function<std::optional<std::string>(std::string_view)> set;
};

/// The visitor that `Describe(visit)` talks to; collects the declarations of one params struct.
class ParamCollector {
 public:
  void operator()(const char* name, double& field, const char* help, Range<double> range = {});
  void operator()(const char* name, int& field, const char* help, Range<int> range = {});
  void operator()(const char* name, bool& field, const char* help);
  void operator()(const char* name, std::string& field, const char* help);
  /// Three numbers, each in the range: `[x, y, z]`, brackets and commas optional. `unit` is the
  /// symbol of what they are in.
  void operator()(const char* name, Eigen::Vector3d& field, const char* unit, const char* help,
                  Range<double> each = {});
  /// Numbers in a given order, `[a, b, c]`, brackets and commas optional; `form` says the order.
  void operator()(const char* name, std::array<double, 5>& field, const char* form,
                  const char* help, Range<double> each = {});
  /// One entry per line of the block.
  void operator()(const char* name, std::vector<std::string>& field, const char* help);
  /// A string that must be one of `choices`.
  void Choice(const char* name, std::string& field, const char* help,
              std::vector<std::string> choices);

  /// A number that is kept in another form than blocks give it in, e.g. one below 0 as nothing:
  /// `store` does that. `default_value` is as in a block.
  void Number(const char* name, double default_value, const char* help, Range<double> range,
              std::function<void(double)> store);
  /// A text of a form of its own, e.g. `x,y:x,y` as `form`: `store` says whether it could be read.
  void Parsed(const char* name, const char* form, const char* help, const char* default_text,
              std::function<bool(std::string_view)> store);
  /// A text as of Parsed that a block may say on several lines, once per line.
  void ParsedLines(const char* name, const char* form, const char* help,
                   std::function<bool(std::string_view)> store);
  /// Other names of the parameter declared last, as existing missions spell it.
  void Also(std::initializer_list<const char*> aliases);
  /// Existing missions may hold values of the number declared last that are not allowed: beyond its
  /// range they are taken as the nearest bound, and a fraction of a whole number is cut off. Who
  /// reads the block says so (`AlteredValues`).
  void Clipped();
  /// As Clipped, where `taken_as` says what a text stands for; nothing for those that are allowed,
  /// and those that are refused.
  void TakenAs(const char* rule,
               std::function<std::optional<std::string>(std::string_view)> taken_as);
  /// Keys that existing missions may hold and nothing here heeds: they are known, and who reads
  /// the block says so (`IgnoredKeys`).
  void WithoutEffect(std::initializer_list<const char*> names);

  template <class D>
  void operator()(const char* name, Quantity<D>& field, const char* help,
                  Range<Quantity<D>> range = {}) {
    Range<double> in_text;
    if (range.low) in_text.low = range.low->in_text_unit();
    if (range.high) in_text.high = range.high->in_text_unit();
    DeclareNumber(name, D::kSymbol, field.in_text_unit(), help, in_text,
                  [&field](double text) { field = Quantity<D>::FromTextUnit(text); });
  }

  /// What a mission may leave unsaid, as something else can stand for it. `example` never reaches a
  /// mission.
  template <class D>
  void Optional(const char* name, std::optional<Quantity<D>>& field, const char* help,
                Quantity<D> example) {
    DeclareNumber(name, D::kSymbol, example.in_text_unit(), help, {},
                  [&field](double text) { field = Quantity<D>::FromTextUnit(text); });
    specs_.back().default_text.clear();
  }

  /// Declares what a mission must say, as the call without `Required` declares what it may say.
  /// What the field is initialised with is an example and never reaches a mission.
  template <class Field, class... More>
  void Required(const char* name, Field& field, const char* help, const More&... more) {
    (*this)(name, field, help, more...);
    specs_.back().is_required = true;
    specs_.back().default_text.clear();
  }

  /// A block must say the parameter declared last, unless it has the key `other`.
  void NeededUnless(const char* other) { specs_.back().needed_unless = other; }

  [[nodiscard]] const std::vector<ParamSpec>& specs() const { return specs_; }

 private:
  void Add(ParamSpec spec);
  void DeclareNumber(const char* name, const char* unit, double default_value, const char* help,
                     const Range<double>& range, std::function<void(double)> store);
  std::vector<ParamSpec> specs_;
};

template <class P>
[[nodiscard]] std::vector<ParamSpec> DescribeParams(P& params) {
  ParamCollector collector;
  params.Describe(collector);
  return collector.specs();
}

/// Applies `block` to `specs`: every problem of every line, those found in reading it first, with
/// the nearest known key, and every required parameter that no line gives. Keys listed in
/// `also_known` are somebody else's and pass.
[[nodiscard]] std::vector<ConfigProblem> ApplyBlock(
    const ConfigBlock& block, const std::vector<ParamSpec>& specs,
    const std::vector<std::string>& also_known = {});

/// A note for each line of `block` whose key `specs` declare to be without effect.
[[nodiscard]] std::vector<ConfigProblem> IgnoredKeys(const ConfigBlock& block,
                                                     const std::vector<ParamSpec>& specs);

/// A note for each line of `block` whose value is not allowed and is taken as another.
[[nodiscard]] std::vector<ConfigProblem> AlteredValues(const ConfigBlock& block,
                                                       const std::vector<ParamSpec>& specs);

/// Reads a params struct. Throws ConfigError with every problem of the block.
template <class P>
[[nodiscard]] P ReadParams(const ConfigBlock& block,
                           const std::vector<std::string>& also_known = {}) {
  P params;
  const std::vector<ConfigProblem> problems = ApplyBlock(block, DescribeParams(params), also_known);
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
  return params;
}

}  // namespace limpet
