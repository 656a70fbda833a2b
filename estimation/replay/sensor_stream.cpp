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
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "estimation/replay/csv_fields.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/statistics.hpp"

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
    if (!stated.empty()) noise = UpperMedian(std::move(stated));
  }
  std::vector<double> velocity_, depth_, tilt_;
};

DvlRow ParseDvl(const CsvFields& f) {
  f.Expect(13);
  DvlRow row{.t = f.Number(1),
             .v_WD_B = {},
             .altitude = f.Optional(8),
             .beams = {f.Optional(9), f.Optional(10), f.Optional(11), f.Optional(12)}};
  if (f.Integer(2) != 0) {
    row.v_WD_B = Eigen::Vector3d(f.Number(3), f.Number(4), f.Number(5));
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
    const CsvFields f(line);
    const std::string_view kind = f.kind();
    if (kind == "DET") {
      if (missing_boxes_ == 0) throw BadLine{"a DET beyond those its frame announced"};
      TakeBox(f);
      --missing_boxes_;
      return;
    }
    const bool lacks_boxes = DropFrameWithoutItsBoxes();
    TakeRow(f, kind);
    if (lacks_boxes) throw BadLine{"a DET of the frame before is missing"};
  }
  void Finish() {
    if (DropFrameWithoutItsBoxes()) stream_.cut = "the last frame's DET rows are missing";
    noises_.ReplaceIn(stream_.meta.noise);
  }

 private:
  void TakeRow(const CsvFields& f, std::string_view kind) {
    if (kind == "FRM") {
      f.Expect(5);
      const int boxes = f.Integer(4);  // it waits for none before all of its line is read
      stream_.rows.emplace_back(FrameRow{
          .arrival = f.Number(2),
          .frame = {.frame = f.Integer(3), .exposure = Seconds(f.Number(1)), .boxes = {}}});
      missing_boxes_ = boxes;
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
      stream_.rows.emplace_back(DepthReading{f.Number(1), f.Number(2)});
    } else if (kind == "GPS") {
      f.Expect(5);
      stream_.rows.emplace_back(PositionFix{f.Number(1), {f.Number(2), f.Number(3)}, f.Number(4)});
    } else {
      throw BadLine{fmt::format("`{}` is no kind of row (ATT, DVL, DEP, GPS, FRM, DET)", kind)};
    }
  }
  /// It would say of objects that they were not seen.
  bool DropFrameWithoutItsBoxes() {
    if (missing_boxes_ == 0) return false;
    stream_.rows.pop_back();
    missing_boxes_ = 0;
    return true;
  }
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

Value MailValue(std::string_view written) {
  const std::string_view text = Trim(written);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number ? Value(number) : Value(std::string(text));
}

/// Takes the first field off a line, with the comma behind it; of the last one commas are part. In
/// quotes a quote is written twice.
std::string TakeField(std::string_view& rest, bool is_last) {
  const std::size_t begin = rest.find_first_not_of(" \t");
  std::size_t end = is_last ? std::string_view::npos : rest.find(',');
  std::string field;
  if (begin == std::string_view::npos || rest[begin] != '"') {
    field = Trim(rest.substr(0, end));
  } else {
    std::size_t i = begin + 1;
    for (; i < rest.size() && (rest[i] != '"' || rest.substr(i, 2) == "\"\""); ++i) {
      field += rest[i];
      if (rest[i] == '"') ++i;
    }
    if (i >= rest.size()) throw BadLine{"a field's quotes do not end on its line"};
    end = rest.find_first_not_of(" \t\r", i + 1);
    if (end != std::string_view::npos && (is_last || rest[end] != ','))
      throw BadLine{"more than a comma follows a field's quotes"};
  }
  if (!is_last && end == std::string_view::npos) throw BadLine{"is no `t,variable,value`"};
  rest.remove_prefix(is_last ? rest.size() : end + 1);
  return field;
}

/// What of a file's lines could not be taken.
struct Losses {
  std::size_t lines = 0;           ///< that were passed over
  std::size_t sound = 0;           ///< before the first of them
  std::string first;               ///< why the first of them was, with file and line
  std::optional<std::string> cut;  ///< why the last line was, which is cut in two
  std::size_t again = 0;           ///< lines that came before, word for word: one measurement
  std::size_t first_again = 0;     ///< the first of them

  [[nodiscard]] std::string Text() const {
    return fmt::format("{}; {} {} passed over", first, lines, lines == 1 ? "line" : "lines");
  }
  /// A damaged line now and then leaves a recording sound; more is no recording of this kind.
  [[nodiscard]] bool AreTooMany(const StreamFile& file) const {
    constexpr std::size_t kSoundLines = 100;  // for each that is not
    return lines * kSoundLines > file.lines.size();
  }
};

/// Calls `take` with each line, also after one that it chokes on.
template <class Take>
Losses ForEachLine(const StreamFile& file, Take take) {
  Losses losses;
  std::unordered_set<std::string_view> taken;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::string& line = file.lines[i];
    if (line.empty() || line.front() == '#') continue;
    if (taken.contains(line)) {
      if (losses.again++ == 0) losses.first_again = i + 1;
      continue;
    }
    try {
      take(line);
      taken.insert(line);
    } catch (const BadLine& bad) {
      const std::string why = fmt::format("{}:{}: {}", file.name, i + 1, bad.why);
      if (i + 1 == file.lines.size() && !file.is_last_line_whole) {
        losses.cut = why;
      } else if (losses.lines++ == 0) {
        losses.first = why;
        losses.sound = i;
      }
    }
  }
  return losses;
}

