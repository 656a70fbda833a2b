// SPDX-License-Identifier: MIT
#include "limpet/scoring/session_record.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <span>
#include <utility>

#include "limpet/app/warning_text.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/four_decimals.hpp"
#include "limpet/core/statistics.hpp"
#include "limpet/scoring/scoring_warnings.hpp"
#include "limpet/topics/chips.hpp"
#include "limpet/topics/grid_place.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/topics/surface_fix.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

// The log keeps five decimals of a stamp; rounding here makes a live record equal to a replayed
// one.
Seconds LoggedStamp(const Message& message) {
  return Seconds(ToFourDecimals(message.time.value()));
}

template <class T>
std::optional<T> Read(const Topic<T>&, const Message& message) {
  return TopicCodec<T>::Decode(message.value);
}

bool IsSame(const StatusPosterior& a, const StatusPosterior& b) {
  return a.confirmed == b.confirmed && a.removed == b.removed && a.appeared == b.appeared;
}

bool IsSame(const GridFrame& a, const GridFrame& b) {
  return a.rows == b.rows && a.columns == b.columns && a.north_min == b.north_min &&
         a.east_min == b.east_min && a.cell_m == b.cell_m;
}

void CollectTruth(SessionRecord& record, const Message& message) {
  constexpr double kMinInterval = 0.0399;  // 25 Hz: 2 cm of way at survey speed
  PoseTrack& truth = record.truth;
  const Seconds time = LoggedStamp(message);
  if (!truth.empty() && time.value() < truth.time(truth.size() - 1) + kMinInterval) return;
  if (const auto state = Read(topics::kSimTruth, message)) truth.Add(time, state->pose());
}

void CollectNavState(SessionRecord& record, const Message& message) {
  const auto state = Read(topics::kNavState, message);
  if (!state) return;
  record.nav.Add(LoggedStamp(message), state->pose());
  if (record.nav_sd.size() < record.nav.size()) {
    record.nav_sd.push_back({static_cast<float>(state->sd_north),
                             static_cast<float>(state->sd_east), static_cast<float>(state->sd_down),
                             static_cast<float>(state->sd_yaw)});
  }
}

void CollectDeadReckoning(SessionRecord& record, const Message& message) {
  const auto state = Read(topics::kNavDeadReckoning, message);
  if (!state) return;
  record.dead_reckoning.Add(LoggedStamp(message),
                            {{state->north, state->east, state->down}, 0.0, 0.0, state->yaw});
}

void CollectLandmarks(SessionRecord& record, const Message& message) {
  if (auto update = Read(topics::kNavLandmarks, message)) {
    record.landmarks = std::move(update->landmarks);
  }
}

void CollectOpis(SessionRecord& record, const Message& message) {
  const auto update = Read(topics::kMapOpis, message);
  if (!update) return;
  record.opis = update->opis;
  for (const OpiBelief& opi : record.opis) {
    const auto last =
        std::find_if(record.beliefs.rbegin(), record.beliefs.rend(),
                     [&](const BeliefRecord& belief) { return belief.opi == opi.id; });
    if (last != record.beliefs.rend() && IsSame(last->posterior, opi.posterior)) continue;
    record.beliefs.push_back({LoggedStamp(message), opi.id, opi.posterior});
  }
}

void CollectChips(SessionRecord& record, const Message& message) {
  if (auto chips = Read(topics::kDetectionChips, message)) record.chips.Add(std::move(*chips));
}

void CollectFrame(SessionRecord& record, const Message& message) {
  if (const auto frame = Read(topics::kNavCameraFrame, message)) record.chips.Add(*frame);
}

void CollectCoverage(SessionRecord& record, const Message& message) {
  if (const auto update = Read(topics::kMapCoverage, message)) {
    record.believed_coverage.push_back({LoggedStamp(message), *update});
  }
}

void CollectWater(SessionRecord& record, const Message& message) {
  if (const auto state = Read(topics::kWaterState, message)) record.water = *state;
}

void CollectCurrent(SessionRecord& record, const Message& message) {
  if (record.PhaseStart(SurveyPhase::kAscend)) return;
  if (const auto current = Read(topics::kNavCurrent, message)) record.current = *current;
}

void CollectEnergy(SessionRecord& record, const Message& message) {
  const auto state = Read(topics::kEnergyState, message);
  if (!state) return;
  const bool is_going_home =
      record.PhaseStart(SurveyPhase::kReturn) || record.PhaseStart(SurveyPhase::kAscend);
  if (!record.energy) record.energy.emplace();
  record.energy->Add(*state, is_going_home);
}

void CollectGrid(SessionRecord& record, const Message& message) {
  if (const auto delta = Read(topics::kMapDelta, message)) record.grid.Apply(*delta);
}

// A path and its bids come in either order; the first of the two opens the decision.
DecisionRecord& DecisionOf(SessionRecord& record, int path_id, const Message& message) {
  if (record.decisions.empty() || record.decisions.back().path_id != path_id) {
    record.decisions.push_back({.time = LoggedStamp(message), .path_id = path_id});
  }
  return record.decisions.back();
}

void CollectPath(SessionRecord& record, const Message& message) {
  const auto path = Read(topics::kHelmPath, message);
  if (!path) return;
  DecisionRecord& decision = DecisionOf(record, path->id, message);
  decision.north = path->north, decision.east = path->east;
  decision.has_way = !path->segments.empty();
}

void CollectBids(SessionRecord& record, const Message& message) {
  const auto bids = Read(topics::kHelmBids, message);
  if (bids) DecisionOf(record, bids->path_id, message).offer.emplace(*bids);
}

