// SPDX-License-Identifier: MIT
#include "limpet/app/mail_journal.hpp"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/durable/failing_file_system.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/torn_disk.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class MailJournalTest : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path File() const { return folder_.path() / "pNav.mail"; }
  [[nodiscard]] static Message Mail(const std::string& name, Value value) {
    return {.name = name,
            .value = std::move(value),
            .time = Seconds(1.5),
            .source = "pOther",
            .source_aux = "part",
            .community = "alpha",
            .id = 7};
  }
  /// Two pieces of mail and a tick between them.
  void LiveOnce() const {
    MailJournal journal(File(), false);
    journal.NoteMail(Mail("DEPTH", 2.5), Seconds(10.0));
    journal.NoteTick(Seconds(10.1));
    journal.NoteMail(Mail("PHASE", std::string("DIVE")), Seconds(10.2));
    journal.Vouch();
  }
  static std::vector<std::string> NamesIn(const MailJournal& journal) {
    std::vector<std::string> names;
    journal.Replay(
        [&names](Seconds, const MessagePtr& mail) { names.push_back(mail ? mail->name : "tick"); });
    return names;
  }
  [[nodiscard]] std::vector<std::string> NamesOfFormerLife() const {
    return NamesIn(MailJournal(File(), true));
  }

  TemporaryFolder folder_{PlaceInMemory()};
};

TEST_F(MailJournalTest, TellsMailAndTicksInOrder) {
  LiveOnce();
  EXPECT_THAT(NamesOfFormerLife(), ElementsAre("DEPTH", "tick", "PHASE"));
}

TEST_F(MailJournalTest, TellsMailAsItWasAndWhen) {
  LiveOnce();
  const MailJournal journal(File(), true);
  std::vector<Seconds> times;
  MessagePtr last;
  journal.Replay([&](Seconds now, const MessagePtr& mail) {
    times.push_back(now);
    last = mail;
  });
  EXPECT_THAT(times, ElementsAre(Seconds(10.0), Seconds(10.1), Seconds(10.2)));
  EXPECT_EQ(std::get<std::string>(last->value), "DIVE");
  EXPECT_EQ(last->source, "pOther");
  EXPECT_EQ(last->source_aux, "part");
  EXPECT_EQ(last->time, Seconds(1.5));
}

TEST_F(MailJournalTest, GoesOnWhereItEnded) {
  LiveOnce();
  {
    MailJournal second(File(), true);
    second.NoteMail(Mail("LATER", 1.0), Seconds(11.0));
    second.Vouch();
  }
  EXPECT_THAT(NamesOfFormerLife(), ElementsAre("DEPTH", "tick", "PHASE", "LATER"));
}

TEST_F(MailJournalTest, BeginsAnewWhenNobodyWentOn) {
  LiveOnce();
  EXPECT_THAT(NamesIn(MailJournal(File(), false)), IsEmpty());
}

TEST_F(MailJournalTest, LeavesOffACutEndWhereverTheCutIs) {
  LiveOnce();
  const auto whole = std::filesystem::file_size(File());
  for (auto size = whole - 1; size > 0; --size) {
    LiveOnce();
    std::filesystem::resize_file(File(), size);
    const std::vector<std::string> names = NamesOfFormerLife();
    EXPECT_LT(names.size(), 3U) << size;
    {
      MailJournal next(File(), true);
      next.NoteTick(Seconds(12.0));
      next.Vouch();
    }
    EXPECT_EQ(NamesOfFormerLife().size(), names.size() + 1) << size;
  }
}

TEST_F(MailJournalTest, IsEmptyAfterNoise) {
  Random random(1, "noise");
  std::string noise(5000, ' ');
  for (char& c : noise) {
    c = static_cast<char>(random.Index(256));
  }
  std::ofstream(File(), std::ios::binary) << noise;
  EXPECT_THAT(NamesOfFormerLife(), IsEmpty());
}

TEST_F(MailJournalTest, SparesAnAppThatDiedOfItTwice) {
  LiveOnce();
  EXPECT_FALSE(NamesOfFormerLife().empty());
  EXPECT_FALSE(NamesOfFormerLife().empty());
  EXPECT_THAT(NamesOfFormerLife(), IsEmpty());
}

TEST_F(MailJournalTest, IsTrustedAgainOnceTheAppHasLived) {
  LiveOnce();
  for (int life = 0; life < 5; ++life) {
    MailJournal journal(File(), true);
    EXPECT_FALSE(NamesIn(journal).empty());
    journal.Vouch();
  }
}

TEST_F(MailJournalTest, IsWithoutAGapWhereverThePowerIsCut) {
  const auto root = folder_.path() / "disk", left = folder_.path() / "left";
  std::filesystem::create_directory(root);
  TornDisk disk(root);
  constexpr int kTicks = 60;
  for (const bool continues : {false, true}) {
    MailJournal journal(root / "pNav.mail", continues, disk);
    journal.Vouch();
    for (int i = continues ? kTicks / 2 : 0; i < (continues ? kTicks : kTicks / 2); ++i) {
      journal.NoteTick(Seconds(i));
      journal.NoteMail(Mail("N", std::string(static_cast<std::size_t>(i), 'x')), Seconds(i));
      journal.Flush();
    }
  }
  Random random(1, "cuts");
  std::size_t longest = 0;
  for (int cut = 0; cut < 100; ++cut) {
    disk.Cut(random.Index(disk.calls() + 1), random, left);
    const MailJournal journal(left / "pNav.mail", true);
    std::size_t found = 0;
    journal.Replay([&found](Seconds now, const MessagePtr& mail) {
      EXPECT_EQ(now, Seconds(static_cast<double>(found / 2)));
      EXPECT_EQ(mail != nullptr, found % 2 == 1);
      ++found;
    });
    longest = std::max(longest, found);
  }
  EXPECT_GT(longest, 0U);
  disk.Cut(disk.calls(), random, left);
  std::size_t entries = 0;
  MailJournal(left / "pNav.mail", true).Replay([&entries](Seconds, const MessagePtr&) {
    ++entries;
  });
  EXPECT_EQ(entries, 2U * kTicks) << "all of it is on the disk at the end";
}

TEST_F(MailJournalTest, SaysSoAndLeavesNoHalfOfItselfOnADiskThatFails) {
  FailingFileSystem disk(RealFileSystem());
  {
    MailJournal journal(File(), false, disk);
    journal.NoteTick(Seconds(1.0));
    journal.Flush();
    EXPECT_TRUE(journal.is_good());
    disk.Set(FailingFileSystem::Fault::kFull);
    while (journal.is_good()) {
      journal.NoteTick(Seconds(2.0));
      journal.Flush();
    }
    EXPECT_EQ(journal.trouble(), "No space left on device");
  }
  EXPECT_THAT(NamesOfFormerLife(), IsEmpty());
}

TEST_F(MailJournalTest, LeavesNoFileAfterAnOrderlyEnd) {
  MailJournal journal(File(), false);
  journal.NoteTick(Seconds(1.0));
  journal.Remove();
  EXPECT_FALSE(std::filesystem::exists(File()));
}

}  // namespace
}  // namespace limpet
