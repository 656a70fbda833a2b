// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "estimation/matching/session_matching.hpp"
#include "limpet/objects/former_session.hpp"
#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// A former session's objects, and which of this session's each of them is: as landmarks say,
/// decided or with a chance. What is decided tells where the former session's frame lies. Both
/// kinds of objects are named by their index.
class FormerTies {
 public:
  FormerTies(std::vector<FormerObject> former, const MatchingParams& params);

  /// This session's objects as now known.
  void Take(const std::vector<Landmark>& objects);

  [[nodiscard]] const std::vector<FormerObject>& former() const { return former_; }
  /// Offset of the former session's frame in this session's.
  [[nodiscard]] const FrameOffset& offset() const { return match_.offset; }
  /// The object that stands for a former one: decided, or the likeliest; nothing if none may be it.
  [[nodiscard]] std::optional<std::size_t> NowOf(std::size_t former) const;
  /// True if the object stands for a former one.
  [[nodiscard]] bool StandsForFormer(std::size_t object) const;
  /// That `object` is `former`, as the landmark says: 1 if that is decided.
  [[nodiscard]] double Chance(std::size_t former, std::size_t object) const;
  /// Sum over all objects of the chance that each is `former`, as landmarks say: may be above 1, as
  /// several may each be likely it.
  [[nodiscard]] double SumOfFormer(std::size_t former) const;
  /// Sum over all former objects of the chance that `object` is each of them.
  [[nodiscard]] double SumOfObject(std::size_t object) const;
  /// Where a former object lies in this session's frame, with what is unknown of that frame.
  [[nodiscard]] ObjectEstimate PlaceNow(std::size_t former) const;
  /// Where an object of now lies in the former session's frame, likewise.
  [[nodiscard]] ObjectEstimate PlaceThen(const ObjectEstimate& now) const;

 private:
  void TakeCandidates(const Landmark& landmark, std::size_t object);
  void FitFrame(const std::vector<Landmark>& objects);
  [[nodiscard]] ObjectEstimate InOtherFrame(ObjectEstimate place, const Eigen::Vector3d& p_W) const;

  std::vector<FormerObject> former_;
  MatchingParams params_;
  SessionMatch match_;  ///< `chance` is what landmarks say, 1 for a decided match
};

}  // namespace limpet
