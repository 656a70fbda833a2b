// SPDX-License-Identifier: MIT
#include "limpet/topics/byte_stream.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

constexpr std::size_t kCameraHeader = 32;
constexpr std::size_t kGridHeader = 48;
constexpr std::size_t kGridCell = 16;
constexpr std::size_t kGridCellWithoutFloor = 12;
constexpr std::uint32_t kMaxImageSide = 16384;
constexpr std::uint32_t kMaxGridSide = 1U << 16U;

}  // namespace

Value TopicCodec<CameraFrame>::Encode(const CameraFrame& frame) {
  ByteWriter out(kCameraHeader + frame.bgr.size());
  out.Magic("LCF1");
  out.Put(frame.frame);
  out.Put(frame.exposure.value());
  out.Put(static_cast<std::uint32_t>(frame.width_px));
  out.Put(static_cast<std::uint32_t>(frame.height_px));
  out.Zeros(8);
  out.Raw(frame.bgr.data(), frame.bgr.size());
  return out.Take();
}

std::optional<CameraFrame> TopicCodec<CameraFrame>::Decode(const Value& value) {
  const auto* bytes = std::get_if<Binary>(&value);
  if (bytes == nullptr) {
    return std::nullopt;
  }
  ByteReader in(*bytes);
  CameraFrame frame;
  double exposure = 0.0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  const bool has_header = in.HasMagic("LCF1") && in.Get(frame.frame) && in.Get(exposure) &&
                          in.Get(width) && in.Get(height) && in.Skip(8);
  if (!has_header || width > kMaxImageSide || height > kMaxImageSide ||
      in.left() != std::size_t{3} * width * height) {
    return std::nullopt;
  }
  frame.exposure = Seconds(exposure);
  frame.width_px = static_cast<int>(width);
  frame.height_px = static_cast<int>(height);
  frame.bgr.resize(in.left());
  in.Raw(frame.bgr.data(), frame.bgr.size());
  return frame;
}

Value TopicCodec<GridDelta>::Encode(const GridDelta& delta) {
  ByteWriter out(kGridHeader + kGridCell * delta.cells.size());
  out.Magic("LGD2");
  out.Put(static_cast<std::uint32_t>(delta.cells.size()));
  out.Put(delta.frame.north_min);
  out.Put(delta.frame.east_min);
  out.Put(delta.frame.cell_m);
  out.Put(static_cast<std::uint32_t>(delta.frame.rows));
  out.Put(static_cast<std::uint32_t>(delta.frame.columns));
  out.Zeros(8);
  for (const GridDelta::Cell& cell : delta.cells) {
    out.Put(cell.index);
    out.Put(cell.now.seen_height);
    out.Put(cell.now.seabed_down);
    out.Put(cell.now.seen_floor);
  }
  return out.Take();
}

std::optional<GridDelta> TopicCodec<GridDelta>::Decode(const Value& value) {
  const auto* bytes = std::get_if<Binary>(&value);
  if (bytes == nullptr) {
    return std::nullopt;
  }
  ByteReader in(*bytes);
  GridDelta delta;
  std::uint32_t count = 0;
  std::uint32_t rows = 0;
  std::uint32_t columns = 0;
  const bool has_floors = in.HasMagic("LGD2");
  const bool has_header = (has_floors || in.HasMagic("LGD1")) && in.Get(count) &&
                          in.Get(delta.frame.north_min) && in.Get(delta.frame.east_min) &&
                          in.Get(delta.frame.cell_m) && in.Get(rows) && in.Get(columns) &&
                          in.Skip(8);
  if (!has_header || rows > kMaxGridSide || columns > kMaxGridSide ||
      in.left() != (has_floors ? kGridCell : kGridCellWithoutFloor) * count) {
    return std::nullopt;
  }
  delta.frame.rows = static_cast<int>(rows);
  delta.frame.columns = static_cast<int>(columns);
  delta.cells.resize(count);
  for (GridDelta::Cell& cell : delta.cells) {
    in.Get(cell.index);
    in.Get(cell.now.seen_height);
    in.Get(cell.now.seabed_down);
    if (has_floors) {
      in.Get(cell.now.seen_floor);
    }
    if (cell.index >= std::uint64_t{rows} * columns) {
      return std::nullopt;
    }
  }
  return delta;
}

}  // namespace limpet
