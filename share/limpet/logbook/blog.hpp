// SPDX-License-Identifier: MIT
// Binary values of a log: their bytes lie in a .blog file, their place stands in the .alog file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"
#include "limpet/durable/append_file.hpp"

namespace limpet {

/// Collects bytes in one file, created by the first value, or continued.
class BlogWriter {
 public:
  explicit BlogWriter(std::filesystem::path path, bool continues = false,
                      FileSystem& disk = RealFileSystem())
      : path_(std::move(path)), continues_(continues), disk_(disk) {}

  /// Appends a value and returns its marker; nothing if it cannot be written.
  [[nodiscard]] std::optional<std::string> Write(const Binary& bytes);
  [[nodiscard]] bool Sync();
  /// Why the last call failed; nothing after one that did not.
  [[nodiscard]] std::error_code trouble() const { return file_ ? file_->trouble() : trouble_; }

 private:
  [[nodiscard]] bool Open();

  std::filesystem::path path_;
  bool continues_;
  FileSystem& disk_;
  std::optional<AppendFile> file_;
  std::error_code trouble_;  ///< of creating it
};

/// A binary value's place in the .blog file.
struct BlogSpan {
  std::string file;
  std::size_t offset = 0;
  std::size_t bytes = 0;
};
/// Parses `<MOOS_BINARY>File=f,Offset=n,Bytes=m</MOOS_BINARY>`; nothing if it is no such marker.
[[nodiscard]] std::optional<BlogSpan> ParseBlogMarker(std::string_view value);
/// Where the bytes of `span` must lie: only its file name counts, so that a log in `folder` cannot
/// lead elsewhere.
[[nodiscard]] std::filesystem::path BlogPath(const std::filesystem::path& folder,
                                             const BlogSpan& span);
/// Reads a binary value from the .blog file in `folder`.
[[nodiscard]] Expected<Binary> ReadBlog(const std::filesystem::path& folder, const BlogSpan& span);

}  // namespace limpet
