// SPDX-License-Identifier: MIT
#include "estimation/replay/stream_meta.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "estimation/replay/csv_fields.hpp"

namespace limpet {
namespace {

constexpr double kLongestArm = 20.0;                         // [m]; most are longer in centimetres
constexpr double kGreatestSize = 20.0;                       // [m], radius of objects
constexpr double kGreatestFocal = 50000.0;                   // [px], as of a vehicle's file
constexpr double kLeastAngle = 1.0, kGreatestAngle = 170.0;  // [deg] over an image
constexpr double kRounding = 0.02;  // of a rotation that was written with two decimals
constexpr const char* kIntrinsics = "intrinsics_fx_fy_cx_cy";

std::string Written(const std::vector<double>& numbers) {
  return fmt::format("{:g}", fmt::join(numbers, ", "));
}
std::string Written(const Eigen::Vector3d& v) {
  return Written(std::vector<double>{v.x(), v.y(), v.z()});
}
std::string Written(const Eigen::Matrix3d& R) {
  return Written(std::vector<double>{R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0),
                                     R(2, 1), R(2, 2)});
}
std::string Written(const LensDistortion& lens) {
  return Written(std::vector<double>{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3});
}
std::vector<double> SizeOf(const CameraModel& camera) {
  return {static_cast<double>(camera.width_px), static_cast<double>(camera.height_px)};
}
std::vector<double> IntrinsicsOf(const CameraModel& camera) {
  return {camera.fx, camera.fy, camera.cx, camera.cy};
}

/// One line, of which the numbers must be such as a vehicle can have. Throws BadLine.
class MetaLine {
 public:
  explicit MetaLine(std::string_view line) : fields_(line) {}

  [[nodiscard]] std::string_view key() const { return fields_.kind(); }
  [[nodiscard]] double Number(std::size_t i) const {
    const double value = fields_.Number(i);
    if (!std::isfinite(value)) Refuse(fmt::format("{}", value), "finite numbers");
    return value;
  }
  [[nodiscard]] double Positive(std::size_t i, double greatest) const {
    const double value = Number(i);
    if (value > 0.0 && value <= greatest) return value;
    Refuse(fmt::format("{:g}", value), fmt::format("greater than 0, up to {:g}", greatest));
  }
  /// Of an error that a vehicle may not have: a sheet of the vehicle's file may say 0, too.
  [[nodiscard]] double Sigma(std::size_t i) const {
    const double value = Number(i);
    if (value >= 0.0) return value;
    Refuse(fmt::format("{:g}", value), "0 or more");
  }
  [[nodiscard]] int Pixels(std::size_t i) const {
    const int value = fields_.Integer(i);
    if (value > 0) return value;
    Refuse(fmt::format("{}", value), "greater than 0");
  }
  [[nodiscard]] Eigen::Vector3d Arm() const {
    Eigen::Vector3d arm_B(Number(1), Number(2), Number(3));
    if (arm_B.norm() <= kLongestArm) return arm_B;
    Refuse(Written(arm_B),
           fmt::format("up to {:g} m from the body's origin, in metres", kLongestArm));
  }
  [[nodiscard]] Eigen::Matrix3d Rotation() const {
    Eigen::Matrix3d R;
    for (int i = 0; i < 9; ++i) {
      R(i / 3, i % 3) = Number(static_cast<std::size_t>(i) + 1);
    }
    const double off = (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(off < kRounding) || R.determinant() < 0.0) {
      Refuse(Written(R), "a rotation: three rows of length 1 at right angles, right-handed");
    }
    constexpr double kExact = 1e-6;
    return off < kExact ? R : Eigen::Quaterniond(R).normalized().toRotationMatrix();
  }

