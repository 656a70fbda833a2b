// SPDX-License-Identifier: MIT
#include "limpet/runs/written_files.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/console/command_output.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/durable/durable_file.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kListFormat = "limpet-written-1";

/// Inside the folder: relative and without a way out of it.
bool StaysInside(const fs::path& path) {
  return !path.empty() && path.is_relative() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& p) { return p == ".."; });
}

std::set<std::string> NamesIn(const nlohmann::json& list) {
  std::set<std::string> names;
  for (const nlohmann::json& entry : list) {
    const std::string name = entry.get<std::string>();
    if (!StaysInside(name)) throw std::runtime_error("it names `" + OneLine(name) + "`");
    names.insert(name);
  }
  return names;
}

bool IsUnder(const std::string& file, const std::string& part) {
  return file == part || file.starts_with(part + "/");
}

/// A name that is no UTF-8 is not found again: then the file counts as a stranger.
std::string TextOf(const nlohmann::ordered_json& json) {
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace

void RefuseStrangers(const fs::path& folder, const std::vector<fs::path>& strangers) {
  constexpr std::size_t kNamed = 5;
  std::string names;
  for (std::size_t i = 0; i < std::min(strangers.size(), kNamed); ++i) {
    names += fmt::format("{}{}", i == 0 ? "" : ", ", OneLine(strangers[i].generic_string()));
  }
  if (strangers.size() > kNamed) names += fmt::format(" and {} more", strangers.size() - kNamed);
  throw Refusal(
      fmt::format("{} holds what no run of Limpet wrote: {}; nothing was touched. Move it, or "
                  "choose another folder",
                  OneLine(folder.string()), names));
}

WrittenFiles::WrittenFiles(fs::path folder) : folder_(std::move(folder)) {
  const fs::path list = folder_ / kFile;
  if (!fs::exists(fs::symlink_status(list))) return;
  try {
    std::ifstream file(list);
    const nlohmann::json json = nlohmann::json::parse(file);
    if (json.at("format") != kListFormat) throw std::runtime_error("of another format");
    files_ = NamesIn(json.at("files"));
    begun_ = NamesIn(json.at("begun"));
  } catch (const std::exception& error) {
    throw Refusal(
        fmt::format("{}: not the list of what Limpet wrote here: {}; choose another folder",
                    OneLine(list.string()), OneLine(error.what())));
  }
}

bool WrittenFiles::IsReal(const fs::path& relative) const {
  fs::path path = folder_;
  fs::file_status status;
  for (const fs::path& part : relative) {
    path /= part;
    status = fs::symlink_status(path);
    if (status.type() != fs::file_type::directory) break;
  }
  return path == folder_ / relative && status.type() == fs::file_type::regular;
}

bool WrittenFiles::Owns(const fs::path& file) const {
  return files_.contains(file.generic_string()) && IsReal(file);
}

std::vector<fs::path> WrittenFiles::StrangersIn(const fs::path& part) const {
  std::vector<fs::path> strangers;
  const fs::file_status status = fs::symlink_status(folder_ / part);
  if (!fs::exists(status)) return strangers;
  if (status.type() != fs::file_type::directory) {
    if (!Owns(part)) strangers.push_back(part);
    return strangers;
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / part)) {  // follows no link
    const fs::path relative = entry.path().lexically_relative(folder_);
    const bool is_folder = entry.symlink_status().type() == fs::file_type::directory;
    if (!is_folder && !Owns(relative)) strangers.push_back(relative);
  }
  std::ranges::sort(strangers);
  return strangers;
}

void WrittenFiles::Claim(const std::vector<fs::path>& files) {
  std::vector<fs::path> strangers;
  for (const fs::path& file : files) {
    fs::path above;
    for (const fs::path& part : file.parent_path()) {  // written through a link, it lands elsewhere
      above /= part;
      const auto type = fs::symlink_status(folder_ / above).type();
      if (type != fs::file_type::directory && type != fs::file_type::not_found) {
        strangers.push_back(above);
      }
    }
    if (fs::exists(fs::symlink_status(folder_ / file)) && !Owns(file)) strangers.push_back(file);
  }
  if (!strangers.empty()) RefuseStrangers(folder_, strangers);
  for (const fs::path& file : files)
    files_.insert(file.generic_string());
  Save();
}

void WrittenFiles::ClaimAllIn(const fs::path& part) {
  if (IsReal(part)) files_.insert(part.generic_string());
  if (fs::symlink_status(folder_ / part).type() != fs::file_type::directory) return Save();
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / part)) {
    if (entry.symlink_status().type() != fs::file_type::regular) continue;
    files_.insert(entry.path().lexically_relative(folder_).generic_string());
  }
  Save();
}

void WrittenFiles::RemoveIf(const std::function<bool(const std::string&)>& is_wanted) {
  std::set<fs::path> folders;
  for (auto file = files_.begin(); file != files_.end();) {
    if (!is_wanted(*file)) {
      ++file;
      continue;
    }
    if (IsReal(*file)) fs::remove(folder_ / *file);
    for (fs::path above = fs::path(*file).parent_path(); !above.empty();
         above = above.parent_path()) {
      folders.insert(above);
    }
    file = files_.erase(file);
  }
  // Inner folders come after outer ones; one that still holds something stays.
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder) {
    std::error_code ignored;
    if (fs::symlink_status(folder_ / *folder).type() == fs::file_type::directory) {
      fs::remove(folder_ / *folder, ignored);
    }
  }
  Save();
}

void WrittenFiles::Remove(const fs::path& part) {
  RemoveIf([&](const std::string& file) { return IsUnder(file, part.generic_string()); });
}

void WrittenFiles::RemoveAllBut(const std::vector<std::string>& kept) {
  RemoveIf([&](const std::string& file) {
    return std::ranges::none_of(kept, [&](const std::string& part) { return IsUnder(file, part); });
  });
}

std::vector<fs::path> WrittenFiles::FilesIn(const fs::path& part) const {
  std::vector<fs::path> files;
  for (const std::string& file : files_) {
    if (IsUnder(file, part.generic_string())) files.emplace_back(file);
  }
  return files;
}

void WrittenFiles::Begin(const fs::path& part) {
  begun_.insert(part.generic_string());
  Save();
}

void WrittenFiles::End(const fs::path& part) {
  begun_.erase(part.generic_string());
  ClaimAllIn(part);
}

bool WrittenFiles::IsBegun(const fs::path& part) const {
  return begun_.contains(part.generic_string());
}

fs::path WrittenFiles::SetAside(const fs::path& part) {
  const fs::path from = folder_ / part;
  fs::path to;
  if (fs::exists(fs::symlink_status(from))) {
    int number = 1;
    do {
      to = fs::path(fmt::format("{}.cut-{}", from.string(), number++));
    } while (fs::exists(fs::symlink_status(to)));
    fs::rename(from, to);
  }
  begun_.erase(part.generic_string());
  Save();
  return to;
}

void WrittenFiles::Forget(const std::vector<fs::path>& files) {
  for (const fs::path& file : files)
    files_.erase(file.generic_string());
  Save();
}

void WrittenFiles::Save() const {
  const nlohmann::ordered_json json{{"format", kListFormat},
                                    {"about", "what Limpet wrote here; it removes nothing else"},
                                    {"begun", begun_},
                                    {"files", files_}};
  if (const auto error = WriteDurably(folder_ / kFile, TextOf(json))) {
    throw std::runtime_error(error->text);
  }
}

}  // namespace limpet
