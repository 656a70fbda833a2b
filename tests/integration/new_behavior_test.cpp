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

/// Metres flown in the northern half of the area, times a weight.
class NorthernHalf final : public SearchTerm {
 public:
  explicit NorthernHalf(double weight = 1.0) : weight_(weight) {}
  [[nodiscard]] double Worth(const PathStep& step, TermEvents&) const override {
    double metres = 0.0, last = step.before;
    step.Sample([&](const Pose2& pose, double s) {
      metres += pose.north > 0.0 ? s - last : 0.0;
      last = s;
    });
    return weight_ * metres;
  }

 private:
  double weight_;
};

/// Bids for the north.
class BHV_TestPreferNorth : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestPreferNorth(const Params&) {}
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation&) const override {
    const double north = WorthAlong(prospect.path(), NorthernHalf());
    return Bid{.value = north, .why = {{"north", north}}, .veto = {}};
  }
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestPreferNorth);

/// Bids for the north, and makes searches seek it.
class BHV_TestSeekNorth final : public BHV_TestPreferNorth {
 public:
  using BHV_TestPreferNorth::BHV_TestPreferNorth;
  void Shape(const Situation&, double weight, SearchGoals& goals) const override {
    goals.objective.terms.push_back(std::make_shared<NorthernHalf>(weight));
  }
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestSeekNorth);

std::string BlockOf(const std::string& type, double weight) {
  return fmt::format(
      "\nBehavior = {}\n{{\n  name = north\n  pwt = {}\n"
      "  condition = MODE = ACTIVE:SURVEYING\n}}\n",
      type, weight);
}

/// The first two minutes of a survey of the basin: some 60 m of way, less than half of what it
/// takes.
constexpr double kWatched = 120.0;  // [s]

struct Beginning {
  std::vector<HelmPath> paths;
  std::vector<int> options;  ///< valued, per decision
  double north_share = 0.0;  ///< of the track
};

Beginning FlyBasin(const std::string& more_behaviors, std::uint64_t seed) {
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
                         .longest = Seconds(200.0)};
  Beginning beginning;
  std::optional<double> begin_s;
  int north = 0, poses = 0;
  static_cast<void>(RunSession(mission, plan, [&](const Message& message) {
    if (message.name == "HELM_PATH") {
      begin_s = begin_s.value_or(message.time.value());
      beginning.paths.push_back(*TopicCodec<HelmPath>::Decode(message.value));
    } else if (message.name == "HELM_BIDS") {
      beginning.options.push_back(TopicCodec<HelmBids>::Decode(message.value)->considered);
    } else if (message.name == "NAV_Y" && begin_s && message.time.value() < *begin_s + kWatched) {
      ++poses;
      north += std::get<double>(message.value) > 0.0 ? 1 : 0;
    }
  }));
  beginning.north_share = static_cast<double>(north) / std::max(1, poses);
  return beginning;
}

constexpr std::uint64_t kFlights = 6;

/// How much more of each flight's track lies in the north with a behavior than without.
std::vector<double> DrawnBy(const std::string& type, double weight) {
  std::vector<double> drawn;
  for (std::uint64_t seed = 1; seed <= kFlights; ++seed) {
    const double without = FlyBasin("", seed).north_share;
    const double with = FlyBasin(BlockOf(type, weight), seed).north_share;
    ::testing::Test::RecordProperty(fmt::format("{}_{}", type, seed),
                                    fmt::format("{:.3f} {:.3f}", without, with));
    drawn.push_back(with - without);
  }
  return drawn;
}

TEST(NewBehavior, OfHalfTheWeightDrawsTheVehicleWhereItWantsIt) {
  const std::vector<double> drawn = DrawnBy("BHV_TestSeekNorth", 0.5);
  EXPECT_GT(std::accumulate(drawn.begin(), drawn.end(), 0.0) / kFlights, 0.05);
}

/// Bids alone choose among plans: no search seeks what they like, so they must outweigh what the
/// other plans are worse.
TEST(NewBehavior, ThatOnlyBidsTurnsTheVehicleWhereItOutbidsTheDifferenceOfPlans) {
  const std::vector<double> drawn = DrawnBy("BHV_TestPreferNorth", 4.0);
  EXPECT_GT(std::ranges::count_if(drawn, [](double share) { return share != 0.0; }), 1);
  EXPECT_GT(std::accumulate(drawn.begin(), drawn.end(), 0.0), 0.0);
}

TEST(NewBehavior, HasAtLeastADozenOptionsToChooseFrom) {
  std::vector<int> options = FlyBasin("", 5).options;
  ASSERT_GT(options.size(), 4U);
  const auto middle = options.begin() + static_cast<std::ptrdiff_t>(options.size() / 2);
  std::ranges::nth_element(options, middle);
  EXPECT_GE(*middle, 12);
}

}  // namespace
}  // namespace limpet
