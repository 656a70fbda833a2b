// SPDX-License-Identifier: MIT
// What must hold of shared messages, of the window against replays and of routes, for any traffic.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/sharing/output_book.hpp"
#include "limpet/sharing/replay_window.hpp"
#include "limpet/sharing/secure_channel.hpp"
#include "limpet/sharing/share_datagram.hpp"

namespace limpet {
namespace {

/// A message whose texts lie in `texts`.
WireMessage DrawMessage(Random& random, std::vector<std::string>& texts) {
  const auto draw = [&random](std::uint64_t longest) {
    std::string text;
    for (std::uint64_t i = random.Index(longest) + 1; i > 0; --i)
      text += static_cast<char>('A' + random.Index(26));
    return text;
  };
  texts = {draw(30), draw(30), draw(30), draw(2000), draw(20)};
  const bool is_text = random.Chance(0.5);
  return {.id = static_cast<std::int32_t>(random.Index(1000)),
          .data_type = is_text ? wire_data::kString : wire_data::kDouble,
          .source = texts[0],
          .source_aux = texts[4],
          .community = texts[1],
          .key = texts[2],
          .time = random.Uniform(0.0, 2e9),
          .number = is_text ? -1.0 : random.Normal(1e6),
          .text = is_text ? std::string_view(texts[3]) : std::string_view()};
}

TEST(ShareProperties, EveryMessageComesBackWhole) {
  Random random(111);
  std::vector<std::string> texts;
  for (int i = 0; i < 300; ++i) {
    const WireMessage sent = DrawMessage(random, texts);
    const auto bytes = EncodeShare(sent);
    ASSERT_TRUE(bytes);
    const auto back = DecodeShare(*bytes);
    ASSERT_TRUE(back) << back.error().text;
    EXPECT_EQ(back->key, sent.key);
    EXPECT_EQ(back->source, sent.source);
    EXPECT_EQ(back->source_aux, sent.source_aux);
    EXPECT_EQ(back->community, sent.community);
    EXPECT_EQ(back->text, sent.text);
    EXPECT_EQ(back->time, sent.time);
    EXPECT_EQ(back->number, sent.number);
  }
}

TEST(ShareProperties, TheLargestMessageIsSentWholeAndOneByteMoreIsRefusedWithAReason) {
  const auto encode = [](std::size_t size) {
    const std::string text(size, 'x');
    return EncodeShare({.data_type = wire_data::kString, .key = "X", .text = text});
  };
  std::size_t fits = 1, too_large = kLargestShare + 1;
  ASSERT_TRUE(encode(fits));
  while (too_large - fits > 1) {
    const std::size_t middle = (fits + too_large) / 2;
    (encode(middle) ? fits : too_large) = middle;
  }
  EXPECT_EQ(encode(fits)->size(), kLargestShare);
  EXPECT_FALSE(encode(too_large).error().text.empty());
  EXPECT_TRUE(DecodeShare(*encode(fits)));
}

TEST(ReplayWindowProperties, TakesEachCounterOnceAndNoneThatIsTooFarBehind) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed, "counters");
    ReplayWindow window;
    std::set<std::uint64_t> taken;
    std::uint64_t top = random.Index(5000);
    for (int i = 0; i < 1000; ++i) {
      const std::uint64_t behind = random.Index(1400);
      const std::uint64_t counter = random.Chance(0.3) ? top + random.Index(5)
                                    : top > behind     ? top - behind
                                                       : 0;
      const std::uint64_t highest = taken.empty() ? counter : *taken.rbegin();
      const bool is_new = !taken.contains(counter) && (counter > highest || taken.empty() ||
                                                       highest - counter < ReplayWindow::kWidth);
      ASSERT_EQ(window.IsNew(counter), is_new) << counter << " at " << highest;
      if (!is_new) continue;
      window.Take(counter);
      taken.insert(counter);
      top = std::max(top, counter);
    }
  }
}

TEST(ReplayWindowProperties, TheHighestCounterThereIsDoesNotWrapIt) {
  constexpr std::uint64_t kTop = std::numeric_limits<std::uint64_t>::max();
  ReplayWindow window;
  window.Take(3);
  EXPECT_TRUE(window.IsNew(kTop));
  window.Take(kTop);
  EXPECT_FALSE(window.IsNew(kTop));
  EXPECT_FALSE(window.IsNew(0));
  EXPECT_TRUE(window.IsNew(kTop - ReplayWindow::kWidth + 1));
  EXPECT_FALSE(window.IsNew(kTop - ReplayWindow::kWidth));
}

