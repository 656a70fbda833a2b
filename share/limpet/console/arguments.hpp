// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace limpet {

/// A wrong command line; the text names the nearest known option.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a command was given. Options are asked for without their dashes, and only those that it
/// declares.
class Arguments {
 public:
  struct Given {
    std::vector<std::string> values{};  ///< a flag's: one for each time that it was given
    std::string fallback{};
  };

  Arguments(std::vector<std::string> positionals, std::map<std::string, Given> options)
      : positionals_(std::move(positionals)), options_(std::move(options)) {}

  /// Words that belong to no option, in order.
  [[nodiscard]] const std::vector<std::string>& positionals() const { return positionals_; }
  /// True for an option or flag that was given.
  [[nodiscard]] bool Has(const std::string& option) const;
  /// The last value given, else the one declared for that case, if there is one.
  [[nodiscard]] std::optional<std::string> Find(const std::string& option) const;
  /// Every value given, in order.
  [[nodiscard]] std::vector<std::string> All(const std::string& option) const;
  /// REQUIRES: an option declared as WholeNumber, with a fallback.
  [[nodiscard]] int Integer(const std::string& option) const;
  /// REQUIRES: an option that is declared to be a number.
  [[nodiscard]] std::optional<double> Number(const std::string& option) const;

 private:
  [[nodiscard]] const Given& Of(const std::string& option) const;

  std::vector<std::string> positionals_;
  std::map<std::string, Given> options_;
};

}  // namespace limpet
