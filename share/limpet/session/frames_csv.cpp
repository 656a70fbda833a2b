// SPDX-License-Identifier: MIT
#include "limpet/session/frames_csv.hpp"

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/session/class_text.hpp"

namespace limpet {
namespace {

constexpr std::string_view kHeader =
    "frame,t,north_m,east_m,down_m,roll_rad,pitch_rad,yaw_rad,altitude_m,boxes";
constexpr std::size_t kColumns = 10;
constexpr std::size_t kBoxFields = 7;
constexpr int kNoLandmark = -1;  // how the file says that a box is of none

std::string BoxText(const Box& box) {
  return fmt::format("{:.2f}:{:.2f}:{:.2f}:{:.2f}:{:.4f}:{}:{}", box.u, box.v, box.w, box.h,
                     box.confidence, ClassText(box.color), box.landmark.value_or(kNoLandmark));
}

/// Reads numbers until one is bad.
class NumberReader {
 public:
  double operator()(std::string_view text) {
    const std::optional<double> number = ParseNumber(text);
    is_good_ = is_good_ && number.has_value();
    return number.value_or(0.0);
  }
  [[nodiscard]] bool is_good() const { return is_good_; }

 private:
  bool is_good_ = true;
};

std::optional<Box> ParseBox(std::string_view text) {
  const std::vector<std::string> fields = Split(text, ':');
  if (fields.size() != kBoxFields) return std::nullopt;
  NumberReader number;
  Box box{.u = number(fields[0]),
          .v = number(fields[1]),
          .w = number(fields[2]),
          .h = number(fields[3]),
          .confidence = number(fields[4]),
          .color = ClassFrom(fields[5])};
  const int landmark = static_cast<int>(number(fields[6]));
  if (landmark >= 0) box.landmark = landmark;
  return number.is_good() ? std::optional<Box>(box) : std::nullopt;
}

std::optional<ObservedFrame> ParseRow(std::string_view row) {
  const std::vector<std::string> fields = Split(row, ',');
  if (fields.size() != kColumns) return std::nullopt;
  NumberReader number;
  ObservedFrame frame;
  frame.frame = static_cast<int>(number(fields[0]));
  frame.exposure = Seconds(number(fields[1]));
  frame.X_WB.p_WB = {number(fields[2]), number(fields[3]), number(fields[4])};
  frame.X_WB.roll = number(fields[5]);
  frame.X_WB.pitch = number(fields[6]);
  frame.X_WB.yaw = number(fields[7]);
  if (!fields[8].empty()) frame.altitude = number(fields[8]);
  for (const std::string& text : Split(fields[9], ' ')) {
    if (text.empty()) continue;
    const std::optional<Box> box = ParseBox(text);
    if (!box) return std::nullopt;
    frame.boxes.push_back(*box);
  }
  return number.is_good() ? std::optional<ObservedFrame>(std::move(frame)) : std::nullopt;
}

}  // namespace

std::string FramesToCsv(const std::vector<ObservedFrame>& frames) {
  std::string text = std::string(kHeader) + "\n";
  for (const ObservedFrame& frame : frames) {
    fmt::format_to(std::back_inserter(text), "{},{:.3f},{:.4f},{:.4f},{:.4f},{:.5f},{:.5f},{:.5f},",
                   frame.frame, frame.exposure.value(), frame.X_WB.p_WB.x(), frame.X_WB.p_WB.y(),
                   frame.X_WB.p_WB.z(), frame.X_WB.roll, frame.X_WB.pitch, frame.X_WB.yaw);
    text += frame.altitude ? fmt::format("{:.4f},", *frame.altitude) : ",";
    for (std::size_t i = 0; i < frame.boxes.size(); ++i) {
      text += (i > 0 ? " " : "") + BoxText(frame.boxes[i]);
    }
    text += "\n";
  }
  return text;
}

Expected<std::vector<ObservedFrame>> FramesFromCsv(std::string_view text) {
  std::vector<ObservedFrame> frames;
  const std::vector<std::string> rows = Split(text, '\n');
  if (rows.front() != kHeader) {
    return Error{"line 1: not the header of a list of frames"};
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].empty()) continue;
    std::optional<ObservedFrame> frame = ParseRow(rows[i]);
    if (!frame) {
      return Error{fmt::format("line {}: not a frame", i + 1)};
    }
    frames.push_back(*std::move(frame));
  }
  return frames;
}

}  // namespace limpet
