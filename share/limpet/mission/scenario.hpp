// SPDX-License-Identifier: MIT
// scenario.yaml: the truth, for the simulator and the scorer only.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/config.hpp"
#include "limpet/core/key_section.hpp"
#include "limpet/core/params.hpp"
#include "limpet/mission/fault_kinds.hpp"
#include "limpet/simulation/image_params.hpp"
#include "limpet/simulation/object_motion.hpp"
#include "limpet/simulation/object_shape.hpp"
#include "limpet/simulation/simulated_errors.hpp"
#include "limpet/simulation/tidal_current.hpp"
#include "limpet/simulation/upright_body.hpp"

namespace limpet {

struct ScenarioOpi {
  std::string name;
  std::string color;
  double radius_m = 0.5;
  std::map<std::string, std::optional<Eigen::Vector3d>>
      places;                   ///< session to NED of the centre; nothing: absent then
  ObjectShapeParams shape{};    ///< radius_m is its radius
  ObjectMotionParams motion{};  ///< from its place, which stays the truth that a run is judged by
  /// Where the object is in `session` (NED of its centre [m]); nothing if it is absent then.
  [[nodiscard]] std::optional<Eigen::Vector3d> Place(const std::string& session) const;
};

struct ScenarioSeabed {
  double depth_m = 7.5;    ///< at the datum
  double slope_deg = 0.0;  ///< going down towards slope_toward_deg (clockwise from north)
  double slope_toward_deg = 0.0;
  double roughness_m = 0.05;  ///< standard deviation of the relief
  int seed = 1;
};

/// Something that stands on the seabed and that the vehicle must not touch, in every session.
struct ScenarioObstacle {
  std::string name;
  std::string shape = "column";  ///< or box
  double north_m = 0.0, east_m = 0.0;
  double radius_m = 0.5;                                    ///< of a column
  Eigen::Vector2d size_m = Eigen::Vector2d::Constant(1.0);  ///< of a box, northwards and eastwards
  double height_m = 1.0;                                    ///< above the seabed below its centre
  [[nodiscard]] UprightBody Body(const ScenarioSeabed& seabed) const;
};

struct Scenario {
  using Seabed = ScenarioSeabed;
  Seabed seabed;
  struct Water {
    double visibility_m = 8.0;
    double current_north_mps = 0.0;
    double current_east_mps = 0.0;
    TidalCurrentParams current{};  ///< how it differs from that mean
  } water;
  struct Start {
    double north_m = 0.0;
    double east_m = 0.0;
    double heading_deg = 0.0;
  } start;
  std::vector<ScenarioOpi> opis;
  std::vector<ScenarioObstacle> obstacles{};
  std::string camera = "rendered";  ///< or boxes
  struct Sensors {
    double dvl_dropout_per_min = 0.0;
    double dvl_outlier_share = 0.0;
    /// True errors of this vehicle's sensors where they are not those of its file.
    std::optional<double> yaw_bias_deg_per_h, heading_sigma_deg, gps_sigma_m;
    double false_detections_per_image = 0.01;
  } sensors;
  SimulatedErrors errors{};
  ImageParams image{};
  std::vector<ScenarioFault> faults{};
};

/// Sections of scenario.yaml whose keys declare themselves, e.g. `errors.camera`.
[[nodiscard]] std::vector<KeySection> DeclaredScenarioSections();

/// Sessions that the scenario's objects have places in, by name; none without objects. Where one of
/// discovery and change is among them both are: an object without a place in one is absent then.
[[nodiscard]] std::vector<std::string> SessionsOf(const Scenario& scenario);

/// Reads and checks scenario.yaml; unknown keys, wrong types and values out of range are problems.
/// Throws ConfigError with every problem, each with file and line.
[[nodiscard]] Scenario LoadScenario(const std::filesystem::path& file);

/// Reads and checks a scenario's text, as LoadScenario does a file; `file` names it in problems.
/// Whether objects are in the water is left open without `checks_places`.
[[nodiscard]] Scenario ParseScenario(const std::string& text, const std::string& file,
                                     bool checks_places = true);

/// The scenario's obstacles as bodies.
[[nodiscard]] std::vector<UprightBody> BodiesOf(const Scenario& scenario);

/// NED depth of the true seabed at (north, east) [m]: slope plus a smooth random relief of standard
/// deviation roughness_m.
[[nodiscard]] double SeabedDepth(const Scenario::Seabed& seabed, const Eigen::Vector2d& p_W);

}  // namespace limpet
