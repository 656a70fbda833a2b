// SPDX-License-Identifier: MIT
// A recorded sensor stream: a folder with meta.csv and stream.csv.gz.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "estimation/attitude/attitude_filter.hpp"
#include "estimation/navigation/motion_readings.hpp"
#include "limpet/core/camera_model.hpp"
#include "limpet/core/expected.hpp"
#include "limpet/core/geodesy.hpp"
#include "limpet/core/lens_model.hpp"
#include "limpet/core/message.hpp"

namespace limpet {

/// 1-sigma that the rows of a stream state of themselves: their medians, since a sensor's noise is
/// a property of the sensor.
struct StatedNoise {
  double velocity = 0.01;  ///< of a horizontal bottom-track velocity [m/s]
  double depth = 0.02;     ///< of one depth [m]
  double tilt = 0.0047;    ///< of roll and pitch [rad]
};

/// What meta.csv says of vehicle and sensors, and the rows of themselves.
struct StreamMeta {
  CameraModel camera;                                   ///< of the image as it comes, but for
  LensDistortion distortion;                            ///< its lens
  bool has_image_size = false, has_intrinsics = false;  ///< of the camera, in the file
  std::vector<std::string> unsaid;  ///< keys that the file lacks: what stands here is usual
  std::vector<std::string> said;    ///< keys that it has
  StatedNoise noise;
  Eigen::Vector3d dvl_B = Eigen::Vector3d::Zero();
  double yaw_random_walk = 3.5e-6;  ///< [rad/sqrt(s)]
  double yaw_bias_sigma = 9.7e-6;   ///< [rad/s]
  double dvl_scale_sigma = 0.002;
  double dvl_bias_sigma = 0.001;       ///< [m/s]
  double dvl_misalign_sigma = 0.0026;  ///< [rad]
  double opi_radius = 0.5;             ///< [m]
};

/// `v_WD_B`, of the DVL, is empty without bottom lock.
struct DvlRow {
  double t = 0.0;
  std::optional<Eigen::Vector3d> v_WD_B;
  std::optional<double> altitude;                   ///< of the DVL above the seabed [m]
  std::array<std::optional<double>, 4> beams = {};  ///< slant ranges [m]
};
struct FrameRow {
  double arrival = 0.0;
  Detections frame;
};
/// What a further sensor said, as its mail is written: `variable` and its value.
struct SourceRow {
  double t = 0.0;
  std::string variable;
  Value value;
};
/// Attitudes, or what a filter makes them of: inertial samples, and a fibre-optic gyro's rates.
using StreamRow = std::variant<AttitudeEstimate, DvlRow, DepthReading, PositionFix, FrameRow,
                               InertialInput, YawRate, ThrusterShares>;

struct SensorStream {
  StreamMeta meta;
  std::vector<StreamRow> rows;         ///< in order of arrival
  std::vector<SourceRow> source_rows;  ///< in order of time
  int refused_rows = 0;                ///< that held a value that is no finite number
  /// Why the rows after these could not be read: the file was cut. Names file and line.
  std::optional<std::string> cut;
  /// Where north and east count from, if fixes came as latitude and longitude: the first of them.
  std::optional<GeoPoint> datum;
  std::vector<std::string> left_out;  ///< what else of the file is not in the rows, and why
  std::vector<std::string> doubts;    ///< what of the rows may be otherwise than it was taken
};

/// A file's lines and what errors call it.
struct StreamFile {
  std::string name;
  std::vector<std::string> lines;
  bool is_last_line_whole = true;     ///< it ends in a newline
  std::optional<std::string> damage;  ///< of what comes after the lines; names file and line
};
/// The error names file and line. A recorder that lost power leaves a last line, frame or block of
/// a gzip file cut in two: what comes before is the stream, and `cut` says so. Damaged lines in
/// between, up to one in a hundred, are passed over, and `left_out` names the first; so it does of
/// rows that come again word for word, which are dropped.
[[nodiscard]] Expected<SensorStream> ParseSensorStream(const StreamFile& meta,
                                                       const StreamFile& rows);
/// What meta.csv says; the error names file and line, also of what no vehicle can have.
[[nodiscard]] Expected<StreamMeta> ParseStreamMeta(const StreamFile& meta);
/// Adds the rows of further sensors: `t,variable,value`, of which the value may hold commas. A
/// value that is a number is one, any other is text. Fields may stand in CSV's quotes. The error
/// names file and line.
[[nodiscard]] std::optional<Error> AddSourceRows(const StreamFile& file, SensorStream& stream);
/// Reads a stream from its folder: meta.csv, stream.csv.gz and, if there, sources.csv.gz or
/// sources.csv. The error names file and line.
[[nodiscard]] Expected<SensorStream> LoadSensorStream(const std::filesystem::path& folder);

/// The lines of a text file, or of a gzip file; of a damaged one those before the damage. The
/// error names the file.
[[nodiscard]] Expected<StreamFile> ReadLines(const std::filesystem::path& file);

}  // namespace limpet
