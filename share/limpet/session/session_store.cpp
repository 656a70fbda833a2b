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

json BodyOf(const SessionFacts& facts, int generation, const SessionFiles& files) {
  json listed = json::array();
  for (const auto& [name, bytes] : files) {
    listed.push_back({{"name", name}, {"size", bytes.size()}, {"xxh3_64", ChecksumOf(bytes)}});
  }
  return {{"format", kFormat},
          {"version", kVersion},
          {"generation", generation},
          {"facts", facts},
          {"files", listed}};
}

std::optional<Error> WriteGeneration(const fs::path& folder, const SessionFiles& files,
                                     FileSystem& disk) {
  if (fs::exists(folder)) RemoveFolder(folder, disk);  // what an interrupted save left
  if (auto error = CreateFolders(folder, disk)) return error;
  std::set<fs::path> folders{folder};
  for (const auto& [name, bytes] : files) {
    const fs::path file = folder / name;
    if (folders.insert(file.parent_path()).second) {
      if (auto error = CreateFolders(file.parent_path(), disk)) return error;
    }
    if (auto error = WriteContent(file, bytes, disk)) return error;
  }
  // Names and content are on the disk before the manifest tells of them.
  for (const fs::path& filled : folders) {
    if (auto error = SyncFolder(filled, disk)) return error;
  }
  return std::nullopt;
}

/// As GenerationName makes them: somebody's own `gopro` beside them is none.
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

/// Of the generations in `folder`, complete or not; 0 if there is none.
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

Error Damaged(const fs::path& file, const std::string& why) {
  return Error{file.string() + ": " + why};
}

Expected<json> ReadManifest(const fs::path& file) {
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

std::optional<Error> ReadListed(const json& listed, const fs::path& folder,
                                StoredSession& session) {
  for (const json& entry : listed) {
    const std::string name = entry.at("name");
    if (fs::path(name).is_absolute() || name.find("..") != std::string::npos) {
      return Damaged(folder, "lists a file outside the session: " + name);
    }
    Expected<std::string> bytes = ReadWhole(folder / name);
    if (!bytes) {
      return Damaged(folder / name, "missing");
    }
    if (bytes->size() != entry.at("size").get<std::size_t>()) {
      return Damaged(folder / name, fmt::format("damaged: {} bytes instead of {}", bytes->size(),
                                                entry.at("size").get<std::size_t>()));
    }
    if (ChecksumOf(*bytes) != entry.at("xxh3_64").get<std::string>()) {
      return Damaged(folder / name, "damaged: its checksum does not match");
    }
    session.files[name] = *std::move(bytes);
  }
  return std::nullopt;
}

}  // namespace

Expected<int> SessionWriter::Commit(SessionFacts facts, const SessionFiles& files) {
  facts.limpet = LIMPET_VERSION;
  // Never into the folder of a generation that is there: the manifest may name it.
  const int generation = std::max(generation_, GreatestGeneration(folder_)) + 1;
  const std::string name = GenerationName(generation);
  if (std::optional<Error> error = WriteGeneration(folder_ / name, files, disk_)) {
    RemoveFolder(folder_ / name, disk_);  // half of it would only fill the disk
    return *error;
  }
  const std::string manifest = SealedText(BodyOf(facts, generation, files));
  if (std::optional<Error> error = WriteDurably(folder_ / kManifest, manifest, disk_)) {
    return *error;
  }
  generation_ = generation;
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
  const Expected<json> body = ReadManifest(home / kManifest);
  if (!body) {
    return body.error();
  }
  try {
    StoredSession session;
    session.facts = body->at("facts").get<SessionFacts>();
    session.generation = body->at("generation").get<int>();
    const fs::path files = home / GenerationName(session.generation);
    if (std::optional<Error> error = ReadListed(body->at("files"), files, session)) {
      return *error;
    }
    return session;
  } catch (const json::exception& problem) {
    return Damaged(home / kManifest, std::string("lacks an entry: ") + problem.what());
  }
}

}  // namespace limpet
