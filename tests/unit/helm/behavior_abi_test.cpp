// SPDX-License-Identifier: MIT
// A behavior in a shared object that was built before an interface changed must not be loaded
// after it: whoever changes the interface is told here to raise the number.
#include "limpet/helm/behavior_abi.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <xxhash.h>

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kDigestOfNumber15 = 2833124130412095026ULL;

/// A header without comments and blanks.
std::string CodeOf(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  const std::string uncommented = std::regex_replace(text.str(), std::regex("//[^\n]*"), "");
  return std::regex_replace(uncommented, std::regex("\\s+"), "");
}

/// `header` and all of Limpet's that it includes, by name.
void AddHeaders(const std::string& header, std::set<std::string>& headers) {
  if (!headers.insert(header).second) {
    return;
  }
  std::ifstream file(fs::path(LIMPET_SOURCE_DIR) / "share" / header);
  static const std::regex kInclude("#include \"(limpet/[^\"]+)\"");
  for (std::string line; std::getline(file, line);) {
    if (std::smatch found; std::regex_search(line, found, kInclude)) {
      AddHeaders(found[1], headers);
    }
  }
}

TEST(BehaviorAbi, HasANewNumberWheneverWhatBehaviorsSeeChanges) {
  std::set<std::string> headers;
  AddHeaders("limpet/helm/behavior.hpp", headers);
  AddHeaders("limpet/helm/registry.hpp", headers);
  ASSERT_GT(headers.size(), 10U);
  std::string code;
  for (const std::string& header : headers) {
    code += header + "\n" + CodeOf(fs::path(LIMPET_SOURCE_DIR) / "share" / header);
  }
  EXPECT_EQ(LIMPET_BEHAVIOR_ABI, 15);
  EXPECT_EQ(XXH3_64bits(code.data(), code.size()), kDigestOfNumber15)
      << "headers that behaviors include have changed: if objects of old behaviors no longer fit, "
         "raise LIMPET_BEHAVIOR_ABI, and in any case write the new digest here";
}

}  // namespace
}  // namespace limpet
