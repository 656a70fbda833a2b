// SPDX-License-Identifier: MIT
#include "estimation/replay/sensor_stream.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "estimation/replay/csv_fields.hpp"
#include "limpet/core/config.hpp"

namespace limpet {
namespace {

/// Medians of what the rows state; what none of them states stays as it is.
class StatedNoises {
 public:
  void AddVelocity(double sd) { velocity_.push_back(sd); }
  void AddDepth(double sd) { depth_.push_back(sd); }
  void AddTilt(double sd) { tilt_.push_back(sd); }
  void ReplaceIn(StatedNoise& noise) {
    Replace(velocity_, noise.velocity);
    Replace(depth_, noise.depth);
    Replace(tilt_, noise.tilt);
  }

 private:
  static void Replace(std::vector<double>& stated, double& noise) {
    std::erase_if(stated, [](double sd) { return !(sd > 0.0); });
    if (stated.empty()) return;
    const auto middle = stated.begin() + static_cast<std::ptrdiff_t>(stated.size() / 2);
    std::ranges::nth_element(stated, middle);
    noise = *middle;
  }
  std::vector<double> velocity_, depth_, tilt_;
};

DvlRow ParseDvl(const CsvFields& f) {
  f.Expect(13);
  DvlRow row{.t = f.Number(1),
             .velocity = {},
             .altitude = f.Optional(8),
             .beams = {f.Optional(9), f.Optional(10), f.Optional(11), f.Optional(12)}};
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
      stream_.rows.emplace_back(FrameRow{
          .arrival = f.Number(2),
          .frame = {.frame = f.Integer(3), .exposure = Seconds(f.Number(1)), .boxes = {}}});
    } else if (!f.AreFinite(1)) {
      ++stream_.refused_rows;
    } else if (kind == "ATT") {
      f.Expect(8);
      noises_.AddTilt(std::max(f.Number(5), f.Number(6)));
      stream_.rows.emplace_back(AttitudeEstimate{.t = f.Number(1),
                                                 .roll = f.Number(2),
                                                 .pitch = f.Number(3),
                                                 .yaw = f.Number(4),
                                                 .yaw_rate = 0.0,
                                                 .sd_roll = f.Number(5),
                                                 .sd_pitch = f.Number(6),
                                                 .sd_yaw = f.Number(7)});
    } else if (kind == "DVL") {
      stream_.rows.emplace_back(ParseDvl(f));
      if (const auto sd = f.Optional(6)) noises_.AddVelocity(*sd);
    } else if (kind == "DEP") {
      f.Expect(4);
      noises_.AddDepth(f.Number(3));
      stream_.rows.emplace_back(DepthRow{f.Number(1), f.Number(2)});
    } else if (kind == "GPS") {
      f.Expect(5);
      stream_.rows.emplace_back(GpsRow{f.Number(1), {f.Number(2), f.Number(3)}, f.Number(4)});
    } else {
      throw BadLine{fmt::format("`{}` is no kind of row (ATT, DVL, DEP, GPS, FRM, DET)", kind)};
    }
  }
  /// A last frame without all its boxes would say of objects that they were not seen.
  void Finish() {
    if (missing_boxes_ > 0) {
      stream_.rows.pop_back();
      stream_.cut = "the last frame's DET rows are missing";
    }
    noises_.ReplaceIn(stream_.meta.noise);
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
  StatedNoises noises_;
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
  } else if (f.kind() == "distortion_k1_k2_p1_p2_k3") {
    meta.distortion = {.k1 = f.Number(1),
                       .k2 = f.Number(2),
                       .p1 = f.Number(3),
                       .p2 = f.Number(4),
                       .k3 = f.Number(5)};
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
  } else if (f.kind() == "stated_noise_velocity_depth_tilt") {
    meta.noise = {.velocity = f.Number(1), .depth = f.Number(2), .tilt = f.Number(3)};
  }
}

Value MailValue(std::string_view written) {
  const std::string_view text = Trim(written);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number ? Value(number) : Value(std::string(text));
}

