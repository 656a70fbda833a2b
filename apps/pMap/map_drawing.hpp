// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "limpet/shapes/shape_board.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

/// Objects as viewers draw them: a marker colored by status, and a circle of one sigma. An object
/// decided to be removed keeps a grey marker without circle; one that is no object any more is
/// erased. Labels begin with the vehicle's name. Positions follow in steps, not with every
/// centimetre of the estimate.
class MapDrawing {
 public:
  MapDrawing(const std::string& vehicle, ShapeBoard::Post post);

  void Draw(const OpiBeliefs& beliefs);

 private:
  struct Place {
    double north = 0.0, east = 0.0, sigma = 0.0;
  };
  [[nodiscard]] const Place& PlaceOf(const OpiBelief& belief);

  std::string prefix_;
  ShapeBoard board_;
  std::map<int, Place> places_;  ///< as drawn, by id
};

}  // namespace limpet
