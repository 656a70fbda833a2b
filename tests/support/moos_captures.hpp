// SPDX-License-Identifier: MIT
// Recorded sessions of MOOS clients with a stock MOOSDB: those of the project
// (tests/golden/moos-wire), and more where they lie beside it.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "limpet/wire/packet_codec.hpp"

namespace limpet {

inline std::vector<std::filesystem::path> CaptureFolders() {
  const std::filesystem::path project(LIMPET_SOURCE_DIR);
  return {project / "tests" / "golden" / "moos-wire",
          project / ".." / "shared" / "moos-wire" / "captures"};
}

/// The recording of this name, the project's own first; a path that does not exist if there is
/// none.
inline std::filesystem::path Capture(const std::string& name) {
  std::filesystem::path file;
  for (const auto& folder : CaptureFolders()) {
    file = folder / name;
    if (std::filesystem::exists(file)) break;
  }
  return file;
}

inline ByteBuffer BytesOfFile(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

/// Recordings whose names end so, each once, sorted by name.
inline std::vector<std::filesystem::path> Captures(const std::string& ending) {
  std::map<std::string, std::filesystem::path> files;
  for (const auto& folder : CaptureFolders()) {
    if (!std::filesystem::exists(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(ending)) {
        files.try_emplace(name, entry.path());
      }
    }
  }
  std::vector<std::filesystem::path> list;
  for (const auto& [name, path] : files) {
    list.push_back(path);
  }
  return list;
}

/// What went over the wire in one direction of one session at one moment.
struct Segment {
  double t = 0.0;
  std::string session;
  bool is_from_client = true;
  bool is_end = false;
  std::size_t size = 0;
};

/// The segment log of a scenario, in order of time.
inline std::vector<Segment> SegmentsOf(const std::filesystem::path& log) {
  std::vector<Segment> segments;
  std::ifstream in(log);
  std::string session;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("session ")) {
      session = line.substr(8, line.find(" (") - 8);
    } else if (line.starts_with("  ") && !session.empty()) {
      std::istringstream words(line);
      Segment segment{.session = session};
      std::string direction, size;
      words >> segment.t >> direction >> size;
      segment.is_from_client = direction == "C>S";
      segment.is_end = size == "EOF";
      segment.size = segment.is_end ? 0 : std::stoul(size);
      segments.push_back(segment);
    }
  }
  std::ranges::stable_sort(segments, {}, &Segment::t);
  return segments;
}

}  // namespace limpet