/// A line that could not be taken, and whether that is because it was cut in two.
struct Stumble {
  std::string why;  ///< with file and line
  bool is_cut = false;
};

/// Calls `take` with each line up to the first one that it chokes on.
template <class Take>
std::optional<Stumble> ForEachLine(const StreamFile& file, Take take) {
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    try {
      take(file.lines[i]);
    } catch (const BadLine& bad) {
      return Stumble{.why = fmt::format("{}:{}: {}", file.name, i + 1, bad.why),
                     .is_cut = i + 1 == file.lines.size() && !file.is_last_line_whole};
    }
  }
  return std::nullopt;
}

}  // namespace

Expected<StreamMeta> ParseStreamMeta(const StreamFile& meta) {
  StreamMeta said;
  const auto key = [&said](std::string_view line) { TakeMeta(line, said); };
  if (const auto bad = ForEachLine(meta, key)) return Error{bad->why};
  if (meta.damage) return Error{*meta.damage};
  if (!said.distortion.is_none() && !LensModel::IsOneToOne(said.camera, said.distortion)) {
    return Error{fmt::format("{}: distortion_k1_k2_p1_p2_k3: folds the image", meta.name)};
  }
  return said;
}

Expected<SensorStream> ParseSensorStream(const StreamFile& meta, const StreamFile& rows) {
  SensorStream stream;
  Expected<StreamMeta> said = ParseStreamMeta(meta);
  if (!said) return said.error();
  stream.meta = *std::move(said);
  StreamParser parser(stream);
  const auto row = [&parser](std::string_view line) { parser.Take(line); };
  const auto bad = ForEachLine(rows, row);
  if (bad && !bad->is_cut) return Error{bad->why};
  parser.Finish();
  if (stream.cut) stream.cut = fmt::format("{}: {}", rows.name, *stream.cut);
  if (rows.damage) stream.cut = rows.damage;
  if (bad) stream.cut = bad->why;
  if (stream.rows.empty()) {
    return Error{fmt::format("{}: holds no measurement", rows.name)};
  }
  return stream;
}

std::optional<Error> AddSourceRows(const StreamFile& file, SensorStream& stream) {
  const auto take = [&stream](std::string_view line) {
    if (line.empty() || line.front() == '#' || Trim(line) == "t,variable,value") return;
    const CsvFields f(line);
    if (f.size() < 3 || f.Text(1).empty()) throw BadLine{"is no `t,variable,value`"};
    const double t = f.Number(0);
    if (!std::isfinite(t)) {
      ++stream.refused_rows;
      return;
    }
    const std::size_t variable = line.find(',') + 1;
    stream.source_rows.push_back({.t = t,
                                  .variable = f.Text(1),
                                  .value = MailValue(line.substr(line.find(',', variable) + 1))});
  };
  const auto bad = ForEachLine(file, take);
  if (bad && !bad->is_cut) return Error{bad->why};
  if (file.damage) stream.cut = file.damage;
  if (bad) stream.cut = bad->why;
  std::ranges::stable_sort(stream.source_rows, {}, &SourceRow::t);
  return std::nullopt;
}

Expected<SensorStream> LoadSensorStream(const std::filesystem::path& folder) {
  const Expected<StreamFile> meta = ReadLines(folder / "meta.csv");
  if (!meta) return meta.error();
  const Expected<StreamFile> rows = ReadLines(folder / "stream.csv.gz");
  if (!rows) return rows.error();
  Expected<SensorStream> stream = ParseSensorStream(*meta, *rows);
  if (!stream) return stream.error();
  for (const char* name : {"sources.csv.gz", "sources.csv"}) {
    if (!std::filesystem::exists(folder / name)) continue;
    const Expected<StreamFile> further = ReadLines(folder / name);
    if (!further) return further.error();
    if (const auto bad = AddSourceRows(*further, *stream)) return *bad;
  }
  return stream;
}

}  // namespace limpet
