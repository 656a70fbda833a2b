// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/sharing/output_book.hpp"

namespace limpet {
namespace {

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
