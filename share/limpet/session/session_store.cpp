// SPDX-License-Identifier: MIT
#include "limpet/session/session_store.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/core/number_text.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/session/checksum.hpp"

namespace limpet {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SessionFacts, limpet, mission, session, community, seed,
                                   lat_origin, long_origin, saved_at, cause)

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kFormat = "limpet-session";
constexpr int kVersion = 1;
constexpr const char* kManifest = "manifest.json";
constexpr int kMostAside = 1000;
constexpr std::int64_t kMostGenerations = 100'000'000;

std::string GenerationName(int generation) { return fmt::format("g{:06d}", generation); }

std::string TextOf(const json& value) {
  return value.dump(1, ' ', false, json::error_handler_t::replace);
}

/// The one way to write this body: a reader accepts no other bytes, so that no bit of the manifest
/// can change unnoticed.
std::string SealedText(const json& body) {
  return TextOf(json{{"body", body}, {"xxh3_64", ChecksumOf(TextOf(body))}}) + "\n";
}

json BodyOf(const SessionFacts& facts, int generation, const ListedFiles& files) {
  json listed = json::array();
  for (const auto& [name, file] : files) {
    listed.push_back({{"name", name}, {"size", file.size}, {"xxh3_64", file.checksum}});
  }
  return {{"format", kFormat},
          {"version", kVersion},
          {"generation", generation},
          {"facts", facts},
          {"files", listed}};
}

Error Damaged(const fs::path& file, const std::string& why) {
  return Error{file.string() + ": " + why};
}

std::optional<Error> SizeTrouble(const fs::path& file, std::uintmax_t size,
                                 const ListedFile& listed) {
  if (size == listed.size) return std::nullopt;
  return Damaged(file, fmt::format("damaged: {} bytes instead of {}", size, listed.size));
}

Expected<std::string> ReadListed(const fs::path& file, const ListedFile& listed) {
  Expected<std::string> bytes = ReadWhole(file);
  if (!bytes) {
    return Damaged(file, "missing");
  }
  if (std::optional<Error> error = SizeTrouble(file, bytes->size(), listed)) {
    return *error;
  }
  if (ChecksumOf(*bytes) != listed.checksum) {
    return Damaged(file, "damaged: its checksum does not match");
  }
  return bytes;
}

/// `file` becomes what `former`, which is on the disk, is.
std::optional<Error> KeepFile(const fs::path& former, const fs::path& file,
                              const ListedFile& listed, FileSystem& disk) {
  std::error_code missing;
  const std::uintmax_t size = fs::file_size(former, missing);
  if (missing) return Damaged(former, "missing");
  if (auto error = SizeTrouble(former, size, listed)) return error;
  const std::error_code trouble = disk.Link(former, file);
  if (!trouble) return std::nullopt;
  if (!IsWithoutLinks(trouble)) {
    return Error{fmt::format("{}: cannot be linked: {}", former.string(), trouble.message())};
  }
  const Expected<std::string> bytes = ReadListed(former, listed);
  return bytes ? WriteContent(file, *bytes, disk) : bytes.error();
}

/// The folder that files are taken from, and which of them are `kept`.
struct FormerFiles {
  fs::path folder;
  const ListedFiles& kept;
};

std::optional<Error> WriteGeneration(const fs::path& folder, const SessionFiles& files,
                                     const FormerFiles& former, FileSystem& disk) {
  if (fs::exists(folder)) RemoveFolder(folder, disk);  // what an interrupted save left
  std::set<fs::path> folders{folder};
  for (const auto& [name, bytes] : files)
    folders.insert((folder / name).parent_path());
  for (const auto& [name, listed] : former.kept)
    folders.insert((folder / name).parent_path());
  for (const fs::path& needed : folders) {
    if (auto error = CreateFolders(needed, disk)) return error;
  }
  for (const auto& [name, bytes] : files) {
    if (auto error = WriteContent(folder / name, bytes, disk)) return error;
  }
  for (const auto& [name, listed] : former.kept) {
    if (auto error = KeepFile(former.folder / name, folder / name, listed, disk)) return error;
  }
  // Names and content are on the disk before the manifest tells of them.
  for (const fs::path& filled : folders) {
    if (auto error = SyncFolder(filled, disk)) return error;
  }
  return std::nullopt;
}

/// True for names as GenerationName makes them: somebody's own `gopro` beside them is none.
bool IsGenerationName(const std::string& name) {
  return name.size() >= 7 && name[0] == 'g' &&
         name.find_first_not_of("0123456789", 1) == std::string::npos;
}

void RemoveOtherGenerations(const fs::path& folder, const std::string& kept, FileSystem& disk) {
  std::error_code ignored;  // a leftover costs space only
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && IsGenerationName(name) && name != kept) {
      RemoveFolder(entry.path(), disk);
    }
  }
}

/// Greatest number of the generations in `folder`, complete or not; 0 if there is none.
int GreatestGeneration(const fs::path& folder) {
  int greatest = 0;
  std::error_code absent;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, absent)) {
    const std::string name = entry.path().filename().string();
    const auto number = name.starts_with("g") ? ParseInteger(name.substr(1)) : std::nullopt;
    if (number && *number > 0 && *number < kMostGenerations) {
      greatest = std::max(greatest, static_cast<int>(*number));
    }
  }
  return greatest;
}

struct Manifest {
  SessionFacts facts;
  int generation = 0;
  ListedFiles files;
};

