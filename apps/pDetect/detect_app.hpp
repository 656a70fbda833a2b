// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "limpet/app/app.hpp"
#include "limpet/core/params.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/vision/detector.hpp"

namespace limpet {

/// Boxes with class and confidence from every image, also when there are none.
class DetectApp final : public App {
 public:
  struct Params {
    std::string detector = "color_shape";
    double min_confidence = 0.3;
    std::string classes = "all";
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit.Choice("detector", detector, "How objects are found", {"color_shape"});
      visit("min_confidence", min_confidence, "Boxes below are not published", InRange(0.0, 1.0));
      visit("classes", classes, "What to report, e.g. yellow,orange; or all");
    }
  };

  /// Throws ConfigError if a class is unknown.
  DetectApp(const AppContext& context, const Params& params);
  void Report(ReportLines& report) const override;

 private:
  void OnFrame(const Stamped<CameraFrame>& frame);
  [[nodiscard]] bool IsWanted(const Box& box) const;

  Params params_;
  std::vector<std::string> classes_;  ///< empty: all
  std::unique_ptr<Detector> detector_;
  int frames_ = 0, frames_with_boxes_ = 0;
  Detections last_;
};

}  // namespace limpet
