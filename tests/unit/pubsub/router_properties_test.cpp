// SPDX-License-Identifier: MIT
// The router against a plain model of it: whatever is asked in whatever order, both deliver the
// same to the same.
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/pubsub/router.hpp"

namespace limpet {
namespace {

const std::array<std::string, 4> kClientNames{"pNav", "pHelm", "uScope", "pLog"};
const std::array<std::string, 5> kVariableNames{"NAV_X", "NAV_Y", "MODE", "A", "NAV_DEPTH"};
const std::array<std::string, 5> kPatterns{"*", "NAV_*", "?", "*A*", "MODE"};
const std::array<std::string, 3> kAppPatterns{"*", "p*", "uScope"};

/// One way of what MOOS says of subscriptions, with no thought of speed.
class PlainRouter {
 public:
  void Disconnect(const std::string& client) {
    filters_.erase(client);
    for (auto& [name, variable] : variables_)
      variable.subscribers.erase(client);
  }
  bool Subscribe(const std::string& client, const std::string& name, double interval, double now) {
    Variable& variable = variables_[name];
    const bool has_value = variable.type != '~';
    variable.subscribers[client] = {interval, has_value ? std::optional(now) : std::nullopt};
    return has_value;
  }
  void Unsubscribe(const std::string& client, const std::string& name) {
    variables_[name].subscribers.erase(client);
  }
  std::vector<std::string> SubscribeWildcard(const std::string& client,
                                             const WildcardFilter& filter, double now) {
    filters_[client].push_back(filter);
    std::vector<std::string> to_send;
    for (auto& [name, variable] : variables_) {
      if (!Matches(filter, name, variable.writer)) continue;
      if (Subscribe(client, name, filter.interval.value(), now)) to_send.push_back(name);
    }
    return to_send;
  }
  void UnsubscribeWildcard(const std::string& client, const WildcardFilter& filter) {
    std::erase_if(filters_[client], [&](const WildcardFilter& kept) {
      return kept.app_pattern == filter.app_pattern &&
             kept.variable_pattern == filter.variable_pattern;
    });
    for (auto& [name, variable] : variables_) {
      if (Matches(filter, name, variable.writer)) variable.subscribers.erase(client);
    }
  }
  /// Who gets it, by name; nothing: it is refused.
  std::optional<std::vector<std::string>> Write(const std::string& name, char type,
                                                const std::string& source, double now) {
    Variable& variable = variables_[name];
    if (variable.type != '~' && variable.type != type) return std::nullopt;
    if (variable.type == '~') Meet(name, variable, source);
    variable.type = type;
    variable.writer = source;
    std::vector<std::string> due;
    for (auto& [client, subscriber] : variable.subscribers) {
      const bool is_due = subscriber.interval <= 0.0 || !subscriber.last ||
                          now - *subscriber.last >= subscriber.interval;
      if (!is_due) continue;
      subscriber.last = now;
      due.push_back(client);
    }
    return due;
  }
  void Clear() {
    for (auto& [name, variable] : variables_)
      variable.type = '~', variable.writer.clear();
  }
  [[nodiscard]] std::vector<std::string> SubscriptionsOf(const std::string& client) const {
    std::vector<std::string> names;
    for (const auto& [name, variable] : variables_) {
      if (variable.subscribers.contains(client)) names.push_back(name);
    }
    return names;
  }

 private:
  struct Subscriber {
    double interval = 0.0;
    std::optional<double> last;
  };
  struct Variable {
    char type = '~';
    std::string writer;
    std::map<std::string, Subscriber> subscribers;
  };
  static bool Matches(const WildcardFilter& filter, const std::string& name,
                      const std::string& writer) {
    return MatchesWildcard(filter.variable_pattern, name) &&
           MatchesWildcard(filter.app_pattern, writer);
  }
  void Meet(const std::string& name, Variable& variable, const std::string& source) {
    for (const auto& [client, filters] : filters_) {
      const auto filter = std::ranges::find_if(
          filters, [&](const WildcardFilter& f) { return Matches(f, name, source); });
      if (filter == filters.end() || variable.subscribers.contains(client)) continue;
      variable.subscribers[client] = {filter->interval.value(), std::nullopt};
    }
  }
  std::map<std::string, Variable> variables_;
  std::map<std::string, std::vector<WildcardFilter>> filters_;
};

class RouterProperties : public ::testing::TestWithParam<int> {
 protected:
  template <std::size_t n>
  const std::string& Any(const std::array<std::string, n>& names) {
    return names[random_.Index(n)];
  }
  std::string NameOf(Router::Variable variable) const { return router_.Info(variable).name; }

