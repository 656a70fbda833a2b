// SPDX-License-Identifier: MIT
// landmarks.csv, a line of dashes, landmarks_covariance.csv; what is understood is matched with.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "estimation/replay/former_landmarks.hpp"
#include "limpet/core/config.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kObjects = 20;  // a fuzzer's patience
  limpet::StreamFile landmarks{.name = "landmarks.csv", .lines = {}};
  limpet::StreamFile covariance{.name = "landmarks_covariance.csv", .lines = {}};
  bool is_first = true;
  for (std::string& line :
       limpet::Split(std::string_view(reinterpret_cast<const char*>(data), size), '\n')) {
    if (is_first && line == "---") {
      is_first = false;
    } else {
      (is_first ? landmarks : covariance).lines.push_back(std::move(line));
    }
  }
  const auto former = limpet::ParseFormerLandmarks(landmarks, covariance);
  if (!former || former->objects.size() > kObjects) {
    return 0;
  }
  limpet::FormerSessionTie tie({});
  tie.SetFormer(*former);
  limpet::PresentLandmarks present{.slots = {0, 1}, .objects = {}, .covariance = {}};
  present.objects = {{.p_W = {1.0, 2.0, 3.0}, .color = "0"},
                     {.p_W = {5.0, -2.0, 3.0}, .color = "0"}};
  present.covariance = 0.1 * Eigen::MatrixXd::Identity(6, 6);
  static_cast<void>(tie.Match(present, std::nullopt));
  if (tie.prior() && !tie.prior()->mean().allFinite()) std::abort();
  return 0;
}
