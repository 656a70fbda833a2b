// SPDX-License-Identifier: MIT
#include "estimation/replay/stream_meta.hpp"

#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Expected<StreamMeta> MetaOf(std::vector<std::string> lines) {
  lines.insert(lines.begin(), "key,v1");
  return ParseStreamMeta({.name = "meta.csv", .lines = std::move(lines), .damage = {}});
}

struct Nonsense {
  const char* line;
  const char* said;
};
class MetaThatNoVehicleHas : public ::testing::TestWithParam<Nonsense> {};

TEST_P(MetaThatNoVehicleHas, IsRefusedWithLineKeyValueAndWhatIsAllowed) {
  const auto meta = MetaOf({"image_size,640,360", GetParam().line});
  ASSERT_FALSE(meta.has_value());
  EXPECT_THAT(meta.error().text, HasSubstr(GetParam().said));
}

INSTANTIATE_TEST_SUITE_P(
    Lines, MetaThatNoVehicleHas,
    ::testing::Values(
        Nonsense{"cam_R_body_from_cam,0,-2.5,0.5,1,0,0,0,0.5,2.5",
                 "meta.csv:3: cam_R_body_from_cam: `0, -2.5, 0.5, 1, 0, 0, 0, 0.5, 2.5` is not "
                 "allowed; allowed: a rotation"},
        Nonsense{"cam_R_body_from_cam,1,0,0,0,1,0,0,0,-1", "meta.csv:3: cam_R_body_from_cam: "},
        Nonsense{"intrinsics_fx_fy_cx_cy,-490,490,320,180",
                 "meta.csv:3: intrinsics_fx_fy_cx_cy: `-490` is not allowed; allowed: greater"},
        Nonsense{"intrinsics_fx_fy_cx_cy,490,0,320,180", "`0` is not allowed"},
        Nonsense{"intrinsics_fx_fy_cx_cy,0.49,0.49,320,180", "focal lengths by which an image"},
        Nonsense{"intrinsics_fx_fy_cx_cy,490,490,320,720",
                 "meta.csv:3: intrinsics_fx_fy_cx_cy: `490, 490, 320, 720` is not allowed; "
                 "allowed: an axis (cx, cy) that meets the image of 640 x 360 pixels"},
        Nonsense{"image_size,-640,360", "meta.csv:3: image_size: `-640` is not allowed"},
        Nonsense{"dvl_pos_body,-20,0,18",
                 "meta.csv:3: dvl_pos_body: `-20, 0, 18` is not allowed; allowed: up to 20 m"},
        Nonsense{"cam_pos_body,25,0,15", "meta.csv:3: cam_pos_body: `25, 0, 15` is not allowed"},
        Nonsense{"opi_radius,0", "opi_radius: `0` is not allowed; allowed: greater than 0, up to"},
        Nonsense{"opi_radius,50", "opi_radius: `50` is not allowed"},
        Nonsense{"dvl_scale_sigma,-0.002", "dvl_scale_sigma: `-0.002` is not allowed"},
        Nonsense{"yaw_arw_rad_per_sqrt_s,nan", "yaw_arw_rad_per_sqrt_s: `nan` is not allowed"},
        Nonsense{"stated_noise_velocity_depth_tilt,0.01,0,0.005", "`0` is not allowed"}));

TEST(StreamMetaText, ARotationThatWasWrittenWithTwoDecimalsIsOne) {
  const auto meta = MetaOf({"cam_R_body_from_cam,0,-0.87,0.5,1,0,0,0,0.5,0.87"});
  ASSERT_TRUE(meta.has_value()) << meta.error().text;
  EXPECT_NEAR(meta->camera.R_BC.determinant(), 1.0, 1e-12);
  EXPECT_NEAR(meta->camera.R_BC(0, 1), -0.867, 0.002);
}

TEST(StreamMetaText, AVehicleWithoutAConstantErrorMaySaySo) {
  EXPECT_TRUE(MetaOf({"dvl_bias_sigma,0", "yaw_arw_rad_per_sqrt_s,0"}).has_value());
}

class VehicleBesideMeta : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> ContradictedKeys() const {
    std::vector<std::string> keys;
    for (const Contradiction& one : Contradictions(*meta_, vehicle_))
      keys.push_back(one.key);
    return keys;
  }
  Expected<StreamMeta> meta_ =
      MetaOf({"image_size,640,360", "intrinsics_fx_fy_cx_cy,490,490,320,180",
              "cam_pos_body,0.25,0,0.15", "cam_R_body_from_cam,0,-1,0,1,0,0,0,0,1"});
  VehicleGeometry vehicle_{
      .image = meta_->camera, .distortion = {}, .dvl_B = Eigen::Vector3d(1.0, 0.0, 0.0)};
};

TEST_F(VehicleBesideMeta, DoesNotContradictWhatMetaLeavesOutOrCalibratesALittleOtherwise) {
  vehicle_.image.fx = 492.0;
  vehicle_.image.p_BC.x() += 0.01;
  EXPECT_THAT(ContradictedKeys(), IsEmpty());
}

TEST_F(VehicleBesideMeta, IsNamedForEachKeyThatItContradicts) {
  vehicle_.image.fx = 600.0;
  vehicle_.image.p_BC.x() = 0.5;
  vehicle_.image.R_BC = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()) * meta_->camera.R_BC;
  EXPECT_THAT(ContradictedKeys(),
              ElementsAre("intrinsics_fx_fy_cx_cy", "cam_pos_body", "cam_R_body_from_cam"));
  const Contradiction arm = Contradictions(*meta_, vehicle_).at(1);
  EXPECT_EQ(arm.in_meta, "0.25, 0, 0.15");
  EXPECT_EQ(arm.in_vehicle, "0.5, 0, 0.15");
}

}  // namespace
}  // namespace limpet
