// SPDX-License-Identifier: MIT
#include "estimation/replay/sensor_stream.hpp"

#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "estimation/replay/csv_fields.hpp"
#include "limpet/core/config.hpp"

namespace limpet {
namespace {

DvlRow ParseDvl(const CsvFields& f) {
  f.Expect(13);
  DvlRow row{.t = f.Number(1), .velocity = {}, .altitude = f.Optional(8)};
  if (f.Integer(2) != 0) {
    row.velocity = Eigen::Vector3d(f.Number(3), f.Number(4), f.Number(5));
  }
  return row;
}

Box ParseDetection(const CsvFields& f, const Detections& frame) {
  f.Expect(11);
  if (f.Integer(3) != frame.frame) {
    throw BadLine{fmt::format("a DET of frame {} among those of {}", f.Integer(3), frame.frame)};
  }
  return {.u = f.Number(5),
          .v = f.Number(6),
          .w = f.Number(7),
          .h = f.Number(8),
          .confidence = f.Number(9),
          .color = std::to_string(f.Integer(10))};
}

/// Turns lines into rows; DET rows belong to the FRM before them.
class StreamParser {
 public:
  explicit StreamParser(SensorStream& stream) : stream_(stream) {}

  void Take(std::string_view line) {
    if (line.empty() || line.front() == '#') {
      return;
    }
    const CsvFields f(line);
    const std::string_view kind = f.kind();
    if ((missing_boxes_ > 0) != (kind == "DET")) {
      throw BadLine{missing_boxes_ > 0 ? "a DET of the frame before is missing"
                                       : "a DET beyond those its frame announced"};
    }
    if (kind == "DET") {
      --missing_boxes_;
      TakeBox(f);
    } else if (kind == "FRM") {
      f.Expect(5);
      missing_boxes_ = f.Integer(4);
      stream_.rows.push_back(FrameRow{
          .arrival = f.Number(2),
          .frame = {.frame = f.Integer(3), .exposure = Seconds(f.Number(1)), .boxes = {}}});
    } else if (!f.AreFinite(1)) {
      ++stream_.refused_rows;
    } else if (kind == "ATT") {
      f.Expect(8);
      stream_.rows.push_back(AttitudeEstimate{.t = f.Number(1),
                                              .roll = f.Number(2),
                                              .pitch = f.Number(3),
                                              .yaw = f.Number(4),
                                              .yaw_rate = 0.0,
                                              .sd_roll = f.Number(5),
                                              .sd_pitch = f.Number(6),
                                              .sd_yaw = f.Number(7)});
    } else if (kind == "DVL") {
      stream_.rows.push_back(ParseDvl(f));
    } else if (kind == "DEP") {
      f.Expect(4);
      stream_.rows.push_back(DepthRow{f.Number(1), f.Number(2)});
    } else if (kind == "GPS") {
      f.Expect(5);
      stream_.rows.push_back(GpsRow{f.Number(1), {f.Number(2), f.Number(3)}, f.Number(4)});
    } else {
      throw BadLine{fmt::format("`{}` is no kind of row (ATT, DVL, DEP, GPS, FRM, DET)", kind)};
    }
  }
  void Finish() const {
    if (missing_boxes_ > 0) throw BadLine{"the last frame's DET rows are missing"};
  }

 private:
  void TakeBox(const CsvFields& f) {
    Detections& frame = std::get<FrameRow>(stream_.rows.back()).frame;
    if (!f.AreFinite(1)) {
      ++stream_.refused_rows;
      frame.boxes.emplace_back();  // keeps the numbering; its confidence is 0
      return;
    }
    frame.boxes.push_back(ParseDetection(f, frame));
  }
  SensorStream& stream_;
  int missing_boxes_ = 0;
};

void TakeMeta(std::string_view line, StreamMeta& meta) {
  const CsvFields f(line);
  CameraModel& camera = meta.camera;
  const auto vector = [&f] { return Eigen::Vector3d(f.Number(1), f.Number(2), f.Number(3)); };
  if (f.kind() == "image_size") {
    camera.width_px = f.Integer(1), camera.height_px = f.Integer(2);
    meta.has_image_size = true;
  } else if (f.kind() == "intrinsics_fx_fy_cx_cy") {
    camera.fx = f.Number(1), camera.fy = f.Number(2);
    camera.cx = f.Number(3), camera.cy = f.Number(4);
    meta.has_intrinsics = true;
  } else if (f.kind() == "cam_pos_body") {
    camera.p_BC = vector();
  } else if (f.kind() == "cam_R_body_from_cam") {
    for (int i = 0; i < 9; ++i) {
      camera.R_BC(i / 3, i % 3) = f.Number(static_cast<std::size_t>(i) + 1);
    }
  } else if (f.kind() == "dvl_pos_body") {
    meta.dvl_B = vector();
  } else if (f.kind() == "yaw_arw_rad_per_sqrt_s") {
    meta.yaw_random_walk = f.Number(1);
  } else if (f.kind() == "yaw_bias_sigma_rad_per_s") {
    meta.yaw_bias_sigma = f.Number(1);
  } else if (f.kind() == "dvl_scale_sigma") {
    meta.dvl_scale_sigma = f.Number(1);
  } else if (f.kind() == "dvl_bias_sigma") {
    meta.dvl_bias_sigma = f.Number(1);
  } else if (f.kind() == "dvl_misalign_sigma") {
    meta.dvl_misalign_sigma = f.Number(1);
  } else if (f.kind() == "opi_radius") {
    meta.opi_radius = f.Number(1);
  }
}

/// Calls `take` with each line; the error names the file and the line it choked on.
template <class Take>
std::optional<Error> ForEachLine(const std::string& file, const std::vector<std::string>& lines,
                                 Take take) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    try {
      take(lines[i]);
    } catch (const BadLine& bad) {
      return Error{fmt::format("{}:{}: {}", file, i + 1, bad.why)};
    }
  }
  return std::nullopt;
}

}  // namespace

Expected<SensorStream> ParseSensorStream(const StreamFile& meta, const StreamFile& rows) {
  SensorStream stream;
  const auto key = [&stream](std::string_view line) { TakeMeta(line, stream.meta); };
  if (std::optional<Error> error = ForEachLine(meta.name, meta.lines, key)) {
    return *error;
  }
  StreamParser parser(stream);
  const auto row = [&parser](std::string_view line) { parser.Take(line); };
  if (std::optional<Error> error = ForEachLine(rows.name, rows.lines, row)) {
    return *error;
  }
  try {
    parser.Finish();
  } catch (const BadLine& bad) {
    return Error{fmt::format("{}: {}", rows.name, bad.why)};
  }
  if (stream.rows.empty()) {
    return Error{fmt::format("{}: holds no measurement", rows.name)};
  }
  return stream;
}

Expected<SensorStream> LoadSensorStream(const std::filesystem::path& folder) {
  StreamFile meta{.name = (folder / "meta.csv").string(), .lines = {}};
  StreamFile rows{.name = (folder / "stream.csv.gz").string(), .lines = {}};
  for (StreamFile* file : {&meta, &rows}) {
    Expected<std::vector<std::string>> lines = ReadLines(file->name);
    if (!lines) return lines.error();
    file->lines = *std::move(lines);
  }
  return ParseSensorStream(meta, rows);
}

}  // namespace limpet
