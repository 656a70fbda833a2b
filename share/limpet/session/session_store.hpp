// SPDX-License-Identifier: MIT
// A session on disk: numbered generations, of which the manifest names the last complete one.
//   session/manifest.json     names, sizes and checksums of all files; itself checksummed
//   session/g000012/...       the files
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "limpet/core/expected.hpp"
#include "limpet/durable/file_system.hpp"

namespace limpet {

/// File name (may contain one folder, `mission/x.moos`) to bytes; sorted, so equal content gives
/// equal files.
using SessionFiles = std::map<std::string, std::string>;

/// What the manifest says about the session as a whole.
struct SessionFacts {
  std::string limpet;   ///< version that wrote it; filled in by the writer
  std::string mission;  ///< name of the mission folder
  std::string session;  ///< discovery, change, ...
  std::string community;
  std::uint64_t seed = 0;
  std::string lat_origin, long_origin;  ///< datum, as the mission file has it
  double saved_at = 0.0;                ///< MOOS time [s]
  std::string cause;                    ///< why this generation was saved
};

struct StoredSession {
  SessionFacts facts;
  int generation = 0;
  SessionFiles files;
};

/// What the manifest says of each file, by its name.
struct ListedFile {
  std::uint64_t size = 0;
  std::string checksum;
};
using ListedFiles = std::map<std::string, ListedFile>;

/// Writes generations of one session, numbered on from those that are there. A crash at any moment
/// leaves the last complete one.
class SessionWriter {
 public:
  /// `folder` is created on the first commit.
  explicit SessionWriter(std::filesystem::path folder, FileSystem& disk = RealFileSystem())
      : folder_(std::move(folder)), disk_(disk) {}
  /// Writes one generation and then forgets the one before; its number, or why it failed. Files
  /// named `unchanged` are as in the generation before, which this writer committed or else the
  /// manifest names: they are not written again but linked, or copied where the disk has no links.
  /// One that is missing there, or has another size, is an error that names it, and nothing is
  /// written: the next commit has to bring that file.
  [[nodiscard]] Expected<int> Commit(SessionFacts facts, const SessionFiles& files,
                                     const std::set<std::string>& unchanged = {});
  /// A file of the last complete generation; the error says why it cannot be read.
  [[nodiscard]] Expected<std::string> ReadLast(const std::string& name);

 private:
  struct Generation {
    int number = 0;
    ListedFiles files;
  };
  /// The last complete generation; read from the manifest by a writer that has written none.
  [[nodiscard]] Expected<const Generation*> Last();
  /// What the last generation's manifest says of the `unchanged` that are not in `files`.
  [[nodiscard]] Expected<ListedFiles> Kept(const SessionFiles& files,
                                           const std::set<std::string>& unchanged);

  std::filesystem::path folder_;
  FileSystem& disk_;
  std::optional<Generation> last_;
};

/// Renames a session's folder to `<folder>-former-1`, or the next number that is free, so that
/// another can be saved there; what it is called now, or why that failed.
[[nodiscard]] Expected<std::filesystem::path> SetSessionAside(const std::filesystem::path& folder,
                                                              FileSystem& disk = RealFileSystem());

/// Loads the last complete generation. `folder` is a session folder or one that contains
/// `session/`. Any missing, damaged or altered file is an error that names it; nothing is loaded by
/// halves.
[[nodiscard]] Expected<StoredSession> LoadSession(const std::filesystem::path& folder);

}  // namespace limpet
