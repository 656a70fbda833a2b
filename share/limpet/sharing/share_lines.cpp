// SPDX-License-Identifier: MIT
#include "limpet/sharing/share_lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr std::string_view kArrow = "->";

/// The `word=value` parts of a line, each word at most once.
class WordValues {
 public:
  explicit WordValues(std::vector<std::string> known) : known_(std::move(known)) {}

  [[nodiscard]] std::optional<Error> Add(std::string_view part) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos) {
      return Error{fmt::format("`{}` is not word=value", Trim(part))};
    }
    const std::string word(Trim(part.substr(0, equals)));
    const auto found = std::ranges::find_if(
        known_, [&word](const std::string& name) { return EqualsIgnoringCase(name, word); });
    if (found == known_.end()) {
      const std::string nearest = NearestWord(word, known_);
      return Error{
          fmt::format("unknown word `{}`{}", word,
                      nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest))};
    }
    if (!values_.emplace(*found, Trim(part.substr(equals + 1))).second) {
      return Error{fmt::format("`{}` is said twice", word)};
    }
    return std::nullopt;
  }
  [[nodiscard]] std::string Of(const std::string& word) const {
    const auto found = values_.find(word);
    return found == values_.end() ? "" : found->second;
  }
  [[nodiscard]] bool Has(const std::string& word) const { return values_.contains(word); }

 private:
  std::vector<std::string> known_;
  std::map<std::string, std::string> values_;
};

Expected<WordValues> WordsIn(std::string_view line, std::vector<std::string> known) {
  WordValues words(std::move(known));
  for (const std::string& part : Split(line, ',')) {
    if (Trim(part).empty()) {
      continue;
    }
    if (auto error = words.Add(part)) {
      return *error;
    }
  }
  return words;
}

/// True if the line is in `word=value` form: MOOS looks for the word `route`.
bool IsLongForm(std::string_view line) {
  const std::vector<std::string> parts = Split(line, ',');
  return std::ranges::any_of(parts, [](std::string_view part) {
    return EqualsIgnoringCase(Trim(part.substr(0, part.find('='))), "route") &&
           part.find('=') != std::string_view::npos;
  });
}

Expected<ShareSecurity> SecurityIn(const WordValues& words) {
  ShareSecurity security{.key_file = words.Of("key"), .is_plain = false};
  if (words.Has("plain")) {
    const std::optional<bool> is_plain = ParseFlag(words.Of("plain"));
    if (!is_plain) {
      return Error{fmt::format("plain = `{}`; allowed: true or false", words.Of("plain"))};
    }
    security.is_plain = *is_plain;
  }
  if (security.is_plain && !security.key_file.empty()) {
    return Error{"a route is plain or has a key, not both"};
  }
  return security;
}

/// A number of at least 0, if the word is there.
Expected<std::optional<double>> NumberIn(const WordValues& words, const std::string& word) {
  if (!words.Has(word)) {
    return std::optional<double>();
  }
  const std::optional<double> number = ParseNumber(words.Of(word));
  if (!number || *number < 0.0 || *number > 1e9) {
    return Error{fmt::format("{} = `{}`; allowed: 0 to 1e9", word, words.Of(word))};
  }
  return number;
}

std::optional<Error> SetSource(ShareOutput& output, std::string_view text) {
  text = Trim(text);
  const std::size_t colon = text.find(':');
  output.source = Trim(text.substr(0, colon));
  if (colon != std::string_view::npos) {
    output.app_pattern = Trim(text.substr(colon + 1));
  }
  if (output.source.empty() || output.app_pattern.empty()) {
    return Error{fmt::format("`{}` names no variable", text)};
  }
  return std::nullopt;
}

std::optional<Error> SetDestination(ShareOutput& output, std::string_view text) {
  output.dest = Trim(text);
  const bool has_one_star = std::ranges::count(output.source, '*') == 1 &&
                            output.source.find('?') == std::string::npos &&
                            (output.source.front() == '*' || output.source.back() == '*');
  if (output.dest == "^" && !has_one_star) {
    return Error{"dest_name ^ needs a src_name with one * at its end or beginning"};
  }
  if (output.dest.empty() && !output.is_pattern()) {
    output.dest = output.source;
  }
  return std::nullopt;
}

