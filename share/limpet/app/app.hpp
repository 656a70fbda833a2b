// SPDX-License-Identifier: MIT
// An app: mail in, Tick, mail out. It knows no transport, reads no clock and owns no thread, so the
// same class runs embedded on virtual time and as a process of a community.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "limpet/app/app_caster.hpp"
#include "limpet/app/app_warnings.hpp"
#include "limpet/app/report_lines.hpp"
#include "limpet/app/stamp_guard.hpp"
#include "limpet/app/warning_board.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/message.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/durable/file_system.hpp"
#include "limpet/pubsub/database.hpp"
#include "limpet/topics/event.hpp"
#include "limpet/topics/topic.hpp"
#include "limpet/topics/warning.hpp"

namespace limpet {

/// The transport seam: what an app needs from whatever carries its mail (embedded database, TCP, a
/// journal).
class AppLink {
 public:
  virtual ~AppLink() = default;
  /// Sends a write; source, time and community are filled in.
  virtual void Publish(std::string name, Value value, std::string source_aux) = 0;
  /// Sends a write as it is: its source, time and community are kept where the transport can do
  /// that. Another community's, or what was measured a moment ago.
  virtual void Forward(const Message& message) {
    Publish(message.name, message.value, message.source_aux);
  }
  virtual void Subscribe(const std::string& name, Seconds interval) = 0;
  virtual void SubscribeWildcard(const WildcardFilter& filter) = 0;
  /// MOOS time: seconds since 1970 times warp, by the vehicle's clock, which never steps.
  [[nodiscard]] virtual Seconds Now() const = 0;
  /// How far the database's clock has run away from Now() (real time).
  [[nodiscard]] virtual Seconds ClockDisagreement() const { return Seconds(0.0); }
  /// True while the app goes through the mail of its former life (mail_journal.hpp): nothing that
  /// it publishes is sent, and what it did to files is done.
  [[nodiscard]] virtual bool is_replaying() const { return false; }
  /// Has the app's `Attend` called soon. From any thread; live only.
  virtual void Wake() {}
};

/// Everything an app is handed at construction.
struct AppContext {
  std::string name;  ///< MOOS name; names its block, its mail and its random stream
  AppLink* link = nullptr;
  std::vector<ConfigEntry> globals;  ///< of the mission file, first wins: Community, LatOrigin, ...
  std::filesystem::path mission_folder;  ///< where relative file parameters start
  std::filesystem::path mission_file{};  ///< as launched; empty if embedded
  std::filesystem::path run_folder;      ///< this session's output
  std::filesystem::path prior_folder;    ///< former session to load; empty if none
  std::string session;                   ///< discovery, change, ...
  std::uint64_t seed = 1;
  /// True in a process of a community, on real time: what must not wait for a disk has a thread
  /// then. False embedded: one thread, virtual time, same bits.
  bool runs_live = false;
  /// True if the launcher started this process again after it had failed: what it did in its former
  /// life is done, and others count on it.
  bool is_restarted = false;
  /// True if it lives only to bring to an end what a cut left undone (cut_life.hpp).
  bool ends_cut_life = false;
  /// True if who hosts the app makes the faults of a scenario that no app of it makes.
  bool makes_host_faults = false;
  double warp = 1.0;  ///< MOOS time per real time
  /// What files are written through; embedded it fails when the scenario says so.
  FileSystem* disk = &RealFileSystem();
  /// Every block of the mission as this run reads it: plugs expanded, settings of the command line
  /// in place.
  std::vector<ConfigBlock> blocks{};

  /// Value of a mission global, or "".
  [[nodiscard]] std::string Global(std::string_view key) const;
};

/// Base of all apps. One thread runs callbacks and Tick, so an app has no locks.
class App {
 public:
  explicit App(const AppContext& context);
  virtual ~App() = default;
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// Called at AppTick (default: the registered rate), after all mail up to `now`.
  virtual void Tick(Seconds now) { static_cast<void>(now); }
  /// Called after mail, and soon after AppLink::Wake: for an app that waits for more than mail.
  virtual void Attend(Seconds now) { static_cast<void>(now); }
  /// Called once at an orderly end, after the last mail.
  virtual void Finish(Seconds now) { static_cast<void>(now); }
  /// The body of the report that operators see (APPCAST); made only when somebody looks.
  virtual void Report(ReportLines& report) const { static_cast<void>(report); }

  /// Hands one message to its handlers. For the runner.
  void Deliver(const MessagePtr& message);
  /// Answers APPCAST_REQ from now on. For the runner, before the first mail.
  void StartReporting(CastSettings settings);
  /// Tick, and the report if one is due. For the runner.
  void Iterate(Seconds now);
  /// Finish, and embedded the last report: it stays in the log. For the runner.
  void End(Seconds now);
  /// The journal that a successor would go through is lost, and why. For the runner.
  void NoteJournalLost(const std::string& why);
  [[nodiscard]] std::int64_t iteration() const { return iteration_; }
  [[nodiscard]] const std::string& name() const { return context_.name; }
  /// Variables that it hears and can do without.
  [[nodiscard]] const std::set<std::string>& dispensable() const { return dispensable_; }
  /// Warnings that stand now, by id.
  [[nodiscard]] const std::map<std::string, StandingWarning>& warnings() const {
    return warnings_.standing();
  }

