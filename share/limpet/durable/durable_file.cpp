// SPDX-License-Identifier: MIT
#include "limpet/durable/durable_file.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

namespace limpet {
namespace {

namespace fs = std::filesystem;

Error Trouble(const fs::path& file, const char* what, const std::error_code& trouble) {
  return Error{file.filename().string() + ": " + what + ": " + trouble.message()};
}

}  // namespace

std::optional<Error> SyncFolder(const fs::path& folder, FileSystem& disk) {
  if (const std::error_code trouble = disk.SyncFolder(folder)) {
    return Trouble(folder, "cannot sync the folder", trouble);
  }
  return std::nullopt;
}

std::optional<Error> WriteContent(const fs::path& file, std::string_view bytes, FileSystem& disk) {
  const FileSystem::Opened opened = disk.Open(file, FileSystem::Opening::kEmpty);
  if (opened.file == nullptr) return Trouble(file, "cannot create", opened.trouble);
  std::error_code trouble = opened.file->WriteAt(0, bytes);
  if (!trouble) trouble = opened.file->Sync();
  if (trouble) {
    static_cast<void>(disk.Remove(file));
    return Trouble(file, "cannot write", trouble);
  }
  return std::nullopt;
}

std::optional<Error> WriteDurably(const fs::path& file, std::string_view bytes, FileSystem& disk) {
  fs::path aside = file;
  aside += ".new";
  if (std::optional<Error> error = WriteContent(aside, bytes, disk)) return error;
  if (const std::error_code trouble = disk.Rename(aside, file)) {
    static_cast<void>(disk.Remove(aside));
    return Trouble(file, "cannot rename", trouble);
  }
  return SyncFolder(file.parent_path(), disk);
}

std::optional<Error> CreateFolders(const fs::path& folder, FileSystem& disk) {
  std::vector<fs::path> missing;
  for (fs::path above = folder; !above.empty() && !fs::is_directory(above);
       above = above.parent_path()) {
    if (above.has_filename()) missing.push_back(above);
  }
  for (auto next = missing.rbegin(); next != missing.rend(); ++next) {
    const std::error_code trouble = disk.CreateFolder(*next);
    if (trouble && !fs::is_directory(*next)) return Trouble(*next, "cannot create", trouble);
    if (std::optional<Error> error = SyncFolder(next->parent_path(), disk)) return error;
  }
  return std::nullopt;
}

void RemoveFolder(const fs::path& folder, FileSystem& disk) {
  std::error_code ignored;
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    found.push_back(entry.path());
  }
  for (const fs::path& path : found) {
    if (fs::is_directory(fs::symlink_status(path, ignored))) {
      RemoveFolder(path, disk);
    } else {
      static_cast<void>(disk.Remove(path));
    }
  }
  static_cast<void>(disk.Remove(folder));
}

Expected<std::string> ReadWhole(const fs::path& file) {
  // A stream opens a folder, and fails only when it reads, by an exception without its name.
  std::error_code unknown;
  if (fs::is_directory(file, unknown)) {
    return Trouble(file, "cannot open", std::make_error_code(std::errc::is_a_directory));
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    return Trouble(file, "cannot open", {errno, std::generic_category()});
  }
  return std::string(std::istreambuf_iterator<char>(in), {});
}

}  // namespace limpet
