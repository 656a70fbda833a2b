// SPDX-License-Identifier: MIT
#include "tests/support/torn_disk.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <mutex>
#include <optional>
#include <utility>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr int kNothing = -1;

/// One call, as it was done.
struct Call {
  enum class Kind { kWrite, kTruncate, kSync, kNames, kSyncFolder };
  /// An entry of a folder that is another one from now on.
  struct Entry {
    int folder = 0;
    std::string name;
    int node = kNothing;  ///< kNothing: it is gone
  };
  Kind kind = Kind::kSync;
  int node = 0;          ///< that it is about
  std::uint64_t at = 0;  ///< offset, or size to truncate to
  std::string bytes{};   ///< written
  std::vector<Entry> entries{};
};

/// A file or folder as the disk has it.
struct Node {
  bool is_folder = false;
  std::string content;
  std::map<std::string, int> entries;
};

void Apply(const Call& call, Node& node) {
  if (call.kind == Call::Kind::kTruncate) {
    node.content.resize(call.at, '\0');
    return;
  }
  node.content.resize(std::max<std::size_t>(node.content.size(), call.at + call.bytes.size()),
                      '\0');
  node.content.replace(call.at, call.bytes.size(), call.bytes);
}

void Apply(const Call::Entry& entry, std::vector<Node>& nodes) {
  auto& entries = nodes[static_cast<std::size_t>(entry.folder)].entries;
  if (entry.node == kNothing) {
    entries.erase(entry.name);
  } else {
    entries[entry.name] = entry.node;
  }
}

/// What of a write reaches the disk: all, nothing, or a piece of it that begins and ends anywhere.
void ApplyInPart(const Call& call, Random& random, Node& node) {
  const std::size_t chance = random.Index(4);
  if (chance == 0) {
    return;
  }
  if (chance == 1 || call.kind == Call::Kind::kTruncate || call.bytes.empty()) {
    Apply(call, node);
    return;
  }
  const std::size_t begin = chance == 2 ? 0 : random.Index(call.bytes.size());
  const std::size_t end = begin + random.Index(call.bytes.size() - begin + 1);
  Call piece = call;
  piece.at += begin;
  piece.bytes = call.bytes.substr(begin, end - begin);
  Apply(piece, node);
}

void Leave(const std::vector<Node>& nodes, int folder, const fs::path& where) {
  fs::create_directories(where);
  for (const auto& [name, index] : nodes[static_cast<std::size_t>(folder)].entries) {
    const Node& node = nodes[static_cast<std::size_t>(index)];
    if (node.is_folder) {
      Leave(nodes, index, where / name);
    } else {
      std::ofstream(where / name, std::ios::binary) << node.content;
    }
  }
}

}  // namespace

/// What was there at the start, every call since, and the tree as it is now.
class TornDisk::Account {
 public:
  explicit Account(const fs::path& root) {
    nodes.push_back({.is_folder = true, .content = {}, .entries = {}});
    Take(root, 0);
    at_start = nodes;
  }
  /// kNothing if there is none of that path below the root.
  [[nodiscard]] int Find(const fs::path& relative) const {
    int node = 0;
    for (const fs::path& part : relative) {
      if (part.empty() || part == ".") continue;
      const auto& entries = nodes[static_cast<std::size_t>(node)].entries;
      const auto found = entries.find(part.string());
      if (found == entries.end()) return kNothing;
      node = found->second;
    }
    return node;
  }
  int Add(bool is_folder) {
    nodes.push_back({.is_folder = is_folder, .content = {}, .entries = {}});
    return static_cast<int>(nodes.size()) - 1;
  }
  void Note(Call call) {
    for (const Call::Entry& entry : call.entries) {
      Apply(entry, nodes);
    }
    calls.push_back(std::move(call));
  }

  std::mutex mutex;
  std::vector<Node> at_start, nodes;  ///< of the live ones the names alone are kept
  std::vector<Call> calls;

