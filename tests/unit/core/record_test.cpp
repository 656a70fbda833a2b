// SPDX-License-Identifier: MIT
#include "limpet/core/record.hpp"

#include <gtest/gtest.h>

#include "limpet/core/params.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"

namespace limpet {
namespace {

struct Sample {
  double depth = 0.0;
  int count = 0;
  bool is_on = false;
  std::string mode;
  std::optional<double> altitude;
  template <class V>
  void Describe(V& visit) {
    visit("depth", depth), visit("count", count), visit("is_on", is_on), visit("mode", mode);
    visit("altitude", altitude);
  }
};

TEST(Record, IsReadableText) {
  EXPECT_EQ(EncodeRecord(Sample{1.5, 2, true, "DRIVE", std::nullopt}),
            "depth=1.5,count=2,is_on=true,mode=DRIVE");
}

TEST(Record, BringsBackAnyNumbers) {
  Random random(1, "records");
  for (int i = 0; i < 500; ++i) {
    const Sample sent{random.Normal(1e3), static_cast<int>(random.Index(1000)), random.Chance(0.5),
                      "x", random.Chance(0.5) ? std::optional(random.Normal(1.0)) : std::nullopt};
    const auto back = DecodeRecord<Sample>(EncodeRecord(sent));
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->depth, sent.depth);
    EXPECT_EQ(back->count, sent.count);
    EXPECT_EQ(back->is_on, sent.is_on);
    EXPECT_EQ(back->altitude, sent.altitude);
  }
}

TEST(Record, TakesFieldsInAnyOrderWithBlanksAndStrangers) {
  const auto back = DecodeRecord<Sample>(" is_on=TRUE, depth = 2 ,extra=9,count=1,mode=A B,,noise");
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->depth, 2.0);
  EXPECT_EQ(back->mode, "A B");
}

TEST(Record, IsRefusedWhenAFieldIsMissingOrMalformed) {
  for (const char* text :
       {"", "depth=1,count=2,is_on=true", "depth=x,count=2,is_on=true,mode=a",
        "depth=1,count=2.5,is_on=true,mode=a", "depth=1,count=99999999999,is_on=true,mode=a",
        "depth=1,count=2,is_on=perhaps,mode=a", "depth=1,count=2,is_on=true,mode=a,altitude=?"}) {
    EXPECT_FALSE(DecodeRecord<Sample>(text).has_value()) << text;
  }
}

/// Declared as parameters are.
struct Sheet {
  double share = 0.5;
  Radians tilt{0.0};
  template <class V>
  void Describe(V& visit) {
    visit("share", share, "Share of something", InRange(0.0, 1.0));
    visit("tilt_deg", tilt, "How far it is tilted");
  }
};

TEST(Record, HoldsParametersInTheUnitOfTheirText) {
  EXPECT_EQ(EncodeRecord(Sheet{.tilt = Radians::FromTextUnit(45.0)}), "share=0.5,tilt_deg=45");
  const auto back = DecodeRecord<Sheet>("tilt_deg=90,share=2");
  ASSERT_TRUE(back.has_value());
  EXPECT_DOUBLE_EQ(back->tilt.value(), RadiansFromDegrees(90.0));
  EXPECT_EQ(back->share, 2.0) << "ranges are for blocks";
  EXPECT_FALSE(DecodeRecord<Sheet>("share=0.5").has_value());
}

TEST(Random, GivesEachNameAStreamOfItsOwn) {
  EXPECT_EQ(Random(1, "a").Bits(), Random(1, "a").Bits());
  EXPECT_NE(Random(1, "a").Bits(), Random(1, "b").Bits());
  EXPECT_NE(Random(1, "a").Bits(), Random(2, "a").Bits());
}

TEST(Random, DrawsWithinItsBounds) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double value = random.Uniform(2.0, 3.0);
    EXPECT_TRUE(value >= 2.0 && value < 3.0);
    EXPECT_LT(random.Index(7), 7U);
  }
}

}  // namespace
}  // namespace limpet