TEST(ShareKeyProperties, EveryKeyComesBackFromItsTextAndNoDigitOfItMayBeWrong) {
  Random random(112);
  for (int i = 0; i < 40; ++i) {
    ShareKey::Bytes bytes{};
    for (unsigned char& byte : bytes)
      byte = static_cast<unsigned char>(random.Index(256));
    const ShareKey key(bytes);
    const auto back = ShareKey::Parse(key.Text());
    ASSERT_TRUE(back) << back.error().text;
    EXPECT_EQ(back->bytes(), bytes);
    std::string wrong = key.Text();
    char& digit = wrong[wrong.find("limpet-key-1 ") + 13 + random.Index(64)];
    digit = digit == 'f' ? '0' : 'f';
    EXPECT_FALSE(ShareKey::Parse(wrong));
  }
}

TEST(ShareKeyProperties, AKeyFilesBlankLinesAndCommentsDoNotMatter) {
  const ShareKey key = ShareKey::Random();
  EXPECT_EQ(ShareKey::Parse("\n# of the fleet\n\n" + key.Text() + "\n\n")->bytes(), key.bytes());
}

TEST(ShareReceivers, ACommunityStandsForItsPShareAndNoTwoNamesForOne) {
  EXPECT_EQ(ShareNodeName("shore"), "shore/pShare");
  EXPECT_EQ(ShareNodeName("shore/pOther"), "shore/pOther");
  EXPECT_EQ(ShareReceiverId("shore"), ShareReceiverId("shore/pShare"));
  std::set<std::uint64_t> ids;
  for (int i = 0; i < 2000; ++i)
    EXPECT_TRUE(ids.insert(ShareReceiverId("vehicle_" + std::to_string(i))).second);
  EXPECT_FALSE(ids.contains(0)) << "zero is for questions and answers";
}

ShareOutput RouteOf(const std::string& source, double max_hz) {
  return {.source = source,
          .dest = source,
          .address = {.host = "shore", .port = 9200, .channel = {}},
          .max_hz = max_hz,
          .duration = {},
          .max_shares = {},
          .security = {}};
}

Message WriteOf(const std::string& name) {
  Message message;
  message.name = name;
  message.source = "pNav";
  return message;
}

TEST(OutputBookProperties, NeverSendsFasterThanItsRateNorSlowerThanTheWritesAllow) {
  for (const double max_hz : {0.5, 1.0, 4.0, 10.0}) {
    Random random(113);
    OutputBook book;
    ASSERT_EQ(book.Add(RouteOf("X", max_hz), Seconds(0.0)), OutputBook::Added::kNew);
    std::optional<double> last;
    double now = 0.0;
    for (int i = 0; i < 500; ++i) {
      now += random.Uniform(0.0, 0.3);
      const bool is_sent = !book.TakeDue(WriteOf("X"), Seconds(now)).empty();
      const double since = last ? now - *last : 1e9;
      if (std::abs(since * max_hz - 1.0) > 1e-9) {
        EXPECT_EQ(is_sent, since * max_hz > 1.0) << since << " s at " << max_hz << " Hz";
      }
      if (is_sent) last = now;
    }
  }
}

TEST(OutputBookProperties, APatternSharesWhatARouteOfEachNameWouldShare) {
  Random random(114);
  OutputBook by_pattern, by_name;
  ShareOutput pattern = RouteOf("NAV_*", 0.0);
  pattern.dest = "";
  ASSERT_EQ(by_pattern.Add(pattern, Seconds(0.0)), OutputBook::Added::kNew);
  const std::vector<std::string> names{"NAV_X", "NAV_Y", "MODE", "NAVX", "NAV_"};
  for (const std::string& name : names) {
    if (!name.starts_with("NAV_")) continue;
    ASSERT_EQ(by_name.Add(RouteOf(name, 0.0), Seconds(0.0)), OutputBook::Added::kNew);
  }
  for (int i = 0; i < 200; ++i) {
    const Message message = WriteOf(names[random.Index(names.size())]);
    const auto a = by_pattern.TakeDue(message, Seconds(i)),
               b = by_name.TakeDue(message, Seconds(i));
    ASSERT_EQ(a.size(), b.size()) << message.name;
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_EQ(a[k].dest, b[k].dest);
      EXPECT_EQ(a[k].address, b[k].address);
    }
  }
}

}  // namespace
}  // namespace limpet
