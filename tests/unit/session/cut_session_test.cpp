// SPDX-License-Identifier: MIT
#include "limpet/session/cut_session.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

class CutSessionTest : public ::testing::Test {
 protected:
  CutSessionTest() {
    fs::create_directories(folder_.path() / "session");
    std::ofstream(folder_.path() / "session" / "manifest.json") << "{}";
  }
  TemporaryFolder folder_;
};

TEST_F(CutSessionTest, IsNoneAfterAnOrderlyEnd) {
  EXPECT_FALSE(JournalOf(folder_.path()));
  EXPECT_FALSE(CutNote(folder_.path()));
  EXPECT_FALSE(CutNote(folder_.path() / "nowhere"));
}

TEST_F(CutSessionTest, IsKnownByItsJournalHoweverItIsNamed) {
  const fs::path journal = folder_.path() / "pSession.mail";
  std::ofstream(journal) << "x";
  EXPECT_EQ(JournalOf(folder_.path()), journal);
  EXPECT_EQ(JournalOf(folder_.path() / "session"), journal);
  EXPECT_EQ(JournalOf(folder_.path() / "session" / ""), journal);
  EXPECT_THAT(CutNote(folder_.path()).value(), testing::HasSubstr("limpet session recover "));
}

}  // namespace
}  // namespace limpet
