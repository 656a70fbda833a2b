// SPDX-License-Identifier: MIT
#include "limpet/console/arguments.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

bool IsListed(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

Arguments::Arguments(std::span<const std::string> args, const std::vector<std::string>& with_value,
                     const std::vector<std::string>& flags) {
  for (std::size_t i = 0; i < args.size(); ++i) {
    const std::string& word = args[i];
    if (!word.starts_with("--")) {
      positionals_.push_back(word);
      continue;
    }
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(2, equals == std::string::npos ? equals : equals - 2);
    if (IsListed(flags, name) && equals == std::string::npos) {
      given_.push_back({name, ""});
    } else if (IsListed(with_value, name) && equals != std::string::npos) {
      given_.push_back({name, word.substr(equals + 1)});
    } else if (IsListed(with_value, name)) {
      if (i + 1 == args.size()) {
        throw UsageError(fmt::format("--{} needs a value", name));
      }
      given_.push_back({name, args[++i]});
    } else {
      std::vector<std::string> known = with_value;
      known.insert(known.end(), flags.begin(), flags.end());
      const std::string nearest = NearestWord(name, known);
      throw UsageError(
          fmt::format("unknown option --{}{}", name,
                      nearest.empty() ? "" : fmt::format("; did you mean --{}?", nearest)));
    }
  }
}

bool Arguments::Has(const std::string& flag) const { return Find(flag).has_value(); }

std::optional<std::string> Arguments::Find(const std::string& option) const {
  const std::vector<std::string> all = All(option);
  return all.empty() ? std::nullopt : std::optional<std::string>(all.back());
}

std::vector<std::string> Arguments::All(const std::string& option) const {
  std::vector<std::string> values;
  for (const Given& given : given_) {
    if (given.name == option) {
      values.push_back(given.value);
    }
  }
  return values;
}

int Arguments::Integer(const std::string& option, int fallback, int low) const {
  const std::optional<std::string> text = Find(option);
  if (!text) {
    return fallback;
  }
  const std::optional<std::int64_t> value = ParseInteger(*text);
  if (!value || *value < low || *value > 2'000'000'000) {
    throw UsageError(
        fmt::format("--{} takes a whole number of at least {}, not `{}`", option, low, *text));
  }
  return static_cast<int>(*value);
}

}  // namespace limpet
