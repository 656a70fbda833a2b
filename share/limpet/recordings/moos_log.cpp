// SPDX-License-Identifier: MIT
#include "limpet/recordings/moos_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limpet/core/harmless_text.hpp"
#include "limpet/core/units.hpp"
#include "limpet/logbook/log_name.hpp"
#include "limpet/recordings/place_columns.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// North and east come as two entries; those of one instant are a place.
class PlacePairs {
 public:
  explicit PlacePairs(std::vector<TimedPlace>& places) : places_(places) {}
  void TakeEast(double t, double east) { Take({t, east}, east_); }
  void TakeNorth(double t, double north) { Take({t, north}, north_); }

 private:
  static constexpr double kOneInstant = 0.1;  ///< [s]
  void Take(const TimedNumber& now, std::optional<TimedNumber>& own) {
    own = now;
    if (!east_ || !north_ || std::abs(east_->t - north_->t) > kOneInstant) return;
    places_.push_back({.t = now.t, .p_W = {north_->value, east_->value}});
    east_.reset(), north_.reset();
  }
  std::vector<TimedPlace>& places_;
  std::optional<TimedNumber> east_, north_;
};

/// Sorts the entries of a log.
class NavigationEntries {
 public:
  explicit NavigationEntries(Recording& recording)
      : recording_(recording), pairs_(recording.own.places) {}

  void Take(const AlogEntry& entry) {
    if (!TakeNumber(entry)) NoteOther(entry.name);
  }
  void Finish(const std::string& file) {
    if (not_numbers_ > 0) {
      recording_.left_out.push_back(
          fmt::format("{}: {} entries of NAV_* that are no finite number", file, not_numbers_));
    }
    if (!others_.empty()) {
      recording_.left_out.push_back(
          fmt::format("{}: {}: their form is that vehicle's own, not known here", file,
                      fmt::join(others_, ", ")));
    }
  }

 private:
  static constexpr std::size_t kMostNamed = 12;
  bool TakeNumber(const AlogEntry& entry) {
    constexpr std::array kKnown{"NAV_X",     "NAV_Y",     "NAV_HEADING",
                                "NAV_SPEED", "NAV_DEPTH", "NAV_ALTITUDE"};
    if (std::ranges::find(kKnown, entry.name) == kKnown.end()) return false;
    if (!entry.number || !std::isfinite(*entry.number) || !std::isfinite(entry.time)) {
      ++not_numbers_;
      return true;
    }
    const double t = entry.time, value = *entry.number;
    if (entry.name == "NAV_X") pairs_.TakeEast(t, value);
    if (entry.name == "NAV_Y") pairs_.TakeNorth(t, value);
    if (entry.name == "NAV_HEADING") own().headings.push_back({t, RadiansFromDegrees(value)});
    if (entry.name == "NAV_SPEED") own().speeds.push_back({t, value});
    if (entry.name == "NAV_DEPTH") recording_.depths.push_back({.t = t, .depth = value});
    if (entry.name == "NAV_ALTITUDE") own().altitudes.push_back({t, value});
    return true;
  }
  /// What may tell motion or attitude, too.
  void NoteOther(std::string_view name) {
    constexpr std::array kHints{"DVL", "IMU", "GYRO", "COMPASS", "NAV_ROLL", "NAV_PITCH"};
    const bool is_hint = std::ranges::any_of(
        kHints, [name](const char* hint) { return name.find(hint) != std::string_view::npos; });
    if (is_hint && others_.size() < kMostNamed) others_.insert(HarmlessText(name));
  }
  OwnNavigation& own() { return recording_.own; }

  Recording& recording_;
  PlacePairs pairs_;
  std::set<std::string> others_;
  std::size_t not_numbers_ = 0;
};

