// SPDX-License-Identifier: MIT
#include "limpet/durable/failing_file_system.hpp"

#include <utility>

namespace limpet {
namespace {

class FailingFile final : public WritableFile {
 public:
  FailingFile(std::unique_ptr<WritableFile> file, const FailingFileSystem& disk)
      : file_(std::move(file)), disk_(disk) {}

  [[nodiscard]] std::error_code WriteAt(std::uint64_t offset, std::string_view bytes) override {
    const std::error_code trouble = disk_.TroubleOfWriting();
    if (disk_.fault() == FailingFileSystem::Fault::kFull) {
      static_cast<void>(file_->WriteAt(offset, bytes.substr(0, bytes.size() / 2)));
    }
    return trouble ? trouble : file_->WriteAt(offset, bytes);
  }
  [[nodiscard]] std::error_code Truncate(std::uint64_t size) override {
    const std::error_code trouble = disk_.TroubleOfChanging();
    return trouble ? trouble : file_->Truncate(size);
  }
  [[nodiscard]] std::error_code Sync() override {
    const std::error_code trouble = disk_.TroubleOfChanging();
    return trouble ? trouble : file_->Sync();
  }
  [[nodiscard]] std::uint64_t size() const override { return file_->size(); }

 private:
  std::unique_ptr<WritableFile> file_;
  const FailingFileSystem& disk_;
};

}  // namespace

std::error_code FailingFileSystem::TroubleOfWriting() const {
  return fault() == Fault::kFull ? std::make_error_code(std::errc::no_space_on_device)
                                 : TroubleOfChanging();
}

std::error_code FailingFileSystem::TroubleOfChanging() const {
  switch (fault()) {
    case Fault::kFailing:
      return std::make_error_code(std::errc::io_error);
    case Fault::kReadOnly:
      return std::make_error_code(std::errc::read_only_file_system);
    case Fault::kNone:
    case Fault::kFull:
      break;
  }
  return {};
}

FileSystem::Opened FailingFileSystem::Open(const std::filesystem::path& path, Opening how) {
  Opened opened;
  opened.trouble = TroubleOfWriting();
  if (!opened.trouble) {
    opened = disk_.Open(path, how);
  }
  if (opened.file != nullptr) {
    opened.file = std::make_unique<FailingFile>(std::move(opened.file), *this);
  }
  return opened;
}

std::error_code FailingFileSystem::Rename(const std::filesystem::path& from,
                                          const std::filesystem::path& to) {
  const std::error_code trouble = TroubleOfChanging();
  return trouble ? trouble : disk_.Rename(from, to);
}

std::error_code FailingFileSystem::Link(const std::filesystem::path& existing,
                                        const std::filesystem::path& name) {
  const std::error_code trouble = TroubleOfWriting();
  return trouble ? trouble : disk_.Link(existing, name);
}

std::error_code FailingFileSystem::Remove(const std::filesystem::path& path) {
  const std::error_code trouble = TroubleOfChanging();
  return trouble ? trouble : disk_.Remove(path);
}

std::error_code FailingFileSystem::CreateFolder(const std::filesystem::path& path) {
  const std::error_code trouble = TroubleOfWriting();
  return trouble ? trouble : disk_.CreateFolder(path);
}

std::error_code FailingFileSystem::SyncFolder(const std::filesystem::path& path) {
  const std::error_code trouble = TroubleOfChanging();
  return trouble ? trouble : disk_.SyncFolder(path);
}

std::optional<std::uint64_t> FailingFileSystem::Room(const std::filesystem::path& path) const {
  constexpr std::uint64_t kRoomMade = std::uint64_t{10} << 30U;
  const std::uint64_t limit = state_.room;
  if (fault() == Fault::kFull) return 0;
  if (limit != kRoomOfDisk) return limit;
  if (&state_ != &own_) return disk_.Room(path);
  return was_full_ ? std::optional(kRoomMade) : std::nullopt;
}

}  // namespace limpet
