// SPDX-License-Identifier: MIT
#include "tests/support/published_sets.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "estimation/replay/sensor_stream.hpp"
#include "limpet/core/number_text.hpp"
#include "tests/support/matlab_matrices.hpp"

namespace limpet {
namespace {

/// What is wrong with a line.
struct BadSetLine {
  std::string why;
};

/// A line's words: a kind, if it has one, and numbers.
class Words {
 public:
  explicit Words(const std::string& line) {
    std::istringstream text(line);
    for (std::string word; text >> word;)
      words_.push_back(word);
  }
  [[nodiscard]] bool is_empty() const { return words_.empty(); }
  [[nodiscard]] const std::string& kind() const { return words_.front(); }
  void Expect(std::size_t count) const {
    if (words_.size() != count) {
      throw BadSetLine{fmt::format("{} words, not {}", words_.size(), count)};
    }
  }
  [[nodiscard]] double Number(std::size_t i) const {
    const std::optional<double> value = ParseNumber(words_.at(i));
    if (!value) throw BadSetLine{fmt::format("`{}` is no finite number", words_[i])};
    return *value;
  }
  /// A number that counts something, as a file may write it (`2.0e+000`).
  [[nodiscard]] int Count(std::size_t i) const {
    const double value = Number(i);
    if (value != std::floor(value) || value < 0.0 || value > 1e8) {
      throw BadSetLine{fmt::format("`{}` is no number of a pose or landmark", words_[i])};
    }
    return static_cast<int>(value);
  }
  [[nodiscard]] double Positive(std::size_t i) const {
    const double value = Number(i);
    if (value <= 0.0) throw BadSetLine{fmt::format("`{}` is not positive", words_[i])};
    return value;
  }

 private:
  std::vector<std::string> words_;
};

/// Calls `take` with the words of every line that has any.
template <class Take>
std::optional<Error> ForEachSetLine(const std::filesystem::path& file, Take take) {
  const Expected<StreamFile> read = ReadLines(file);
  if (!read) return read.error();
  if (read->damage) return Error{*read->damage};
  for (std::size_t i = 0; i < read->lines.size(); ++i) {
    const Words words(read->lines[i]);
    if (words.is_empty() || words.kind().front() == '#') continue;
    try {
      take(words);
    } catch (const BadSetLine& bad) {
      return Error{fmt::format("{}:{}: {}", file.string(), i + 1, bad.why)};
    }
  }
  return std::nullopt;
}

PlanarEdge EdgeOf(const Words& words) {
  words.Expect(12);  // kind, from, to, x, y, yaw, information xx, xy, yy, yaw, x yaw, y yaw
  for (const std::size_t i : {7U, 10U, 11U}) {
    if (words.Number(i) != 0.0) throw BadSetLine{"information that is not diagonal"};
  }
  PlanarEdge edge{.from = words.Count(1), .to = words.Count(2)};
  if (edge.from == edge.to) throw BadSetLine{"an edge from a pose to itself"};
  // Not by <<: a bad word throws, and would leave it half filled.
  edge.motion = {words.Number(3), words.Number(4), words.Number(5)};
  edge.variance = {1.0 / words.Positive(6), 1.0 / words.Positive(8), 1.0 / words.Positive(9)};
  return edge;
}

PlanarSighting SightingOf(const Words& words) {
  words.Expect(7);
  return {.pose = words.Count(1),
          .landmark = words.Count(2),
          .bearing_range = {words.Number(3), words.Positive(4)},
          .sigma = {words.Positive(5), words.Positive(6)}};
}

void TakeGraphLine(const Words& words, PlanarGraph& graph) {
  if (words.kind() == "VERTEX2") {
    words.Expect(5);
    if (words.Count(1) != static_cast<int>(graph.poses.size())) {
      throw BadSetLine{"poses are not numbered one after the other"};
    }
    graph.poses.emplace_back(words.Number(2), words.Number(3), words.Number(4));
  } else if (words.kind() == "EDGE2") {
    graph.edges.push_back(EdgeOf(words));
  } else if (words.kind() == "BR") {
    graph.sightings.push_back(SightingOf(words));
  } else if (words.kind() == "EQUIV") {
    words.Expect(3);
    ++graph.equivalents;
  } else {
    throw BadSetLine{fmt::format("`{}` is no line of a planar graph", words.kind())};
  }
  const auto count = static_cast<int>(graph.poses.size());
  const bool is_edge = words.kind() == "EDGE2";
  if ((is_edge || words.kind() == "BR") &&
      (words.Count(1) >= count || (is_edge && words.Count(2) >= count))) {
    throw BadSetLine{"a pose that has no VERTEX2 line"};
  }
}

}  // namespace

Expected<PlanarGraph> ReadPlanarGraph(const std::filesystem::path& file) {
  PlanarGraph graph;
  if (auto error =
          ForEachSetLine(file, [&graph](const Words& words) { TakeGraphLine(words, graph); })) {
    return *error;
  }
  if (graph.poses.empty()) return Error{fmt::format("{}: no poses", file.string())};
  std::vector<bool> has_step(graph.poses.size(), false);
  for (const PlanarEdge& edge : graph.edges) {
    const int later = std::max(edge.from, edge.to);
    if (std::min(edge.from, edge.to) == later - 1) has_step[static_cast<std::size_t>(later)] = true;
  }
  for (std::size_t i = 1; i < has_step.size(); ++i) {
    if (!has_step[i]) {
      return Error{fmt::format("{}: no edge between poses {} and {}", file.string(), i - 1, i)};
    }
  }
  return graph;
}

Expected<RangeSession> ReadRangeSession(const std::filesystem::path& stem) {
  RangeSession session;
  const auto take_step = [&](const Words& words) {
    words.Expect(3);
    session.steps.push_back({words.Number(0), words.Number(1), words.Number(2)});
    const std::size_t count = session.steps.size();
    if (count > 1 && session.steps[count - 2].t > session.steps[count - 1].t) {
      throw BadSetLine{"time goes back"};
    }
  };
  const auto take_range = [&](const Words& words) {
    words.Expect(4);  // time, who asks, beacon, range
    session.ranges.push_back({words.Number(0), words.Count(2), words.Positive(3)});
  };
  if (auto error = ForEachSetLine(stem.string() + "_DR.txt", take_step)) return *error;
  if (auto error = ForEachSetLine(stem.string() + "_TD.txt", take_range)) return *error;
  std::ranges::stable_sort(session.ranges, {}, &BeaconRange::t);  // they come as they arrive
  const std::filesystem::path truth_file = stem.string() + "_.mat";
  if (!std::filesystem::exists(truth_file)) return session;
  const auto matrices = ReadMatlabMatrices(truth_file);
  if (!matrices) return matrices.error();
  const auto truth = matrices->find("GT"), beacons = matrices->find("TL");
  if (truth == matrices->end() || truth->second.cols() != 4 || beacons == matrices->end() ||
      beacons->second.cols() != 3) {
    return Error{fmt::format("{}: no GT of four columns and TL of three", truth_file.string())};
  }
  for (const auto& row : truth->second.rowwise())
    session.truth.emplace_back(row.transpose());
  for (const auto& row : beacons->second.rowwise())
    session.beacons[static_cast<int>(row(0))] = row.tail<2>();
  return session;
}

}  // namespace limpet
