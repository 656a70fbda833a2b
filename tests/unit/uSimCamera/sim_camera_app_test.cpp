// SPDX-License-Identifier: MIT
#include "apps/uSimCamera/sim_camera_app.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

std::string TextOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class SimCamera : public ::testing::Test {
 protected:
  SimCamera() { Write("rendered"); }

  void Write(const std::string& camera) {
    std::ofstream(folder_.path() / "scenario.yaml")
        << "seabed: {depth_m: 7.5, slope_deg: 0, slope_toward_deg: 0, roughness_m: 0.05, seed: 1}\n"
           "water: {visibility_m: 8, current_north_mps: 0, current_east_mps: 0}\n"
           "start: {north_m: 0, east_m: 0, heading_deg: 0}\n"
           "opis:\n"
           "  - {name: A, color: yellow, radius_m: 0.5, discovery: [0, 0, 7], change: null}\n"
           "camera: "
        << camera << "\n";
  }
  /// Boxes of a world with more to it: lines of scenario.yaml, and of the object.
  void WriteWith(const std::string& lines, const std::string& of_object = "") {
    Write("boxes");
    std::string text = TextOf(folder_.path() / "scenario.yaml");
    text.replace(text.find("radius_m: 0.5"), 13, "radius_m: 0.5" + of_object);
    std::ofstream(folder_.path() / "scenario.yaml") << text << lines;
  }
  SimCameraApp Make(const std::string& session, const SimCameraApp::Params& params = {}) {
    AppContext context;
    context.name = "uSimCamera";
    context.link = &link_;
    context.mission_folder = folder_.path();
    context.session = session;
    return SimCameraApp(context, params);
  }
  /// Truth at 50 Hz over `seconds`, level at `depth`.
  void Fly(SimCameraApp& app, double seconds, double depth) {
    SimTruth truth;
    truth.down = depth;
    const double start = link_.time.value();
    for (int i = 0; i < static_cast<int>(50.0 * seconds); ++i) {
      link_.time = Seconds(start + 0.02 * i);
      link_.Send(app, topics::kSimTruth, truth);
    }
    link_.time = Seconds(start + seconds);
  }
  int CountOf(const std::string& name) const {
    return static_cast<int>(std::ranges::count_if(
        link_.published, [&name](const MessagePtr& message) { return message->name == name; }));
  }

  TemporaryFolder folder_;
  TestLink link_;
};

TEST_F(SimCamera, TakesFourPicturesPerSecondUnderWater) {
  SimCameraApp app = Make("discovery");
  Fly(app, 2.0, 3.5);
  EXPECT_EQ(CountOf("CAMERA_FRAME"), 8);
}

TEST_F(SimCamera, TakesPicturesWithTheRealLookIfTheScenarioAsksForIt) {
  SimCameraApp plain = Make("discovery");
  Fly(plain, 0.3, 3.5);
  const auto clean = link_.Last(topics::kCameraFrame);
  Write("rendered\nimage: {look: real, seabed: {kind: sand}}");
  SimCameraApp real = Make("discovery");
  Fly(real, 0.3, 3.5);
  EXPECT_EQ(CountOf("CAMERA_FRAME"), 4);
  EXPECT_NE(clean->bgr, link_.Last(topics::kCameraFrame)->bgr);
}

TEST_F(SimCamera, TakesNoneAtTheSurface) {
  SimCameraApp app = Make("discovery");
  Fly(app, 1.0, 0.2);
  EXPECT_TRUE(link_.published.empty());
}

TEST_F(SimCamera, StampsTheTimeOfTheTruth) {
  SimCameraApp app = Make("discovery");
  SimTruth truth;
  truth.down = 3.0;
  link_.time = Seconds(1767225601.5);
  link_.Send(app, topics::kSimTruth, truth);
  const auto frame = link_.Last(topics::kCameraFrame);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->exposure.value(), 1767225601.5);
  EXPECT_EQ(frame->width_px, 640);
}

TEST_F(SimCamera, SameSeedAndSessionGiveTheSamePicture) {
  SimCameraApp one = Make("discovery");
  Fly(one, 0.02, 3.5);
  const auto first = link_.Last(topics::kCameraFrame);
  SimCameraApp two = Make("discovery");
  Fly(two, 0.02, 3.5);
  ASSERT_TRUE(first);
  EXPECT_EQ(CountOf("CAMERA_FRAME"), 2);
  EXPECT_EQ(first->bgr, link_.Last(topics::kCameraFrame)->bgr);
}

