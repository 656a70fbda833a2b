// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limpet/app/app.hpp"
#include "limpet/core/params.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/vision/detector.hpp"
#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

/// Boxes with class and confidence from every image, also when there are none.
class DetectApp final : public App {
 public:
  struct Params {
    std::string detector = "color_shape";
    double min_confidence = 0.3;
    std::string classes = "all";
    Seconds chips_every{1.0};
    double chip_confidence = 0.45;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit.Choice("detector", detector, "How objects are found; brings keys of its own",
                   DetectorNames());
      visit("min_confidence", min_confidence, "Boxes below are not published", InRange(0.0, 1.0));
      visit("classes", classes, "What to report, e.g. yellow,orange; or all");
      visit("chips_every_s", chips_every,
            "Shortest time between two images of which boxes are cut out (DETECTION_CHIPS)",
            InRange(Seconds(0.1), Seconds(1e6)));
      visit("chip_confidence", chip_confidence, "Boxes below are not cut out", InRange(0.0, 1.0));
    }
  };

  /// `detector` is what `params.detector` names. Throws ConfigError if a class is unknown.
  DetectApp(const AppContext& context, const Params& params, std::unique_ptr<Detector> detector);
  void Report(ReportLines& report) const override;

 private:
  void OnFrame(const Stamped<CameraFrame>& frame);
  /// Now and then, how strongly the ground stands out.
  void PublishContrast(ImageView picture, Seconds exposure);
  /// Now and then, pictures of the boxes in `last_`.
  void PublishChips(ImageView picture);
  [[nodiscard]] bool IsWanted(const Box& box) const;

  Params params_;
  std::vector<std::string> classes_;  ///< empty: all
  std::unique_ptr<Detector> detector_;
  int frames_ = 0, frames_with_boxes_ = 0;
  Detections last_;
  std::optional<Seconds> last_contrast_, last_chips_;
};

}  // namespace limpet
