// SPDX-License-Identifier: MIT
#include "limpet/scoring/opi_score.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

// The judge's own yardsticks, whatever a mission has the vehicle take for moved or decided.

/// Farther from a true object a report is of none [m].
constexpr double kMatchRadius = 2.5;
/// An object this far or farther from its former place was moved; places are written with decimals,
/// whose difference rounding may make less [m].
constexpr double kMovedDistance = 0.5 - 1e-6;

/// An object whose status is open is reported from this probability on that it is there.
constexpr double kSurelyThere = 0.9;

/// At one place the belief about an object of the same colour comes first.
constexpr double kOtherColor = 1.0;

struct Place {
  const ScenarioOpi* opi = nullptr;
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
};

bool SaysPresent(const OpiBelief& opi) {
  return opi.decided == Status::kNew || opi.decided == Status::kConfirmed ||
         opi.decided == Status::kMoved;
}

/// True for a mapped object that is there by the vehicle's account; since when may be open in a
/// session that has a former one.
bool IsReported(const OpiBelief& opi, bool has_former) {
  const bool is_sure = has_former && opi.landmark && opi.decided == Status::kUncertain &&
                       opi.posterior.present() >= kSurelyThere;
  return SaysPresent(opi) || is_sure;
}

double ProbabilityOf(const OpiBelief& opi) {
  const StatusPosterior& p = opi.posterior;
  if (opi.decided == Status::kConfirmed) return p.confirmed;
  if (opi.decided == Status::kRemoved) return p.removed;
  if (opi.decided == Status::kNew) return p.appeared;
  if (opi.decided == Status::kMoved && opi.moved_probability) return *opi.moved_probability;
  return std::max({p.confirmed, p.removed, p.appeared, p.nothing});
}

/// The belief that each place is matched with, or nullptr; nearest pairs first, those of one colour
/// before others.
std::vector<const OpiBelief*> Match(const std::vector<Place>& places,
                                    const std::vector<OpiBelief>& beliefs) {
  struct Pair {
    double distance;
    std::size_t place, belief;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < beliefs.size(); ++j) {
      const double distance = (places[i].p_W - beliefs[j].object.p_W).norm();
      const bool is_same_color = places[i].opi->color == beliefs[j].object.color;
      if (distance <= kMatchRadius) {
        pairs.push_back({distance + (is_same_color ? 0.0 : kOtherColor), i, j});
      }
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  std::vector<const OpiBelief*> matched(places.size(), nullptr);
  std::vector<bool> is_taken(beliefs.size(), false);
  for (const Pair& pair : pairs) {
    if (matched[pair.place] != nullptr || is_taken[pair.belief]) continue;
    matched[pair.place] = &beliefs[pair.belief];
    is_taken[pair.belief] = true;
  }
  return matched;
}

/// The beliefs that are reported, as SmoothedBelief gives them.
std::vector<OpiBelief> Reported(const SessionRecord& record, bool has_former) {
  std::vector<OpiBelief> beliefs;
  for (const OpiBelief& opi : record.opis) {
    if (IsReported(opi, has_former)) beliefs.push_back(SmoothedBelief(opi, record.landmarks));
  }
  return beliefs;
}

bool Contains(const std::vector<const OpiBelief*>& matched, const OpiBelief& belief) {
  return std::find(matched.begin(), matched.end(), &belief) != matched.end();
}

/// REQUIRES: `beliefs` are those that are reported.
void ScorePresence(const std::vector<OpiBelief>& beliefs, const SessionRecord& record,
                   const Scenario& scenario, const CommonOffset& offset, OpiScores& scores) {
  std::vector<Place> places;
  for (const ScenarioOpi& opi : scenario.opis) {
    if (const auto place = opi.Place(record.name)) places.push_back({&opi, *place});
  }
  const auto matched = Match(places, beliefs);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ScenarioOpi& truth = *places[i].opi;
    if (matched[i] == nullptr) {
      scores.missed.push_back(truth.name);
      continue;
    }
    const Eigen::Vector3d& said_W = matched[i]->object.p_W;
    scores.found.push_back({.truth = truth.name,
                            .color = truth.color,
                            .radius_m = truth.radius_m,
                            .truth_W = places[i].p_W,
                            .belief = *matched[i],
                            .error_m = (said_W - places[i].p_W).norm(),
                            .aligned_error_m = (offset.Apply(said_W) - places[i].p_W).norm()});
  }
  for (const OpiBelief& belief : beliefs) {
    if (!Contains(matched, belief)) scores.invented.push_back(belief);
  }
}