TEST_F(SimCamera, DrawsBoxesWhereTheScenarioSaysSo) {
  Write("boxes");
  SimCameraApp app = Make("discovery");
  Fly(app, 5.0, 3.5);
  EXPECT_EQ(CountOf("CAMERA_FRAME"), 0);
  EXPECT_EQ(CountOf("DETECTIONS"), 20);
  const auto detections = link_.Last(topics::kDetections);
  ASSERT_TRUE(detections);
  ASSERT_FALSE(detections->boxes.empty());
  EXPECT_EQ(detections->boxes[0].color, "yellow");
  EXPECT_NEAR(detections->boxes[0].u, 320.0, 3.0);
}

TEST_F(SimCamera, ParameterOverridesTheScenario) {
  SimCameraApp::Params params;
  params.camera = "boxes";
  SimCameraApp app = Make("discovery", params);
  Fly(app, 0.5, 3.5);
  EXPECT_EQ(CountOf("DETECTIONS"), 2);
}

TEST_F(SimCamera, ShowsOnlyWhatIsThereInTheSession) {
  SimCameraApp::Params params;
  params.camera = "boxes";
  SimCameraApp app = Make("change", params);
  Fly(app, 5.0, 3.5);
  EXPECT_LE(link_.Last(topics::kDetections)->boxes.size(), 0U);
}

TEST_F(SimCamera, RefusesAScenarioThatIsNotThere) {
  SimCameraApp::Params params;
  params.scenario = "nowhere.yaml";
  EXPECT_THROW(Make("discovery", params), ConfigError);
}

TEST_F(SimCamera, PublishesAFrameItsLatencyAfterTheExposure) {
  SimCameraApp::Params params;
  params.camera = "boxes";
  params.timing.latency = Seconds(0.3);
  SimCameraApp app = Make("discovery", params);
  Fly(app, 0.2, 3.5);
  EXPECT_EQ(CountOf("DETECTIONS"), 0);
  Fly(app, 0.2, 3.5);
  EXPECT_EQ(CountOf("DETECTIONS"), 1);
  EXPECT_GT((link_.time - link_.Last(topics::kDetections)->exposure).value(), 0.3);
}

/// Mean of the middle of the object's boxes.
struct Seen {
  double u = 0.0, v = 0.0;
  int boxes = 0;
};
Seen SeenIn(const TestLink& link) {
  Seen seen;
  for (const MessagePtr& message : link.published) {
    if (message->name != "DETECTIONS") continue;
    const auto frame = TopicCodec<Detections>::Decode(message->value);
    for (const Box& box : frame->boxes) {
      if (box.color != "yellow") continue;
      seen.u += box.u, seen.v += box.v;
      ++seen.boxes;
    }
  }
  seen.u /= std::max(seen.boxes, 1), seen.v /= std::max(seen.boxes, 1);
  return seen;
}

TEST_F(SimCamera, ATiltedCameraShowsAnObjectElsewhere) {
  WriteWith("errors:\n  camera: {pitch_deg: 3, roll_deg: 2}\n");
  SimCameraApp app = Make("discovery");
  Fly(app, 20.0, 3.5);
  const Seen seen = SeenIn(link_);
  ASSERT_GT(seen.boxes, 40);
  const CameraModel camera = SimCameraApp::Params{}.geometry.geometry();
  // Pitched up it looks ahead: what lies below moves aft, down in the image.
  EXPECT_NEAR(seen.v, 240.0 + camera.fy * std::tan(RadiansFromDegrees(3.0)), 1.5);
  // Rolled to starboard it looks to port: what lies below moves to starboard.
  EXPECT_NEAR(seen.u, 320.0 + camera.fx * std::tan(RadiansFromDegrees(2.0)), 1.5);
}

TEST_F(SimCamera, ACameraOffItsPlaceShowsAnObjectElsewhere) {
  WriteWith("errors: {camera: {off_m: [0.2, 0, 0]}}\n");
  SimCameraApp app = Make("discovery");
  Fly(app, 20.0, 3.5);
  const CameraModel camera = SimCameraApp::Params{}.geometry.geometry();
  EXPECT_NEAR(SeenIn(link_).v, 240.0 + camera.fy * 0.2 / 3.5, 1.5);
}

