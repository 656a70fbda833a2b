// SPDX-License-Identifier: MIT
#include "limpet/logbook/blog.hpp"

#include <fstream>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {

bool BlogWriter::Open() {
  Expected<AppendFile> file =
      continues_ ? AppendFile::Continue(path_, disk_) : AppendFile::Create(path_, disk_);
  if (file) {
    file_ = *std::move(file);
    trouble_.clear();
  } else {
    trouble_ = std::make_error_code(std::errc::io_error);
  }
  return file_.has_value();
}

bool BlogWriter::Sync() {
  // A former life's bytes may have been with the system alone.
  const bool has_former = continues_ && !file_ && std::filesystem::exists(path_);
  if (has_former && !Open()) {
    return false;
  }
  return !file_ || file_->Sync();
}

std::optional<std::string> BlogWriter::Write(const Binary& bytes) {
  if (!file_ && !Open()) {
    return std::nullopt;
  }
  const std::uint64_t offset = file_->size();
  if (!file_->Append({reinterpret_cast<const char*>(bytes.data()), bytes.size()})) {
    return std::nullopt;
  }
  return fmt::format("<MOOS_BINARY>File={},Offset={},Bytes={}</MOOS_BINARY>",
                     path_.filename().string(), offset, bytes.size());
}

std::filesystem::path BlogPath(const std::filesystem::path& folder, const BlogSpan& span) {
  return folder / std::filesystem::path(span.file).filename();
}

std::optional<BlogSpan> ParseBlogMarker(std::string_view value) {
  constexpr std::string_view kOpen = "<MOOS_BINARY>";
  constexpr std::string_view kClose = "</MOOS_BINARY>";
  value = Trim(value);
  if (!value.starts_with(kOpen) || !value.ends_with(kClose) ||
      value.size() < kOpen.size() + kClose.size()) {
    return std::nullopt;
  }
  BlogSpan span;
  for (const std::string& part :
       Split(value.substr(kOpen.size(), value.size() - kOpen.size() - kClose.size()), ',')) {
    const std::size_t equals = part.find('=');
    const std::string_view key = std::string_view(part).substr(0, equals);
    const std::string_view text =
        std::string_view(part).substr(equals == std::string::npos ? part.size() : equals + 1);
    const std::optional<std::int64_t> number = ParseInteger(text);
    const bool is_count = number && *number >= 0;
    if (key == "File" && !text.empty()) {
      span.file = std::string(text);
    } else if (key == "Offset" && is_count) {
      span.offset = static_cast<std::size_t>(*number);
    } else if (key == "Bytes" && is_count) {
      span.bytes = static_cast<std::size_t>(*number);
    } else {
      return std::nullopt;
    }
  }
  return span.file.empty() ? std::nullopt : std::optional<BlogSpan>(span);
}

Expected<Binary> ReadBlog(const std::filesystem::path& folder, const BlogSpan& span) {
  const std::filesystem::path path = BlogPath(folder, span);
  std::error_code failure;
  const auto size = std::filesystem::file_size(path, failure);
  if (failure || span.offset > size || span.bytes > size - span.offset) {
    return Error{
        fmt::format("`{}` does not hold {} bytes at {}", path.string(), span.bytes, span.offset)};
  }
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(span.offset));
  Binary bytes(span.bytes);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(span.bytes));
  return in ? Expected<Binary>(std::move(bytes))
            : Expected<Binary>(Error{fmt::format("`{}` cannot be read", path.string())});
}

}  // namespace limpet
