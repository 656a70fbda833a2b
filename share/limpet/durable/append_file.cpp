// SPDX-License-Identifier: MIT
#include "limpet/durable/append_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

Error Impossible(const std::filesystem::path& path, const char* what,
                 const std::error_code& trouble) {
  return Error{fmt::format("`{}` cannot be {}: {}", path.string(), what, trouble.message())};
}

/// Where the last line of the file's first `size` bytes ends.
std::uint64_t EndOfLines(const std::filesystem::path& path, std::uint64_t size) {
  std::ifstream in(path, std::ios::binary);
  std::array<char, 64 * 1024> block{};
  while (size > 0) {
    const std::uint64_t begin = size - std::min<std::uint64_t>(size, block.size());
    const auto length = static_cast<std::size_t>(size - begin);
    in.seekg(static_cast<std::streamoff>(begin));
    if (!in.read(block.data(), static_cast<std::streamsize>(length))) {
      return size;
    }
    const std::size_t end = std::string_view(block.data(), length).rfind('\n');
    if (end != std::string_view::npos) {
      return begin + end + 1;
    }
    size = begin;
  }
  return 0;
}

}  // namespace

Expected<AppendFile> AppendFile::Open(const std::filesystem::path& path, FileSystem::Opening how,
                                      FileSystem& disk) {
  AppendFile file(path, disk);
  FileSystem::Opened opened = disk.Open(path, how);
  if (opened.file == nullptr) {
    return Impossible(path, how == FileSystem::Opening::kEmpty ? "created" : "continued",
                      opened.trouble);
  }
  file.file_ = std::move(opened.file);
  file.size_ = file.file_->size();
  // What a former life left behind, a name or bytes, may not be on the disk either.
  file.has_new_name_ = opened.is_new || how == FileSystem::Opening::kAsItIs;
  file.is_synced_ = how == FileSystem::Opening::kEmpty;
  return file;
}

Expected<AppendFile> AppendFile::Create(const std::filesystem::path& path, FileSystem& disk) {
  return Open(path, FileSystem::Opening::kEmpty, disk);
}

Expected<AppendFile> AppendFile::Continue(const std::filesystem::path& path, FileSystem& disk) {
  return Open(path, FileSystem::Opening::kAsItIs, disk);
}

Expected<AppendFile> AppendFile::ContinueAt(const std::filesystem::path& path, std::uint64_t size,
                                            FileSystem& disk) {
  Expected<AppendFile> file = Continue(path, disk);
  if (file && file->size_ != size) {
    LIMPET_REQUIRE(size < file->size_, "only what is there can be kept");
    if (const std::error_code trouble = file->file_->Truncate(size)) {
      return Impossible(path, "continued", trouble);
    }
    file->size_ = size;
    file->is_synced_ = false;
  }
  return file;
}

Expected<AppendFile> AppendFile::ContinueLines(const std::filesystem::path& path,
                                               FileSystem& disk) {
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(path, missing);
  return missing ? Continue(path, disk) : ContinueAt(path, EndOfLines(path, size), disk);
}

bool AppendFile::IsFine(std::error_code trouble) {
  trouble_ = trouble;
  return !trouble;
}

bool AppendFile::Append(std::string_view bytes) {
  if (!IsFine(file_->WriteAt(size_, bytes))) {
    // If even this fails, the next piece is still written from size_ on, over the remains.
    static_cast<void>(file_->Truncate(size_));
    return false;
  }
  size_ += bytes.size();
  is_synced_ = is_synced_ && bytes.empty();
  return true;
}

bool AppendFile::Overwrite(std::uint64_t offset, std::string_view bytes) {
  LIMPET_REQUIRE(offset + bytes.size() <= size_, "only what is there can be written over");
  is_synced_ = false;
  return IsFine(file_->WriteAt(offset, bytes));
}

void AppendFile::Discard() {
  file_.reset();
  static_cast<void>(disk_->Remove(path_));
}

bool AppendFile::Sync() {
  if (!is_synced_) {
    is_synced_ = IsFine(file_->Sync());
    if (!is_synced_) {
      return false;
    }
  }
  if (has_new_name_) {
    has_new_name_ = !IsFine(disk_->SyncFolder(path_.parent_path()));
  }
  return !has_new_name_;
}

}  // namespace limpet