  void ComeOrGo() {
    const std::string& name = Any(kClientNames);
    if (ids_.contains(name)) {
      EXPECT_FALSE(router_.Connect(name)) << "a name in use";
      router_.Disconnect(ids_.at(name));
      plain_.Disconnect(name);
      ids_.erase(name);
      return;
    }
    const std::optional<Router::Client> id = router_.Connect(name);
    ASSERT_TRUE(id);
    for (const auto& [other, taken] : ids_)
      EXPECT_NE(*id, taken) << name << " and " << other;
    ids_[name] = *id;
  }
  void Ask(const std::string& client) {
    const std::string& name = Any(kVariableNames);
    const double interval = random_.Chance(0.5) ? 0.0 : random_.Uniform(0.0, 3.0);
    const WildcardFilter filter{Any(kAppPatterns), Any(kPatterns), Seconds(interval)};
    switch (random_.Index(4)) {
      case 0:
        EXPECT_EQ(router_.Subscribe(ids_.at(client), router_.Intern(name), Seconds(interval), now_),
                  plain_.Subscribe(client, name, interval, now_.value()));
        break;
      case 1:
        router_.Unsubscribe(ids_.at(client), router_.Intern(name));
        plain_.Unsubscribe(client, name);
        break;
      case 2: {
        std::vector<std::string> sent;
        for (const Router::Variable id : router_.SubscribeWildcard(ids_.at(client), filter, now_))
          sent.push_back(NameOf(id));
        EXPECT_EQ(sent, plain_.SubscribeWildcard(client, filter, now_.value()));
        break;
      }
      default:
        router_.UnsubscribeWildcard(ids_.at(client), filter);
        plain_.UnsubscribeWildcard(client, filter);
    }
  }
  void Write() {
    const std::string& name = Any(kVariableNames);
    const std::string& source = Any(kClientNames);
    const char type = random_.Chance(0.8) ? 'D' : 'S';
    std::vector<std::string> told;
    const Router::WriteResult result =
        router_.Write(router_.Intern(name), type, source, now_,
                      [&](Router::Client client) { told.push_back(router_.NameOf(client)); });
    const auto expected = plain_.Write(name, type, source, now_.value());
    ASSERT_EQ(result == Router::WriteResult::kStored, expected.has_value());
    EXPECT_EQ(told, expected.value_or(std::vector<std::string>{}))
        << name << " at " << now_.value();
  }
  void Step() {
    now_ = now_ + Seconds(random_.Uniform(0.0, 1.0));
    const double what = random_.Uniform(0.0, 1.0);
    if (what < 0.1) {
      ComeOrGo();
    } else if (what < 0.5 && !ids_.empty()) {
      auto client = ids_.begin();
      std::advance(client, static_cast<std::ptrdiff_t>(random_.Index(ids_.size())));
      Ask(std::string(client->first));
    } else if (what < 0.98) {
      Write();
    } else {
      router_.Clear();
      plain_.Clear();
    }
  }

  Random random_{static_cast<std::uint64_t>(GetParam()), "router"};
  Router router_;
  PlainRouter plain_;
  std::map<std::string, Router::Client> ids_;
  Seconds now_;
};

TEST_P(RouterProperties, DeliversWhatThePlainModelDelivers) {
  for (int i = 0; i < 400; ++i) {
    Step();
    if (HasFailure()) return;
  }
  for (const auto& [name, id] : ids_) {
    std::vector<std::string> subscriptions = router_.SubscriptionsOf(id);
    EXPECT_EQ(subscriptions, plain_.SubscriptionsOf(name)) << name;
  }
}

TEST_P(RouterProperties, CountsEveryWriteAndKeepsWhoWrote) {
  std::map<std::string, std::uint64_t> writes;
  std::map<std::string, std::vector<std::string>> writers;
  for (int i = 0; i < 200; ++i) {
    const std::string name = Any(kVariableNames), source = Any(kClientNames);
    const auto result = router_.Write(router_.Intern(name), 'D', source, now_, [](auto) {});
    ASSERT_EQ(result, Router::WriteResult::kStored);
    ++writes[name];
    if (std::ranges::count(writers[name], source) == 0) writers[name].push_back(source);
    std::ranges::sort(writers[name]);
  }
  for (const auto& [name, count] : writes) {
    const Router::VariableInfo& info = router_.Info(*router_.Find(name));
    EXPECT_EQ(info.writes, count);
    EXPECT_EQ(info.writers, writers[name]);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RouterProperties, ::testing::Range(1, 21));

TEST(Router, ANameThatIsNoneOrInUseIsRefusedAndFreeAgainAfterwards) {
  Router router;
  EXPECT_FALSE(router.Connect(""));
  const auto first = router.Connect("pNav");
  ASSERT_TRUE(first);
  EXPECT_FALSE(router.Connect("pNav"));
  router.Disconnect(*first);
  EXPECT_TRUE(router.Connect("pNav"));
}

TEST(Router, WhoTakesTheSeatOfOneThatLeftInheritsNothing) {
  Router router;
  const auto first = *router.Connect("pNav");
  EXPECT_FALSE(router.Subscribe(first, router.Intern("X"), Seconds(0.0), Seconds(0.0)));
  EXPECT_TRUE(router.SubscribeWildcard(first, {}, Seconds(0.0)).empty());
  router.Disconnect(first);
  const auto second = *router.Connect("pHelm");
  EXPECT_EQ(second, first) << "the seat is used again";
  EXPECT_TRUE(router.SubscriptionsOf(second).empty());
  EXPECT_EQ(router.FilterCount(second), 0U);
  int told = 0;
  router.Write(router.Intern("X"), 'D', "pLog", Seconds(1.0), [&](auto) { ++told; });
  router.Write(router.Intern("NEW"), 'D', "pLog", Seconds(1.0), [&](auto) { ++told; });
  EXPECT_EQ(told, 0);
}

}  // namespace
}  // namespace limpet
