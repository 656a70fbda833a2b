// SPDX-License-Identifier: MIT
#include "limpet/session/datum.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/config.hpp"

namespace limpet {
namespace {

SessionFacts FactsAt(const std::string& latitude, const std::string& longitude) {
  SessionFacts facts;
  facts.session = "change";
  facts.lat_origin = latitude;
  facts.long_origin = longitude;
  return facts;
}

std::string Complaint(const SessionFacts& former, const SessionFacts& now) {
  try {
    RequireOneDatum(former, now, "runs/monday");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(SessionDatum, OfSessionsFarApartIsRefusedWithBothPlacesAndTheDistance) {
  const std::string text = Complaint(FactsAt("43.7210", "10.2830"), FactsAt("44.7210", "10.2830"));
  EXPECT_THAT(text, ::testing::HasSubstr("runs/monday"));
  EXPECT_THAT(text, ::testing::HasSubstr("43.7210, 10.2830"));
  EXPECT_THAT(text, ::testing::HasSubstr("44.7210, 10.2830"));
  EXPECT_THAT(text, ::testing::HasSubstr("111194.9 m"));
}

TEST(SessionDatum, MayBeWrittenWithFewerDigitsOrAsAFullTurnMore) {
  EXPECT_EQ(Complaint(FactsAt("43.7210", "10.2830"), FactsAt("43.721", "10.283001")), "");
  EXPECT_EQ(Complaint(FactsAt("-17.5", "-179.9"), FactsAt("-17.5", "180.1")), "");
}

TEST(SessionDatum, ThatNobodySaidIsNoReasonToRefuse) {
  EXPECT_EQ(Complaint(FactsAt("", ""), FactsAt("44.7", "10.3")), "");
  EXPECT_FALSE(DatumOf(FactsAt("here", "10")));
}

TEST(SessionDatum, AFewMetresApartIsAnotherPlace) {
  EXPECT_THAT(Complaint(FactsAt("43.72100", "10.2830"), FactsAt("43.72102", "10.2830")),
              ::testing::HasSubstr("2.2 m"));
}

}  // namespace
}  // namespace limpet
