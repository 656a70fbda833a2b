// SPDX-License-Identifier: MIT
// pMap and the mail of a survey.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "apps/pMap/map_app.hpp"
#include "estimation/mapping/saved_map.hpp"
#include "limpet/session/map_tile_table.hpp"
#include "tests/support/flyover.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {

inline constexpr SurveyArea kArea{
    .north_min = -15, .north_max = 15, .east_min = -18, .east_max = 18};

inline const Eigen::Vector3d kCovariance(0.04, 0.04, 0.09);  // of each place [m^2]

inline Landmark LandmarkOf(const trial::Sphere& sphere) {
  return {.id = sphere.landmark.value(),
          .object = {.p_W = sphere.ned, .cov_W = kCovariance.asDiagonal(), .color = sphere.color},
          .detections = 5};
}

struct FormerOpi {
  int id;
  Eigen::Vector3d ned;
  std::string color;
};
inline SessionPrior Former(const std::vector<FormerOpi>& objects) {
  SessionPrior prior;
  prior.session = "discovery";
  for (const FormerOpi& object : objects) {
    prior.former.objects.push_back(
        {.id = object.id,
         .object = {.p_W = object.ned, .cov_W = kCovariance.asDiagonal(), .color = object.color},
         .log_likelihood_ratio = 8.0,
         .looks = 5});
  }
  return prior;
}

/// Where a former session looked from on this leg, two views a metre.
inline void AddViews(const trial::Leg& leg, SessionPrior& prior) {
  const Seconds start =
      prior.views.empty() ? Seconds(0.0) : prior.views.back().frame.exposure + Seconds(20.0);
  for (int i = 0; 0.5 * i <= leg.length; ++i) {
    prior.views.push_back({.frame = {.exposure = start + Seconds(i),
                                     .X_WB = {{leg.north + 0.5 * i, leg.east, leg.down}},
                                     .altitude = leg.altitude},
                           .altitude_age = Seconds(0.0)});
  }
}

/// pMap with mail as a survey would send it.
class MapAppTest : public ::testing::Test {
 protected:
  /// The map as its tiles tell it.
  [[nodiscard]] Expected<SemanticOctree> ToldMap() const {
    MapFiles files;
    for (const MessagePtr& message : link_.published) {
      if (message->name != topics::kMapTile.name) continue;
      const MapTile tile = TopicCodec<MapTile>::Decode(message->value).value();
      if (tile.packed.empty()) {
        files.erase(TileFile(tile.key));
      } else {
        files[TileFile(tile.key)] = tile.packed;
      }
    }
    return OctreeOf(files);
  }
  AppContext Context() {
    AppContext context;
    context.name = "pMap";
    context.link = &link_;
    return context;
  }

  void Survey(const trial::Leg& leg, const std::vector<trial::Sphere>& spheres,
              const trial::Detector& detector = {}) {
    for (const ObservedFrame& frame : trial::Fly(leg, link_.time, spheres, detector, random_)) {
      link_.time = frame.exposure;
      link_.Send(app_, topics::kNavCameraFrame, frame);
      app_.Tick(link_.time);
    }
    link_.time += Seconds(20.0);
  }
  /// `former_of`: by landmark, which former object pNav matched it with.
  void Confirm(const std::vector<trial::Sphere>& spheres, std::map<int, int> former_of = {}) {
    Landmarks landmarks;
    for (const trial::Sphere& sphere : spheres) {
      landmarks.landmarks.push_back(LandmarkOf(sphere));
      const auto former = former_of.find(sphere.landmark.value());
      if (former != former_of.end()) landmarks.landmarks.back().former.id = former->second;
    }
    link_.Send(app_, topics::kNavLandmarks, landmarks);
    link_.time += Seconds(1.0);
    app_.Tick(link_.time);
  }
  std::vector<OpiBelief> Objects() {
    return link_.Last(topics::kMapOpis).value_or(OpiBeliefs{}).opis;
  }

  TestLink link_;
  Random random_{1};
  MapApp app_{Context(), MapApp::Params{}};
};

inline const trial::Sphere kYellow{.ned = {4, 1, 5.5}, .color = "yellow", .landmark = 3};

}  // namespace limpet