 protected:
  /// Calls `handler` for each message of `topic`. Text that does not decode raises a warning.
  /// What is stamped in the future is refused, counted, and raises STAMP_FROM_FUTURE_<name> until
  /// the variable's stamps are right again. A command comes with the time of its reception.
  /// `interval` > 0 drops messages that come sooner.
  template <class A, class T>
  void Subscribe(const Topic<T>& topic, void (A::*handler)(const Stamped<T>&),
                 Seconds interval = Seconds(0.0)) {
    AddHandler(
        topic.name, interval,
        [this, handler, is_command = topic.is_command](const MessagePtr& message) {
          if (!is_command && !HasUsableStamp(message->name, message->time, message->source)) {
            return;
          }
          std::optional<T> value = TopicCodec<T>::Decode(message->value);
          if (!value) {
            Warn(warnings::kBadMail.Of(message->name),
                 "does not decode; sent by " + message->source);
            return;
          }
          ClearWarning(warnings::kBadMail, message->name);
          const Seconds time = is_command ? now() : message->time;
          (static_cast<A*>(this)->*handler)(Stamped<T>{time, std::move(*value)});
        });
  }
  /// Subscribes to what the app is better off with, and does without where nobody writes it.
  template <class A, class T>
  void SubscribeIfWritten(const Topic<T>& topic, void (A::*handler)(const Stamped<T>&),
                          Seconds interval = Seconds(0.0)) {
    dispensable_.insert(topic.name);
    Subscribe(topic, handler, interval);
  }
  /// False for a time that a variable's content names (an exposure) and that lies in the future:
  /// refused, counted and warned of like a message's own stamp.
  [[nodiscard]] bool HasUsableStamp(const std::string& variable, Seconds stamp,
                                    const std::string& source);
  /// Every variable that matches, undecoded; stamps are as the sender made them, here and below.
  void SubscribeRaw(const WildcardFilter& filter, std::function<void(const MessagePtr&)> handler);
  /// One variable, undecoded: for names and types that only the mission knows.
  void SubscribeRaw(const std::string& name, std::function<void(const MessagePtr&)> handler);
  /// One that the app can do without where nobody writes it.
  void SubscribeRawIfWritten(const std::string& name,
                             std::function<void(const MessagePtr&)> handler) {
    dispensable_.insert(name);
    SubscribeRaw(name, std::move(handler));
  }

  template <class T>
  void Publish(const Topic<T>& topic, const T& value, const std::string& source_aux = "") {
    context_.link->Publish(topic.name, TopicCodec<T>::Encode(value), source_aux);
  }
  void PublishRaw(std::string name, Value value, std::string source_aux = "");
  /// What was so at `time`, a moment ago: subscribers get that time, not the time of sending.
  template <class T>
  void PublishMeasured(const Topic<T>& topic, const T& value, Seconds time) {
    context_.link->Forward({.name = topic.name,
                            .value = TopicCodec<T>::Encode(value),
                            .time = time,
                            .source = context_.name,
                            .source_aux = "",
                            .community = ""});
  }

  /// Raises a declared warning, or gives one that stands its new text. <APP>_WARNINGS tells at once
  /// what is raised and cleared, and every few seconds what a text says anew.
  void Warn(const WarningId& id, const std::string& text);
  void ClearWarning(const WarningId& id);
  /// The one of a family that is about `subject`; cheap while nothing stands.
  void ClearWarning(const WarningFamily& family, std::string_view subject) {
    if (!warnings().empty()) {
      ClearWarning(family.Of(subject));
    }
  }
  /// Something that an operator may want to have seen; the report lists the last few.
  void ReportEvent(const EventId& event, std::string_view text);
  /// A doubt about the configuration: in the report from now on.
  void WarnOfConfig(std::string text) { caster_.AddConfigWarning(std::move(text)); }

  [[nodiscard]] Seconds now() const { return context_.link->Now(); }
  /// This app's own random stream; `part` names one user of it.
  [[nodiscard]] Random MakeRandom(std::string_view part) const;
  [[nodiscard]] const AppContext& context() const { return context_; }

 private:
  using Handler = std::function<void(const MessagePtr&)>;
  void AddHandler(const std::string& name, Seconds interval, Handler handler);
  void PublishWarnings();
  void Cast(Seconds now);
  void WatchClock();
  void ReportRefusedStamps(ReportLines& report) const;

  AppContext context_;
  std::unordered_map<std::string, std::vector<Handler>> handlers_;
  std::vector<std::pair<WildcardFilter, Handler>> wildcard_handlers_;
  std::set<std::string> dispensable_;
  WarningBoard warnings_;
  StampGuard stamps_;
  AppCaster caster_;
  Seconds created_;
  std::int64_t iteration_ = 0;
};

}  // namespace limpet
