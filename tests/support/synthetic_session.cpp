// SPDX-License-Identifier: MIT
#include "tests/support/synthetic_session.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/topics/simulation.hpp"

namespace limpet {
namespace {

constexpr double kSpeed = 0.5;
constexpr double kHalfNorth = 15.0, kHalfEast = 18.0;
constexpr double kDepth = 3.5;

struct Point {
  double north, east, yaw;
};

/// Lanes along north joined by half circles, by the distance along them.
Point PointAt(double way, double spacing) {
  const double lane = 2.0 * (kHalfNorth - 2.5);
  const double turn = std::numbers::pi * spacing / 2.0;
  const int k = static_cast<int>(way / (lane + turn));
  const double s = way - k * (lane + turn);
  const double east = -kHalfEast + 2.5 + k * spacing;
  const double sign = k % 2 == 0 ? 1.0 : -1.0;
  if (s <= lane) return {sign * (s - 0.5 * lane), east, sign > 0.0 ? 0.0 : std::numbers::pi};
  const double angle = (s - lane) / (spacing / 2.0);
  return {sign * (0.5 * lane + 0.5 * spacing * std::sin(angle)),
          east + 0.5 * spacing * (1.0 - std::cos(angle)),
          sign > 0.0 ? angle : WrapAngle(std::numbers::pi - angle)};
}

double LengthOfWay(double spacing) {
  const double lanes = std::floor((2.0 * kHalfEast - 5.0) / spacing + 1e-9) + 1.0;
  return lanes * 2.0 * (kHalfNorth - 2.5) + (lanes - 1.0) * std::numbers::pi * spacing / 2.0;
}

class Recorder {
 public:
  template <class T>
  void Post(const Topic<T>& topic, double time, const T& value) {
    messages.push_back({topic.name, TopicCodec<T>::Encode(value), Seconds(kEpoch + time), "pTest",
                        "", "alpha", -1});
  }
  std::vector<Message> messages;
};

/// What the image shows of the grid from here, as pMap would say.
GridDelta DeltaAt(const Point& p, std::vector<float>& seen) {
  GridDelta delta;
  delta.frame = {-kHalfNorth, -kHalfEast, 0.25, 120, 144};
  const auto index = [](double offset, int count) {
    return std::clamp(static_cast<int>(offset / 0.25), 0, count);
  };
  constexpr double kReach = 4.2;  // half the image's diagonal
  const int last_row = index(p.north + kReach + kHalfNorth, delta.frame.rows);
  const int last_column = index(p.east + kReach + kHalfEast, delta.frame.columns);
  for (int row = index(p.north - kReach + kHalfNorth, delta.frame.rows); row < last_row; ++row) {
    for (int column = index(p.east - kReach + kHalfEast, delta.frame.columns); column < last_column;
         ++column) {
      const double north = -kHalfNorth + (row + 0.5) * 0.25 - p.north;
      const double east = -kHalfEast + (column + 0.5) * 0.25 - p.east;
      const double along = std::abs(north * std::cos(p.yaw) + east * std::sin(p.yaw));
      const double across = std::abs(-north * std::sin(p.yaw) + east * std::cos(p.yaw));
      const double height = std::min(4.0 - along / std::tan(0.5235987755982988),
                                     4.0 - across / std::tan(0.6981317007977318));
      if (height < 0.0) continue;
      const double down =
          7.5 + 0.15 * std::sin(0.4 * (north + p.north)) * std::cos(0.3 * (east + p.east));
      const auto cell = static_cast<std::size_t>(row * delta.frame.columns + column);
      if (static_cast<float>(std::min(height, 2.0)) <= seen[cell]) continue;
      seen[cell] = static_cast<float>(std::min(height, 2.0));
      delta.cells.push_back(
          {static_cast<std::uint32_t>(cell), {seen[cell], static_cast<float>(down)}});
    }
  }
  return delta;
}

HelmPath PathAhead(const Point& p, int id, const std::string& purpose) {
  return {id, p.north, p.east, p.yaw, {{0.0, 8.0}, {1.0 / 3.0, 3.0}}, purpose};
}

/// Every fifth path is for an object; what offered it is the same beam.
HelmBids BidsFor(const HelmPath& path, bool is_look) {
  HelmBids bids{.path_id = path.id, .cause = "path end", .considered = 120, .options = {}};
  for (int i = 0; i < 4; ++i) {
    const double turn = path.yaw + 0.35 * (i - 1);
    BiddenOption option;
    option.source = i < 3 ? "beam" : "home";
    option.length = 11.0;
    option.total = 7.5 - 2.0 * i;
    option.rate = option.total / option.length;
    option.end = {path.north + 9.0 * std::cos(turn), path.east + 9.0 * std::sin(turn)};
    const double looks = is_look ? 5.0 : 0.0;
    option.bids = {
        {"cover",
         1.0,
         {.value = option.total - looks,
          .why = {{"useful", 18.0}, {"ragged", 0.0}, {"length", 11.0}}}},
        {"revisit", 1.0, {.value = looks, .why = {{"looks_worth", 5.0}, {"open_objects", 1.0}}}}};
    bids.options.push_back(option);
  }
  return bids;
}

void PostPose(Recorder& out, const SyntheticSession& session, double t, const Point& p, double down,
              double way) {
  SimTruth truth;
  truth.north = p.north, truth.east = p.east, truth.down = down, truth.yaw = p.yaw;
  out.Post(topics::kSimTruth, t, truth);
  NavState nav;
  nav.north = p.north + session.nav_offset_m, nav.east = p.east, nav.down = down, nav.yaw = p.yaw;
  nav.sd_north = nav.sd_east = nav.sd_down = session.nav_sd_m;
  out.Post(topics::kNavState, t, nav);
  DeadReckoning reckoning;
  reckoning.north = p.north + session.dead_reckoning_drift * way, reckoning.east = p.east;
  reckoning.down = down;
  out.Post(topics::kNavDeadReckoning, t, reckoning);
}

/// Objects become known one after the other, ever surer.
OpiBeliefs BeliefsAt(const SyntheticSession& session, double done) {
  OpiBeliefs beliefs;
  for (std::size_t i = 0; i < session.opis.size(); ++i) {
    const double since =
        done - static_cast<double>(i) / (static_cast<double>(session.opis.size()) + 1.0);
    if (since < 0.0) continue;
    OpiBelief opi = session.opis[i];
    const double share = 1.0 - std::exp(-12.0 * since);
    for (double* p : {&opi.posterior.confirmed, &opi.posterior.removed, &opi.posterior.appeared}) {
      *p = done >= 1.0 ? *p : 0.25 + share * (*p - 0.25);
    }
    beliefs.opis.push_back(opi);
  }
  return beliefs;
}

}  // namespace

Scenario Table1Scenario() {
  Scenario scenario;
  scenario.start = {-12.5, -15.5, 90.0};
  scenario.seabed.roughness_m = 0.0;
  const auto place = [](double n, double e, double d) {
    return std::optional<Eigen::Vector3d>(Eigen::Vector3d(n, e, d));
  };
  const std::optional<Eigen::Vector3d> absent;
  scenario.opis = {
      {"OPI 1", "yellow", 0.5, {{"discovery", place(4, 1, 5.5)}, {"change", place(4, 1, 5.5)}}},
      {"OPI 2", "orange", 0.5, {{"discovery", place(2, 10, 7)}, {"change", absent}}},
      {"OPI 3", "green", 0.5, {{"discovery", place(6, -3, 5.5)}, {"change", absent}}},
      {"OPI 4", "yellow", 0.5, {{"discovery", place(-6, -5, 6.5)}, {"change", place(-6, -5, 6.5)}}},
      {"OPI 5", "orange", 0.5, {{"discovery", absent}, {"change", place(-3, 11, 6)}}}};
  return scenario;
}

ReportSettings Table1Settings() {
  ReportSettings settings;
  settings.mission = "table1";
  settings.camera = "boxes";
  settings.command = "limpet survey missions/table1 --seed 1";
  settings.wall_s = {{"discovery", 12.5}, {"change", 14.25}};
  return settings;
}

std::vector<OpiBelief> RightBeliefs(const Scenario& scenario, const std::string& session,
                                    double error_m) {
  std::vector<OpiBelief> beliefs;
  for (const ScenarioOpi& truth : scenario.opis) {
    const auto before = truth.Place("discovery");
    const auto now = truth.Place(session);
    if (!now && (session == "discovery" || !before)) continue;
    OpiBelief opi;
    opi.id = static_cast<int>(beliefs.size());
    const Eigen::Vector3d place = now ? *now : *before;
    opi.object.p_W = {place.x(), place.y() + error_m, place.z()};
    opi.object.cov_W << 0.04, 0.01, 0.0, 0.01, 0.09, 0.0, 0.0, 0.0, 0.02;
    opi.centroid_W = {place.x() + 0.1, place.y() + error_m, place.z() - 0.1};
    opi.centroid_sd_W = {0.25, 0.3, 0.2};
    opi.object.color = truth.color;
    opi.looks = 7;
    const bool is_change = session == "change";
    opi.decided = !now ? Status::kRemoved : is_change && before ? Status::kConfirmed : Status::kNew;
    opi.posterior = !now                  ? StatusPosterior{0.02, 0.96, 0.01, 0.01}
                    : is_change && before ? StatusPosterior{0.97, 0.01, 0.01, 0.01}
                                          : StatusPosterior{0.01, 0.01, 0.97, 0.01};
    beliefs.push_back(opi);
  }
  return beliefs;
}

std::vector<Message> MessagesOf(const SyntheticSession& session) {
  Recorder out;
  out.Post(topics::kSurveyArea, 0.0, {-kHalfNorth, kHalfNorth, -kHalfEast, kHalfEast, 2.0, 2.0});
  out.Post(topics::kSurveyHome, 0.0, {-12.5, -15.5});
  const std::string former = session.former.value_or(session.name == "change" ? "discovery" : "");
  if (!former.empty()) {
    SessionPrior prior;
    prior.session = former;
    out.Post(topics::kSessionPrior, 0.0, prior);
  }
  out.Post(topics::kSurveyPhase, 0.0, std::string("DIVE"));
  constexpr int kDiveTicks = 200;
  const Point start = PointAt(0.0, session.lane_spacing_m);
  for (int i = 0; i < kDiveTicks; ++i) {
    PostPose(out, session, 0.1 * i, start, kDepth * i / kDiveTicks, 0.0);
  }
  out.Post(topics::kSurveyPhase, 20.0, std::string("SURVEY"));
  const double length =
      std::min(LengthOfWay(session.lane_spacing_m), session.seconds_of_survey * kSpeed);
  const int ticks = static_cast<int>(length / kSpeed * 10.0);
  int path_id = 0;
  std::vector<float> seen(120 * 144, -1.0F);
  for (int i = 0; i <= ticks; ++i) {
    const double t = 20.0 + 0.1 * i, way = 0.1 * i * kSpeed;
    const Point p = PointAt(way, session.lane_spacing_m);
    PostPose(out, session, t, p, kDepth, way);
    if (i % 10 == 0) out.Post(topics::kMapDelta, t, DeltaAt(p, seen));
    if (i % 160 == 0) {
      const HelmPath path = PathAhead(p, ++path_id, "beam");
      out.Post(topics::kHelmPath, t, path);
      out.Post(topics::kHelmBids, t, BidsFor(path, i % 800 == 0));
    }
    if (i % 20 == 0) {
      const double done = static_cast<double>(i) / ticks;
      out.Post(topics::kMapCoverage, t, Coverage{done, 0.97 * done, 0.95 * done});
      out.Post(topics::kMapOpis, t, BeliefsAt(session, done));
    }
  }
  const double end = 20.0 + 0.1 * ticks;
  out.Post(topics::kMapOpis, end, OpiBeliefs{session.opis});
  out.Post(topics::kSurveyPhase, end, std::string("ASCEND"));
  out.Post(topics::kMissionEnd, end, std::string("home"));
  return std::move(out.messages);
}

SessionRecord RecordOf(const SyntheticSession& session) {
  SessionRecord record(session.name);
  for (const Message& message : MessagesOf(session))
    record.Collect(message);
  return record;
}

}  // namespace limpet
