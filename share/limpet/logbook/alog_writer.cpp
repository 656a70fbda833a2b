// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_writer.hpp"

namespace limpet {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{256} << 10U;
constexpr std::size_t kMostBytesKept = std::size_t{4} << 20U;

}  // namespace

Expected<AlogWriter> AlogWriter::Open(const std::filesystem::path& file, Seconds start,
                                      const AlogOptions& options,
                                      std::shared_ptr<BlogWriter> blog) {
  Expected<AppendFile> created = AppendFile::Create(file);
  if (!created) {
    return created.error();
  }
  if (!blog) {
    blog = std::make_shared<BlogWriter>(std::filesystem::path(file).replace_extension(".blog"));
  }
  AlogWriter writer(*std::move(created), std::move(blog), AlogFormat(start, options));
  writer.format_.AppendBanner(writer.buffer_, file.filename().string());
  return writer;
}

Expected<AlogWriter> AlogWriter::Continue(const std::filesystem::path& file, Seconds start,
                                          const AlogOptions& options,
                                          std::shared_ptr<BlogWriter> blog) {
  Expected<AppendFile> former = AppendFile::ContinueLines(file);
  if (!former) {
    return former.error();
  }
  if (former->size() == 0) {
    return Open(file, start, options, std::move(blog));
  }
  if (!blog) {
    blog =
        std::make_shared<BlogWriter>(std::filesystem::path(file).replace_extension(".blog"), true);
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
      is_good_ = false;
      return;
    }
  }
  format_.AppendLine(buffer_, message, marker.value_or(""));
  if (buffer_.size() > kBufferBytes) {
    HandOver();
  }
}

void AlogWriter::WriteComment(std::string_view text) {
  buffer_ += "%% ";
  buffer_ += text;
  buffer_ += '\n';
}

void AlogWriter::HandOver() {
  if (file_.Append(buffer_)) {
    buffer_.clear();
    return;
  }
  is_good_ = false;
  if (buffer_.size() > kMostBytesKept) {
    buffer_.clear();
  }
}

bool AlogWriter::Flush() {
  if (blog_) {
    HandOver();
  }
  return is_good_;
}

bool AlogWriter::Sync() {
  // Not `&&`: the lines go to the disk even if the bytes do not.
  const bool has_bytes = blog_->Sync();
  const bool has_lines = Flush() && file_.Sync();
  is_good_ = has_bytes && has_lines;
  return is_good_;
}

}  // namespace limpet
