// SPDX-License-Identifier: MIT
#include "limpet/app/embedded.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "limpet/app/app_tick.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/core/require.hpp"
#include "limpet/mission/stand_ins.hpp"

namespace limpet {
namespace {

constexpr int kMaxDeliveriesPerInstant =
    1'000'000;  // two apps answering each other for ever are a bug

}  // namespace

class EmbeddedCommunity::Impl {
 public:
  explicit Impl(EmbeddedSetup setup) : setup_(std::move(setup)), database_(setup_.community) {
    std::vector<ConfigProblem> problems;
    for (const std::string& name : setup_.apps) {
      try {
        AddApp(name);
      } catch (const ConfigError& error) {
        std::ranges::copy(error.problems(), std::back_inserter(problems));
      }
    }
    if (!problems.empty()) {
      throw ConfigError(problems);
    }
  }

  void Step() {
    const auto next = std::ranges::min_element(
        hosted_, {}, [](const std::unique_ptr<Hosted>& hosted) { return hosted->NextTick(); });
    LIMPET_REQUIRE(next != hosted_.end(), "a community needs an app");
    Hosted& hosted = **next;
    elapsed_ = hosted.NextTick();
    ++hosted.ticks;
    if (!hosted.is_stalled) {
      hosted.app->Iterate(now());
      DeliverAll();
    }
  }

  void Stall(const std::string& app, bool hangs) {
    const auto found =
        std::ranges::find_if(hosted_, [&app](const auto& hosted) { return hosted->name == app; });
    LIMPET_REQUIRE(found != hosted_.end(), "only an app that is hosted can hang");
    (*found)->is_stalled = hangs;
  }

  void StallDatabase(bool hangs) {
    is_database_stalled_ = hangs;
    if (!hangs) {
      for (Message& message : std::exchange(held_, {})) {
        Write(std::move(message));
      }
      DeliverAll();
    }
  }

  /// Writes to the database, and tells the message to whoever observes it.
  void Write(Message message) {
    const std::string variable = message.name;
    const Database::WriteResult result = database_.Write(std::move(message), now());
    LIMPET_REQUIRE(result == Database::WriteResult::kStored, "a variable changed its data type");
    if (!observers_.empty()) {
      const MessagePtr latest = database_.Latest(variable);
      for (const auto& observer : observers_) {
        observer(*latest);
      }
    }
  }

  void Publish(const std::string& source, std::string name, Value value, std::string aux) {
    Message message{.name = std::move(name),
                    .value = std::move(value),
                    .time = now(),
                    .source = source,
                    .source_aux = std::move(aux),
                    .community = {}};
    if (is_database_stalled_) {
      held_.push_back(std::move(message));
    } else {
      Write(std::move(message));
    }
  }

  void DeliverAll() {
    if (is_database_stalled_) {
      return;
    }
    int deliveries = 0;
    for (bool is_quiet = false; !is_quiet;) {
      is_quiet = true;
      for (const auto& hosted : hosted_) {
        if (hosted->is_stalled || !database_.HasMail(hosted->client)) {
          continue;
        }
        is_quiet = false;
        for (const MessagePtr& message : database_.TakeMail(hosted->client)) {
          LIMPET_REQUIRE(++deliveries < kMaxDeliveriesPerInstant,
                         "mail without end at one instant");
          if (!setup_.may_hear || setup_.may_hear(hosted->name, message->name)) {
            hosted->app->Deliver(message);
          }
        }
      }
    }
  }

  void Finish() {
    for (const auto& hosted : hosted_) {
      if (!hosted->is_stalled) {
        hosted->app->End(now());
        DeliverAll();
      }
    }
  }

  [[nodiscard]] Seconds now() const { return setup_.start + Seconds(elapsed_); }

  EmbeddedSetup setup_;
  FailingFileSystem disk_{RealFileSystem()};
  Database database_;
  double elapsed_ = 0.0;
  std::vector<std::function<void(const Message&)>> observers_;
  bool is_database_stalled_ = false;
  std::vector<Message> held_;  ///< written while the database hangs

