// SPDX-License-Identifier: MIT
#include "tests/layers/test_subjects.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace limpet::layers {
namespace {

/// By library: what its tests may be called after.
using SubjectsOfLibrary = std::map<std::string, std::set<std::string>>;

/// Every folder on the way to a file is a library to whoever calls a test folder so.
void AddSubject(std::string_view path, SubjectsOfLibrary& subjects) {
  constexpr std::string_view kShared = "share/limpet/";
  if (path.starts_with(kShared)) path.remove_prefix(kShared.size());
  const std::filesystem::path file(path);
  for (const auto& library : file.parent_path()) {
    subjects[library.string()].insert(file.stem().string());
  }
}

bool HasSubject(const std::string& name, const std::set<std::string>& subjects) {
  return std::ranges::any_of(subjects, [&name](const std::string& file) {
    return name == file || name.starts_with(file + "_");
  });
}

/// The folder that tests/unit/<folder> is about: its own name, but for the command's.
std::string LibraryOf(const std::string& folder) { return folder == "cli" ? "limpet" : folder; }

}  // namespace

std::vector<std::string> TestsWithoutSubject(const std::vector<SourceFile>& files) {
  SubjectsOfLibrary subjects;
  for (const SourceFile& file : files) {
    if (!file.path.starts_with("tests/") || file.path.starts_with("tests/support/")) {
      AddSubject(file.path, subjects);
    }
  }
  std::vector<std::string> complaints;
  for (const SourceFile& file : files) {
    constexpr std::string_view kUnit = "tests/unit/", kEnd = "_test";
    std::string name = std::filesystem::path(file.path).stem().string();
    if (!file.path.starts_with(kUnit) || !name.ends_with(kEnd)) continue;
    name.erase(name.size() - kEnd.size());
    const std::string folder =
        file.path.substr(kUnit.size(), file.path.find('/', kUnit.size()) - kUnit.size());
    const std::string library = LibraryOf(folder);
    if (!HasSubject(name, subjects[library]) && !HasSubject(name, subjects["support"])) {
      complaints.push_back(fmt::format("{}: is of no file of `{}`", file.path, library));
    }
  }
  return complaints;
}

}  // namespace limpet::layers
