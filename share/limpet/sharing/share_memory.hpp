// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"

namespace limpet {

/// What one app must still know of one key after a restart: its own epoch, so that the next is
/// later whatever the clock says, and how far it has heard each sender, so that nobody can repeat
/// that.
struct ShareMemory {
  struct Heard {
    std::uint64_t epoch = 0, counter = 0;
    bool operator==(const Heard&) const = default;
  };
  std::uint64_t own_epoch = 0;
  std::map<std::uint64_t, Heard> heard;  ///< by sender

  bool operator==(const ShareMemory&) const = default;

  /// Lines `own <epoch>` and `<sender> <epoch> <counter>`, in hexadecimal. What does not read so is
  /// left out: less memory is better than no sharing.
  [[nodiscard]] static ShareMemory Parse(std::string_view text);
  [[nodiscard]] std::string Text() const;

  /// Empty if there is no such file.
  [[nodiscard]] static ShareMemory Load(const std::filesystem::path& file);
  /// Replaces the file as a whole.
  [[nodiscard]] std::optional<Error> Save(const std::filesystem::path& file) const;
};

}  // namespace limpet
