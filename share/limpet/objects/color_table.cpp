// SPDX-License-Identifier: MIT
#include "limpet/objects/color_table.hpp"

#include <algorithm>

namespace limpet {
namespace {

struct Paint {
  std::string_view name;
  Albedo albedo;
};
// Buoy paints, linear blue, green, red.
constexpr std::array<Paint, 8> kPaints{{{"yellow", {0.05F, 0.62F, 0.85F}},
                                        {"orange", {0.03F, 0.22F, 0.85F}},
                                        {"red", {0.04F, 0.04F, 0.62F}},
                                        {"green", {0.10F, 0.48F, 0.06F}},
                                        {"white", {0.85F, 0.85F, 0.85F}},
                                        {"blue", {0.60F, 0.14F, 0.04F}},
                                        {"black", {0.02F, 0.02F, 0.02F}},
                                        {"purple", {0.45F, 0.05F, 0.40F}}}};

}  // namespace

std::optional<Albedo> AlbedoOf(std::string_view color) {
  const auto found = std::ranges::find(kPaints, color, &Paint::name);
  return found == kPaints.end() ? std::nullopt : std::optional<Albedo>(found->albedo);
}

std::vector<std::string> ColorNames() {
  std::vector<std::string> names;
  for (const Paint& paint : kPaints) {
    names.emplace_back(paint.name);
  }
  return names;
}

}  // namespace limpet