void CollectPhase(SessionRecord& record, const Message& message) {
  const auto text = Read(topics::kSurveyPhase, message);
  if (!text) return;
  const std::string phase(Trim(*text));
  if (record.phases.empty() || record.phases.back().value != phase) {
    record.phases.push_back({LoggedStamp(message), phase});
  }
}

void CollectSurfaceFix(SessionRecord& record, const Message& message) {
  const auto is_up = Read(topics::kSurfaceFix, message);
  const bool was_up = !record.surface_fixes.empty() && record.surface_fixes.back().value;
  if (is_up && *is_up != was_up) record.surface_fixes.push_back({LoggedStamp(message), *is_up});
}

void CollectArea(SessionRecord& record, const Message& message) {
  if (const auto area = Read(topics::kSurveyArea, message)) record.area = area;
}

void CollectHome(SessionRecord& record, const Message& message) {
  if (const auto home = Read(topics::kSurveyHome, message)) record.home = home;
}

void CollectPrior(SessionRecord& record, const Message& message) {
  if (auto prior = Read(topics::kSessionPrior, message)) record.former = std::move(prior->session);
}

void CollectEnd(SessionRecord& record, const Message& message) {
  if (const auto text = Read(topics::kMissionEnd, message)) record.ended = std::string(Trim(*text));
}

using Collector = void (*)(SessionRecord&, const Message&);

const std::map<std::string, Collector, std::less<>>& Collectors() {
  static const std::map<std::string, Collector, std::less<>> collectors{
      {topics::kSimTruth.name, CollectTruth},
      {topics::kNavState.name, CollectNavState},
      {topics::kNavDeadReckoning.name, CollectDeadReckoning},
      {topics::kNavLandmarks.name, CollectLandmarks},
      {topics::kMapOpis.name, CollectOpis},
      {topics::kDetectionChips.name, CollectChips},
      {topics::kNavCameraFrame.name, CollectFrame},
      {topics::kMapCoverage.name, CollectCoverage},
      {topics::kWaterState.name, CollectWater},
      {topics::kNavCurrent.name, CollectCurrent},
      {topics::kEnergyState.name, CollectEnergy},
      {topics::kMapDelta.name, CollectGrid},
      {topics::kHelmPath.name, CollectPath},
      {topics::kHelmBids.name, CollectBids},
      {topics::kSurveyPhase.name, CollectPhase},
      {topics::kSurfaceFix.name, CollectSurfaceFix},
      {topics::kSurveyArea.name, CollectArea},
      {topics::kSurveyHome.name, CollectHome},
      {topics::kSessionPrior.name, CollectPrior},
      {topics::kMissionEnd.name, CollectEnd}};
  return collectors;
}

}  // namespace

DecisionRecord::Offer::Offer(const HelmBids& bids) {
  if (const auto deciding = DecidingBidOf(bids)) purpose = deciding->purpose;
  if (!bids.options.empty()) chosen_source = bids.options.front().source;
  for (const BiddenOption& option :
       std::span(bids.options).first(std::min(bids.options.size(), kBest))) {
    ends.push_back(option.end);
  }
}

void GridRecord::Apply(const GridDelta& delta) {
  if (delta.frame.rows <= 0 || delta.frame.columns <= 0) return;
  if (!IsSame(frame, delta.frame)) {
    frame = delta.frame;
    cells = TileGrid<SeenCell>(frame.rows, frame.columns);
  }
  const auto columns = static_cast<std::uint32_t>(frame.columns);
  for (const GridDelta::Cell& cell : delta.cells) {
    const std::uint32_t row = cell.index / columns, column = cell.index % columns;
    if (row >= static_cast<std::uint32_t>(frame.rows)) continue;
    cells.Write(static_cast<int>(row), static_cast<int>(column)) = cell.now;
  }
}

double GridRecord::SeenFloor() const {
  std::vector<float> floors;
  EachSeen([&floors](int, int, const SeenCell& cell) { floors.push_back(cell.seen_floor); });
  if (floors.empty()) return 0.0;
  return static_cast<double>(UpperMedian(std::move(floors)));
}

bool GridRecord::HasInspected(const Eigen::Vector3d& p_W) const {
  const std::optional<GridPlace> place = GridPlaceOf(frame, p_W.head<2>());
  if (!place) return false;
  const SeenCell& cell = cells.At(place->row, place->column);
  const double height = static_cast<double>(cell.seabed_down) - p_W.z();
  return cell.is_in_sight() && height >= static_cast<double>(cell.seen_floor) &&
         height <= static_cast<double>(cell.seen_height);
}

std::optional<Seconds> SessionRecord::PhaseStart(SurveyPhase phase) const {
  const auto found = std::find_if(phases.begin(), phases.end(),
                                  [&](const auto& entry) { return entry.value == NameOf(phase); });
  return found != phases.end() ? std::optional<Seconds>(found->time) : std::nullopt;
}

void SessionRecord::AddCut(const std::string& why_and_where, Seconds elapsed) {
  warnings.push_back({.app = "limpet",
                      .id = warnings::kSessionCut.name(),
                      .severity = warnings::kSessionCut.severity(),
                      .text = why_and_where,
                      .from = begun.value_or(Seconds(0.0)) + elapsed,
                      .to = {}});
}

bool SessionRecord::Listens(const std::string& variable) {
  return Collectors().contains(variable) || CarriesWarnings(variable);
}

void SessionRecord::Collect(const Message& message) {
  const auto found = Collectors().find(message.name);
  if (found != Collectors().end()) {
    begun = begun.value_or(LoggedStamp(message));
    found->second(*this, message);
  } else if (CarriesWarnings(message.name) && ended.empty()) {
    // Once the mission has ended, apps miss each other.
    CollectWarnings(message, LoggedStamp(message), warnings);
  }
}

}  // namespace limpet