std::optional<Error> SetAddress(ShareOutput& output, std::string_view text,
                                const MulticastPlan& plan) {
  auto address = ParseShareAddress(text, plan);
  if (!address) {
    return address.error();
  }
  if (address->port == 0) {
    return Error{fmt::format("`{}`: nothing can be sent to port 0", Trim(text))};
  }
  output.address = std::move(*address);
  return std::nullopt;
}

std::optional<Error> SetLimits(ShareOutput& output, const WordValues& words) {
  const auto max_hz = NumberIn(words, "frequency");
  const auto duration = NumberIn(words, "duration");
  const auto max_shares = NumberIn(words, "max_shares");
  for (const auto* number : {&max_hz, &duration, &max_shares}) {
    if (!*number) {
      return number->error();
    }
  }
  output.max_hz = max_hz->value_or(0.0);
  if (*duration) {
    output.duration = Seconds(**duration);
  }
  if (*max_shares) {
    output.max_shares = static_cast<int>(**max_shares);
  }
  return std::nullopt;
}

Expected<std::vector<ShareOutput>> ParseLongOutput(std::string_view line,
                                                   const MulticastPlan& plan) {
  const auto words = WordsIn(line, {"src_name", "dest_name", "route", "frequency", "duration",
                                    "max_shares", "key", "to", "plain"});
  if (!words) {
    return words.error();
  }
  const auto security = SecurityIn(*words);
  if (!security) {
    return security.error();
  }
  ShareOutput output;
  output.security = *security;
  output.to = words->Of("to");
  auto error = SetSource(output, words->Of("src_name"));
  error = error ? error : SetDestination(output, words->Of("dest_name"));
  error = error ? error : SetLimits(output, *words);
  std::vector<ShareOutput> outputs;
  for (const std::string& route : Split(words->Of("route"), '&')) {
    error = error ? error : SetAddress(output, route, plan);
    outputs.push_back(output);
  }
  return error ? Expected<std::vector<ShareOutput>>(*error) : outputs;
}

/// `[dest:]host:port[@hz]` or `[dest:]multicast_N[@hz]`.
std::optional<Error> SetShortRoute(ShareOutput& output, std::string_view text,
                                   const MulticastPlan& plan) {
  const std::size_t at = text.find('@');
  if (at != std::string_view::npos) {
    const std::optional<double> hz = ParseNumber(text.substr(at + 1));
    if (!hz || *hz < 0.0) {
      return Error{fmt::format("`{}`: behind @ comes a number of Hz", Trim(text))};
    }
    output.max_hz = *hz;
  }
  std::string_view route = Trim(text.substr(0, at));
  const std::size_t last = route.rfind(':');
  const bool is_channel = Trim(route.substr(last + 1)).starts_with("multicast_");
  const std::size_t cut = is_channel ? last : route.rfind(':', last - 1);
  const bool has_dest =
      last != std::string_view::npos && (is_channel || last > 0) && cut != std::string_view::npos;
  auto error = SetDestination(output, has_dest ? route.substr(0, cut) : std::string_view());
  return error ? error : SetAddress(output, has_dest ? route.substr(cut + 1) : route, plan);
}

Expected<std::vector<ShareOutput>> ParseShortOutputs(std::string_view line,
                                                     const MulticastPlan& plan) {
  WordValues words({"key", "to", "plain"});
  std::vector<ShareOutput> outputs;
  for (const std::string& part : Split(line, ',')) {
    const std::size_t arrow = part.find(kArrow);
    if (arrow == std::string::npos) {
      if (auto error = words.Add(part)) {
        return Error{fmt::format("`{}` is neither X->host:port nor word=value", Trim(part))};
      }
      continue;
    }
    for (const std::string& route : Split(part.substr(arrow + kArrow.size()), '&')) {
      ShareOutput output;
      auto error = SetSource(output, part.substr(0, arrow));
      error = error ? error : SetShortRoute(output, route, plan);
      if (error) {
        return *error;
      }
      outputs.push_back(output);
    }
  }
  const auto security = SecurityIn(words);
  if (!security) {
    return security.error();
  }
  std::ranges::for_each(outputs, [&](ShareOutput& output) {
    output.security = *security;
    output.to = words.Of("to");
  });
  return outputs;
}