 private:
  void Take(const fs::path& folder, int node) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      const int child = Add(entry.is_directory());
      nodes[static_cast<std::size_t>(node)].entries[entry.path().filename().string()] = child;
      if (entry.is_directory()) {
        Take(entry.path(), child);
      } else {
        std::ifstream in(entry.path(), std::ios::binary);
        nodes[static_cast<std::size_t>(child)].content.assign(std::istreambuf_iterator<char>(in),
                                                              {});
      }
    }
  }
};

class TornFile final : public WritableFile {
 public:
  TornFile(std::unique_ptr<WritableFile> file, TornDisk::Account& account, int node)
      : file_(std::move(file)), account_(account), node_(node) {}

  [[nodiscard]] std::error_code WriteAt(std::uint64_t offset, std::string_view bytes) override {
    Note({.kind = Call::Kind::kWrite, .node = node_, .at = offset, .bytes = std::string(bytes)});
    return file_->WriteAt(offset, bytes);
  }
  [[nodiscard]] std::error_code Truncate(std::uint64_t size) override {
    Note({.kind = Call::Kind::kTruncate, .node = node_, .at = size});
    return file_->Truncate(size);
  }
  [[nodiscard]] std::error_code Sync() override {
    Note({.kind = Call::Kind::kSync, .node = node_});
    return {};
  }
  [[nodiscard]] std::uint64_t size() const override { return file_->size(); }

 private:
  void Note(Call call) {
    const std::lock_guard lock(account_.mutex);
    account_.Note(std::move(call));
  }

  std::unique_ptr<WritableFile> file_;
  TornDisk::Account& account_;
  int node_;
};

TornDisk::TornDisk(fs::path root)
    : account_(std::make_unique<Account>(root)), root_(std::move(root)) {}
TornDisk::~TornDisk() = default;

FileSystem::Opened TornDisk::Open(const fs::path& path, Opening how) {
  Opened opened = RealFileSystem().Open(path, how);
  if (opened.file == nullptr) {
    return opened;
  }
  const std::lock_guard lock(account_->mutex);
  const fs::path relative = path.lexically_relative(root_);
  int node = account_->Find(relative);
  if (node == kNothing) {
    node = account_->Add(false);
    account_->Note({.kind = Call::Kind::kNames,
                    .entries = {{.folder = account_->Find(relative.parent_path()),
                                 .name = relative.filename().string(),
                                 .node = node}}});
  } else if (how == Opening::kEmpty) {
    account_->Note({.kind = Call::Kind::kTruncate, .node = node, .at = 0});
  }
  opened.file = std::make_unique<TornFile>(std::move(opened.file), *account_, node);
  return opened;
}

std::error_code TornDisk::Rename(const fs::path& from, const fs::path& to) {
  const std::lock_guard lock(account_->mutex);
  const std::error_code trouble = RealFileSystem().Rename(from, to);
  if (!trouble) {
    const fs::path old_name = from.lexically_relative(root_), name = to.lexically_relative(root_);
    account_->Note({.kind = Call::Kind::kNames,
                    .entries = {{.folder = account_->Find(old_name.parent_path()),
                                 .name = old_name.filename().string(),
                                 .node = kNothing},
                                {.folder = account_->Find(name.parent_path()),
                                 .name = name.filename().string(),
                                 .node = account_->Find(old_name)}}});
  }
  return trouble;
}

std::error_code TornDisk::Link(const fs::path& existing, const fs::path& name) {
  const std::lock_guard lock(account_->mutex);
  const std::error_code trouble = RealFileSystem().Link(existing, name);
  if (!trouble) {
    const fs::path relative = name.lexically_relative(root_);
    account_->Note({.kind = Call::Kind::kNames,
                    .entries = {{.folder = account_->Find(relative.parent_path()),
                                 .name = relative.filename().string(),
                                 .node = account_->Find(existing.lexically_relative(root_))}}});
  }
  return trouble;
}

std::error_code TornDisk::Remove(const fs::path& path) {
  const std::lock_guard lock(account_->mutex);
  const fs::path relative = path.lexically_relative(root_);
  const bool is_there = account_->Find(relative) != kNothing;
  const std::error_code trouble = RealFileSystem().Remove(path);
  if (!trouble && is_there) {
    account_->Note({.kind = Call::Kind::kNames,
                    .entries = {{.folder = account_->Find(relative.parent_path()),
                                 .name = relative.filename().string(),
                                 .node = kNothing}}});
  }
  return trouble;
}

