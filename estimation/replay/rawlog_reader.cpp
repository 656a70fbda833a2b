// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/registerAllClasses.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/topography/conversions.h>

#include "estimation/navigation/observation_forms.hpp"
#include "estimation/replay/bounded_input.hpp"
#include "estimation/replay/csv_fields.hpp"
#include "estimation/replay/rawlog.hpp"
#include "estimation/replay/rawlog_scan.hpp"
#include "limpet/core/config.hpp"
#include "limpet/packing/gzip_bytes.hpp"

namespace limpet {
namespace {

using mrpt::obs::CObservationComment;
using mrpt::obs::CObservationGPS;
using mrpt::obs::CObservationIMU;
using mrpt::obs::CObservationRawDAQ;
using mrpt::obs::CObservationRobotPose;
using mrpt::obs::TIMUDataIndex;
using Gga = mrpt::obs::gnss::Message_NMEA_GGA;

constexpr std::array kOrientation{mrpt::obs::IMU_ROLL, mrpt::obs::IMU_PITCH, mrpt::obs::IMU_YAW};

/// 1-sigma of each horizontal axis [m]: what a receiver errs by per unit of dilution, by the kind
/// of its solution; nothing if it has none, or only guesses.
std::optional<double> SigmaOf(const Gga::content_t& fix) {
  constexpr std::array<double, 6> kErrors{0.0, 3.0, 1.0, 3.0, 0.02, 0.3};  // invalid, GPS, ... RTK
  constexpr double kUsualDilution = 1.5;
  if (fix.fix_quality == 0 || fix.fix_quality >= kErrors.size()) return std::nullopt;
  const double dilution = static_cast<double>(fix.HDOP);
  return kErrors.at(fix.fix_quality) * (dilution > 0.0 ? dilution : kUsualDilution);
}

/// Turns observations into rows; false for one that says nothing to the estimator.
class RawlogRows {
 public:
  RawlogRows(SensorStream& stream, std::string name) : stream_(stream), name_(std::move(name)) {}

  bool Take(const CObservationComment& comment) {
    if (!comment.text.starts_with(kRawlogMetaBegin)) return false;
    auto meta = ParseStreamMeta(
        {.name = name_ + ": meta", .lines = Split(comment.text, '\n'), .damage = {}});
    if (!meta) throw BadLine{meta.error().text};
    stream_.meta = *std::move(meta);
    has_meta_ = true;
    return true;
  }
  bool Take(const CObservationIMU& imu) {
    if (!AreTruthValues(imu)) throw BadLine{"a CObservationIMU that is damaged begins there"};
    if (imu.sensorLabel == observation_labels::kDvl) return TakePing(*BottomTrackOf(imu));
    const auto depth = DepthOf(imu);
    if (imu.sensorLabel == observation_labels::kDepth && depth) {
      Add(*depth, {depth->depth});
    } else if (const auto turned = Numbers(imu, kOrientation)) {
      TakeAttitude(SecondsOf(imu), *turned);
    } else if (const auto felt = InertialOf(imu)) {
      Add(*felt, {felt->force_B.sum(), felt->rate_B.sum(), felt->heading});
    } else if (const auto rate = YawRateOf(imu); rate && !imu.has(mrpt::obs::IMU_WX)) {
      Add(*rate, {rate->rate});
    } else {
      return false;
    }
    return true;
  }
  bool Take(const CObservationRobotPose& pose) {
    if (pose.sensorLabel != observation_labels::kGps) return false;
    const PositionFix fix = *FixOf(pose);
    Add(fix, {fix.p_W.x(), fix.p_W.y(), fix.sd});
    return true;
  }
  bool Take(const CObservationGPS& gps) {
    if (!gps.hasMsgClass<Gga>()) return false;
    const Gga::content_t& fix = gps.getMsgByClass<Gga>().fields;
    const std::optional<double> sd = SigmaOf(fix);
    const bool is_place =
        std::abs(fix.latitude_degrees) < 89.0 && std::abs(fix.longitude_degrees) <= 180.0;
    if (!sd || !is_place) return false;
    const GeoPoint place{fix.latitude_degrees, fix.longitude_degrees};
    if (!stream_.datum) stream_.datum = place;
    mrpt::math::TPoint3D p_ENU;
    mrpt::topography::geodeticToENU_WGS84(
        {place.latitude_deg, place.longitude_deg, 0.0}, p_ENU,
        {stream_.datum->latitude_deg, stream_.datum->longitude_deg, 0.0});
    Add(PositionFix{SecondsOf(gps), {p_ENU.y, p_ENU.x}, *sd}, {*sd});
    return true;
  }
  bool Take(const CObservationRawDAQ& some) {
    const std::vector<double>& numbers = some.AIN_double;
    if (some.sensorLabel == observation_labels::kAttitudeSigma && numbers.size() == 3) {
      sigma_ = {numbers[0], numbers[1], numbers[2]};
      return true;
    }
    if (some.sensorLabel == observation_labels::kBeams && !stream_.rows.empty()) {
      const auto ranges = SlantRangesOf(some);
      auto* ping = std::get_if<DvlRow>(&stream_.rows.back());
      if (ranges && ping != nullptr) ping->beams = ranges->beams;
      if (ranges) return ping != nullptr;
    }
    if (some.sensorLabel == observation_labels::kThrusters) {
      const auto command = ThrusterSharesOf(some);
      if (command) stream_.rows.emplace_back(*command);
      return command.has_value();
    }
    return some.sensorLabel == observation_labels::kBoxes && TakeBoxes(some);
  }
  /// True once it is one of those that we write.
  [[nodiscard]] bool has_meta() const { return has_meta_; }

