// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/helm/view_decision.hpp"
#include "limpet/shapes/shape_board.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// What viewers draw of the helm's world: area and operating region, home, the path in force, and
/// where the next best options would have ended. Labels begin with the vehicle's name.
class HelmDrawing {
 public:
  HelmDrawing(std::string vehicle, ShapeBoard::Post post);

  void DrawArea(const SurveyArea& area);
  void DrawHome(const HomePoint& home);
  /// REQUIRES: a path was chosen.
  void DrawDecision(const ViewDecision& decision);
  /// Nothing is being followed any more.
  void ErasePath();

 private:
  void DrawShape(const SurveyShape& shape);
  void DrawRing(const std::string& what, const SimplePolygon& polygon, const std::string& color);
  [[nodiscard]] std::string Label(const std::string& what) const;

  std::string vehicle_;
  ShapeBoard board_;
  bool has_path_ = false;
};

}  // namespace limpet