std::optional<Error> AddAddresses(ShareInput& input, std::string_view list, char separator,
                                  const MulticastPlan& plan) {
  for (const std::string& text : Split(list, separator)) {
    auto address = ParseShareAddress(text, plan);
    if (!address) {
      return address.error();
    }
    input.addresses.push_back(std::move(*address));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Error> Settle(ShareSecurity& line, const ShareSecurity& block) {
  if (line.is_plain || !line.key_file.empty()) {
    return std::nullopt;
  }
  line = {.key_file = block.key_file, .is_plain = block.key_file.empty() && block.is_plain};
  if (!line.is_plain && line.key_file.empty()) {
    return Error{
        "has no key: say `key_file = FILE` in this block (`limpet key new FILE` makes one); or, "
        "for "
        "MOOS's open datagrams, which anybody can read and forge, `plain = true` in this line or "
        "`allow_plain_routes = true` in this block"};
  }
  return std::nullopt;
}

std::optional<Error> SettleReceiver(ShareOutput& output, const std::string& to) {
  if (output.security.is_plain) {
    return output.to.empty() ? std::nullopt
                             : std::optional(Error{"a plain route is for anybody: it has no `to`"});
  }
  output.to = output.to.empty() && !output.address.channel ? to : output.to;
  if (output.to.empty() && !output.address.channel) {
    return Error{
        "is sealed for nobody: say `to = NAME`, the receiver's Community, in this line or in this "
        "block; else whoever has the key could be made to believe what is meant for another"};
  }
  return std::nullopt;
}

Expected<std::vector<ShareOutput>> ParseShareOutputs(std::string_view line,
                                                     const MulticastPlan& plan) {
  if (IsLongForm(line)) {
    return ParseLongOutput(line, plan);
  }
  auto outputs = ParseShortOutputs(line, plan);
  if (outputs && outputs->empty()) {
    return Error{"names no route; as in `src_name=X, route=host:port` or `X->host:port`"};
  }
  return outputs;
}

Expected<ShareInput> ParseShareInput(std::string_view line, const MulticastPlan& plan) {
  ShareInput input;
  if (!IsLongForm(line)) {
    const auto error = AddAddresses(input, line, ',', plan);
    return error ? Expected<ShareInput>(*error) : input;
  }
  const auto words = WordsIn(line, {"route", "white_list", "interface", "key", "plain"});
  if (!words) {
    return words.error();
  }
  const auto security = SecurityIn(*words);
  if (!security) {
    return security.error();
  }
  input.security = *security;
  if (words->Has("interface")) {
    input.interface = words->Of("interface");
  }
  for (const std::string& pattern : Split(words->Of("white_list"), '&')) {
    if (!Trim(pattern).empty()) {
      input.white_list.emplace_back(Trim(pattern));
    }
  }
  const auto error = AddAddresses(input, words->Of("route"), '&', plan);
  return error ? Expected<ShareInput>(*error) : input;
}

Expected<ShareCommand> ParseShareCommand(std::string_view text) {
  std::optional<bool> is_output;
  std::string line;
  for (const std::string& part : Split(text, ',')) {
    const std::size_t equals = part.find('=');
    if (!EqualsIgnoringCase(Trim(std::string_view(part).substr(0, equals)), "cmd")) {
      line += (line.empty() ? "" : ",") + part;
      continue;
    }
    const std::string verb(equals == std::string::npos ? "" : Trim(part.substr(equals + 1)));
    if (!EqualsIgnoringCase(verb, "output") && !EqualsIgnoringCase(verb, "input")) {
      return Error{fmt::format("cmd = `{}`; allowed: output or input", verb)};
    }
    is_output = EqualsIgnoringCase(verb, "output");
  }
  if (!is_output) {
    return Error{"says neither cmd=output nor cmd=input"};
  }
  return ShareCommand{.is_output = *is_output, .line = std::move(line)};
}

}  // namespace limpet