Expected<json> ReadManifestBody(const fs::path& file) {
  const Expected<std::string> text = ReadWhole(file);
  if (!text) {
    return Damaged(file, "missing: no complete session here");
  }
  const json manifest = json::parse(*text, nullptr, false);
  if (!manifest.is_object() || !manifest.contains("body") ||
      SealedText(manifest.at("body")) != *text) {
    return Damaged(file, "damaged: its checksum does not match");
  }
  const json& body = manifest.at("body");
  if (body.value("format", "") != kFormat || body.value("version", 0) != kVersion) {
    return Damaged(file, fmt::format("is no session of format version {}", kVersion));
  }
  return body;
}

Expected<Manifest> ReadManifest(const fs::path& file) {
  const Expected<json> body = ReadManifestBody(file);
  if (!body) {
    return body.error();
  }
  try {
    Manifest manifest{.facts = body->at("facts").get<SessionFacts>(),
                      .generation = body->at("generation").get<int>(),
                      .files = {}};
    for (const json& entry : body->at("files")) {
      const std::string name = entry.at("name");
      if (fs::path(name).is_absolute() || name.find("..") != std::string::npos) {
        return Damaged(file, "lists a file outside the session: " + name);
      }
      manifest.files[name] = {.size = entry.at("size").get<std::uint64_t>(),
                              .checksum = entry.at("xxh3_64").get<std::string>()};
    }
    return manifest;
  } catch (const json::exception& problem) {
    return Damaged(file, std::string("lacks an entry: ") + problem.what());
  }
}

}  // namespace

Expected<const SessionWriter::Generation*> SessionWriter::Last() {
  if (!last_) {  // this writer's first
    Expected<Manifest> manifest = ReadManifest(folder_ / kManifest);
    if (!manifest) return manifest.error();
    last_ = Generation{.number = manifest->generation, .files = std::move(manifest->files)};
  }
  return &*last_;
}

Expected<std::string> SessionWriter::ReadLast(const std::string& name) {
  const Expected<const Generation*> last = Last();
  if (!last) return last.error();
  const fs::path file = folder_ / GenerationName((*last)->number) / name;
  Expected<std::string> bytes = ReadWhole(file);
  const auto listed = (*last)->files.find(name);
  if (!bytes || listed == (*last)->files.end()) return Damaged(file, "missing");
  if (ChecksumOf(*bytes) != listed->second.checksum) {
    return Damaged(file, "damaged: its checksum does not match");
  }
  return bytes;
}

Expected<ListedFiles> SessionWriter::Kept(const SessionFiles& files,
                                          const std::set<std::string>& unchanged) {
  ListedFiles kept;
  for (const std::string& name : unchanged) {
    if (files.contains(name)) continue;
    const Expected<const Generation*> last = Last();
    if (!last) return Error{name + " cannot be kept: " + last.error().text};
    const auto found = (*last)->files.find(name);
    if (found == (*last)->files.end()) {
      return Error{fmt::format("{} cannot be kept: {} has no such file", name,
                               (folder_ / GenerationName(last_->number)).string())};
    }
    kept.insert(*found);
  }
  return kept;
}

Expected<int> SessionWriter::Commit(SessionFacts facts, const SessionFiles& files,
                                    const std::set<std::string>& unchanged) {
  facts.limpet = LIMPET_VERSION;
  Expected<ListedFiles> listed = Kept(files, unchanged);
  if (!listed) {
    return listed.error();
  }
  const int last = last_ ? last_->number : 0;
  // Never into the folder of a generation that is there: the manifest may name it.
  const int generation = std::max(last, GreatestGeneration(folder_)) + 1;
  const std::string name = GenerationName(generation);
  const FormerFiles former{.folder = folder_ / GenerationName(last), .kept = *listed};
  if (std::optional<Error> error = WriteGeneration(folder_ / name, files, former, disk_)) {
    RemoveFolder(folder_ / name, disk_);  // half of it would only fill the disk
    return *error;
  }
  for (const auto& [file, bytes] : files) {
    (*listed)[file] = {.size = bytes.size(), .checksum = ChecksumOf(bytes)};
  }
  const std::string manifest = SealedText(BodyOf(facts, generation, *listed));
  if (std::optional<Error> error = WriteDurably(folder_ / kManifest, manifest, disk_)) {
    return *error;
  }
  last_ = Generation{.number = generation, .files = *std::move(listed)};
  RemoveOtherGenerations(folder_, name, disk_);
  return generation;
}

Expected<fs::path> SetSessionAside(const fs::path& folder, FileSystem& disk) {
  for (int number = 1; number < kMostAside; ++number) {
    const fs::path aside = fs::path(fmt::format("{}-former-{}", folder.string(), number));
    if (fs::exists(aside)) {
      continue;
    }
    if (const std::error_code failure = disk.Rename(folder, aside)) {
      return Error{fmt::format("{} cannot be set aside: {}", folder.string(), failure.message())};
    }
    if (std::optional<Error> error = SyncFolder(folder.parent_path(), disk)) {
      return *error;
    }
    return aside;
  }
  return Error{folder.string() + " cannot be set aside: too many former ones"};
}

Expected<StoredSession> LoadSession(const fs::path& folder) {
  const bool is_inside = !fs::exists(folder / kManifest) && fs::is_directory(folder / "session");
  const fs::path home = is_inside ? folder / "session" : folder;
  Expected<Manifest> manifest = ReadManifest(home / kManifest);
  if (!manifest) {
    return manifest.error();
  }
  StoredSession session{
      .facts = std::move(manifest->facts), .generation = manifest->generation, .files = {}};
  const fs::path files = home / GenerationName(session.generation);
  for (const auto& [name, listed] : manifest->files) {
    Expected<std::string> bytes = ReadListed(files / name, listed);
    if (!bytes) {
      return bytes.error();
    }
    session.files[name] = *std::move(bytes);
  }
  return session;
}

}  // namespace limpet
