// SPDX-License-Identifier: MIT
#include "limpet/packing/gzip_bytes.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include <fmt/format.h>
#include <zlib.h>

#include "limpet/core/require.hpp"

namespace limpet {

namespace {

constexpr int kGzipWindow = 15 + 16;             // 16: zlib's sign for a gzip header
constexpr std::size_t kMostPerCall = 1U << 30U;  // zlib counts in 32 bits

/// zlib's interface is older than const.
Bytef* BytesOf(std::string_view part) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
}

}  // namespace

std::string Gzip(std::string_view bytes, Packing packing) {
  z_stream deflater{};
  const int level = packing == Packing::kFast ? 1 : Z_DEFAULT_COMPRESSION;
  const int begun = deflateInit2(&deflater, level, Z_DEFLATED, kGzipWindow, 8, Z_DEFAULT_STRATEGY);
  LIMPET_REQUIRE(begun == Z_OK, "zlib has no memory");
  std::string packed;
  std::array<char, 65536> buffer{};
  do {
    const std::string_view part = bytes.substr(0, kMostPerCall);
    bytes.remove_prefix(part.size());
    deflater.next_in = BytesOf(part);
    deflater.avail_in = static_cast<uInt>(part.size());
    do {
      deflater.next_out = reinterpret_cast<Bytef*>(buffer.data());
      deflater.avail_out = static_cast<uInt>(buffer.size());
      static_cast<void>(deflate(&deflater, bytes.empty() ? Z_FINISH : Z_NO_FLUSH));
      packed.append(buffer.data(), buffer.size() - deflater.avail_out);
    } while (deflater.avail_out == 0);
  } while (!bytes.empty());
  deflateEnd(&deflater);
  return packed;
}

bool IsGzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

Expected<std::string> Gunzip(std::string_view packed, std::size_t most) {
  z_stream inflater{};
  LIMPET_REQUIRE(inflateInit2(&inflater, kGzipWindow) == Z_OK, "zlib has no memory");
  std::string bytes;
  std::array<char, 65536> buffer{};
  int code = Z_OK;
  while (code == Z_OK && bytes.size() <= most) {
    if (inflater.avail_in == 0) {
      const std::string_view part = packed.substr(0, kMostPerCall);
      packed.remove_prefix(part.size());
      inflater.next_in = BytesOf(part);
      inflater.avail_in = static_cast<uInt>(part.size());
    }
    inflater.next_out = reinterpret_cast<Bytef*>(buffer.data());
    inflater.avail_out = static_cast<uInt>(buffer.size());
    code = inflate(&inflater, Z_NO_FLUSH);
    bytes.append(buffer.data(), buffer.size() - inflater.avail_out);
  }
  inflateEnd(&inflater);
  if (bytes.size() > most) {
    return Error{fmt::format("is longer than {} bytes", most)};
  }
  if (code != Z_STREAM_END) {
    return Error{"is damaged or cut short"};
  }
  bytes.shrink_to_fit();  // it may be kept, and grew by doubling
  return bytes;
}

Expected<UnpackedFile> ReadUnpacked(const std::filesystem::path& file, std::size_t most) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile_s*)> input(gzopen(file.c_str(), "rb"), gzclose);
  if (input == nullptr) return Error{fmt::format("{}: cannot be opened", file.string())};
  UnpackedFile read;
  std::array<char, 65536> buffer{};
  int count = 0;
  while (read.bytes.size() < most &&
         (count = gzread(input.get(), buffer.data(), static_cast<unsigned>(buffer.size()))) > 0) {
    read.bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
  int code = Z_OK;
  const std::string why = gzerror(input.get(), &code);
  if (code != Z_OK && code != Z_STREAM_END) {
    read.damage = fmt::format("{}: the file is damaged or cut short ({})", file.string(), why);
  } else if (read.bytes.size() >= most) {
    read.damage = fmt::format("{}: is longer than {} bytes", file.string(), most);
  }
  return read;
}

}  // namespace limpet