 private:
  /// MRPT copies what the file holds into `bool`s; to look at one that is neither is undefined.
  static bool AreTruthValues(const CObservationIMU& imu) {
    std::array<std::uint8_t, sizeof(imu.dataIsPresent)> bytes{};
    std::memcpy(bytes.data(), imu.dataIsPresent.data(), bytes.size());
    return std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte <= 1; });
  }
  /// Nothing if it lacks one of them.
  static std::optional<std::vector<double>> Numbers(const CObservationIMU& imu,
                                                    std::span<const TIMUDataIndex> fields) {
    std::vector<double> numbers;
    for (const TIMUDataIndex field : fields) {
      if (!imu.has(field)) return std::nullopt;
      numbers.push_back(imu.get(field));
    }
    return numbers;
  }
  void Add(StreamRow row, std::initializer_list<double> values) {
    if (std::ranges::all_of(values, [](double v) { return std::isfinite(v); })) {
      stream_.rows.push_back(std::move(row));
    } else {
      ++stream_.refused_rows;
    }
  }
  bool TakePing(const BottomTrack& ping) {
    Add(DvlRow{.t = ping.t, .v_WD_B = ping.v_WD_D, .altitude = ping.altitude},
        {ping.v_WD_D.value_or(Eigen::Vector3d::Zero()).sum(), ping.altitude.value_or(0.0)});
    return true;
  }
  void TakeAttitude(double t, const std::vector<double>& angles) {
    Add(AttitudeEstimate{.t = t,
                         .roll = angles[0],
                         .pitch = angles[1],
                         .yaw = angles[2],
                         .yaw_rate = 0.0,
                         .sd_roll = sigma_.x(),
                         .sd_pitch = sigma_.y(),
                         .sd_yaw = sigma_.z()},
        {angles[0], angles[1], angles[2], sigma_.sum()});
  }
  bool TakeBoxes(const CObservationRawDAQ& some) {
    std::optional<SeenFrame> seen = FrameOf(some);
    if (!seen) return false;
    stream_.refused_rows += seen->refused_boxes;
    stream_.rows.emplace_back(FrameRow{.arrival = seen->arrival, .frame = std::move(seen->frame)});
    return true;
  }

  SensorStream& stream_;
  std::string name_;
  bool has_meta_ = false;
  Eigen::Vector3d sigma_{0.0047, 0.0047, 0.0175};  // [rad] of an attitude that says none
};

/// Goes through the bytes once and keeps account of what is not taken.
class RawlogParser {
 public:
  RawlogParser(std::string_view bytes, const std::string& name, SensorStream& stream)
      : bytes_(bytes), name_(name), stream_(stream), rows_(stream, name) {
    static std::once_flag once;
    std::call_once(once, [] { mrpt::obs::registerAllClasses_mrpt_obs(); });
  }

  void Parse() {
    for (std::size_t at = 0; at < bytes_.size() && !stream_.cut;)
      at = TakeObject(at);
    for (const auto& [kind, count] : passed_over_)
      stream_.left_out.push_back(fmt::format("{}: {} {} passed over", name_, count, kind));
    if (again_ > 0) {
      stream_.left_out.push_back(fmt::format(
          "{}: byte {} of {}: an observation came before, bit for bit; {} such {} dropped: each "
          "counts once",
          name_, first_again_, bytes_.size(), again_, again_ == 1 ? "was" : "were"));
    }
    if (damaged_ > 0) {
      stream_.left_out.push_back(fmt::format("{}: damaged in {} {}; {}", name_, damaged_,
                                             damaged_ == 1 ? "place" : "places", first_damage_));
    }
  }

