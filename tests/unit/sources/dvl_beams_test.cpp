// SPDX-License-Identifier: MIT
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/sources/motion_sensor_fixture.hpp"

namespace limpet {
namespace {

TEST(DvlBeams, ABeamWithoutAnEchoStaysOne) {
  DvlSample said;
  said.b1 = 4.4, said.b3 = 4.5 / 7.0;
  const auto read = ReadingBy<SlantRanges>("dvl_beams", TopicCodec<DvlSample>::Encode(said));
  EXPECT_THAT(read.beams, ::testing::ElementsAre(4.4, std::nullopt, 4.5 / 7.0, std::nullopt));
}

TEST(DvlBeams, OfOthersIsNoReading) { ExpectRefusals("dvl_beams"); }

}  // namespace
}  // namespace limpet
