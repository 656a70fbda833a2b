// SPDX-License-Identifier: MIT
// Topics of ROS as CSV, files divided by lines of dashes; what is understood is checked and said.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "limpet/recordings/check_text.hpp"
#include "limpet/recordings/recording_check.hpp"
#include "limpet/recordings/ros_csv.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::string_view kDivider = "---\n";
  std::string_view text(reinterpret_cast<const char*>(data), size);
  limpet::Recording recording;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(kDivider), text.size());
    const auto added = limpet::AddRosCsv(text.substr(0, end), "some.csv", recording);
    if (!added) return 0;
    text.remove_prefix(std::min(end + kDivider.size(), text.size()));
  }
  const limpet::RecordingCheck check = limpet::Check(recording);
  if (check.dvl && check.dvl->with_velocity > recording.pings.size()) std::abort();
  if (limpet::CheckText(recording, check).empty()) std::abort();
  if (limpet::CheckJson(recording, check).empty()) std::abort();
  return 0;
}
