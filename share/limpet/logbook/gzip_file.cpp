// SPDX-License-Identifier: MIT
#include "limpet/logbook/gzip_file.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include "limpet/logbook/append_file.hpp"

namespace limpet {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 18U;

/// REQUIRES: freshly opened. Leaves the file at its beginning; a pipe is never gzip to us.
bool IsGzip(std::FILE* file) {
  if (std::fseek(file, 0, SEEK_END) != 0 || std::fseek(file, 0, SEEK_SET) != 0) {
    return false;
  }
  std::array<unsigned char, 2> magic{};
  const bool is_gzip =
      std::fread(magic.data(), 1, 2, file) == 2 && magic[0] == 0x1f && magic[1] == 0x8b;
  std::rewind(file);
  return is_gzip;
}

bool PackInto(const std::filesystem::path& packed, SequentialFile& source) {
  gzFile out = ::gzopen(packed.c_str(), "wb6");
  if (out == nullptr) {
    return false;
  }
  std::vector<char> chunk(kChunkBytes);
  bool is_good = true;
  for (std::size_t count = 0; is_good && (count = source.Read(chunk.data(), chunk.size())) > 0;) {
    is_good = ::gzwrite(out, chunk.data(), static_cast<unsigned>(count)) > 0;
  }
  return ::gzclose(out) == Z_OK && is_good && !source.has_failed();
}

bool SyncFile(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_good = descriptor >= 0 && ::fsync(descriptor) == 0;
  if (descriptor >= 0) {
    ::close(descriptor);
  }
  return is_good;
}

}  // namespace

void SequentialFile::Closer::operator()(gzFile_s* file) const { ::gzclose(file); }

Expected<SequentialFile> SequentialFile::Open(const std::filesystem::path& path) {
  SequentialFile file;
  std::error_code ignored;
  file.plain_.reset(std::fopen(path.c_str(), "rbe"));
  if (!file.plain_ || std::filesystem::is_directory(path, ignored)) {
    return Error{fmt::format("`{}` cannot be read", path.string())};
  }
  if (IsGzip(file.plain_.get())) {
    file.packed_.reset(::gzopen(path.c_str(), "rb"));
    file.plain_.reset();
    if (!file.packed_) {
      return Error{fmt::format("`{}` cannot be read", path.string())};
    }
    ::gzbuffer(file.packed_.get(), static_cast<unsigned>(kChunkBytes));
  }
  return file;
}

std::size_t SequentialFile::Read(char* out, std::size_t size) {
  if (plain_) {
    const std::size_t count = std::fread(out, 1, size, plain_.get());
    has_failed_ = std::ferror(plain_.get()) != 0;
    count_ += count;
    return count;
  }
  // In small bites: what lies before a tear still comes out.
  const int count =
      ::gzread(packed_.get(), out, static_cast<unsigned>(std::min(size, std::size_t{1} << 16U)));
  int code = Z_OK;
  ::gzerror(packed_.get(), &code);
  has_failed_ = has_failed_ || (count < 0 && code != Z_BUF_ERROR);
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

std::uint64_t SequentialFile::position() const {
  return packed_ ? static_cast<std::uint64_t>(std::max<z_off_t>(::gzoffset(packed_.get()), 0))
                 : count_;
}

bool CompressFile(const std::filesystem::path& path) {
  Expected<SequentialFile> source = SequentialFile::Open(path);
  if (!source) {
    return false;
  }
  SequentialFile file = *std::move(source);
  std::filesystem::path part = path;
  part += ".gz.part";
  std::filesystem::path packed = path;
  packed += ".gz";
  std::error_code failure;
  if (!PackInto(part, file) || !SyncFile(part)) {
    std::filesystem::remove(part, failure);
    return false;
  }
  std::filesystem::rename(part, packed, failure);
  if (!failure) {
    SyncFileNames(path.parent_path());
    std::filesystem::remove(path, failure);
  }
  return !failure;
}

}  // namespace limpet
