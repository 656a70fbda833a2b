// SPDX-License-Identifier: MIT
#include "limpet/recordings/ros_csv.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/packing/gzip_bytes.hpp"
#include "limpet/recordings/ros_table.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{1} << 29U;

/// When it was measured, or if the message does not say so, when it was recorded.
std::size_t StampColumn(const RosColumns& columns) {
  return columns.Find("field.header.stamp").value_or(0);
}

/// What reads the rows of one kind of topic.
class RosTopic {
 public:
  RosTopic() = default;
  RosTopic(const RosTopic&) = delete;
  RosTopic& operator=(const RosTopic&) = delete;
  virtual ~RosTopic() = default;
  /// False of a row with a value that is no finite number. Throws BadLine.
  [[nodiscard]] virtual bool Take(const RosRow& row) = 0;
  virtual void Finish(const std::string& /*file*/) {}
};

class DepthTopic final : public RosTopic {
 public:
  DepthTopic(Recording& recording, std::size_t stamp, std::size_t depth)
      : recording_(recording), stamp_(stamp), depth_(depth) {}
  bool Take(const RosRow& row) override {
    const auto depth = row.Number(depth_);
    if (depth) recording_.depths.push_back({.t = row.Stamp(stamp_), .depth = *depth});
    return depth.has_value();
  }

 private:
  Recording& recording_;
  std::size_t stamp_, depth_;
};

/// The columns of a LinkQuest DVL's driver.
struct LinkQuestColumns {
  std::size_t stamp = 0, has_velocity = 0, altitude = 0;
  std::array<std::size_t, 4> is_good{}, range{}, speed{};
  std::array<std::size_t, 3> velocity{};

  /// Nothing if a column lacks.
  static std::optional<LinkQuestColumns> Of(const RosColumns& columns) {
    const auto is_good = columns.FindAll<4>("field.dataGood");
    const auto range = columns.FindAll<4>("field.altitudeBeam");
    const auto speed = columns.FindAll<4>("field.bottomVelocityBeam");
    const auto velocity = columns.FindAll<3>("field.velocityInst");
    const auto has_velocity = columns.Find("field.velocityInstFlag");
    const auto altitude = columns.Find("field.altitude");
    if (!is_good || !range || !speed || !velocity || !has_velocity || !altitude) {
      return std::nullopt;
    }
    return LinkQuestColumns{.stamp = StampColumn(columns),
                            .has_velocity = *has_velocity,
                            .altitude = *altitude,
                            .is_good = *is_good,
                            .range = *range,
                            .speed = *speed,
                            .velocity = *velocity};
  }
};

/// An angle of the instrument, and whether its column ever says anything but one value.
class AngleColumn {
 public:
  AngleColumn(const RosColumns& columns, const char* what, const std::string& name,
              const char* cost)
      : what_(what), name_(name), cost_(cost), column_(columns.Find(name)) {}
  void Take(const RosRow& row) {
    const auto value = column_ ? row.Number(*column_) : std::nullopt;
    if (!value) return;
    has_changed_ = has_changed_ || (value_ && *value != *value_);
    value_ = value;
    ++rows_;
  }
  /// One that changes is not read: drivers differ in its unit, and how the instrument sits on the
  /// vehicle is in no column.
  [[nodiscard]] MissingData Missing(const std::string& file) const {
    return {.what = what_, .reason = file + ": " + Reason(), .cost = cost_};
  }

 private:
  [[nodiscard]] std::string Reason() const {
    if (!value_) return "no column " + name_;
    if (has_changed_) return name_ + " is not read: its unit and the mounting are in no column";
    return fmt::format("{} is {} in all of {} rows", name_, TextOf(*value_), rows_);
  }
  const char* what_;
  std::string name_;
  const char* cost_;
  std::optional<std::size_t> column_;
  std::optional<double> value_;
  bool has_changed_ = false;
  std::size_t rows_ = 0;
};

class LinkQuestTopic final : public RosTopic {
 public:
  LinkQuestTopic(Recording& recording, const RosColumns& columns, const LinkQuestColumns& own)
      : recording_(recording),
        own_(own),
        angles_{AngleColumn(columns, "heading", "field.heading",
                            "velocities cannot be laid out: no track can be reckoned"),
                AngleColumn(columns, "roll", "field.roll",
                            "velocities cannot be levelled: a list of 5 deg tilts 9 % of each"),
                AngleColumn(columns, "pitch", "field.pitch",
                            "velocities cannot be levelled: a trim of 5 deg tilts 9 % of each")} {}

  bool Take(const RosRow& row) override {
    DvlPing ping{.t = row.Stamp(own_.stamp),
                 .beam_speeds = {},
                 .beam_ranges = {},
                 .v_D = {},
                 .altitude = Length(row.Number(own_.altitude))};
    for (std::size_t beam = 0; beam < own_.is_good.size(); ++beam) {
      if (!row.Flag(own_.is_good[beam])) continue;
      ping.beam_speeds[beam] = row.Number(own_.speed[beam]);
      ping.beam_ranges[beam] = Length(row.Number(own_.range[beam]));
    }
    bool is_finite = true;
    if (row.Flag(own_.has_velocity)) {
      Eigen::Vector3d velocity;
      for (std::size_t axis = 0; axis < own_.velocity.size(); ++axis) {
        const auto value = row.Number(own_.velocity[axis]);
        is_finite = is_finite && value;
        velocity[static_cast<Eigen::Index>(axis)] = value.value_or(0.0);
      }
      ping.v_D = velocity;
    }
    if (!is_finite) return false;
    for (AngleColumn& angle : angles_)
      angle.Take(row);
    recording_.pings.push_back(ping);
    return true;
  }
  void Finish(const std::string& file) override {
    for (const AngleColumn& angle : angles_) {
      recording_.missing.push_back(angle.Missing(file));
    }
  }

