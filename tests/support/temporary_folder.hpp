// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace limpet {

/// Where files are made that are synced again and again: in memory where there is such a place.
inline std::filesystem::path PlaceInMemory() {
  const std::filesystem::path memory = "/dev/shm";
  return std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
}

/// A folder of this test (or, made for a whole suite, of this process) alone, removed with it.
/// Tests run in parallel, each in its own process: a fixed name would be shared.
class TemporaryFolder {
 public:
  TemporaryFolder() : TemporaryFolder(std::filesystem::temp_directory_path()) {}
  explicit TemporaryFolder(const std::filesystem::path& parent) {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    static int count = 0;
    std::string name =
        "limpet_" + std::to_string(::getpid()) + "_" + std::to_string(++count) + "_" +
        (test == nullptr ? "suite" : std::string(test->test_suite_name()) + "_" + test->name());
    std::ranges::replace(name, '/', '_');  // of a parametrised test: it would nest folders
    path_ = parent / name;
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace limpet
