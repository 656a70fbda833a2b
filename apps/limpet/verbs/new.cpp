// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/new.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/console/command_output.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/core/folders_above.hpp"
#include "limpet/core/letter_case.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/mission/process_name.hpp"
#include "limpet/mission/source_text.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

Command NewForm() {
  return {.name = "limpet new",
          .words = "behavior <BHV_Name> | app <pName>",
          .about = R"(A repository of your own with a behavior, or an app, its test and, for a
behavior, a mission in which it bids. It builds against an installed Limpet:

  limpet new behavior BHV_KeepOff --out own
  cmake -S own -B own/build -DCMAKE_PREFIX_PATH=<where Limpet is installed>
  cmake --build own/build && ctest --test-dir own/build)",
          .options = {{.names = "--out",
                       .value = "DIR",
                       .meaning = "where to (default: a folder of that name)",
                       .rule = NotEmpty("a folder")}},
          .more = R"(In a repository that is there already only what is new is added: nothing is
written over.)",
          .takes = "what and its name: `behavior BHV_Name` or `app pName`",
          .least_words = 2,
          .most_words = 2};
}

/// What can be made, and how the template calls it.
struct Kind {
  const char* word;
  const char* template_name;       ///< what the template has in its place
  const char* pattern;             ///< of names, for complaints
  std::array<const char*, 2> own;  ///< folders that only this kind takes
};
constexpr Kind kBehavior{"behavior", "BHV_Template", "BHV_Name", {"behaviors", "missions"}};
constexpr Kind kAppKind{"app", "pTemplate", "pName", {"apps", "apps"}};

const Kind& KindOf(const std::string& word) {
  for (const Kind* kind : {&kBehavior, &kAppKind}) {
    if (word == kind->word) {
      return *kind;
    }
  }
  throw UsageError(fmt::format("`{}` is neither `behavior` nor `app`", OneLine(word, 40)));
}

/// Throws UsageError for what C++ or the helm would not take.
void CheckName(const Kind& kind, const std::string& name) {
  const bool is_word =
      std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
  const bool has_form =
      &kind == &kBehavior ? name.starts_with("BHV_") && name.size() > 4 : IsNameOfMoosProcess(name);
  if (!is_word || !has_form) {
    throw UsageError(fmt::format("`{}` is no name for {} {}: {}letters, digits and _, as `{}`",
                                 OneLine(name, 40), &kind == &kAppKind ? "an" : "a", kind.word,
                                 &kind == &kAppKind ? "p, i or u and a capital letter, then " : "",
                                 kind.pattern));
  }
  const bool is_database = name == "LimpetDB" || name == "MOOSDB";
  if (BehaviorRegistry().contains(name) || AppRegistry().contains(name) || is_database) {
    throw UsageError(fmt::format("`{}` is one of Limpet's own: call yours something else", name));
  }
}

fs::path TemplateFolder() {
  std::vector<fs::path> folders;
  AddFoldersOfProgram(fs::path("share") / "limpet-template", folders);
  if (folders.empty()) {
    throw std::runtime_error("the template, share/limpet-template, is not near this program");
  }
  return folders.front();
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// The template's names replaced by the user's, in a path or in a text.
std::string Renamed(const std::string& text, const Kind& kind, const std::string& name) {
  return Replaced(Replaced(text, kind.template_name, name), UpperCase(kind.template_name),
                  UpperCase(name));
}

struct NewFile {
  fs::path path;
  std::string text;
  bool is_named = false;  ///< after what is made; else every repository has it
};

std::vector<NewFile> FilesFor(const Kind& kind, const std::string& name, const fs::path& out) {
  const fs::path from = TemplateFolder();
  const Kind& other = &kind == &kAppKind ? kBehavior : kAppKind;
  std::vector<NewFile> files;
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    const std::string path = entry.path().lexically_relative(from).string();
    const bool is_others = std::ranges::any_of(
        other.own, [&path](const char* folder) { return path.starts_with(folder); });
    if (entry.is_regular_file() && !is_others) {
      const std::string renamed = Renamed(path, kind, name);
      files.push_back({.path = out / renamed,
                       .text = Renamed(ReadTextFile(entry.path()), kind, name),
                       .is_named = renamed != path});
    }
  }
  std::ranges::sort(files, {}, &NewFile::path);
  return files;
}

void WriteNew(const NewFile& file) {
  fs::create_directories(file.path.parent_path());
  std::ofstream output(file.path, std::ios::binary);
  output << file.text;
  if (!output.flush()) {
    throw std::runtime_error(fmt::format("{}: cannot be written", file.path.string()));
  }
}

int MakeNew(const Arguments& given) {
  const Kind& kind = KindOf(given.positionals()[0]);
  const std::string& name = given.positionals()[1];
  CheckName(kind, name);
  const fs::path out = given.Find("out").value_or(name);
  const std::vector<NewFile> files = FilesFor(kind, name, out);
  for (const NewFile& file : files) {
    if (file.is_named && fs::exists(file.path)) {
      throw Refusal(fmt::format("{} is there already: nothing was written", file.path.string()));
    }
  }
  for (const NewFile& file : files) {
    const bool is_kept = fs::exists(file.path);
    if (!is_kept) {
      WriteNew(file);
    }
    fmt::print("{:<8} {}\n", is_kept ? "kept" : "written", OneLine(file.path.string()));
  }
  fmt::print("\nnext: see {}\n", OneLine((out / "README.md").string()));
  return kOk;
}

}  // namespace

int RunNew(std::span<const std::string> args) { return RunCommand(NewForm(), args, MakeNew); }

}  // namespace limpet
