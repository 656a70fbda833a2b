// SPDX-License-Identifier: MIT
#include "tests/layers/layers.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace limpet::layers {
namespace {

/// Beginnings of the include paths of each third-party library that the table names.
const std::vector<std::pair<std::string, std::vector<std::string>>>& ThirdParty() {
  static const std::vector<std::pair<std::string, std::vector<std::string>>> prefixes{
      {"OpenCV", {"opencv2/"}},
      {"OctoMap", {"octomap/"}},
      {"SUNDIALS", {"cvode/", "nvector/", "sundials/", "sunmatrix/", "sunlin", "sunnonlin"}},
      {"MRPT", {"mrpt/"}},
      {"nlohmann-json", {"nlohmann/"}},
      {"yaml-cpp", {"yaml-cpp/"}},
      {"pugixml", {"pugixml.hpp"}},
      {"xxHash", {"xxhash.h"}},
      {"libsodium", {"sodium.h"}},
      {"CLI11", {"CLI/"}}};
  return prefixes;
}

std::string ThirdPartyOf(std::string_view include) {
  for (const auto& [library, prefixes] : ThirdParty()) {
    if (std::ranges::any_of(prefixes, [&](const auto& p) { return include.starts_with(p); })) {
      return library;
    }
  }
  return "";
}

std::string_view WithoutShare(std::string_view path) {
  constexpr std::string_view kShare = "share/";
  return path.starts_with(kShare) ? path.substr(kShare.size()) : path;
}

/// The folder that an include path belongs to: `core`, `estimation/change`, `apps/pNav`, `tests`.
std::optional<std::string> FolderOf(std::string_view path) {
  const auto two_parts = [path] {
    return std::string(path.substr(0, path.find('/', path.find('/') + 1)));
  };
  if (path.starts_with("limpet/")) return two_parts().substr(std::string_view("limpet/").size());
  if (path.starts_with("apps/") || path.starts_with("estimation/")) return two_parts();
  if (path.starts_with("behaviors/") || path.starts_with("generators/") ||
      path.starts_with("tests/")) {
    return std::string(path.substr(0, path.find('/')));
  }
  return std::nullopt;
}

/// The row of the table that a folder falls under.
std::string LayerOf(const std::string& folder) {
  return folder.starts_with("estimation/") ? "estimation" : folder;
}

struct Include {
  std::string path;
  int line = 0;
  bool is_quoted = false;
};

std::optional<Include> IncludeIn(std::string_view line, int number) {
  const auto skip = [&line](std::string_view letters) {
    line.remove_prefix(std::min(line.find_first_not_of(letters), line.size()));
  };
  skip(" \t");
  if (!line.starts_with('#')) return std::nullopt;
  skip("# \t");
  if (!line.starts_with("include")) return std::nullopt;
  line.remove_prefix(std::string_view("include").size());
  skip(" \t");
  if (line.empty() || (line[0] != '"' && line[0] != '<')) return std::nullopt;
  const bool is_quoted = line[0] == '"';
  const std::size_t close = line.find(is_quoted ? '"' : '>', 1);
  if (close == std::string_view::npos) return std::nullopt;
  return Include{std::string(line.substr(1, close - 1)), number, is_quoted};
}

std::vector<Include> IncludesOf(std::string_view text) {
  std::vector<Include> includes;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (auto include = IncludeIn(text.substr(0, end), number)) {
      includes.push_back(*std::move(include));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return includes;
}

class Checker {
 public:
  Checker(const std::vector<SourceFile>& files, const LayerTable& table) : table_(table) {
    for (const SourceFile& file : files) {
      if (const auto folder = FolderOf(WithoutShare(file.path))) {
        sources_.push_back(
            {file.path, std::string(WithoutShare(file.path)), *folder, IncludesOf(file.text)});
      }
    }
    FindPublicHeaders();
  }

  [[nodiscard]] std::vector<std::string> Run() const {
    std::vector<std::string> found;
    for (const Source& source : sources_) {
      for (const Include& include : source.includes) {
        const std::string complaint = Complaint(source, include);
        if (!complaint.empty()) {
          found.push_back(
              fmt::format("{}:{}: {}: {}", source.file, include.line, include.path, complaint));
        }
      }
    }
    return found;
  }

 private:
  struct Source {
    std::string file;  ///< from the repository root
    std::string path;  ///< as an include names it
    std::string folder;
    std::vector<Include> includes;
  };

  /// Headers that another row of the table includes, and what those include in turn. Tests do not
  /// count: they may look inside.
  void FindPublicHeaders() {
    for (bool is_growing = true; is_growing;) {
      is_growing = false;
      for (const Source& source : sources_) {
        for (const Include& include : source.includes) {
          const std::optional<std::string> target = FolderOf(include.path);
          const bool is_from_outside = source.folder != "tests" && include.is_quoted && target &&
                                       LayerOf(*target) != LayerOf(source.folder);
          if (is_from_outside || public_headers_.contains(source.path)) {
            is_growing = public_headers_.insert(include.path).second || is_growing;
          }
        }
      }
    }
  }

  [[nodiscard]] std::string Complaint(const Source& source, const Include& include) const {
    if (!include.is_quoted) {
      return ThirdPartyComplaint(source, include);
    }
    if (const auto target = FolderOf(include.path)) {
      return EdgeComplaint(source.folder, *target);
    }
    return source.folder == "tests" ? "" : "a quoted include is a path from the repository root";
  }

  [[nodiscard]] std::string EdgeComplaint(const std::string& folder,
                                          const std::string& target) const {
    if (folder == target || folder == "tests") return "";
    if (target == "tests") return "nothing but tests may include tests";
    if (folder.starts_with("apps/")) {
      return target.starts_with("apps/") ? "an app may not include another app" : "";
    }
    const std::string layer = LayerOf(folder);
    const auto row = table_.find(layer);
    if (row == table_.end()) return fmt::format("`{}` has no row in the layer table", layer);
    return row->second.may_use.contains(LayerOf(target))
               ? ""
               : fmt::format("`{}` may not use `{}`", layer, LayerOf(target));
  }

  [[nodiscard]] std::string ThirdPartyComplaint(const Source& source,
                                                const Include& include) const {
    const std::string library = ThirdPartyOf(include.path);
    const bool is_free = source.folder == "tests" || source.folder.starts_with("apps/");
    if (library.empty() || is_free) {
      return "";
    }
    const auto row = table_.find(LayerOf(source.folder));
    if (row == table_.end() || !row->second.hidden.contains(library)) {
      return fmt::format("`{}` may not use {}", LayerOf(source.folder), library);
    }
    return public_headers_.contains(source.path)
               ? fmt::format("{} stays out of headers that other libraries reach", library)
               : "";
  }

  const LayerTable& table_;
  std::vector<Source> sources_;
  Names public_headers_;
};

}  // namespace

std::vector<std::string> Violations(const std::vector<SourceFile>& files, const LayerTable& table) {
  return Checker(files, table).Run();
}

}  // namespace limpet::layers
