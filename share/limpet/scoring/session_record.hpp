// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/decision/deciding_bid.hpp"
#include "limpet/objects/best_chips.hpp"
#include "limpet/scoring/energy_record.hpp"
#include "limpet/scoring/pose_track.hpp"
#include "limpet/scoring/warning_record.hpp"
#include "limpet/survey/tile_grid.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {

/// The survey grid as it was at the end of the session; what was never seen takes no room.
struct GridRecord {
  GridFrame frame;
  TileGrid<SeenCell> cells{1, 1};  ///< as many as the frame says, once it is known

  void Apply(const GridDelta& delta);
  /// Calls visit(row, column, cell) for each cell that was inside an image.
  template <class Visit>
  void EachSeen(Visit visit) const {
    cells.EachCell([&visit](int row, int column, const SeenCell& cell) {
      if (cell.seen_height >= 0.0F) visit(row, column, cell);
    });
  }
  /// Whether the vehicle believes to have seen this place (NED).
  [[nodiscard]] bool HasInspected(const Eigen::Vector3d& p_W) const;
  /// Lowest height that was in sight, median over what images have shown [m]; 0 if the bottom was.
  [[nodiscard]] double SeenFloor() const;
};

/// One decision of the helm, as far as a report tells of it: surveys of hours have thousands.
struct DecisionRecord {
  /// What the helm was offered.
  struct Offer {
    /// The best few options; more lines would hide the track in a figure.
    static constexpr std::size_t kBest = 3;

    explicit Offer(const HelmBids& bids);

    std::string chosen_source;                  ///< its generator; empty: no option
    std::optional<BidPurpose> purpose;          ///< of the bid that decided
    std::vector<std::array<double, 2>> ends{};  ///< of the best options, north and east [m]
  };
  Seconds time;
  int path_id = 0;
  double north = 0.0, east = 0.0;  ///< where the path begins [m]
  bool has_way = false;            ///< the path leads somewhere
  std::optional<Offer> offer{};    ///< nothing without bids on record
};

/// How sure the vehicle was about its objects at one time.
struct BeliefRecord {
  Seconds time;
  int opi = 0;
  StatusPosterior posterior;
};

/// All that a report needs to know about one session, gathered message by message: from the running
/// session or from its log, with the same result. Unknown and malformed messages are passed over.
struct SessionRecord {
  explicit SessionRecord(std::string session_name) : name(std::move(session_name)) {}
  void Collect(const Message& message);
  /// True for the variables that Collect reads; for a reader that wants to skip the rest.
  [[nodiscard]] static bool Listens(const std::string& variable);

  /// Notes that the session did not end by itself, `elapsed` after its start.
  void AddCut(const std::string& why_and_where, Seconds elapsed);

  /// Start of the first phase of this name, or nothing.
  [[nodiscard]] std::optional<Seconds> PhaseStart(SurveyPhase phase) const;

  std::string name;    ///< discovery, change, ...
  std::string former;  ///< session that the vehicle compared with (SESSION_PRIOR); empty: none
  PoseTrack truth;     ///< SIM_TRUTH, at most 25 Hz; empty after a real dive
  PoseTrack nav;       ///< NAV_STATE
  /// 1-sigma of north, east, down [m] and yaw [rad], one for each pose of `nav`.
  std::vector<std::array<float, 4>> nav_sd;
  PoseTrack dead_reckoning;
  std::vector<Landmark> landmarks;    ///< as last published
  std::vector<OpiBelief> opis;        ///< as last published
  std::vector<BeliefRecord> beliefs;  ///< every change of every posterior
  BestChips chips;                    ///< pictures of the landmarks; none without images
  std::vector<Stamped<Coverage>> believed_coverage;
  std::optional<WaterVisibility> water;  ///< as last published
  std::optional<WaterCurrent> current;   ///< as last published before the ascent
  std::optional<EnergyRecord> energy;    ///< nothing of a vehicle without a battery
  GridRecord grid;
  std::vector<DecisionRecord> decisions;
  std::vector<Stamped<std::string>> phases;
  std::vector<Stamped<bool>> surface_fixes;  ///< SURFACE_FIX where it changed
  std::optional<SurveyArea> area;
  std::optional<HomePoint> home;
  std::vector<WarningRecord> warnings;  ///< every one raised, in order
  std::optional<Seconds> begun;         ///< stamp of the first message collected
  std::string ended;                    ///< MISSION_END; empty when the session was cut short
};

}  // namespace limpet