/// A session and the one that it is compared with.
struct SessionPair {
  std::string former, now;
};

std::optional<Status> ExpectedStatus(const ScenarioOpi& opi, const SessionPair& sessions) {
  const auto before = opi.Place(sessions.former);
  const auto now = opi.Place(sessions.now);
  if (before && now)
    return (*before - *now).norm() >= kMovedDistance ? Status::kMoved : Status::kConfirmed;
  if (before) return Status::kRemoved;
  if (now) return Status::kNew;
  return std::nullopt;
}

/// True for what is left over at the old place of an object that was moved.
bool IsTraceOfAMove(const OpiBelief& belief, const Scenario& scenario,
                    const SessionPair& sessions) {
  return std::any_of(scenario.opis.begin(), scenario.opis.end(), [&](const ScenarioOpi& opi) {
    const auto before = opi.Place(sessions.former);
    return ExpectedStatus(opi, sessions) == Status::kMoved && belief.decided == Status::kRemoved &&
           (*before - belief.object.p_W).norm() <= kMatchRadius;
  });
}

bool IsDecided(const OpiBelief& opi) { return SaysPresent(opi) || opi.decided == Status::kRemoved; }

void ScoreChanges(const SessionRecord& record, const std::string& former, const Scenario& scenario,
                  OpiScores& scores) {
  const SessionPair sessions{former, record.name};
  std::vector<OpiBelief> beliefs;
  for (const OpiBelief& opi : record.opis)
    beliefs.push_back(SmoothedBelief(opi, record.landmarks));
  std::vector<Place> places;
  for (const ScenarioOpi& opi : scenario.opis) {
    auto place = opi.Place(sessions.now);
    if (!place) place = opi.Place(sessions.former);
    if (place) places.push_back({&opi, *place});
  }
  const auto matched = Match(places, beliefs);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Status unknown =
        record.grid.HasInspected(places[i].p_W) ? Status::kUncertain : Status::kNotInspected;
    ChangeScore score{
        places[i].opi->name, ExpectedStatus(*places[i].opi, sessions), unknown, std::nullopt, {}};
    if (matched[i] != nullptr) {
      const OpiBelief& opi = *matched[i];
      score.decided = opi.decided;
      score.probability = ProbabilityOf(opi);
      score.p_W = opi.object.p_W;
      score.posterior = opi.posterior;
      score.moved_probability = opi.moved_probability;
    }
    scores.changes.push_back(std::move(score));
  }
  for (const OpiBelief& belief : beliefs) {
    const bool is_known = Contains(matched, belief) || IsTraceOfAMove(belief, scenario, sessions);
    if (is_known || !IsDecided(belief)) continue;
    scores.changes.push_back({std::nullopt, std::nullopt, belief.decided, ProbabilityOf(belief),
                              belief.object.p_W, belief.posterior, belief.moved_probability});
  }
}

}  // namespace

OpiBelief SmoothedBelief(OpiBelief opi, const std::vector<Landmark>& landmarks) {
  for (const Landmark& landmark : landmarks) {
    if (opi.landmark != landmark.id) continue;
    opi.object.p_W = landmark.object.p_W, opi.object.cov_W = landmark.object.cov_W;
    opi.object.size = landmark.object.size;
  }
  return opi;
}

OpiScores ScoreOpis(const SessionRecord& record, const std::string& former,
                    const Scenario& scenario, const CommonOffset& offset) {
  OpiScores scores;
  ScorePresence(Reported(record, !former.empty()), record, scenario, offset, scores);
  if (!former.empty()) ScoreChanges(record, former, scenario, scores);
  return scores;
}

OpiScores ReportedOpis(const SessionRecord& record, bool has_former) {
  OpiScores scores;
  scores.reported = Reported(record, has_former);
  if (!has_former) return scores;
  for (const OpiBelief& opi : record.opis) {
    scores.changes.push_back({std::nullopt, std::nullopt, opi.decided, ProbabilityOf(opi),
                              SmoothedBelief(opi, record.landmarks).object.p_W, opi.posterior,
                              opi.moved_probability});
  }
  return scores;
}

}  // namespace limpet
