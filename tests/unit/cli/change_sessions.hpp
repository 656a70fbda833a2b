// SPDX-License-Identifier: MIT
// pMap and pSession fly sessions, embedded, for `limpet change` to judge what they saved.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/change.hpp"
#include "limpet/app/embedded.hpp"
#include "limpet/session/saved_session.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "tests/support/flyover.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {

inline const Eigen::Vector3d kCovariance(0.04, 0.04, 0.09);  // of each place [m^2]
inline const trial::Sphere kStays{.ned = {4, 1, 5.5}, .color = "yellow", .landmark = 1};
inline const trial::Sphere kGoes{.ned = {9, -1, 6.0}, .color = "orange", .landmark = 2};
inline const trial::Sphere kComes{.ned = {0, 0.5, 6.2}, .color = "green", .landmark = 3};
inline const trial::Sphere kOnUnseenGround{.ned = {4, 14, 6.0}, .color = "orange", .landmark = 4};

inline ConfigBlock MapBlock() {
  ConfigBlock block{.name = "pMap", .where = {}, .entries = {}};
  for (const auto& [key, value] :
       {std::pair{"camera_fov_across_deg", "80"}, std::pair{"camera_fov_along_deg", "60"},
        std::pair{"camera_width_px", "640"}, std::pair{"camera_height_px", "480"},
        std::pair{"object_radius_m", "0.5"}, std::pair{"visibility_m", "6"},
        std::pair{"detection_best", "0.8"}, std::pair{"presence_prior", "0.03"},
        std::pair{"decide_at", "0.93"}}) {
    block.entries.push_back({.key = key, .value = value, .where = {}});
  }
  return block;
}

class ChangeVerbTest : public ::testing::Test {
 protected:
  EmbeddedCommunity Community(const std::string& session) {
    return EmbeddedCommunity({.community = "alpha",
                              .apps = {"pMap", "pSession"},
                              .blocks = {MapBlock()},
                              .globals = {},
                              .mission_folder = {},
                              .run_folder = folder_.path() / session,
                              .prior_folder = session == "change" ? folder_.path() / "discovery"
                                                                  : std::filesystem::path(),
                              .session = session,
                              .seed = 1,
                              .may_hear = nullptr});
  }
  template <class T>
  static void Say(EmbeddedCommunity& community, const Topic<T>& topic, const T& value) {
    community.Poke(topic.name, TopicCodec<T>::Encode(value));
  }
  static void Wait(EmbeddedCommunity& community, double seconds) {
    const Seconds end = community.elapsed() + Seconds(seconds);
    while (community.elapsed() < end)
      community.Step();
  }
  void Pass(EmbeddedCommunity& community, const trial::Leg& leg,
            const std::vector<trial::Sphere>& spheres) {
    for (const ObservedFrame& frame :
         trial::Fly(leg, community.now(), spheres, {.detects = 0.8}, random_)) {
      Say(community, topics::kNavCameraFrame, frame);
      Wait(community, 0.25);
    }
    Wait(community, 20.0);
  }
  /// As pNav would say it: kStays is object 1 of the discovery session.
  static std::optional<int> FormerOf(const std::string& session, const trial::Sphere& sphere) {
    const bool is_matched = session == "change" && sphere.landmark == kStays.landmark;
    return is_matched ? std::optional(1) : std::nullopt;
  }
  static void Confirm(EmbeddedCommunity& community, const std::string& session,
                      const std::vector<trial::Sphere>& spheres, const Eigen::Vector3d& off) {
    Landmarks landmarks;
    for (const trial::Sphere& sphere : spheres) {
      landmarks.landmarks.push_back({.id = sphere.landmark.value(),
                                     .object = {.p_W = sphere.ned + off,
                                                .cov_W = kCovariance.asDiagonal(),
                                                .color = sphere.color},
                                     .detections = 9,
                                     .former = {.id = FormerOf(session, sphere)}});
    }
    Say(community, topics::kNavLandmarks, landmarks);
    Wait(community, 1.0);
  }
  /// Passes along these lines, the smoother's first idea of the objects, and at the end a fix
  /// that moves all of it.
  void FlySession(const std::string& session, const std::vector<trial::Sphere>& spheres,
                  const std::vector<double>& easts) {
    EmbeddedCommunity community = Community(session);
    Say(community, topics::kSurveyPhase, std::string("ALIGN"));
    Pass(community, {.north = 4, .east = 14, .length = 1}, {});  // at the surface
    Say(community, topics::kSurveyPhase, std::string("SURVEY"));
    for (const double east : easts) {
      Pass(community, {.north = -3, .east = east, .length = 15}, spheres);
      Confirm(community, session, spheres, {0.15, -0.1, 0.0});
    }
    Pass(community, {.north = -3, .east = 1, .length = 4, .altitude = 9.0}, {});  // too high
    Say(community, topics::kSurveyPhase, std::string("FIX"));
    const double t = community.now().value();
    Say(community, topics::kNavTrackShift, TrackShift{{{t, 0.2, 0.1, 0.0, 0.0}}});
    Confirm(community, session, spheres, {0.22, 0.08, 0.0});
    Say(community, topics::kSessionSave, std::string("home"));
    Wait(community, 1.0);
    community.Finish();
  }
  nlohmann::json Change(std::vector<std::string> more = {}, const std::string& b = "change") {
    std::vector<std::string> words{"--session-a", (folder_.path() / "discovery").string(),
                                   "--session-b", (folder_.path() / b).string()};
    words.insert(words.end(), more.begin(), more.end());
    ::testing::internal::CaptureStdout();
    try {
      const int code = RunChange(words);
      const std::string out = ::testing::internal::GetCapturedStdout();
      EXPECT_EQ(code, kOk);
      return nlohmann::json::parse(out);
    } catch (...) {
      static_cast<void>(::testing::internal::GetCapturedStdout());
      throw;
    }
  }
  /// What the vehicle said last, by colour and place.
  OpiBeliefs OnBoard() {
    return LoadSavedSession(folder_.path() / "change", "change").memory.objects;
  }
  TemporaryFolder folder_;
  Random random_{3};
};

}  // namespace limpet
