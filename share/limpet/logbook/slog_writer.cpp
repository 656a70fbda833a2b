// SPDX-License-Identifier: MIT
#include "limpet/logbook/slog_writer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace limpet {
namespace {

constexpr std::size_t kColumnWidth = 18;
constexpr std::size_t kSpareNameWidth = 64;
constexpr int kRowsPerLabel = 30;
constexpr std::size_t kMostBytesKept = std::size_t{4} << 20U;

/// A name without blanks, cut or filled to the room that a spare column has in the banner.
std::string SpareName(const std::string& name) {
  std::string word;
  AppendLogWord(word, name.substr(0, kSpareNameWidth - 1), kSpareNameWidth - 1);
  return word;
}

}  // namespace

Expected<SlogWriter> SlogWriter::Open(const std::filesystem::path& file, Seconds start,
                                      const Columns& columns, const AlogOptions& options) {
  Expected<AppendFile> created = AppendFile::Create(file);
  if (!created) {
    return created.error();
  }
  SlogWriter writer(*std::move(created), options.double_precision);
  std::string banner;
  AppendLogBanner(banner, file.filename().string(), start,
                  Seconds(start.value() / options.time_warp), "");
  writer.WriteHeader(banner, columns);
  return writer;
}

void SlogWriter::WriteHeader(const std::string& banner, const Columns& columns) {
  buffer_ += banner + "%%   (1) TIME \n";
  int number = 2;
  for (const std::string& name : columns.names) {
    buffer_ += fmt::format("%%   ({}) {}\n", number++, name);
    names_.push_back(name);
  }
  for (int i = 0; i < columns.spare; ++i) {
    names_.push_back(fmt::format("DYNAMIC_{}", i));
    buffer_ += fmt::format("%%   ({}) ", number++);
    spare_places_.push_back(buffer_.size());
    buffer_ += SpareName(names_.back()) + "\n";
  }
  buffer_ += std::string(56, '%') + "\n";
  WriteLabels();
  Flush();  // the spare names' places are in the file from now on
}

void SlogWriter::WriteLabels() {
  AppendLogWord(buffer_, "%%", 2);
  AppendLogWord(buffer_, "TIME", kColumnWidth - 3);
  for (const std::string& name : names_) {
    AppendLogWord(buffer_, name, kColumnWidth);
  }
  buffer_ += '\n';
}

void SlogWriter::WriteRow(double time, const std::vector<double>& values) {
  buffer_ += fmt::format("{:<{}.5f} ", time, kColumnWidth);
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (i < values.size() && std::isfinite(values[i])) {
      buffer_ += fmt::format("{:<{}.{}f} ", values[i], kColumnWidth, decimals_);
    } else {
      buffer_ += fmt::format("{:<{}} ", "NaN", kColumnWidth);
    }
  }
  buffer_ += '\n';
  if (++rows_ % kRowsPerLabel == 0) {
    WriteLabels();
  }
}

bool SlogWriter::Claim(const std::string& name) {
  if (spare_places_.empty()) {
    return false;
  }
  const std::size_t column = names_.size() - spare_places_.size();
  names_[column] = name;
  const std::uint64_t place = spare_places_.front();
  spare_places_.erase(spare_places_.begin());
  const std::string word = SpareName(name);
  if (place + word.size() <= file_.size()) {  // else the header never reached the disk
    is_good_ = file_.Overwrite(place, word) && is_good_;
  }
  WriteLabels();
  return true;
}

bool SlogWriter::Flush() {
  if (file_.Append(buffer_)) {
    buffer_.clear();
    return is_good_;
  }
  is_good_ = false;
  if (buffer_.size() > kMostBytesKept) {
    buffer_.clear();
  }
  return is_good_;
}

bool SlogWriter::Sync() {
  is_good_ = Flush() && file_.Sync();
  return is_good_;
}

}  // namespace limpet
