// SPDX-License-Identifier: MIT
// Recorded sessions of MOOS clients with a stock MOOSDB, where they lie beside the project.
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

inline std::filesystem::path CaptureFolder() {
  return std::filesystem::path(LIMPET_SOURCE_DIR) / ".." / "shared" / "moos-wire" / "captures";
}

inline ByteBuffer BytesOfFile(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

/// Files of the captures whose names end so, sorted.
inline std::vector<std::filesystem::path> Captures(const std::string& ending) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::exists(CaptureFolder())) {
    for (const auto& entry : std::filesystem::directory_iterator(CaptureFolder())) {
      if (entry.path().filename().string().ends_with(ending)) {
        files.push_back(entry.path());
      }
    }
  }
  std::ranges::sort(files);
  return files;
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
