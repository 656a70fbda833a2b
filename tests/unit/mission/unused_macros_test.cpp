// SPDX-License-Identifier: MIT
#include "limpet/mission/unused_macros.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class UnusedMacrosTest : public ::testing::Test {
 protected:
  std::filesystem::path File(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name) << text;
    return folder_.path() / name;
  }
  TemporaryFolder folder_;
};

TEST_F(UnusedMacrosTest, AreNamedWithTheirLineAndTheNearestThatIsUsed) {
  File("part.moos", "#ifdef KEEP_OUT\nkeep_out = $(KEEP_OUT)\n#endif\n");
  const auto notes = UnusedMacros(File("m.moos",
                                       "Community = a\n#define KEEP_OUTT pts={0,0:1,0:1,1}\n"
                                       "#include part.moos\n"));
  ASSERT_THAT(notes, SizeIs(1));
  EXPECT_EQ(notes[0].problem.where.line, 2);
  EXPECT_FALSE(notes[0].is_beyond_its_series);
  EXPECT_THAT(notes[0].problem.text, HasSubstr("`KEEP_OUTT`; nearest that is: `KEEP_OUT`"));
}

TEST_F(UnusedMacrosTest, AreNoneOfThoseThatAnUntakenBranchADefaultOrAnotherMacroUses) {
  File("A.part", "x = %(UPPER) $(SPEED:=1.4) $(OUTER$(INNER))\n");
  EXPECT_THAT(
      UnusedMacros(File("m.moos",
                        "#define NAME A\n#define UPPER a\n#define SPEED 1\n"
                        "#define INNER b\n#define BASE 2\n#define SUM $(BASE)\n"
                        "#define THERE\n#define OTHER 3\n"
                        "#include \"$(NAME).part\"\n"
                        "#ifdef NOWHERE\ny = $(SUM)\n#elseifdef OTHER 4 || THERE\n#endif\n")),
      IsEmpty());
}

TEST_F(UnusedMacrosTest, OfANumberedSeriesAreToldFromThoseThatOnlyHaveANumber) {
  File("part.moos",
       "#ifdef ZONE\na = $(ZONE)\n#endif\n#ifdef ZONE_2\na = $(ZONE_2)\n#endif\n"
       "#ifdef ZONE_FILE\n#include $(ZONE_FILE)\n#endif\nb = $(DEPTH)\n");
  const auto unused = UnusedMacros(File(
      "m.moos", "#define ZONE_10 x\n#define ZONE_1 x\n#define DEPTH_2 x\n#include part.moos\n"));
  ASSERT_THAT(unused, SizeIs(3));
  EXPECT_TRUE(unused[0].is_beyond_its_series);
  EXPECT_THAT(unused[0].problem.text,
              HasSubstr("of its series these are: ZONE_2, ZONE, ZONE_FILE"));
  EXPECT_TRUE(unused[1].is_beyond_its_series);
  EXPECT_FALSE(unused[2].is_beyond_its_series) << "nothing reads any other number of it";
}

TEST_F(UnusedMacrosTest, AreNoneOfAFileThatIsNotThere) {
  EXPECT_THAT(UnusedMacros(folder_.path() / "none.moos"), IsEmpty());
}

}  // namespace
}  // namespace limpet
