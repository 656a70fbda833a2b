// SPDX-License-Identifier: MIT
#include "estimation/change/look_log.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/change/lambda.hpp"

namespace limpet {
namespace {

/// `count` frames 4 per second along a line over the place, `step` metres apart.
void AddPass(LookLog& log, double start, int count, double step, bool has_box) {
  for (int i = 0; i < count; ++i) {
    log.Add({.time = start + 0.25 * i,
             .p_OC = {step * i - 1.0, 0.0, -3.0},
             .detects = 0.9,
             .false_alarm = 0.003,
             .has_box = has_box});
  }
}

TEST(LookLog, SaysNothingBeforeItHasLooked) {
  const LookLog log{LookParams{}};
  EXPECT_NEAR(trial::Lambda(log), 0.0, 1e-12);
  EXPECT_EQ(log.looks()(0), 0);
}

TEST(LookLog, CountsFramesFromOneViewpointAsOneWitness) {
  LookLog once{LookParams{}};
  LookLog hovering{LookParams{}};
  AddPass(once, 0.0, 1, 0.0, true);
  AddPass(hovering, 0.0, 40, 0.0, true);
  EXPECT_EQ(hovering.looks()(0), 1);
  EXPECT_NEAR(trial::Lambda(hovering), trial::Lambda(once), 1e-9);
}

TEST(LookLog, CountsANewLookEveryHalfMetre) {
  LookLog log{LookParams{}};
  AddPass(log, 0.0, 17, 0.125, true);
  EXPECT_EQ(log.looks()(0), 5);
  EXPECT_EQ(log.looks_with_box(), 5);
  EXPECT_EQ(log.passes(), 1);
}

TEST(LookLog, CountsANewLookWhenTheDirectionTurns) {
  LookLog log{LookParams{}};
  log.Add({.time = 0.0, .p_OC = {0, 0, -1}, .detects = 0.9, .false_alarm = 0.003, .has_box = true});
  log.Add(
      {.time = 1.0, .p_OC = {0.3, 0, -1}, .detects = 0.9, .false_alarm = 0.003, .has_box = true});
  EXPECT_EQ(log.looks()(0), 2);
}

TEST(LookLog, OnePassCannotBeSurerThanPassesAreReliable) {
  LookLog log{LookParams{}};
  AddPass(log, 0.0, 40, 0.125, false);
  EXPECT_GT(trial::Lambda(log), std::log(LookParams{}.pass_failure) - 0.6);
}

TEST(LookLog, ASecondPassIsASecondWitnessOfWhatAPassMayMiss) {
  LookLog one{LookParams{}};
  AddPass(one, 0.0, 20, 0.125, false);
  LookLog two = one;
  AddPass(two, 60.0, 20, 0.125, false);
  EXPECT_EQ(two.passes(), 2);
  EXPECT_LT(trial::Lambda(two), trial::Lambda(one) - 0.5);
}

TEST(LookLog, WhatNoPassOfASessionSawMayStillBeOvergrown) {
  LookLog log{LookParams{}};
  for (int pass = 0; pass < 50; ++pass)
    AddPass(log, 60.0 * pass, 5, 0.5, false);
  EXPECT_EQ(log.passes(), 50);
  const double failing_looks = 50.0 * 5.0 * std::log(1.0 - 0.9 * LookParams{}.failing_detects);
  EXPECT_GT(trial::Lambda(log), std::log(LookParams{}.place_failure) + failing_looks - 0.1);
}

TEST(LookLog, AStoneThatLooksLikeABuoyIsNoneForBeingSeenAgain) {
  LookLog one{LookParams{}};
  AddPass(one, 0.0, 20, 0.125, true);
  LookLog many = one;
  for (int pass = 1; pass < 10; ++pass)
    AddPass(many, 60.0 * pass, 1, 0.5, true);
  EXPECT_LT(trial::Lambda(many), -std::log(0.5 * trial::kLookalike));
  EXPECT_LT(trial::Lambda(many), trial::Lambda(one) + std::log(2.0)) << "nine times over";
}

TEST(LookLog, ALoneBoxAmongManyCleanLooksIsAFalseAlarm) {
  LookLog log{LookParams{}};
  AddPass(log, 0.0, 1, 0.125, true);
  AddPass(log, 0.25, 24, 0.125, false);
  EXPECT_LT(trial::Lambda(log), 0.0);
}

TEST(LookLog, AMissWhereLittleWasVisibleSaysLittle) {
  LookLog log{LookParams{}};
  log.Add(
      {.time = 0.0, .p_OC = {0, 0, -3}, .detects = 0.2, .false_alarm = 0.003, .has_box = false});
  EXPECT_GT(trial::Lambda(log), -0.25);
  EXPECT_EQ(log.looks()(0), 0) << "and is no look that an operator would count";
}

}  // namespace
}  // namespace limpet
