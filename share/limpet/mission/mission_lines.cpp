// SPDX-License-Identifier: MIT
#include "limpet/mission/mission_lines.hpp"

#include <cstdlib>
#include <optional>

#include <fmt/format.h>

namespace limpet {
namespace {

constexpr std::string_view kBare = "is neither a comment (//) nor `key = value`";
constexpr std::string_view kVariable = "${";

}  // namespace

std::string CleanMissionLine(std::string_view line, bool keeps_quotes) {
  const std::size_t open = line.find('"');
  const std::size_t close = open == std::string_view::npos ? open : line.find('"', open + 1);
  std::size_t comment = line.find("//");
  const bool has_quotes = close != std::string_view::npos && open < comment;
  if (has_quotes) {
    comment = line.find("//", close + 1);
  }
  std::string text(line.substr(0, comment));
  if (has_quotes && !keeps_quotes) {
    text.erase(close, 1).erase(open, 1);
  }
  return std::string(Trim(text));
}

KeyValue SplitKeyValue(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) {
    return {};
  }
  return {.key = std::string(Trim(line.substr(0, equals))),
          .value = std::string(Trim(line.substr(equals + 1))),
          .has_equals = true};
}

std::optional<ConfigProblem> PassByteOrderMark(std::string_view& text, const std::string& file) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (!text.starts_with(kMark)) return std::nullopt;
  text.remove_prefix(kMark.size());
  return ConfigProblem{{file, 1},
                       "",
                       "begins with a byte order mark, which is passed over; to MOOS it is part of "
                       "this line"};
}

bool IsBlockHeader(std::string_view key) {
  std::string bare(key);
  std::erase_if(bare, [](char letter) { return letter == ' ' || letter == '\t'; });
  return EqualsIgnoringCase(bare, "ProcessConfig");
}

ConfigProblem BareLine(const TextLine& line, const std::string& block) {
  return {line.where, block, fmt::format("`{}` {}", line.text, kBare)};
}

bool IsPassedOver(const ConfigProblem& problem) {
  return problem.key.starts_with(kVariable) || problem.text.ends_with(kBare);
}

void MissionVariables::Learn(const std::vector<TextLine>& lines) {
  constexpr std::string_view kDefine = "define:";
  for (const TextLine& line : lines) {
    KeyValue pair = SplitKeyValue(CleanMissionLine(line.text, false));
    if (EqualsIgnoringCase(std::string_view(pair.key).substr(0, kDefine.size()), kDefine)) {
      pair.key = std::string(Trim(std::string_view(pair.key).substr(kDefine.size())));
    }
    if (!pair.key.empty()) {
      values_[pair.key] = pair.value;
    }
  }
}

std::string MissionVariables::Substitute(const TextLine& line,
                                         std::vector<ConfigProblem>& problems) {
  std::string_view rest = line.text;
  std::string out;
  for (std::size_t open = rest.find("${"); open != std::string_view::npos; open = rest.find("${")) {
    const std::size_t close = rest.find('}', open);
    if (close == std::string_view::npos) {
      break;
    }
    const std::string name(Trim(rest.substr(open + 2, close - open - 2)));
    out += rest.substr(0, open);
    const std::size_t before = out.size();
    if (const auto found = values_.find(name); found != values_.end()) {
      out += found->second;
    } else if (const char* value =
                   std::getenv(name.c_str())) {  // NOLINT(concurrency-mt-unsafe): read only
      out += value;
    } else {
      problems.push_back({line.where, "${" + name + "}", "is defined neither here nor outside"});
      out += name;
    }
    bytes_ += out.size() - before;
    if (bytes_ > kMaxBytes) {
      throw ConfigError(
          {line.where, "${" + name + "}", "the file's variables stand for more than 4 MiB in all"});
    }
    rest.remove_prefix(close + 1);
  }
  return out.append(rest);
}

}  // namespace limpet
