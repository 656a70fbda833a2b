// SPDX-License-Identifier: MIT
// Keys of sealed routes: 256 random bits in a text file that its owner alone may read.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"

namespace limpet {

inline constexpr std::size_t kShareKeySize = 32;

/// Whoever has the key reads and speaks on every route sealed with it. Wiped when it dies.
class ShareKey {
 public:
  using Bytes = std::array<unsigned char, kShareKeySize>;

  explicit ShareKey(const Bytes& bytes) : bytes_(bytes) {}
  ShareKey(const ShareKey&) = default;
  ShareKey& operator=(const ShareKey&) = default;
  ShareKey(ShareKey&&) = default;  ///< copies: each wipes its own
  ShareKey& operator=(ShareKey&&) = default;
  ~ShareKey();

  [[nodiscard]] static ShareKey Random();
  /// The key in the text of a key file.
  [[nodiscard]] static Expected<ShareKey> Parse(std::string_view text);

  [[nodiscard]] const Bytes& bytes() const { return bytes_; }
  /// Text of a key file: a comment, and `limpet-key-1 <64 hexadecimal digits> <fingerprint>`.
  [[nodiscard]] std::string Text() const;
  /// Eight hexadecimal digits that tell keys apart and give nothing away.
  [[nodiscard]] std::string Fingerprint() const;

 private:
  Bytes bytes_;
};

/// Refused: what is no regular file of this user's, or may be read or written by others.
[[nodiscard]] Expected<ShareKey> LoadShareKey(const std::filesystem::path& file);

/// Writes a key file with mode 600. Never writes over one; why not, if it did not.
[[nodiscard]] std::optional<Error> SaveShareKey(const ShareKey& key,
                                                const std::filesystem::path& file);

}  // namespace limpet
