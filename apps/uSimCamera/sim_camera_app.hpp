// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "limpet/app/app.hpp"
#include "limpet/core/camera_params.hpp"
#include "limpet/core/lens_model.hpp"
#include "limpet/core/params.hpp"
#include "limpet/imaging/picture_renderer.hpp"
#include "limpet/mission/fault_schedule.hpp"
#include "limpet/mission/scenario.hpp"
#include "limpet/mission/seabed.hpp"
#include "limpet/simulation/stamp_error.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vision/box_model.hpp"
#include "limpet/vision/contrast_model.hpp"
#include "limpet/vision/lens_image.hpp"
#include "limpet/vision/scene_renderer.hpp"
#include "limpet/vision/sphere.hpp"

namespace limpet {

/// The down-looking camera of the simulated vehicle: images of the scenario's seabed and objects,
/// or directly the boxes that a detector would find in them.
class SimCameraApp final : public App {
 public:
  struct Params {
    std::string scenario = "scenario.yaml";
    std::string camera = "scenario";
    Meters least_depth{0.5};
    CameraTiming timing;
    CameraParams geometry;
    BoxModelConstants boxes;  ///< where it makes boxes
    template <class Visitor>
    void Describe(Visitor& visit) {
      using namespace literals;
      visit("scenario", scenario, "The truth; relative to the mission's folder");
      visit.Choice("camera", camera, "Images, boxes, or what the scenario says",
                   {"scenario", "rendered", "boxes"});
      timing.Describe(visit);
      visit("least_depth_m", least_depth, "No frames while the body is higher than this",
            InRange(0.0_m, 100.0_m));
      geometry.Describe(visit);
      boxes.Describe(visit);
    }
  };

  /// Throws ConfigError if the scenario cannot be read.
  SimCameraApp(const AppContext& context, const Params& params);
  void Report(ReportLines& report) const override;

 private:
  void OnTruth(const Stamped<SimTruth>& truth);
  /// Whether one of the scenario's obstacles stands before an object's middle.
  [[nodiscard]] bool IsHidden(const SimTruth& truth, const Sphere& sphere) const;
  /// Those that no obstacle hides.
  [[nodiscard]] std::vector<Sphere> InSight(const SimTruth& truth,
                                            std::span<const Sphere> shown) const;
  /// Where the objects appear to be in an image taken now.
  [[nodiscard]] std::vector<Sphere> Shown(const Stamped<SimTruth>& truth);
  void MakeCamera(const AppContext& context, const Scenario& scenario);
  [[nodiscard]] Image Picture(const Stamped<SimTruth>& truth, std::span<const Sphere> shown);
  [[nodiscard]] CameraFrame MakeImage(const Stamped<SimTruth>& truth, std::span<const Sphere> shown,
                                      Seconds stamp);
  [[nodiscard]] Detections MakeBoxes(const SimTruth& truth, std::span<const Sphere> shown,
                                     Seconds stamp);
  /// Boxes that the scenario's fault adds to a frame.
  void AddFalseBoxes(std::vector<Box>& boxes);
  /// How the ground stands out in an image that is not made.
  void PublishContrast(const SimTruth& truth, Seconds stamp);
  /// What was exposed at least the latency ago.
  void PublishReady(Seconds now);

  Params params_;
  SimulatedErrors::Camera errors_;
  LensModel lens_;
  CameraModel camera_;                   ///< the lens' enclosing pinhole, as it truly stands
  std::optional<LensImage> lens_image_;  ///< if images are rendered and the lens distorts
  FaultSchedule faults_;
  StampError stamp_;
  std::vector<Sphere> spheres_;              ///< in their places
  std::vector<ObjectMotionParams> motions_;  ///< of each
  std::vector<UprightBody> bodies_;          ///< that the camera does not see through
  std::optional<Seconds> start_;             ///< of the session
  std::optional<SceneRenderer> renderer_;    ///< of the plain look, unless boxes are drawn
  std::vector<Solid> solids_;                ///< the spheres' forms, for the real look
  std::optional<PictureRenderer> pictures_;  ///< of the real look
  Seabed seabed_;
  std::optional<ContrastModel> contrast_model_;  ///< if boxes are drawn
  Random contrast_random_;
  std::optional<Seconds> last_contrast_;
  BoxModel box_model_;
  Random box_random_, storm_random_;
  std::optional<double> last_slot_;  ///< exposures are the first truth in each 1/rate of MOOS time
  std::uint32_t frame_ = 0;
  std::deque<std::pair<Seconds, std::variant<CameraFrame, Detections>>> exposed_;
};

}  // namespace limpet
