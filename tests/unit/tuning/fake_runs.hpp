// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/tuning/race.hpp"

namespace limpet {

/// A cost of each setting with noise of its own and noise that all settings share per seed.
struct FakeRuns {
  std::function<double(const SettingValues&)> cost;
  double own_sigma = 1.0;
  double shared_sigma = 50.0;
  std::vector<int> runs_of{};  ///< how often each contender was flown
  std::set<std::pair<std::size_t, std::size_t>> flown{};

  std::vector<RunOutcome> operator()(const std::vector<Contender>& contenders,
                                     const std::vector<Flight>& flights) {
    runs_of.resize(contenders.size());
    std::vector<RunOutcome> outcomes;
    for (const Flight& flight : flights) {
      EXPECT_TRUE(flown.emplace(flight.contender, flight.seed_index).second) << "flown twice";
      ++runs_of[flight.contender];
      Random shared(flight.seed_index, "shared");
      Random own(flight.seed_index, "own" + std::to_string(flight.contender));
      outcomes.push_back({.cost = cost(contenders[flight.contender].setting) +
                                  shared.Normal(shared_sigma) + own.Normal(own_sigma)});
    }
    return outcomes;
  }
};

}  // namespace limpet