TEST_F(SimCamera, ALensThatDistortsDrawsBoxesToTheMiddle) {
  WriteWith("errors: {camera: {off_m: [0, 1.7, 0]}}\n");
  SimCameraApp straight = Make("discovery");
  Fly(straight, 20.0, 3.5);
  const Seen pinhole = SeenIn(link_);
  link_.published.clear();
  SimCameraApp::Params params;
  params.geometry.distortion = {-0.18, 0.03, 0.0, 0.0, 0.0};
  SimCameraApp app = Make("discovery", params);
  Fly(app, 20.0, 3.5);
  const Seen seen = SeenIn(link_);
  ASSERT_GT(seen.boxes, 40);
  const LensModel lens = params.geometry.lens();
  const CameraModel camera = params.geometry.pinhole();
  const Eigen::Vector2d there = lens.FromPinhole(camera, Eigen::Vector2d(pinhole.u, pinhole.v));
  EXPECT_GT(std::abs(there.x() - pinhole.u), 6.0) << "else this shows nothing";
  EXPECT_NEAR(seen.u, there.x(), 3.0) << "a box's middle is not quite that of the sphere";
  EXPECT_NEAR(seen.v, there.y(), 3.0);
}

TEST_F(SimCamera, AnImageThroughALensIsAsLargeAsTheVehiclesFileSays) {
  SimCameraApp::Params params;
  params.geometry.distortion = {-0.18, 0.03, 0.0, 0.0, 0.0};
  SimCameraApp app = Make("discovery", params);
  Fly(app, 1.0, 3.5);
  const auto frame = link_.Last(topics::kCameraFrame);
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(frame->width_px, params.geometry.width_px);
  EXPECT_EQ(frame->height_px, params.geometry.height_px);
}

TEST_F(SimCamera, StampsFramesTooLateAndHandsThemOnThen) {
  WriteWith("errors: {camera: {stamp_delay_s: 0.2}}\n");
  SimCameraApp app = Make("discovery");
  SimTruth truth;
  truth.down = 3.5;
  link_.time = Seconds(2000.0);
  link_.Send(app, topics::kSimTruth, truth);
  EXPECT_EQ(CountOf("DETECTIONS"), 0);
  link_.time = Seconds(2000.2);
  link_.Send(app, topics::kSimTruth, truth);
  ASSERT_EQ(CountOf("DETECTIONS"), 1);
  EXPECT_EQ(link_.Last(topics::kDetections)->exposure, Seconds(2000.2));
}

TEST_F(SimCamera, ReadsItsRowsOneAfterAnother) {
  WriteWith("errors: {camera: {readout_s: 0.4}}\n");
  SimCameraApp app = Make("discovery");
  SimTruth truth;
  truth.down = 3.5;
  truth.u = 0.5;  // said to move, held where the object is below
  for (int i = 0; i < 1000; ++i) {
    link_.time = Seconds(3000.0 + 0.02 * i);
    link_.Send(app, topics::kSimTruth, truth);
  }
  const CameraModel camera = SimCameraApp::Params{}.geometry.geometry();
  EXPECT_NEAR(SeenIn(link_).v, 240.0 + camera.fy * 0.5 * 0.2 / 3.5, 2.5);
}

TEST_F(SimCamera, ShowsObjectsThatMoveWhereTheyHaveGone) {
  WriteWith("", ", drift_mps: [0, 0.05, 0]");
  SimCameraApp app = Make("discovery");
  Fly(app, 10.0, 3.5);
  link_.published.clear();
  Fly(app, 2.0, 3.5);
  const CameraModel camera = SimCameraApp::Params{}.geometry.geometry();
  EXPECT_NEAR(SeenIn(link_).u, 320.0 + camera.fx * 0.55 / 3.5, 4.0);
}

TEST_F(SimCamera, AnObjectThatSwaysKeepsItsMiddle) {
  WriteWith("", ", sway_m: [0, 0.3, 0], sway_period_s: 5");
  SimCameraApp app = Make("discovery");
  Fly(app, 20.0, 3.5);
  const Seen swaying = SeenIn(link_);
  EXPECT_NEAR(swaying.u, 320.0, 4.0);
  double widest = 0.0;
  for (const MessagePtr& message : link_.published) {
    const auto frame = TopicCodec<Detections>::Decode(message->value);
    if (!frame) continue;  // how the ground stands out
    for (const Box& box : frame->boxes)
      widest = std::max(widest, box.color == "yellow" ? std::abs(box.u - 320.0) : 0.0);
  }
  EXPECT_GT(widest, 25.0);
}

