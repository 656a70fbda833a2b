// SPDX-License-Identifier: MIT
#include "tests/layers/frame_walk.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet::layers {
namespace {

/// Of a cell like " `name` and words "; empty for words alone.
std::string NameIn(std::string_view cell) {
  const std::size_t open = std::min(cell.find('`'), cell.size());
  const std::string_view rest = cell.substr(std::min(open + 1, cell.size()));
  return std::string(rest.substr(0, std::min(rest.find('`'), rest.size())));
}

/// Empty if there is no such file.
std::string TextOf(const std::string& path, const std::vector<SourceFile>& files) {
  const auto file = std::ranges::find(files, path, &SourceFile::path);
  return file == files.end() ? std::string() : file->text;
}

std::string HeaderOf(const std::string& source) {
  return source.substr(0, source.rfind('.')) + ".hpp";
}

bool Holds(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

}  // namespace

std::string FrameStep::room() const { return file.substr(0, file.rfind('/')); }

std::vector<FrameStep> ReadFrameWalk(std::string_view markdown) {
  std::vector<FrameStep> walk;
  bool is_inside = false;
  for (const std::string& line : Split(markdown, '\n')) {
    const std::vector<std::string> cells = Split(line, '|');
    is_inside = line.starts_with("| file |") || (is_inside && line.starts_with('|'));
    if (!is_inside || cells.size() < 6 || !Holds(cells[1], "`")) continue;
    walk.push_back({.file = NameIn(cells[1]),
                    .function = NameIn(cells[2]),
                    .type = NameIn(cells[3]),
                    .next = NameIn(cells[4])});
  }
  return walk;
}

std::vector<std::string> StepsNotTaken(const std::vector<FrameStep>& walk,
                                       const std::vector<SourceFile>& files) {
  std::vector<std::string> complaints;
  for (const FrameStep& step : walk) {
    const std::string text = TextOf(step.file, files);
    const auto complain = [&](std::string_view what) {
      complaints.push_back(fmt::format("{}: {}", step.file, what));
    };
    if (text.empty()) {
      complain("there is no such file");
      continue;
    }
    if (!Holds(text, step.function + "(")) complain("has no " + step.function);
    if (!Holds(text + TextOf(HeaderOf(step.file), files), step.type)) {
      complain("names no " + step.type);
    }
    if (!Holds(text, step.next)) complain("does not call " + step.next);
  }
  return complaints;
}

Names RoomsOf(const std::vector<FrameStep>& walk) {
  Names rooms;
  for (const FrameStep& step : walk)
    rooms.insert(step.room());
  return rooms;
}

Names TypesOf(const std::vector<FrameStep>& walk) {
  Names types;
  for (const FrameStep& step : walk) {
    if (!step.type.empty()) types.insert(step.type);
  }
  return types;
}

}  // namespace limpet::layers
