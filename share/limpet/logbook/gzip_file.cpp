// SPDX-License-Identifier: MIT
#include "limpet/logbook/gzip_file.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

#include "limpet/durable/append_file.hpp"

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

/// The packer of zlib, as gzip.
class GzipStream {
 public:
  explicit GzipStream(AppendFile& out) : out_(out) {
    constexpr int kLevel = 6, kGzipWindow = 15 + 16, kMemory = 8;
    is_good_ = ::deflateInit2(&stream_, kLevel, Z_DEFLATED, kGzipWindow, kMemory,
                              Z_DEFAULT_STRATEGY) == Z_OK;
  }
  GzipStream(const GzipStream&) = delete;
  GzipStream& operator=(const GzipStream&) = delete;
  ~GzipStream() { ::deflateEnd(&stream_); }

  /// `flush`: Z_NO_FLUSH, or Z_FINISH with the last bytes.
  [[nodiscard]] bool Put(std::vector<char>& bytes, std::size_t count, int flush) {
    stream_.next_in = reinterpret_cast<Bytef*>(bytes.data());
    stream_.avail_in = static_cast<uInt>(count);
    do {
      stream_.next_out = reinterpret_cast<Bytef*>(packed_.data());
      stream_.avail_out = static_cast<uInt>(packed_.size());
      is_good_ = is_good_ && ::deflate(&stream_, flush) != Z_STREAM_ERROR &&
                 out_.Append({packed_.data(), packed_.size() - stream_.avail_out});
    } while (is_good_ && stream_.avail_out == 0);
    return is_good_;
  }

 private:
  AppendFile& out_;
  z_stream stream_{};
  std::vector<char> packed_ = std::vector<char>(kChunkBytes);
  bool is_good_ = false;
};

bool PackInto(AppendFile& packed, SequentialFile& source) {
  GzipStream stream(packed);
  std::vector<char> chunk(kChunkBytes);
  bool is_good = true;
  for (std::size_t count = 0; is_good && (count = source.Read(chunk.data(), chunk.size())) > 0;) {
    is_good = stream.Put(chunk, count, Z_NO_FLUSH);
  }
  return is_good && stream.Put(chunk, 0, Z_FINISH) && !source.has_failed() && packed.Sync();
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

bool CompressFile(const std::filesystem::path& path, FileSystem& disk) {
  Expected<SequentialFile> source = SequentialFile::Open(path);
  std::filesystem::path part = path;
  part += ".gz.part";
  std::filesystem::path packed = path;
  packed += ".gz";
  Expected<AppendFile> out = AppendFile::Create(part, disk);
  if (!source || !out) {
    return false;
  }
  const bool is_done = PackInto(*out, *source) && !disk.Rename(part, packed);
  if (!is_done) {
    static_cast<void>(disk.Remove(part));
    return false;
  }
  return !disk.SyncFolder(path.parent_path()) && !disk.Remove(path);
}

}  // namespace limpet