 private:
  [[noreturn]] void Refuse(const std::string& value, const std::string& allowed) const {
    throw BadLine{fmt::format("{}: `{}` is not allowed; allowed: {}", key(), value, allowed)};
  }
  CsvFields fields_;
};

/// False if the key is another one.
bool TakeCamera(const MetaLine& line, StreamMeta& meta) {
  CameraModel& camera = meta.camera;
  if (line.key() == "image_size") {
    camera.width_px = line.Pixels(1), camera.height_px = line.Pixels(2);
    meta.has_image_size = true;
  } else if (line.key() == kIntrinsics) {
    camera.fx = line.Positive(1, kGreatestFocal), camera.fy = line.Positive(2, kGreatestFocal);
    camera.cx = line.Number(3), camera.cy = line.Number(4);
    meta.has_intrinsics = true;
  } else if (line.key() == "distortion_k1_k2_p1_p2_k3") {
    meta.distortion = {.k1 = line.Number(1),
                       .k2 = line.Number(2),
                       .p1 = line.Number(3),
                       .p2 = line.Number(4),
                       .k3 = line.Number(5)};
  } else if (line.key() == "cam_pos_body") {
    camera.p_BC = line.Arm();
  } else if (line.key() == "cam_R_body_from_cam") {
    camera.R_BC = line.Rotation();
  } else {
    return false;
  }
  return true;
}

void TakeMeta(const MetaLine& line, StreamMeta& meta) {
  constexpr double kGreatestNoise = 100.0;  // of any kind
  if (TakeCamera(line, meta)) return;
  if (line.key() == "dvl_pos_body") {
    meta.dvl_B = line.Arm();
  } else if (line.key() == "yaw_arw_rad_per_sqrt_s") {
    meta.yaw_random_walk = line.Sigma(1);
  } else if (line.key() == "yaw_bias_sigma_rad_per_s") {
    meta.yaw_bias_sigma = line.Sigma(1);
  } else if (line.key() == "dvl_scale_sigma") {
    meta.dvl_scale_sigma = line.Sigma(1);
  } else if (line.key() == "dvl_bias_sigma") {
    meta.dvl_bias_sigma = line.Sigma(1);
  } else if (line.key() == "dvl_misalign_sigma") {
    meta.dvl_misalign_sigma = line.Sigma(1);
  } else if (line.key() == "opi_radius") {
    meta.opi_radius = line.Positive(1, kGreatestSize);
  } else if (line.key() == "stated_noise_velocity_depth_tilt") {
    meta.noise = {.velocity = line.Positive(1, kGreatestNoise),
                  .depth = line.Positive(2, kGreatestNoise),
                  .tilt = line.Positive(3, kGreatestNoise)};
  }
}

/// Why the image of that size cannot have these intrinsics.
std::optional<std::string> ImageProblem(const CameraModel& camera) {
  const auto refused = [&camera](const std::string& allowed) {
    return fmt::format("{}: `{}` is not allowed; allowed: {}", kIntrinsics,
                       Written(IntrinsicsOf(camera)), allowed);
  };
  const auto is_within = [](double px, int size) { return px >= 0.0 && px <= size; };
  if (!is_within(camera.cx, camera.width_px) || !is_within(camera.cy, camera.height_px)) {
    return refused(fmt::format("an axis (cx, cy) that meets the image of {} x {} pixels",
                               camera.width_px, camera.height_px));
  }
  const auto is_angle = [](double angle) {
    return angle >= RadiansFromDegrees(kLeastAngle) && angle <= RadiansFromDegrees(kGreatestAngle);
  };
  if (!is_angle(camera.fov_across()) || !is_angle(camera.fov_along())) {
    return refused(
        fmt::format("focal lengths by which an image of {} x {} pixels shows {:g} to {:g} deg",
                    camera.width_px, camera.height_px, kLeastAngle, kGreatestAngle));
  }
  return std::nullopt;
}

bool Differ(const LensDistortion& a, const LensDistortion& b) {
  constexpr double kAlike = 0.01;
  return std::abs(a.k1 - b.k1) > kAlike || std::abs(a.k2 - b.k2) > kAlike ||
         std::abs(a.p1 - b.p1) > kAlike || std::abs(a.p2 - b.p2) > kAlike ||
         std::abs(a.k3 - b.k3) > kAlike;
}

bool IntrinsicsDiffer(const CameraModel& a, const CameraModel& b) {
  constexpr double kAlike = 0.01;  // of the focal length
  return std::abs(a.fx - b.fx) > kAlike * b.fx || std::abs(a.fy - b.fy) > kAlike * b.fy ||
         std::abs(a.cx - b.cx) > kAlike * b.fx || std::abs(a.cy - b.cy) > kAlike * b.fy;
}

bool ArmsDiffer(const Eigen::Vector3d& a_B, const Eigen::Vector3d& b_B) {
  constexpr double kAlike = 0.02;  // [m]
  return (a_B - b_B).norm() > kAlike;
}

bool MountingsDiffer(const CameraModel& a, const CameraModel& b) {
  constexpr double kAlike = 0.5;  // [deg]
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(a.R_BC.transpose() * b.R_BC));
  return std::abs(turn.angle()) > RadiansFromDegrees(kAlike);
}

}  // namespace

