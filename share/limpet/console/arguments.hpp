// SPDX-License-Identifier: MIT
// The contract of the limpet command and its tools: exit codes, and the small argument reader.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace limpet {

/// design contract: 0 ok, 1 failed, 2 usage or configuration, 3 refused by a check.
enum ExitCode : int { kOk = 0, kFailed = 1, kUsage = 2, kRefused = 3 };

/// A wrong command line; the text names the nearest known option.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Splits arguments into positionals and options. Options are `--name value`, `--name=value`, or
/// bare flags.
class Arguments {
 public:
  /// `with_value` and `flags` list the known options without their dashes. Throws UsageError.
  Arguments(std::span<const std::string> args, const std::vector<std::string>& with_value,
            const std::vector<std::string>& flags);

  [[nodiscard]] const std::vector<std::string>& positionals() const { return positionals_; }
  [[nodiscard]] bool Has(const std::string& flag) const;
  /// Last value given, if any.
  [[nodiscard]] std::optional<std::string> Find(const std::string& option) const;
  /// Every value given, in order.
  [[nodiscard]] std::vector<std::string> All(const std::string& option) const;
  /// A whole number of at least `low`. Throws UsageError.
  [[nodiscard]] int Integer(const std::string& option, int fallback, int low) const;

 private:
  struct Given {
    std::string name;
    std::string value;
  };
  std::vector<std::string> positionals_;
  std::vector<Given> given_;
};

}  // namespace limpet
