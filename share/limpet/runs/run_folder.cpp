// SPDX-License-Identifier: MIT
#include "limpet/runs/run_folder.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "limpet/console/command_output.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/durable/durable_file.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFigures = "figures";
constexpr const char* kReportFiles[] = {"run.json", "report.json", "report.html"};

/// Name of the new file beside `file`, as WriteDurably makes it.
fs::path AsideOf(const fs::path& file) { return file.string() + ".new"; }

/// What is in a folder that never held a run.
std::vector<fs::path> ForeignContent(const fs::path& folder) {
  std::vector<fs::path> content;
  if (!fs::is_directory(folder) || fs::exists(folder / WrittenFiles::kFile)) return content;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename() != FolderLock::kFile) content.push_back(entry.path().filename());
  }
  std::ranges::sort(content);
  return content;
}

void Append(std::vector<fs::path>& to, const std::vector<fs::path>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// Figures of these sessions would be written over.
bool IsFigureOf(const fs::path& file, const std::vector<std::string>& sessions) {
  const std::string name = file.filename().string();
  return file == kFigures || std::ranges::any_of(sessions, [&](const std::string& session) {
           return name.starts_with(session + "_");
         });
}

}  // namespace

RunFolder::RunFolder(fs::path folder, Use use) : path_(std::move(folder)) {
  if (fs::exists(path_) && !fs::is_directory(path_)) {
    throw Refusal(fmt::format("{} is a file, not a folder", OneLine(path_.string())));
  }
  if (use == Use::kNewRun) {
    if (const auto content = ForeignContent(path_); !content.empty()) {
      RefuseStrangers(path_, content);
    }
  }
  fs::create_directories(path_);
  lock_ = std::make_unique<FolderLock>(path_);
  written_.emplace(path_);
}

void RunFolder::MakeRoomFor(const std::vector<std::string>& sessions,
                            const std::vector<std::string>& kept) {
  std::vector<fs::path> strangers;
  for (const char* file : kReportFiles)
    Append(strangers, written_->StrangersIn(file));
  for (const fs::path& figure : written_->StrangersIn(kFigures)) {
    if (IsFigureOf(figure, sessions)) strangers.push_back(figure);
  }
  for (const std::string& session : sessions) {
    if (!written_->IsBegun(session)) Append(strangers, written_->StrangersIn(session));
  }
  if (!strangers.empty()) RefuseStrangers(path_, strangers);
  for (const std::string& session : sessions) {
    if (!written_->IsBegun(session)) continue;
    if (const fs::path aside = written_->SetAside(session); !aside.empty()) {
      fmt::print(stderr, "limpet: {} was cut short by a crash; it is kept as {}\n", session,
                 OneLine(aside.string()));
    }
  }
  written_->RemoveAllBut(kept);
}

void RunFolder::Write(const std::map<std::string, std::string>& files) {
  std::vector<fs::path> names, asides;
  for (const auto& [name, text] : files) {
    names.emplace_back(name);
    asides.push_back(AsideOf(name));
  }
  Append(names, asides);
  written_->Claim(names);
  for (const auto& [name, text] : files) {
    const fs::path file = path_ / name;
    std::optional<Error> error = CreateFolders(file.parent_path());
    if (!error) error = WriteDurably(file, text);
    if (error) throw std::runtime_error(file.parent_path().string() + "/" + error->text);
  }
  written_->Forget(asides);
}

void RunFolder::RemoveOtherFigures(const std::map<std::string, std::string>& files) {
  for (const fs::path& figure : written_->FilesIn(kFigures)) {
    if (!files.contains(figure.generic_string())) written_->Remove(figure);
  }
}

FilledFolder::~FilledFolder() {
  try {
    written_.End(part_);
  } catch (const std::exception& error) {
    // E.g. a full disk: the folder stays begun, and the next run sets it aside.
    fmt::print(stderr, "limpet: {}\n", OneLine(error.what()));
  }
}

}  // namespace limpet
