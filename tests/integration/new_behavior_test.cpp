// SPDX-License-Identifier: MIT
// A behavior that somebody adds to a mission has a say in where the vehicle goes: the search offers
// enough different paths for it to choose from.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "limpet/helm/registry.hpp"
#include "limpet/planning/search_term.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

enum class Half : int { kNorth = 1, kSouth = -1 };

/// Metres flown in one half of the area, times a weight.
class MetresInHalf final : public SearchTerm {
 public:
  explicit MetresInHalf(Half half, double weight = 1.0)
      : side_(static_cast<double>(half)), weight_(weight) {}
  [[nodiscard]] double Worth(const PathStep& step, TermEvents&) const override {
    double metres = 0.0, last = step.before;
    step.Sample([&](const Pose2& pose, double s) {
      metres += side_ * pose.north > 0.0 ? s - last : 0.0;
      last = s;
    });
    return weight_ * metres;
  }

 private:
  double side_;
  double weight_;
};

/// Bids for one half.
template <Half half>
class BHV_TestPrefer : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestPrefer(const Params&) {}
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation&) const override {
    const double metres = WorthAlong(prospect.path(), MetresInHalf(half));
    return Bid{.value = metres, .why = {{"metres", metres}}, .veto = {}};
  }
};
using BHV_TestPreferNorth = BHV_TestPrefer<Half::kNorth>;
LIMPET_REGISTER_BEHAVIOR(BHV_TestPreferNorth);

/// Bids for one half, and makes searches seek it.
template <Half half>
class BHV_TestSeek final : public BHV_TestPrefer<half> {
 public:
  using BHV_TestPrefer<half>::BHV_TestPrefer;
  void Shape(const Situation&, double weight, SearchGoals& goals) const override {
    goals.objective.terms.push_back(std::make_shared<MetresInHalf>(half, weight));
  }
};
using BHV_TestSeekNorth = BHV_TestSeek<Half::kNorth>;
using BHV_TestSeekSouth = BHV_TestSeek<Half::kSouth>;
LIMPET_REGISTER_BEHAVIOR(BHV_TestSeekNorth);
LIMPET_REGISTER_BEHAVIOR(BHV_TestSeekSouth);

std::string BlockOf(const std::string& type, double weight) {
  return fmt::format(
      "\nBehavior = {}\n{{\n  name = half\n  pwt = {}\n"
      "  condition = MODE = ACTIVE:SURVEYING\n}}\n",
      type, weight);
}

/// Of a survey of the basin, from its first path on: some 30 m of way, a quarter of what it takes.
/// What is drawn to one half early has to see the other one later, and the difference goes.
constexpr Seconds kDrawn(60.0);
/// Half of it: plans that bids choose among part later.
constexpr Seconds kTurned(120.0);
/// Until the first path is flown.
constexpr Seconds kBegun(45.0);

struct Beginning {
  std::vector<HelmPath> paths;
  std::vector<int> options;  ///< valued, per decision
  double north_share = 0.0;  ///< of the track
};

Beginning FlyBasin(const std::string& more_behaviors, std::uint64_t seed, Seconds watched) {
  const TemporaryFolder folder;
  const fs::path basin = fs::path(LIMPET_SOURCE_DIR) / "missions" / "basin";
  fs::copy(basin, folder.path() / "mission", fs::copy_options::recursive);
  std::ofstream(folder.path() / "mission" / "mission.bhv", std::ios::app) << more_behaviors;
  MissionFile mission = LoadMission(basin / "mission.moos");
  ApplySetting(mission, "uSimCamera.camera=boxes");
  ApplySetting(mission, "pSurvey.align_s=20");
  const SessionPlan plan{.session = "discovery",
                         .mission_folder = folder.path() / "mission",
                         .run_folder = folder.path() / "discovery",
                         .prior_folder = {},
                         .seed = seed,
                         .longest = kBegun + watched};
  Beginning beginning;
  std::optional<double> begin_s;
  int north = 0, poses = 0;
  static_cast<void>(RunSession(mission, plan, [&](const Message& message) {
    if (message.name == "HELM_PATH") {
      begin_s = begin_s.value_or(message.time.value());
      beginning.paths.push_back(*TopicCodec<HelmPath>::Decode(message.value));
    } else if (message.name == "HELM_BIDS") {
      beginning.options.push_back(TopicCodec<HelmBids>::Decode(message.value)->considered);
    } else if (message.name == "NAV_Y" && begin_s &&
               message.time.value() < *begin_s + watched.value()) {
      ++poses;
      north += std::get<double>(message.value) > 0.0 ? 1 : 0;
    }
  }));
  beginning.north_share = static_cast<double>(north) / std::max(1, poses);
  return beginning;
}

/// How much more of each flight's track lies in the north with one behavior than with another, or
/// none.
std::vector<double> DrawnBy(const std::string& more_behaviors, const std::string& than,
                            std::uint64_t flights, Seconds watched) {
  std::vector<double> drawn;
  for (std::uint64_t seed = 1; seed <= flights; ++seed) {
    const double without = FlyBasin(than, seed, watched).north_share;
    const double with = FlyBasin(more_behaviors, seed, watched).north_share;
    ::testing::Test::RecordProperty(fmt::format("flight_{}", seed),
                                    fmt::format("{:.3f} {:.3f}", without, with));
    drawn.push_back(with - without);
  }
  return drawn;
}

/// Against one that wants the other half: what a survey does without either leans to one side now
/// and then, and a single flight says little.
TEST(NewBehavior, OfHalfTheWeightDrawsTheVehicleWhereItWantsIt) {
  constexpr std::uint64_t kFlights = 12;
  const std::vector<double> drawn = DrawnBy(BlockOf("BHV_TestSeekNorth", 0.5),
                                            BlockOf("BHV_TestSeekSouth", 0.5), kFlights, kDrawn);
  EXPECT_GT(std::accumulate(drawn.begin(), drawn.end(), 0.0) / kFlights, 0.05);
}

/// Bids alone choose among plans: no search seeks what they like, so they must outweigh what the
/// other plans are worse.
TEST(NewBehavior, ThatOnlyBidsTurnsTheVehicleWhereItOutbidsTheDifferenceOfPlans) {
  const std::vector<double> drawn = DrawnBy(BlockOf("BHV_TestPreferNorth", 8.0), "", 6, kTurned);
  EXPECT_GT(std::ranges::count_if(drawn, [](double share) { return share != 0.0; }), 1);
  EXPECT_GT(std::accumulate(drawn.begin(), drawn.end(), 0.0), 0.0);
}

TEST(NewBehavior, HasAtLeastADozenOptionsToChooseFrom) {
  std::vector<int> options = FlyBasin("", 5, kTurned).options;
  ASSERT_GT(options.size(), 4U);
  const auto middle = options.begin() + static_cast<std::ptrdiff_t>(options.size() / 2);
  std::ranges::nth_element(options, middle);
  EXPECT_GE(*middle, 12);
}

}  // namespace
}  // namespace limpet
