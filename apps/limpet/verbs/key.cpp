// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/key.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "apps/limpet/cli.hpp"
#include "limpet/sharing/share_key.hpp"

namespace limpet {
namespace {

Command KeyForm() {
  return {.name = "limpet key",
          .words = "new|show <file>",
          .about = R"(new: makes a random key for pShare's sealed routes in a file that only you may
read; never writes over one (exit code 3). Copy it to each node over a channel you trust, e.g.
scp -p.

show: tells the key's fingerprint, which gives nothing away: two nodes understand each other if
theirs are equal. Fails (exit code 1) if pShare would refuse the file.)",
          .takes = "`new` or `show`, and a file; `limpet key --help` says more",
          .least_words = 2,
          .most_words = 2};
}

int MakeKey(const std::filesystem::path& file) {
  if (std::filesystem::exists(std::filesystem::symlink_status(file))) {
    fmt::print(stderr, "limpet: {} exists; a key is never written over\n", file.string());
    return kRefused;
  }
  if (file.has_parent_path()) {
    std::filesystem::create_directories(file.parent_path());
  }
  const ShareKey key = ShareKey::Random();
  if (const auto error = SaveShareKey(key, file)) {
    fmt::print(stderr, "limpet: {}\n", error->text);
    return kFailed;
  }
  fmt::print("{}: key {}\n", file.string(), key.Fingerprint());
  return kOk;
}

int ShowKey(const std::filesystem::path& file) {
  const auto key = LoadShareKey(file);
  if (!key) {
    fmt::print(stderr, "limpet: {}\n", key.error().text);
    return kFailed;
  }
  fmt::print("{}: key {}\n", file.string(), key->Fingerprint());
  return kOk;
}

int MakeOrShow(const Arguments& given) {
  const std::vector<std::string>& words = given.positionals();
  if (words[0] != "new" && words[0] != "show") {
    throw UsageError("key takes " + KeyForm().takes);
  }
  return words[0] == "new" ? MakeKey(words[1]) : ShowKey(words[1]);
}

}  // namespace

int RunKey(std::span<const std::string> args) { return RunCommand(KeyForm(), args, MakeOrShow); }

}  // namespace limpet
