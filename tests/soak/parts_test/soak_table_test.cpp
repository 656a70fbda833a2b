// SPDX-License-Identifier: MIT
#include "tests/soak/soak_table.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/soak/pooled_slope.hpp"
#include "tests/soak/process_samples.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A run that nothing is wrong with: two lives of pMap that grow by 36 MiB per hour of real time.
SoakRun SoundSoak() {
  SoakRun run;
  run.ended = "home";
  run.down_m = 0.1;
  run.logs = 1;
  run.round_trips_ms = {1.0, 1.0, 2.0};
  for (const pid_t pid : {100, 200}) {
    ProcessLife life;
    life.name = "pMap";
    for (int i = 0; i < 100; ++i) {
      life.times_s.push_back(i);
      life.resident_mib.push_back(pid + 0.01 * i);
      life.descriptors.push_back(i < 10 ? 5 : 12);
    }
    run.lives[pid] = life;
  }
  run.kills["pMap"] = 1;
  run.restarts_s["pMap"] = {2.0};
  return run;
}

double ValueOf(const SoakPlan& plan, const SoakRun& run, const std::string& what) {
  const auto verdicts = VerdictsOf(plan, {run});
  const auto found = std::ranges::find_if(verdicts, [&what](const SoakVerdict& verdict) {
    return verdict.what.find(what) != std::string::npos;
  });
  return found == verdicts.end() ? -1.0 : found->value;
}

bool AreKept(const SoakPlan& plan, const SoakRun& run) {
  const auto verdicts = VerdictsOf(plan, {run});
  return std::ranges::all_of(verdicts, &SoakVerdict::IsKept);
}

TEST(SoakTable, TellsGrowthFromTheLevelsThatProcessesBeginAt) {
  const SoakPlan plan{.warp = 4.0};
  EXPECT_NEAR(ValueOf(plan, SoundSoak(), "slope"), 9.0, 1e-6) << "per hour of vehicle time";
  EXPECT_EQ(ValueOf(plan, SoundSoak(), "growth"), 0.0) << "what it opens while it starts is not";
  EXPECT_TRUE(AreKept(plan, SoundSoak()));
}

TEST(SoakTable, EveryBoundCanBeExceeded) {
  EXPECT_FALSE(AreKept({.most_slope_mib_per_h = 1.0}, SoundSoak()));
  EXPECT_FALSE(AreKept({.most_memory_mib = 150.0}, SoundSoak()));
  EXPECT_FALSE(AreKept({.most_round_trip_ms = 0.5}, SoundSoak()));
  EXPECT_FALSE(AreKept({.most_restart = Seconds(1.0)}, SoundSoak()));
  EXPECT_FALSE(AreKept({.least_watch = Seconds(500.0)}, SoundSoak())) << "nothing was watched";
  SoakRun leaking = SoundSoak();
  leaking.lives[100].descriptors.back() = 40;
  EXPECT_FALSE(AreKept({}, leaking));
  SoakRun deaf = SoundSoak();
  deaf.round_trips_ms.clear();
  EXPECT_FALSE(AreKept({}, deaf));
}

TEST(SoakTable, ComplainsOfARunThatDoesNotEndAsItMust) {
  EXPECT_THAT(SoundSoak().Complaint(), IsEmpty());
  SoakRun run = SoundSoak();
  run.ended.clear();
  EXPECT_THAT(run.Complaint(), HasSubstr("its end was not said"));
  EXPECT_FALSE(AreKept({}, run));
  run = SoundSoak();
  run.down_m = 3.0;
  EXPECT_THAT(run.Complaint(), HasSubstr("ended 3.0 m deep"));
  run = SoundSoak();
  run.unreadable_logs = 1;
  EXPECT_THAT(run.Complaint(), HasSubstr("1 logs cannot be read"));
  run = SoundSoak();
  run.was_cut = true;
  EXPECT_THAT(run.Complaint(), HasSubstr("too long"));
}

TEST(SoakPlans, OfThisTreeCanBeRead) {
  const std::filesystem::path plans = std::filesystem::path(LIMPET_SOURCE_DIR) / "tests/soak/plans";
  EXPECT_LT(LoadSoakPlan(plans / "short.moos").duration, Seconds(150.0));
  EXPECT_EQ(LoadSoakPlan(plans / "night.moos").duration, Seconds(8.0 * 3600.0));
}

TEST(SoakPlans, NameFileLineAndNearestKeyOfWhatCannotBe) {
  const TemporaryFolder folder;
  const auto complaint = [&folder](const std::string& lines) {
    std::ofstream(folder.path() / "plan.moos") << "ProcessConfig = soak\n{\n" << lines << "}\n";
    try {
      static_cast<void>(LoadSoakPlan(folder.path() / "plan.moos"));
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(complaint("  warpp = 3\n"), HasSubstr("plan.moos:3"));
  EXPECT_THAT(complaint("  warpp = 3\n"), HasSubstr("`warp`"));
  EXPECT_THAT(complaint("  fault = dvl_silnt\n"), HasSubstr("nearest: `dvl_silent`"));
  EXPECT_THAT(complaint("  fault = app_hangs\n"), HasSubstr("no fault that a soak draws"));
  EXPECT_THAT(complaint("  warp = 3\n"), HasSubstr("faults_per_run draws from it"));
  EXPECT_EQ(complaint("  fault = leak\n"), "");
  EXPECT_EQ(complaint("  fault = disk_full\n"), "") << "a live mission's disk fails, too";
}

TEST(SoakSamples, SeeTheChildrenOfAProcessAndTheirFiles) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::pause();
    ::_exit(0);
  }
  const std::vector<SampledProcess> children = ChildrenOf(::getpid());
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  const auto found = std::ranges::find(children, child, &SampledProcess::pid);
  ASSERT_NE(found, children.end());
  EXPECT_GT(found->resident_mib, 0.0);
  EXPECT_GE(found->descriptors, 3);
}

}  // namespace
}  // namespace limpet
