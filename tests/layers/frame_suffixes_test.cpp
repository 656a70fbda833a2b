// SPDX-License-Identifier: MIT
#include "tests/layers/frame_suffixes.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/layers/tree_files.hpp"

namespace limpet::layers {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A member that is in no frame, or that cannot say so, and why.
struct Frameless {
  std::string_view member, why;
};

constexpr std::array kFrameless = {
    Frameless{"BoxReading::half_angle", "image"},
    Frameless{"Blob::center", "image"},
    Frameless{"Blob::covariance", "image"},
    Frameless{"Ellipse::center", "image"},
    Frameless{"Ellipse::axes", "image"},
    Frameless{"Layout::corner", "picture"},
    Frameless{"Layout::size", "picture"},
    Frameless{"Contrast::inside", "colour"},
    Frameless{"Contrast::lit", "colour"},
    Frameless{"Contrast::outside", "colour"},
    Frameless{"Contrast::weights", "colour"},
    Frameless{"CameraErrors::lever_and_delay", "metres and a time"},
    Frameless{"Deviation::value", "coefficients"},
    Frameless{"Deviation::sd", "coefficients"},
    Frameless{"VehicleParams::drag_coefficient", "coefficients"},
    Frameless{"BorderVariable::x", "any"},
    Frameless{"ChainValues::border", "any"},
    Frameless{"Block::L", "any"},
    Frameless{"Block::d", "any"},
    Frameless{"SourceErrors::sigma", "any"},
    Frameless{"SourceErrorEstimate::value", "any"},
    Frameless{"SourceErrorEstimate::sd", "any"},
    Frameless{"ScenarioObstacle::size_m", "lengths"},
};

/// Headers whose functions take vectors that are in no frame, or that are true in any, and why.
struct OfAnyFrame {
  std::string_view path, why;
};

constexpr std::array kOfAnyFrame = {
    OfAnyFrame{"share/limpet/core/cross_product.hpp", "any"},
    OfAnyFrame{"share/limpet/core/lens_model.hpp", "image"},
    OfAnyFrame{"share/limpet/core/params.hpp", "any"},
    OfAnyFrame{"share/limpet/figures/", "picture"},
    OfAnyFrame{"share/limpet/scoring/disc_in_rectangle.hpp", "the rectangle's axes"},
    OfAnyFrame{"share/limpet/survey/port_side.hpp", "any"},
    OfAnyFrame{"share/limpet/vision/ellipse.hpp", "image"},
    OfAnyFrame{"share/limpet/vision/paint_classifier.hpp", "colour"},
    OfAnyFrame{"estimation/association/pair_evidence.hpp", "any"},
    OfAnyFrame{"estimation/navigation/motion_comparison.hpp", "any"},
    OfAnyFrame{"estimation/navigation/odometry_errors.hpp", "errors of a bridge"},
    OfAnyFrame{"estimation/smoothing/", "border variables, of any kind"},
};

std::string Letters() {
  return ReadFrameLetters(
      ReadAll(std::filesystem::path(LIMPET_SOURCE_DIR) / "docs/frames-and-units.md"));
}

std::vector<std::string> Found(std::string_view text) {
  return MembersWithoutFrame({{"a.hpp", std::string(text)}}, "WBC");
}

TEST(FrameSuffixes, AreOnEveryVectorThatOtherFilesRead) {
  std::vector<std::string> complaints = MembersWithoutFrame(TreeFiles(), Letters());
  for (const auto& [member, why] : kFrameless) {
    EXPECT_EQ(std::erase_if(complaints,
                            [m = member](const std::string& complaint) {
                              return complaint.ends_with(": " + std::string(m));
                            }),
              1U)
        << member << " (" << why << ") need not be excused";
  }
  EXPECT_THAT(complaints, IsEmpty());
}

TEST(FrameSuffixes, AreOnEveryVectorThatAFunctionTakes) {
  std::vector<std::string> complaints = ParametersWithoutFrame(TreeFiles(), Letters());
  for (const auto& [path, why] : kOfAnyFrame) {
    EXPECT_GE(
        std::erase_if(complaints, [p = path](const auto& each) { return each.starts_with(p); }), 1U)
        << path << " (" << why << ") need not be excused";
  }
  EXPECT_THAT(complaints, IsEmpty());
}

TEST(FrameSuffixes, AreTheFramesOfTheirPage) {
  EXPECT_EQ(ReadFrameLetters("- **World W**: **not** one.\n- **Body B**: x.\n"), "WB");
  EXPECT_EQ(Letters().substr(0, 3), "WBC");
}

TEST(FrameSuffixes, ThatAreLackingAreComplainedAbout) {
  EXPECT_THAT(
      Found("namespace limpet {\n"
            "struct Look {\n"
            "  Eigen::Vector3d p_W = Eigen::Vector3d::Zero(), arm{1.0, 2.0, 3.0};  ///< x\n"
            "  int Count() const { return 1; }\n"
            "  std::optional<Eigen::Vector2d> eye;\n"
            "  struct Part {\n"
            "    std::array<Eigen::Matrix3d, 4> turns;\n"
            "  };\n"
            "};\n"
            "class Eye {\n"
            " public:\n"
            "  Eigen::Vector3d v;\n"
            "};\n"
            "}\n"),
      ElementsAre("a.hpp: Look::arm", "a.hpp: Look::eye", "a.hpp: Part::turns", "a.hpp: Eye::v"));
}

TEST(FrameSuffixes, AreAskedOfAVectorByAnotherName) {
  EXPECT_THAT(Found("using Place = Eigen::Vector2d;\n"
                    "struct Look {\n"
                    "  Place from, to_W, at_px;\n"
                    "  std::vector<Canvas::Place> ring;\n"
                    "  cv::Place corner;\n"
                    "};\n"),
              ElementsAre("a.hpp: Look::from", "a.hpp: Look::ring"));
}

TEST(FrameSuffixes, AreAskedOfParametersInHeaders) {
  const std::string text =
      "using Place = Eigen::Vector2d;\n"
      "void Turn(const Eigen::Vector3d& by, double t,  // [s]\n"
      "          Eigen::Vector2d shift = {}, const std::vector<Place>& ring = {});\n"
      "void Go(const Eigen::Vector3d& p_WB, const Place& at_px, const PlanePoint& to);\n";
  EXPECT_THAT(
      ParametersWithoutFrame({{"a.hpp", text}, {"tests/a.hpp", text}, {"a.cpp", text}}, "WB"),
      ElementsAre("a.hpp: Turn(by)", "a.hpp: Turn(shift)", "a.hpp: Turn(ring)"));
}

TEST(FrameSuffixes, AreNotAskedOfWhatOthersDoNotReadNorOfResults) {
  EXPECT_THAT(
      Found("class Eye final {\n"
            " public:\n"
            "  [[nodiscard]] Eigen::Vector3d place() const { Eigen::Vector3d p; return p; }\n"
            "  void Turn(const Eigen::Vector3d& by, Eigen::Vector2d shift = {});\n"
            "  Eigen::Matrix3d R_WB;\n"
            "  Eigen::Matrix3d J_landmark;\n"
            " private:\n"
            "  struct Hidden {\n"
            "    Eigen::Vector3d q;\n"
            "  };\n"
            "  Eigen::Vector3d p_;\n"
            "};\n"
            "inline Eigen::Vector2d Half(const Eigen::Vector2d& whole) {\n"
            "  const Eigen::Vector2d half = 0.5 * whole;\n"
            "  return half;\n"
            "}\n"),
      IsEmpty());
  EXPECT_THAT(MembersWithoutFrame({{"a.cpp", "struct A { Eigen::Vector3d p; };"},
                                   {"tests/a.hpp", "struct A { Eigen::Vector3d p; };"}},
                                  "W"),
              IsEmpty());
}

}  // namespace
}  // namespace limpet::layers
