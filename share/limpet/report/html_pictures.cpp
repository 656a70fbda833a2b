// SPDX-License-Identifier: MIT
#include "limpet/report/html_pictures.hpp"

#include <cstdint>
#include <span>

#include <fmt/format.h>

#include "limpet/figures/rgba_png.hpp"
#include "limpet/figures/svg_canvas.hpp"

namespace limpet {
namespace {

std::string NameOf(const PicturedObject& object) {
  const std::string own = fmt::format("id {}, {}", object.id, object.color);
  return object.truth.empty() ? own : fmt::format("{} ({})", object.truth, own);
}

std::string PictureOf(const ObjectChip& chip, Seconds begun) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(chip.jpeg.data());
  const std::string said = fmt::format("{} {:.2f}, after {:.0f} s", chip.box.color,
                                       chip.box.confidence, (chip.exposure - begun).value());
  return fmt::format("<img alt=\"{0}\" title=\"{0}\" src=\"data:image/jpeg;base64,{1}\">",
                     EscapedMarkup(said), Base64(std::span(bytes, chip.jpeg.size())));
}

}  // namespace

std::string PicturesOf(const std::vector<PicturedObject>& objects, Seconds begun) {
  if (objects.empty()) return "";
  std::string out =
      "<h3>What they looked like</h3>\n<p class=\"muted\">The best pictures of each, cut out where "
      "the detector had its box.</p>\n<div class=\"chips\">\n";
  for (const PicturedObject& object : objects) {
    out += "<div><p>";
    for (const ObjectChip& chip : object.chips)
      out += PictureOf(chip, begun);
    out += fmt::format("</p><b>{}</b> {}</div>\n", EscapedMarkup(NameOf(object)),
                       NameOf(object.decided));
  }
  return out + "</div>\n";
}

}  // namespace limpet
