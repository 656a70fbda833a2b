// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_writer.hpp"

namespace limpet {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{256} << 10U;

}  // namespace

Expected<AlogWriter> AlogWriter::Open(const std::filesystem::path& file, Seconds start,
                                      const AlogOptions& options, std::shared_ptr<BlogWriter> blog,
                                      FileSystem& disk) {
  Expected<AppendFile> created = AppendFile::Create(file, disk);
  if (!created) {
    return created.error();
  }
  if (!blog) {
    blog = std::make_shared<BlogWriter>(std::filesystem::path(file).replace_extension(".blog"),
                                        false, disk);
  }
  AlogWriter writer(*std::move(created), std::move(blog), AlogFormat(start, options));
  writer.format_.AppendBanner(writer.lines_.text(), file.filename().string());
  return writer;
}

Expected<AlogWriter> AlogWriter::Continue(const std::filesystem::path& file, Seconds start,
                                          const AlogOptions& options,
                                          std::shared_ptr<BlogWriter> blog, FileSystem& disk) {
  Expected<AppendFile> former = AppendFile::ContinueLines(file, disk);
  if (!former) {
    return former.error();
  }
  if (former->size() == 0) {
    return Open(file, start, options, std::move(blog), disk);
  }
  if (!blog) {
    blog = std::make_shared<BlogWriter>(std::filesystem::path(file).replace_extension(".blog"),
                                        true, disk);
  }
  AlogWriter writer(*std::move(former), std::move(blog), AlogFormat(start, options));
  writer.WriteComment("the logger was started again");
  return writer;
}

AlogWriter::~AlogWriter() { Flush(); }

void AlogWriter::Write(const Message& message) {
  std::optional<std::string> marker;
  if (const auto* bytes = std::get_if<Binary>(&message.value)) {
    marker = blog_->Write(*bytes);
    if (!marker) {
      lines_.NoteDropped();
      return;
    }
    ++unsynced_binaries_;
  }
  format_.AppendLine(lines_.text(), message, marker.value_or(""));
  lines_.NoteEntry();
  if (lines_.text().size() > kBufferBytes) {
    lines_.Flush();
  }
}

void AlogWriter::WriteComment(std::string_view text) {
  lines_.text() += "%% ";
  lines_.text() += text;
  lines_.text() += '\n';
}

bool AlogWriter::Flush() { return !blog_ || (lines_.Flush() && !blog_->trouble()); }

bool AlogWriter::Sync() {
  // Not `&&`: the lines go to the disk even if the bytes do not.
  const bool has_bytes = blog_->Sync();
  binaries_in_doubt_ += has_bytes ? 0 : unsynced_binaries_;
  unsynced_binaries_ = 0;
  const bool has_lines = lines_.Sync();
  return has_bytes && has_lines;
}

std::error_code AlogWriter::trouble() const {
  return lines_.trouble() ? lines_.trouble() : blog_->trouble();
}

LogLosses AlogWriter::losses() const {
  LogLosses losses = lines_.losses();
  losses.in_doubt += binaries_in_doubt_;
  return losses;
}

}  // namespace limpet
