// SPDX-License-Identifier: MIT
// What is a slip of the pen, and what is somebody else's name.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

const std::vector<std::string> kKnown{"pHelm", "pNav", "pMap", "pSurvey", "uSimCamera", "pLog"};

struct Written {
  const char* name;
  const char* word;
  const char* meant;
};

class NameCheck : public ::testing::TestWithParam<Written> {};

TEST_P(NameCheck, TellsASlipFromAnotherName) {
  EXPECT_EQ(SlipOf(GetParam().word, kKnown), GetParam().meant);
}

INSTANTIATE_TEST_SUITE_P(
    Names, NameCheck,
    ::testing::Values(Written{"Known", "pHelm", ""}, Written{"KnownInOtherLetters", "phelm", ""},
                      Written{"OneLetterWrong", "pHeln", "pHelm"},
                      Written{"OneLetterLess", "pSurey", "pSurvey"},
                      Written{"OneLetterMore", "pSurveyy", "pSurvey"},
                      Written{"TwoLettersChangedPlaces", "pSruvey", "pSurvey"},
                      Written{"ALongWordMayHaveTwoWrong", "uSimKamara", "uSimCamera"},
                      Written{"AShortWordMayNot", "pRealm", ""},
                      Written{"AStranger", "pMarineViewer", ""}, Written{"Nothing", "", ""}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(NameCheck, MakesNoSlipOfAWordWhereNothingIsKnown) { EXPECT_EQ(SlipOf("pHeln", {}), ""); }

}  // namespace
}  // namespace limpet::internal