 private:
  struct Hosted final : AppLink {
    void Publish(std::string variable, Value value, std::string source_aux) override {
      community->Publish(name, std::move(variable), std::move(value), std::move(source_aux));
    }
    void Subscribe(const std::string& variable, Seconds interval) override {
      community->database_.Subscribe(client, variable, interval, community->now());
    }
    void SubscribeWildcard(const WildcardFilter& filter) override {
      community->database_.SubscribeWildcard(client, filter, community->now());
    }
    [[nodiscard]] Seconds Now() const override { return community->now(); }
    /// k / rate, not k * period: ticks of apps at 10 and 50 Hz then fall on the same double.
    [[nodiscard]] double NextTick() const { return static_cast<double>(ticks + 1) / tick_hz; }

    Impl* community = nullptr;
    Database::Client client = 0;
    std::string name;
    double tick_hz = 4.0;
    std::int64_t ticks = 0;
    bool is_stalled = false;
    std::unique_ptr<App> app;
  };

  void AddApp(const std::string& name) {
    const auto entry = AppRegistry().find(OwnNameOf(name));
    if (entry == AppRegistry().end()) {
      std::vector<std::string> known;
      std::ranges::transform(AppRegistry(), std::back_inserter(known),
                             [](const auto& registered) { return registered.first; });
      throw ConfigError(
          {{},
           "Run",
           fmt::format("no app `{}`; nearest known: `{}`", name, NearestWord(name, known))});
    }
    const auto block = std::ranges::find_if(
        setup_.blocks, [&name](const ConfigBlock& b) { return EqualsIgnoringCase(b.name, name); });
    const ConfigBlock defaults{.name = name, .where = {}, .entries = {}};
    const ConfigBlock& config = block == setup_.blocks.end() ? defaults : *block;
    const std::optional<Database::Client> client = database_.Connect(name);
    if (!client) {
      throw ConfigError({config.where, "Run", fmt::format("app `{}` is launched twice", name)});
    }
    auto hosted = std::make_unique<Hosted>();
    hosted->community = this;
    hosted->client = *client;
    hosted->name = name;
    hosted->tick_hz = AppTickRate(config, entry->second.default_tick_hz);
    CastSettings casts = ReadCastSettings(config);
    hosted->app = entry->second.create(ContextFor(name, hosted.get()), config);
    hosted->app->StartReporting(std::move(casts));
    hosted_.push_back(std::move(hosted));
  }

  AppContext ContextFor(const std::string& name, AppLink* link) {
    return {.name = name,
            .link = link,
            .globals = setup_.globals,
            .mission_folder = setup_.mission_folder,
            .run_folder = setup_.run_folder,
            .prior_folder = setup_.prior_folder,
            .session = setup_.session,
            .seed = setup_.seed,
            .disk = &disk_,
            .blocks = setup_.blocks};
  }

  std::vector<std::unique_ptr<Hosted>> hosted_;
};

EmbeddedCommunity::EmbeddedCommunity(EmbeddedSetup setup)
    : impl_(std::make_unique<Impl>(std::move(setup))) {}
EmbeddedCommunity::~EmbeddedCommunity() = default;
void EmbeddedCommunity::Step() { impl_->Step(); }
void EmbeddedCommunity::Poke(const std::string& name, Value value) {
  impl_->Publish("operator", name, std::move(value), "");
  impl_->DeliverAll();
}
void EmbeddedCommunity::Stall(const std::string& app, bool hangs) { impl_->Stall(app, hangs); }
void EmbeddedCommunity::StallDatabase(bool hangs) { impl_->StallDatabase(hangs); }
void EmbeddedCommunity::FailDisk(FailingFileSystem::Fault fault) { impl_->disk_.Set(fault); }
void EmbeddedCommunity::LimitDisk(std::optional<std::uint64_t> bytes) {
  impl_->disk_.SetRoom(bytes);
}
void EmbeddedCommunity::Observe(std::function<void(const Message&)> observer) {
  impl_->observers_.push_back(std::move(observer));
}
void EmbeddedCommunity::Finish() { impl_->Finish(); }
Seconds EmbeddedCommunity::now() const { return impl_->now(); }
Seconds EmbeddedCommunity::elapsed() const { return Seconds(impl_->elapsed_); }
const Database& EmbeddedCommunity::database() const { return impl_->database_; }

}  // namespace limpet
