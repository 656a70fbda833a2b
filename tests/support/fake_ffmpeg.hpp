// SPDX-License-Identifier: MIT
// A program `ffmpeg` of our own, alone on PATH: a shell script that writes what a test wants.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace limpet {

/// While it lives PATH holds `folder`/bin alone.
class FakeFfmpeg {
 public:
  explicit FakeFfmpeg(const std::filesystem::path& folder) : bin_(folder / "bin") {
    const char* path = std::getenv("PATH");
    former_ = path != nullptr ? path : "";
    std::filesystem::create_directories(bin_);
    ::setenv("PATH", bin_.c_str(), 1);
  }
  FakeFfmpeg(const FakeFfmpeg&) = delete;
  FakeFfmpeg& operator=(const FakeFfmpeg&) = delete;
  ~FakeFfmpeg() { ::setenv("PATH", former_.c_str(), 1); }

  /// `script` is for /bin/sh, and finds no program but by its full path. Its words are kept in
  /// `folder`/bin/words, one a line.
  void Does(const std::string& script) const {
    std::ofstream(bin_ / "ffmpeg")
        << "#!/bin/sh\nprintf '%s\\n' \"$@\" > '" << (bin_ / "words").string() << "'\n"
        << script << '\n';
    std::filesystem::permissions(bin_ / "ffmpeg", std::filesystem::perms::owner_all);
  }
  [[nodiscard]] std::string Words() const {
    std::ifstream in(bin_ / "words");
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  std::filesystem::path bin_;
  std::string former_;
};

}  // namespace limpet