std::error_code TornDisk::CreateFolder(const fs::path& path) {
  const std::lock_guard lock(account_->mutex);
  const std::error_code trouble = RealFileSystem().CreateFolder(path);
  if (!trouble) {
    const fs::path relative = path.lexically_relative(root_);
    account_->Note({.kind = Call::Kind::kNames,
                    .entries = {{.folder = account_->Find(relative.parent_path()),
                                 .name = relative.filename().string(),
                                 .node = account_->Add(true)}}});
  }
  return trouble;
}

std::error_code TornDisk::SyncFolder(const fs::path& path) {
  const std::lock_guard lock(account_->mutex);
  const int node = account_->Find(path.lexically_relative(root_));
  if (node == kNothing) {
    return std::make_error_code(std::errc::no_such_file_or_directory);
  }
  account_->Note({.kind = Call::Kind::kSyncFolder, .node = node});
  return {};
}

std::optional<std::uint64_t> TornDisk::Room(const fs::path& path) const {
  return RealFileSystem().Room(path);
}

std::size_t TornDisk::calls() const {
  const std::lock_guard lock(account_->mutex);
  return account_->calls.size();
}

namespace {

/// The disk after the first calls: what is surely on it, and what may be.
class Aftermath {
 public:
  explicit Aftermath(std::vector<Node> nodes) : nodes_(std::move(nodes)) {}
  void Add(const Call& call);
  /// Decides about everything that was not synced.
  void Decide(Random& random);
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

 private:
  /// Does what `is_wanted` says yes to, in order, and forgets it.
  template <class Predicate>
  void Settle(Predicate is_wanted) {
    std::erase_if(pending_, [&](const Call* call) {
      if (!is_wanted(*call)) return false;
      for (const Call::Entry& entry : call->entries) {
        Apply(entry, nodes_);
      }
      if (call->kind != Call::Kind::kNames) {
        Apply(*call, nodes_[static_cast<std::size_t>(call->node)]);
      }
      return true;
    });
  }

  std::vector<Node> nodes_;
  std::vector<const Call*> pending_;
};

void Aftermath::Add(const Call& call) {
  switch (call.kind) {
    case Call::Kind::kSync:
      Settle([&](const Call& past) {
        return past.kind != Call::Kind::kNames && past.node == call.node;
      });
      break;
    case Call::Kind::kSyncFolder:
      Settle([&](const Call& past) {
        return std::ranges::any_of(
            past.entries, [&](const Call::Entry& entry) { return entry.folder == call.node; });
      });
      break;
    default:
      pending_.push_back(&call);
  }
}

void Aftermath::Decide(Random& random) {
  std::vector<const Call*> writes;
  for (const Call* call : pending_) {
    if (call->kind != Call::Kind::kNames) {
      writes.push_back(call);
    } else if (random.Index(2) == 0) {
      for (const Call::Entry& entry : call->entries) {
        Apply(entry, nodes_);
      }
    }
  }
  for (std::size_t left = writes.size(); left > 0; --left) {  // in any order
    std::swap(writes[random.Index(left)], writes[left - 1]);
    const Call& call = *writes[left - 1];
    ApplyInPart(call, random, nodes_[static_cast<std::size_t>(call.node)]);
  }
}

}  // namespace

void TornDisk::Cut(std::size_t calls, Random& random, const fs::path& folder) const {
  const std::lock_guard lock(account_->mutex);
  LIMPET_REQUIRE(calls <= account_->calls.size(), "a cut is after calls that were made");
  std::vector<Node> nodes = account_->nodes;
  for (std::size_t i = account_->at_start.size(); i < nodes.size(); ++i) {
    nodes[i].entries.clear();
  }
  std::copy(account_->at_start.begin(), account_->at_start.end(), nodes.begin());
  Aftermath aftermath(std::move(nodes));
  for (std::size_t i = 0; i < calls; ++i) {
    aftermath.Add(account_->calls[i]);
  }
  aftermath.Decide(random);
  fs::remove_all(folder);
  Leave(aftermath.nodes(), 0, folder);
}

}  // namespace limpet