void AddWhatTheLogLacks(const std::string& file, Recording& recording) {
  const auto lack = [&](const char* what, const char* variables, const char* cost) {
    recording.missing.push_back(
        {.what = what, .reason = fmt::format("{}: no {}", file, variables), .cost = cost});
  };
  const OwnNavigation& own = recording.own;
  if (own.headings.empty()) lack("heading", "NAV_HEADING", "no track can be reckoned");
  if (own.speeds.empty()) lack("speed", "NAV_SPEED", "no track can be reckoned");
  if (own.places.empty()) lack("position", "NAV_X with NAV_Y", "no track to compare with");
  if (recording.depths.empty()) lack("depth", "NAV_DEPTH", "a track is taken as level");
  lack("roll and pitch", "variable whose unit is agreed on (of NAV_ROLL and NAV_PITCH it is not)",
       "the vehicle is taken as level");
  lack("DVL and gyro", "measurements of them in a form that is known here",
       "the water's motion and side slip are in no speed: a track drifts with them");
}

Error NoEntries(const AlogReader& reader, const std::string& file) {
  std::string why;
  if (!reader.first_skipped().empty()) {
    const AlogReader::Skipped& first = reader.first_skipped().front();
    why = fmt::format("; {}:{}: {}", file, first.line, first.problem);
  }
  return Error{fmt::format("{}: none of {} lines is an entry (time, variable, source, value){}",
                           file, reader.skipped_lines(), why)};
}

/// The logs in a folder (or the one that is named) in the order of their names.
std::vector<fs::path> LogsOf(const fs::path& named) {
  std::error_code error;
  if (fs::is_regular_file(named, error)) {
    return IsAlogName(named) ? std::vector<fs::path>{named} : std::vector<fs::path>();
  }
  std::vector<fs::path> logs;
  for (const fs::directory_entry& entry : fs::directory_iterator(named, error)) {
    if (entry.is_regular_file(error) && IsAlogName(entry.path())) logs.push_back(entry.path());
  }
  std::ranges::sort(logs);
  return logs;
}

}  // namespace

Expected<Recording> ReadMoosLog(AlogReader& reader, const std::string& file) {
  Recording recording{
      .name = file, .pings = {}, .depths = {}, .own = {}, .missing = {}, .left_out = {}};
  NavigationEntries entries(recording);
  bool has_entry = false;
  for (AlogEntry entry; reader.Next(entry);) {
    has_entry = true;
    entries.Take(entry);
  }
  if (!has_entry) return NoEntries(reader, file);
  entries.Finish(file);
  if (recording.own.is_empty() && recording.depths.empty()) {
    return Error{
        fmt::format("{}: holds none of NAV_X, NAV_Y, NAV_HEADING, NAV_SPEED, NAV_DEPTH", file)};
  }
  if (reader.skipped_lines() > 0) {
    recording.left_out.push_back(
        fmt::format("{}: {} lines that are no entry", file, reader.skipped_lines()));
  }
  if (reader.has_torn_end()) recording.left_out.push_back(file + ": the last line is cut");
  if (reader.has_failed()) recording.left_out.push_back(file + ": could not be read to its end");
  AddWhatTheLogLacks(file, recording);
  return recording;
}

bool IsMoosRecording(const fs::path& named) {
  std::error_code error;
  return !fs::exists(named / "stream.csv.gz", error) && !LogsOf(named).empty();
}

Expected<Recording> LoadMoosRecording(const fs::path& named) {
  std::optional<Recording> found;
  std::vector<std::string> others;
  for (const fs::path& file : LogsOf(named)) {
    Expected<AlogReader> reader = AlogReader::Open(file);
    if (!reader) return reader.error();
    Expected<Recording> recording = ReadMoosLog(*reader, file.filename().string());
    if (!recording) {
      const std::string columns = PlaceColumnsText(file);
      others.push_back(columns.empty() ? recording.error().text : columns);
    } else if (found) {
      return Error{fmt::format("{}: holds the logs {} and {}; name one of them", named.string(),
                               found->name, recording->name)};
    } else {
      found = *std::move(recording);
    }
  }
  if (!found) {
    return Error{
        fmt::format("{}: holds no measurement\n  {}", named.string(), fmt::join(others, "\n  "))};
  }
  found->left_out.insert(found->left_out.end(), others.begin(), others.end());
  return *std::move(found);
}

}  // namespace limpet