TEST_F(SimCamera, TellsHowTheGroundStandsOutOnlyWhereNobodyElseCan) {
  Write("boxes");
  SimCameraApp boxes = Make("discovery");
  Fly(boxes, 10.0, 3.5);
  EXPECT_NEAR(CountOf("GROUND_CONTRAST"), 10, 1);
  const double near = link_.Last(topics::kGroundContrast)->green;
  Fly(boxes, 10.0, 0.6);
  EXPECT_LT(link_.Last(topics::kGroundContrast)->green, near);
  link_.published.clear();
  Write("rendered");
  SimCameraApp images = Make("discovery");
  Fly(images, 2.0, 3.5);
  EXPECT_EQ(CountOf("GROUND_CONTRAST"), 0) << "pDetect measures it";
}

TEST_F(SimCamera, AStormOfFalseBoxesComesAndGoesAndLeavesTheOtherBoxesAsTheyAre) {
  const auto boxes = [this](const std::string& lines) {
    WriteWith(lines);
    link_.published.clear();
    link_.time = Seconds(0.0);
    SimCameraApp app = Make("discovery");
    Fly(app, 3.0, 3.5);
    std::vector<std::vector<Box>> frames;
    for (const MessagePtr& message : link_.published) {
      if (message->name != topics::kDetections.name) continue;
      frames.push_back(TopicCodec<Detections>::Decode(message->value)->boxes);
    }
    return frames;
  };
  const auto calm = boxes("");
  const auto stormy = boxes("faults: [{what: false_boxes, size: 40, at_s: 1, for_s: 1}]\n");
  ASSERT_EQ(stormy.size(), calm.size());
  std::size_t stormy_frames = 0;
  for (std::size_t i = 0; i < calm.size(); ++i) {
    if (stormy[i].size() == calm[i].size()) continue;
    ++stormy_frames;
    EXPECT_EQ(stormy[i].size(), calm[i].size() + 40);
    EXPECT_TRUE(std::ranges::is_sorted(stormy[i], std::ranges::greater(), &Box::confidence));
    for (const Box& box : calm[i]) {
      EXPECT_EQ(std::ranges::count(stormy[i], box.u, &Box::u), 1);
    }
  }
  EXPECT_EQ(stormy_frames, 4U);
  const auto again = boxes("faults: [{what: false_boxes, size: 40, at_s: 1, for_s: 1}]\n");
  for (std::size_t i = 0; i < stormy.size(); ++i) {
    EXPECT_TRUE(std::ranges::equal(stormy[i], again[i], {}, &Box::u, &Box::u)) << "frame " << i;
  }
}

TEST_F(SimCamera, ARenderingCameraSaysThatItMakesNoFalseBoxes) {
  const auto warnings = [this](const std::string& lines) {
    link_.published.clear();
    std::ofstream(folder_.path() / "scenario.yaml", std::ios::app) << lines;
    SimCameraApp app = Make("discovery");
    app.Iterate(link_.time);
    std::string text;
    for (const MessagePtr& message : link_.published) {
      if (message->name == "USIMCAMERA_WARNINGS") text = std::get<std::string>(message->value);
    }
    return text;
  };
  EXPECT_EQ(warnings("").find("NO_FALSE_BOXES"), std::string::npos);
  EXPECT_NE(warnings("faults: [{what: false_boxes}]\n").find("NO_FALSE_BOXES"), std::string::npos);
}

TEST_F(SimCamera, SeesNoObjectBehindAnObstacle) {
  const auto boxes = [this](const std::string& east) {
    WriteWith("obstacles:\n  - {name: wall, shape: box, north_m: 0, east_m: " + east +
              ", size_m: [6, 0.3], height_m: 6}\n");
    SimCameraApp app = Make("discovery");
    SimTruth truth;
    truth.down = 3.0;
    truth.east = 2.0;
    int seen = 0;
    for (int i = 0; i < 40; ++i) {
      link_.time += Seconds(0.25);
      link_.Send(app, topics::kSimTruth, truth);
    }
    for (const MessagePtr& message : link_.published) {
      const auto detections = TopicCodec<Detections>::Decode(message->value);
      if (message->name == "DETECTIONS" && detections) {
        seen += static_cast<int>(detections->boxes.size());
      }
    }
    link_.published.clear();
    return seen;
  };
  EXPECT_GT(boxes("-1.5"), 20) << "the wall stands behind it";
  EXPECT_EQ(boxes("1"), 0);
}

}  // namespace
}  // namespace limpet
