// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limpet/app/app.hpp"
#include "limpet/core/config.hpp"
#include "limpet/durable/failing_file_system.hpp"
#include "limpet/pubsub/database.hpp"

namespace limpet {

/// What an embedded community is made of.
struct EmbeddedSetup {
  std::string community;
  /// Process names in launch order; each must be registered, or ours must stand in for it.
  std::vector<std::string> apps;
  std::vector<ConfigBlock> blocks;  ///< ProcessConfig blocks; an app without one takes its defaults
  std::vector<ConfigEntry> globals;
  std::filesystem::path mission_folder;
  std::filesystem::path run_folder;
  std::filesystem::path prior_folder;
  std::string session;
  std::uint64_t seed = 1;
  Seconds start{1767225600.0};  ///< virtual time begins at 2026-01-01T00:00:00Z
  /// If set, mail for which it says no is not delivered to that app.
  std::function<bool(const std::string& app, const std::string& variable)> may_hear;
};

/// Hosts the database and all apps of a mission in one thread on virtual time. Mail is delivered at
/// the instant it is written, in launch order, until all is quiet; then the next tick is due. Same
/// setup, same bits.
class EmbeddedCommunity {
 public:
  /// Builds every app. Throws ConfigError with the problems of all of them.
  explicit EmbeddedCommunity(EmbeddedSetup setup);
  ~EmbeddedCommunity();
  EmbeddedCommunity(const EmbeddedCommunity&) = delete;
  EmbeddedCommunity& operator=(const EmbeddedCommunity&) = delete;

  /// Runs the next due tick and all mail it causes.
  void Step();
  /// Writes a variable as an operator would.
  void Poke(const std::string& name, Value value);
  /// From now on the app does nothing, as a process that hangs: no tick, no mail; or it goes on,
  /// with the mail that has waited. Ticks that it missed are left out. REQUIRES: the app is hosted.
  void Stall(const std::string& app, bool hangs = true);
  /// From now on nothing that is written reaches anybody, as when the database's process hangs; or
  /// it goes on: what was written meanwhile is delivered, in order, stamped when it was written.
  void StallDatabase(bool hangs = true);
  /// From now on the disk that apps write to fails like this, or works again.
  void FailDisk(FailingFileSystem::Fault fault);
  /// From now on that disk has so much room left [bytes], or enough again.
  void LimitDisk(std::optional<std::uint64_t> bytes);
  /// Calls `observer` for every write, in order.
  void Observe(std::function<void(const Message&)> observer);
  /// Ends every app in launch order; the last call.
  void Finish();

  [[nodiscard]] Seconds now() const;
  /// Virtual seconds since the start.
  [[nodiscard]] Seconds elapsed() const;
  [[nodiscard]] const Database& database() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limpet