 private:
  /// Takes the object at byte `at`; returns the byte at which to go on.
  std::size_t TakeObject(std::size_t at) {
    const std::string_view rest = bytes_.substr(at);
    const std::string_view kind = ClassAt(rest);
    if (kind == "CObservationIMU") return Take<CObservationIMU>(at, kind);
    if (kind == "CObservationGPS") return Take<CObservationGPS>(at, kind);
    if (kind == "CObservationRawDAQ") return Take<CObservationRawDAQ>(at, kind);
    if (kind == "CObservationRobotPose") return Take<CObservationRobotPose>(at, kind);
    if (kind == "CObservationComment") return Take<CObservationComment>(at, kind);
    if (!kind.empty()) {
      ++passed_over_[std::string(kind)];
      is_in_foreign_ = true;
    } else if (!is_in_foreign_) {
      NoteDamage(at, "no observation begins there");
    }
    return NextObservation(bytes_, at + 1);
  }
  template <class T>
  std::size_t Take(std::size_t at, std::string_view kind) {
    BoundedInput input(bytes_.substr(at));
    std::string why;
    try {
      T object;
      mrpt::serialization::archiveFrom(input) >> object;
      const std::string_view whole = bytes_.substr(at, input.getPosition());
      if (IsOnce(object) && !taken_.insert(whole).second) {
        if (again_++ == 0) first_again_ = at;
        return at + whole.size();
      }
      if (!rows_.Take(object)) ++passed_over_[std::string(kind) + " `" + object.sensorLabel + "`"];
      return at + input.getPosition();
    } catch (const BadLine& bad) {
      why = bad.why;
    } catch (const std::exception&) {  // MRPT's words are a page with a stack
      why = fmt::format("a {} that is damaged begins there", kind);
    }
    const std::size_t next = NextObservation(bytes_, at + 1);
    if (next == bytes_.size() && input.has_ended()) {
      stream_.cut =
          fmt::format("{}: byte {} of {}: the last observation is cut", name_, at, bytes_.size());
    } else {
      NoteDamage(at, why);
    }
    return next;
  }
  /// True of a measurement that need not come twice. What is said of all that follows may be said
  /// again; and in other people's rawlogs whose stamps are coarse two that are alike may be two.
  template <class T>
  [[nodiscard]] bool IsOnce(const T& object) const {
    return rows_.has_meta() && !std::is_same_v<T, CObservationComment> &&
           object.sensorLabel != observation_labels::kAttitudeSigma;
  }
  void NoteDamage(std::size_t at, const std::string& why) {
    if (damaged_++ == 0) first_damage_ = fmt::format("byte {} of {}: {}", at, bytes_.size(), why);
  }

  std::string_view bytes_;
  const std::string& name_;
  SensorStream& stream_;
  RawlogRows rows_;
  std::map<std::string, int> passed_over_;
  bool is_in_foreign_ = false;  ///< what follows may be the rest of an object of another class
  int damaged_ = 0;
  std::string first_damage_;
  std::unordered_set<std::string_view> taken_;
  std::size_t again_ = 0, first_again_ = 0;  ///< that came before; byte of the first
};

}  // namespace

Expected<SensorStream> ParseRawlog(std::string_view bytes, const std::string& name) {
  SensorStream stream;
  RawlogParser(bytes, name, stream).Parse();
  if (!stream.rows.empty()) return stream;
  std::string why = fmt::format("{}: holds no measurement that can be used", name);
  for (const std::string& loss : stream.left_out)
    why += "\n" + loss;
  return Error{stream.cut.value_or(why)};
}

Expected<SensorStream> LoadRawlog(const std::filesystem::path& file) {
  constexpr std::size_t kLongest = std::size_t{1} << 32U;
  const Expected<UnpackedFile> read = ReadUnpacked(file, kLongest);
  if (!read) return read.error();
  Expected<SensorStream> stream = ParseRawlog(read->bytes, file.string());
  if (stream && read->damage) stream->cut = read->damage;
  if (!stream && read->damage) return Error{*read->damage};
  return stream;
}

}  // namespace limpet