 private:
  /// The instrument writes none as zero or less.
  static std::optional<double> Length(std::optional<double> value) {
    return value.value_or(0.0) > 0.0 ? value : std::nullopt;
  }
  Recording& recording_;
  LinkQuestColumns own_;
  std::array<AngleColumn, 3> angles_;
};

std::unique_ptr<RosTopic> TopicOf(const RosColumns& columns, Recording& recording) {
  if (const auto own = LinkQuestColumns::Of(columns)) {
    return std::make_unique<LinkQuestTopic>(recording, columns, *own);
  }
  if (const auto depth = columns.Find("field.depth")) {
    return std::make_unique<DepthTopic>(recording, StampColumn(columns), *depth);
  }
  return nullptr;
}

/// The next line; advances `text` behind it.
std::string_view TakeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

/// The rows behind the header. Throws BadLine; `line` is where.
void TakeRows(std::string_view text, const RosColumns& columns, RosTopic& topic,
              const std::string& file, std::size_t& line, Recording& recording) {
  std::size_t refused = 0;
  while (!text.empty()) {
    ++line;
    const bool is_whole = text.find('\n') != std::string_view::npos;
    const std::string_view row = TakeLine(text);
    if (row.empty()) continue;
    try {
      if (!topic.Take(RosRow(columns, row))) ++refused;
    } catch (const BadLine& bad) {
      if (is_whole) throw;
      recording.left_out.push_back(
          fmt::format("{}:{}: the last line is cut: {}", file, line, bad.why));
    }
  }
  if (refused > 0) {
    recording.left_out.push_back(
        fmt::format("{}: {} rows hold a value that is no finite number", file, refused));
  }
}

/// What a vehicle's navigation needs and no topic that is known here says.
void AddWhatNoTopicSays(Recording& recording) {
  const auto lack = [&recording](const char* what, const char* cost) {
    recording.missing.push_back(
        {.what = what, .reason = "no file holds such a topic that is known here", .cost = cost});
  };
  if (recording.pings.empty()) lack("DVL", "no velocity: no track can be reckoned");
  if (recording.depths.empty()) lack("depth", "nothing tells the vehicle's depth");
  lack("gyro and accelerometer", "no attitude between and without headings, rolls and pitches");
  lack("camera frames", "no object can be placed");
  lack("position fixes", "a track would count from where it begins");
}

bool IsCsvName(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.ends_with(".csv") || name.ends_with(".csv.gz");
}

bool BeginsAsRosCsv(const fs::path& file) {
  const auto read = ReadUnpacked(file, 64);
  return read && read->bytes.starts_with(kRosCsvHeader);
}

/// The CSV files in a folder (or the one that is named) in the order of their names.
std::vector<fs::path> CsvFilesOf(const fs::path& named) {
  std::error_code error;
  if (fs::is_regular_file(named, error)) return {named};
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(named, error)) {
    if (entry.is_regular_file(error) && IsCsvName(entry.path())) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

Expected<bool> AddRosCsv(std::string_view text, const std::string& file, Recording& recording) {
  std::size_t line = 1;
  try {
    const RosColumns columns(TakeLine(text));
    const auto topic = TopicOf(columns, recording);
    if (topic == nullptr) {
      recording.left_out.push_back(
          fmt::format("{}: neither a LinkQuest DVL's columns nor field.depth among its own: {}",
                      file, columns.Listed()));
      return false;
    }
    TakeRows(text, columns, *topic, file, line, recording);
    topic->Finish(file);
    return true;
  } catch (const BadLine& bad) {
    return Error{fmt::format("{}:{}: {}", file, line, bad.why)};
  }
}

bool IsRosRecording(const fs::path& named) {
  std::error_code error;
  if (fs::exists(named / "stream.csv.gz", error)) return false;
  return std::ranges::any_of(CsvFilesOf(named), BeginsAsRosCsv);
}

Expected<Recording> LoadRosRecording(const fs::path& named) {
  Recording recording{
      .name = named.string(), .pings = {}, .depths = {}, .own = {}, .missing = {}, .left_out = {}};
  for (const fs::path& file : CsvFilesOf(named)) {
    const std::string name = file.filename().string();
    const auto read = ReadUnpacked(file, kMostBytes);
    if (!read) return read.error();
    if (!read->bytes.starts_with(kRosCsvHeader)) {
      recording.left_out.push_back(name + ": no topic of ROS: it does not begin with `%time,`");
      continue;
    }
    const auto added = AddRosCsv(read->bytes, name, recording);
    if (!added) return added.error();
    if (read->damage) recording.left_out.push_back(*read->damage);
  }
  if (recording.pings.empty() && recording.depths.empty()) {
    std::string why;
    for (const std::string& left_out : recording.left_out)
      why += "\n  " + left_out;
    return Error{fmt::format("{}: holds no measurement{}", recording.name, why)};
  }
  AddWhatNoTopicSays(recording);
  return recording;
}

}  // namespace limpet
