// SPDX-License-Identifier: MIT
#include "limpet/console/poke.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "limpet/console/shown_text.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr std::array<std::string_view, 2> kTimes{"@MOOSTIME", "@UTC"};
constexpr std::size_t kLongestName = 1024;  // that a broker takes

std::string WhyBadName(std::string_view name) {
  if (name.empty()) {
    return "names no variable; VAR=value is expected";
  }
  if (name.size() > kLongestName) {
    return fmt::format("has a name of {} bytes; at most {}", name.size(), kLongestName);
  }
  const bool is_clean = std::ranges::none_of(name, [](char c) {
    return c == ' ' || c == ',' || c == 0x7F || static_cast<unsigned char>(c) < 0x20;
  });
  return is_clean ? "" : "has a name with a blank, a comma or a control character";
}

std::string WithTimes(std::string_view text, Seconds now) {
  std::string result(text);
  for (const std::string_view time : kTimes) {
    const std::string value = fmt::format("{:.2f}", now.value());
    for (std::size_t at = result.find(time); at != std::string::npos; at = result.find(time, at)) {
      result.replace(at, time.size(), value);
    }
  }
  return result;
}

Value ValueOf(std::string_view text, Seconds now) {
  if (std::ranges::find(kTimes, text) != kTimes.end()) {
    return now.value();
  }
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    return WithTimes(text.substr(1, text.size() - 2), now);
  }
  if (const std::optional<double> number = ParseNumber(text)) {
    return *number;
  }
  return WithTimes(text, now);
}

std::string KindOf(const Value& value) {
  return std::holds_alternative<double>(value)        ? "a number"
         : std::holds_alternative<std::string>(value) ? "a string"
                                                      : "binary data";
}

}  // namespace

Expected<Poke> ParsePoke(std::string_view word, Seconds now) {
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos) {
    return Error{fmt::format("`{}` is no VAR=value", OneLine(word, 60))};
  }
  const bool is_literal = equals > 0 && word[equals - 1] == ':';
  const std::string_view name = Trim(word.substr(0, equals - (is_literal ? 1 : 0)));
  if (const std::string complaint = WhyBadName(name); !complaint.empty()) {
    return Error{fmt::format("`{}` {}", OneLine(word, 60), complaint)};
  }
  const std::string_view text = word.substr(equals + 1);
  return Poke{std::string(name), is_literal ? Value(std::string(text)) : ValueOf(text, now)};
}

std::vector<PokeResult> PokeResults(const std::vector<Poke>& pokes, const std::string& name,
                                    const std::vector<Message>& before,
                                    const std::vector<Message>& after) {
  std::vector<PokeResult> results;
  for (const Poke& poke : pokes) {
    const auto same = [&poke](const PokeResult& result) { return result.poke.name == poke.name; };
    std::erase_if(results, same);
    PokeResult result{.poke = poke};
    for (const Message& message : before) {
      if (message.name == poke.name) {
        result.before = message;
      }
    }
    for (const Message& message : after) {
      const bool is_ours = message.source == name && message.value == poke.value;
      if (message.name == poke.name && message.id >= 0 && is_ours) {
        result.after = message;
        result.outcome = PokeResult::Outcome::kWritten;
      }
    }
    results.push_back(std::move(result));
  }
  return results;
}

std::string WhyRefused(const PokeResult& result) {
  const Poke& poke = result.poke;
  const std::string name = OneLine(poke.name, 60);
  if (!result.before || result.before->value.index() == poke.value.index()) {
    return fmt::format("{} was not taken by the broker; DB_REFUSED counts its reasons", name);
  }
  const bool is_number = std::holds_alternative<double>(poke.value);
  const bool holds_text = std::holds_alternative<std::string>(result.before->value);
  std::string text = fmt::format("{} was refused: it holds {}, first written so, and {} was given",
                                 name, KindOf(result.before->value), KindOf(poke.value));
  if (is_number && holds_text) {
    text += fmt::format("; {}:={} writes a string", name, TextOf(std::get<double>(poke.value)));
  }
  return text;
}

}  // namespace limpet
