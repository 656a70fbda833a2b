// SPDX-License-Identifier: MIT
#include "limpet/app/host_faults.hpp"

#include <new>

#include "limpet/mission/fault_names.hpp"

namespace limpet {

FailingFileSystem::Fault DiskFaultOf(const FaultSchedule& schedule) {
  using Fault = FailingFileSystem::Fault;
  return schedule.Active(fault_names::kDiskFailing) != nullptr    ? Fault::kFailing
         : schedule.Active(fault_names::kDiskReadOnly) != nullptr ? Fault::kReadOnly
         : schedule.Active(fault_names::kDiskFull) != nullptr     ? Fault::kFull
                                                                  : Fault::kNone;
}

HostFaults::HostFaults()
    : memory_(SharedMemory::Inherit(kVariable, sizeof(HostFaultPage))),
      page_(static_cast<HostFaultPage*>(memory_.data())) {
  if (page_ != nullptr) {
    disk_ = std::make_unique<FailingFileSystem>(RealFileSystem(), page_->disk);
  }
}

FileSystem& HostFaults::disk() const {
  return disk_ != nullptr ? static_cast<FileSystem&>(*disk_) : RealFileSystem();
}

Seconds HostFaults::wall_ahead() const {
  return Seconds(page_ != nullptr ? page_->wall_ahead.load() : 0.0);
}

HostFaultControl::HostFaultControl()
    : memory_(SharedMemory::Create("limpet-host", sizeof(HostFaultPage))) {
  if (memory_.data() != nullptr) page_ = new (memory_.data()) HostFaultPage;
}

void HostFaultControl::FailDisk(FailingFileSystem::Fault fault) {
  if (page_ != nullptr) page_->disk.fault = fault;
}

void HostFaultControl::LimitDisk(std::optional<std::uint64_t> bytes) {
  if (page_ != nullptr) page_->disk.room = bytes.value_or(FailingFileSystem::kRoomOfDisk);
}

void HostFaultControl::SetWallAhead(Seconds ahead) {
  if (page_ != nullptr) page_->wall_ahead = ahead.value();
}

}  // namespace limpet
