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

/// A name without blanks, cut or filled to the room that a spare column has in the banner.
std::string SpareName(const std::string& name) {
  std::string word;
  AppendLogWord(word, name.substr(0, kSpareNameWidth - 1), kSpareNameWidth - 1);
  return word;
}

}  // namespace

Expected<SlogWriter> SlogWriter::Open(const std::filesystem::path& file, Seconds start,
                                      const Columns& columns, const AlogOptions& options,
                                      FileSystem& disk) {
  Expected<AppendFile> created = AppendFile::Create(file, disk);
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
  lines_.text() += banner + "%%   (1) TIME \n";
  int number = 2;
  for (const std::string& name : columns.names) {
    lines_.text() += fmt::format("%%   ({}) {}\n", number++, name);
    names_.push_back(name);
  }
  for (int i = 0; i < columns.spare; ++i) {
    names_.push_back(fmt::format("DYNAMIC_{}", i));
    lines_.text() += fmt::format("%%   ({}) ", number++);
    spare_places_.push_back(lines_.text().size());
    lines_.text() += SpareName(names_.back()) + "\n";
  }
  lines_.text() += std::string(56, '%') + "\n";
  WriteLabels();
  Flush();  // the spare names' places are in the file from now on
}

void SlogWriter::WriteLabels() {
  AppendLogWord(lines_.text(), "%%", 2);
  AppendLogWord(lines_.text(), "TIME", kColumnWidth - 3);
  for (const std::string& name : names_) {
    AppendLogWord(lines_.text(), name, kColumnWidth);
  }
  lines_.text() += '\n';
}

void SlogWriter::WriteRow(double time, const std::vector<double>& values) {
  lines_.text() += fmt::format("{:<{}.5f} ", time, kColumnWidth);
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (i < values.size() && std::isfinite(values[i])) {
      lines_.text() += fmt::format("{:<{}.{}f} ", values[i], kColumnWidth, decimals_);
    } else {
      lines_.text() += fmt::format("{:<{}} ", "NaN", kColumnWidth);
    }
  }
  lines_.text() += '\n';
  lines_.NoteEntry();
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
  if (place + word.size() <= lines_.file().size()) {
    // If it fails the name stands in the labels alone.
    static_cast<void>(lines_.file().Overwrite(place, word));
  } else if (place + word.size() <= lines_.text().size()) {  // the header waits for the disk
    lines_.text().replace(place, word.size(), word);
  }
  WriteLabels();
  return true;
}

}  // namespace limpet
