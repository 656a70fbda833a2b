// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"
#include "limpet/objects/color_table.hpp"

namespace limpet {

/// The form of an object whose radius is given elsewhere: of a cone's foot, of a tyre's outside,
/// half the side of a box.
struct ObjectShapeParams {
  std::string shape = "sphere";
  Meters height{1.0};
  Radians heading{0.0};
  Radians tilt{0.0};
  std::string band = "none";

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit.Choice("shape", shape, "Its form; a cone has half its radius at the top",
                 {"sphere", "cylinder", "cone", "box", "tyre"});
    visit("height_m", height, "From foot to top; of a tyre its width; spheres have none",
          InRange(0.05_m, 10.0_m));
    visit("heading_deg", heading, "The way that it faces and leans, clockwise from north",
          InRange(-360.0_deg, 360.0_deg));
    visit("tilt_deg", tilt, "How far it leans to the side that it faces; 90: it lies",
          InRange(0.0_deg, 180.0_deg));
    std::vector<std::string> bands = ColorNames();
    bands.insert(bands.begin(), "none");
    visit.Choice("band", band, "Colour of the middle third of its height", std::move(bands));
  }
  [[nodiscard]] bool is_plain() const { return shape == "sphere" && band == "none"; }
};

}  // namespace limpet