Expected<StreamMeta> ParseStreamMeta(const StreamFile& meta) {
  StreamMeta said;
  // What a stream would be wrongly read by if it were another vehicle's.
  said.unsaid = {"cam_pos_body", "cam_R_body_from_cam", "dvl_pos_body", "opi_radius"};
  std::size_t intrinsics_at = 0;
  for (std::size_t i = 0; i < meta.lines.size(); ++i) {
    try {
      const MetaLine line(meta.lines[i]);
      TakeMeta(line, said);
      std::erase(said.unsaid, line.key());
      said.said.emplace_back(line.key());
      if (line.key() == kIntrinsics) intrinsics_at = i + 1;
    } catch (const BadLine& bad) {
      return Error{fmt::format("{}:{}: {}", meta.name, i + 1, bad.why)};
    }
  }
  if (meta.damage) return Error{*meta.damage};
  if (said.has_image_size && said.has_intrinsics) {
    if (const auto problem = ImageProblem(said.camera))
      return Error{fmt::format("{}:{}: {}", meta.name, intrinsics_at, *problem)};
  }
  if (!said.distortion.is_none() && !LensModel::IsOneToOne(said.camera, said.distortion)) {
    return Error{fmt::format("{}: distortion_k1_k2_p1_p2_k3: folds the image", meta.name)};
  }
  return said;
}

std::vector<Contradiction> Contradictions(const StreamMeta& meta, const VehicleGeometry& vehicle) {
  std::vector<Contradiction> found;
  const auto look = [&](const char* key, bool differ, const auto& a, const auto& b) {
    if (differ && std::ranges::find(meta.said, key) != meta.said.end())
      found.push_back({.key = key, .in_meta = Written(a), .in_vehicle = Written(b)});
  };
  const CameraModel &a = meta.camera, &b = vehicle.image;
  look("image_size", a.width_px != b.width_px || a.height_px != b.height_px, SizeOf(a), SizeOf(b));
  look(kIntrinsics, IntrinsicsDiffer(a, b), IntrinsicsOf(a), IntrinsicsOf(b));
  look("distortion_k1_k2_p1_p2_k3", Differ(meta.distortion, vehicle.distortion), meta.distortion,
       vehicle.distortion);
  look("cam_pos_body", ArmsDiffer(a.p_BC, b.p_BC), a.p_BC, b.p_BC);
  look("cam_R_body_from_cam", MountingsDiffer(a, b), a.R_BC, b.R_BC);
  look("dvl_pos_body", ArmsDiffer(meta.dvl_B, vehicle.dvl_B), meta.dvl_B, vehicle.dvl_B);
  return found;
}

}  // namespace limpet
