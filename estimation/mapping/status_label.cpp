// SPDX-License-Identifier: MIT
#include "estimation/mapping/status_label.hpp"

namespace limpet {

VoxelLabel LabelOf(Status decided) {
  switch (decided) {
    case Status::kConfirmed:
      return VoxelLabel::kConfirmed;
    case Status::kRemoved:
      return VoxelLabel::kRemoved;
    case Status::kNew:
      return VoxelLabel::kNew;
    case Status::kMoved:
      return VoxelLabel::kMoved;
    case Status::kUncertain:
    case Status::kNotInspected:
    case Status::kNothing:
      break;
  }
  return VoxelLabel::kUncertain;
}

std::optional<Status> StatusOf(VoxelLabel label) {
  switch (label) {
    case VoxelLabel::kGround:
      return std::nullopt;
    case VoxelLabel::kConfirmed:
      return Status::kConfirmed;
    case VoxelLabel::kRemoved:
      return Status::kRemoved;
    case VoxelLabel::kNew:
      return Status::kNew;
    case VoxelLabel::kMoved:
      return Status::kMoved;
    case VoxelLabel::kUncertain:
      break;
  }
  return Status::kUncertain;
}

}  // namespace limpet