/// What comes before the first line that cannot be read: behind damage, gzip's lines are made up.
StreamFile SoundPart(const StreamFile& file, const Losses& losses) {
  const auto end = file.lines.begin() + static_cast<std::ptrdiff_t>(losses.sound);
  return {.name = file.name, .lines = {file.lines.begin(), end}, .damage = losses.first};
}

/// Notes in the stream what it lacks; an error if that is too much.
std::optional<Error> Note(const Losses& losses, const StreamFile& file, SensorStream& stream) {
  if (losses.AreTooMany(file)) return Error{losses.first};
  if (losses.lines > 0) stream.left_out.push_back(losses.Text());
  if (losses.again > 0) {
    stream.left_out.push_back(fmt::format(
        "{}:{}: came before, word for word; {} such {} dropped: each row counts once", file.name,
        losses.first_again, losses.again, losses.again == 1 ? "line was" : "lines were"));
  }
  if (file.damage) stream.cut = file.damage;
  if (losses.cut) stream.cut = losses.cut;
  return std::nullopt;
}

}  // namespace

Expected<SensorStream> ParseSensorStream(const StreamFile& meta, const StreamFile& rows) {
  SensorStream stream;
  Expected<StreamMeta> said = ParseStreamMeta(meta);
  if (!said) return said.error();
  stream.meta = *std::move(said);
  StreamParser parser(stream);
  const auto row = [&parser](std::string_view line) { parser.Take(line); };
  const Losses losses = ForEachLine(rows, row);
  if (losses.AreTooMany(rows) && rows.damage)
    return ParseSensorStream(meta, SoundPart(rows, losses));
  parser.Finish();
  if (stream.cut) stream.cut = fmt::format("{}: {}", rows.name, *stream.cut);
  if (auto error = Note(losses, rows, stream)) return *std::move(error);
  if (stream.rows.empty()) {
    return Error{fmt::format("{}: holds no measurement", rows.name)};
  }
  return stream;
}

std::optional<Error> AddSourceRows(const StreamFile& file, SensorStream& stream) {
  const auto take = [&stream](std::string_view line) {
    const std::string time = TakeField(line, false), variable = TakeField(line, false);
    const std::string value = TakeField(line, true);
    if (time == "t" && variable == "variable" && value == "value") return;
    if (variable.empty()) throw BadLine{"is no `t,variable,value`"};
    const double t = CsvFields(time).Number(0);
    if (!std::isfinite(t)) {
      ++stream.refused_rows;
      return;
    }
    stream.source_rows.push_back({.t = t, .variable = variable, .value = MailValue(value)});
  };
  if (auto error = Note(ForEachLine(file, take), file, stream)) return error;
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
