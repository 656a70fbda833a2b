// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "limpet/core/expected.hpp"
#include "limpet/durable/file_system.hpp"

struct gzFile_s;  // zlib's own name

namespace limpet {

/// Reads a file from front to back, unpacking it if it is gzip.
class SequentialFile {
 public:
  [[nodiscard]] static Expected<SequentialFile> Open(const std::filesystem::path& path);

  /// Up to `size` bytes; 0 at the end, also at that of a torn gzip file.
  [[nodiscard]] std::size_t Read(char* out, std::size_t size);
  /// True if reading ended for another reason than the end of the file.
  [[nodiscard]] bool has_failed() const { return has_failed_; }
  /// How far reading is in the file as it lies on the disk, bytes.
  [[nodiscard]] std::uint64_t position() const;

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
    void operator()(gzFile_s* file) const;
  };
  SequentialFile() = default;

  std::unique_ptr<std::FILE, Closer> plain_;
  std::unique_ptr<gzFile_s, Closer> packed_;
  std::uint64_t count_ = 0;
  bool has_failed_ = false;
};

/// Replaces `path` by `path`.gz; the original goes only once the copy is on the disk.
[[nodiscard]] bool CompressFile(const std::filesystem::path& path,
                                FileSystem& disk = RealFileSystem());

}  // namespace limpet
