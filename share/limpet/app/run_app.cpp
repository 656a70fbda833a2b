// SPDX-License-Identifier: MIT
#include "limpet/app/run_app.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>

#include <fmt/format.h>

#include "limpet/app/app_command.hpp"
#include "limpet/app/app_example.hpp"
#include "limpet/app/app_status.hpp"
#include "limpet/app/app_tick.hpp"
#include "limpet/app/heartbeat.hpp"
#include "limpet/app/host_faults.hpp"
#include "limpet/app/live_link.hpp"
#include "limpet/app/mail_journal.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/core/clock.hpp"

namespace limpet {
namespace {

constexpr int kConfigurationFailed = 2;
constexpr Seconds kLongestWait(0.2);  ///< real time; how soon an end signal is noticed

std::atomic<bool> end_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

ConfigBlock BlockFor(const AppCommand& command) {
  const ConfigBlock* own = command.mission.Block(command.name);
  const ConfigBlock* found = own != nullptr ? own : command.mission.Block(command.process);
  const std::string file =
      command.mission_file.empty() ? "no mission file" : command.mission_file.string();
  ConfigBlock block =
      found != nullptr
          ? *found
          : ConfigBlock{.name = command.name, .where = {.file = file, .line = 0}, .entries = {}};
  for (const ConfigEntry& entry : command.overrides) {
    std::erase_if(block.entries, [&entry](const ConfigEntry& old) {
      return EqualsIgnoringCase(old.key, entry.key);
    });
    block.entries.push_back(entry);
  }
  std::ranges::copy(command.additions, std::back_inserter(block.entries));
  return block;
}

constexpr Seconds kStatusPeriod(2.0);  ///< real time

/// Mail as it comes, Tick on time; a tick that is missed is left out, never made up for.
void Loop(App& app, LiveLink& link, Seconds period, MailJournal* journal, Heartbeat& heart) {
  AppStatus status(app.name(), link.Now());
  Seconds next = SteadyTime() + period;
  Seconds next_status = SteadyTime();
  while (!EndIsRequested()) {
    for (const MessagePtr& message : link.TakeMail(std::min(next, SteadyTime() + kLongestWait))) {
      if (journal != nullptr) {
        journal->NoteMail(*message, link.Now());
      }
      app.Deliver(message);
      heart.Beat();
    }
    heart.Beat();
    app.Attend(link.Now());
    if (const Seconds now = SteadyTime(); now >= next) {
      const Seconds moos_now = link.Now();
      if (journal != nullptr) {
        journal->NoteTick(moos_now);
        journal->Flush();
        if (!journal->is_good()) {
          app.NoteJournalLost(journal->trouble());
        }
      }
      app.Iterate(moos_now);
      next = std::max(next + period, now);
      if (now >= next_status) {
        next_status = now + kStatusPeriod;
        link.Publish(status.variable(), status.Text(app.iteration(), link), "");
      }
    }
  }
  heart.Pause();  // it may take its time to bring its files to an end
  app.End(link.Now());
  if (journal != nullptr) {
    journal->Remove();
  }
}

/// What the app heard in its former life, so that registering brings only news.
void NoteFormerLife(const MailJournal& journal, LiveLink& link, std::optional<Seconds>& began) {
  journal.Replay([&](Seconds now, const MessagePtr& mail) {
    began = began ? began : now;
    if (mail) {
      link.NoteHeard(*mail);
    }
  });
}

/// Leads the app through its former life. What it says meanwhile was said then.
void ReplayFormerLife(MailJournal& journal, LiveLink& link, App& app, Heartbeat& heart) {
  const Seconds begin = SteadyTime();
  std::int64_t count = 0;
  journal.Replay([&](Seconds now, const MessagePtr& mail) {
    heart.Beat();
    link.Replay(now);
    if (mail) {
      ++count;
      app.Deliver(mail);
    } else {
      app.Iterate(now);
    }
  });
  link.Replay(std::nullopt);
  journal.Vouch();
  fmt::print(stderr, "{}: went through the {} messages of its former life in {:.1f} s\n",
             app.name(), count, (SteadyTime() - begin).value());
}

/// True once connected; false if asked to end before.
bool WaitForCommunity(const AppCommand& command, LiveLink& link, Heartbeat& heart) {
  std::string told;
  while (link.client().state() != TcpClient::State::kConnected) {
    heart.Beat();
    if (EndIsRequested()) {
      return false;
    }
    if (const std::string trouble = link.client().trouble(); !trouble.empty() && trouble != told) {
      fmt::print(stderr, "{}: waiting for the database at {}:{} ({})\n", command.name, command.host,
                 command.port, trouble);
      told = trouble;
    }
    static_cast<void>(link.TakeMail(SteadyTime() + kLongestWait));
  }
  return true;
}

int Run(const AppCommand& command, const AppEntry& entry) {
  Heartbeat heart;
  const HostFaults host;
  const ConfigBlock block = BlockFor(command);
  const double tick_hz = AppTickRate(block, entry.default_tick_hz);
  if (const auto problems = entry.check(block); !problems.empty()) {
    throw ConfigError(problems);
  }
  CatchEndSignals();
  LiveLink link({.host = command.host,
                 .port = command.port,
                 .name = command.name,
                 .warp = command.warp,
                 .on_mail = nullptr,
                 .on_state = nullptr});
  heart.Beat();
  if (!WaitForCommunity(command, link, heart)) {
    return 0;
  }
  heart.Pause();  // what it reads at its start may be much
  const AppContext context{.name = command.name,
                           .link = &link,
                           .globals = command.mission.globals,
                           .mission_folder = command.mission_file.parent_path(),
                           .mission_file = command.mission_file,
                           .run_folder = command.run_folder,
                           .prior_folder = command.prior_folder,
                           .session = command.session,
                           .seed = command.seed,
                           .runs_live = true,
                           .is_restarted = command.is_restarted,
                           .makes_host_faults = host.are_made(),
                           .warp = command.warp,
                           .disk = &host.disk(),
                           .blocks = command.mission.blocks};
  CastSettings casts = ReadCastSettings(block);
  casts.warp = command.warp;
  std::optional<MailJournal> journal;
  std::optional<Seconds> began;
  if (entry.replays_mail && !command.run_folder.empty()) {
    journal.emplace(command.run_folder / (command.name + ".mail"), command.is_restarted,
                    host.disk());
    NoteFormerLife(*journal, link, began);
  }
  link.Replay(began);  // an app of a former life was made then
  const std::unique_ptr<App> app = entry.create(context, block);
  app->StartReporting(std::move(casts));
  if (began) {
    ReplayFormerLife(*journal, link, *app, heart);
  }
  Loop(*app, link, Seconds(1.0 / (tick_hz * command.warp)), journal ? &*journal : nullptr, heart);
  return 0;
}

}  // namespace

void CatchEndSignals() {
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, [](int) { end_requested = true; });
  }
}

bool EndIsRequested() { return end_requested; }

int RunApp(const std::string& process, int argc, const char* const* argv) {
  try {
    const AppEntry& entry = AppRegistry().at(process);
    const AppCommand command =
        ReadAppCommand(process, {argv + 1, static_cast<std::size_t>(argc - 1)});
    if (command.wants_help) {
      fmt::print("{}", AppCommandHelp(process));
      return 0;
    }
    if (command.wants_example) {
      fmt::print("{}", AppExample(process, entry));
      return 0;
    }
    return Run(command, entry);
  } catch (const ConfigError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return kConfigurationFailed;
  }
}

}  // namespace limpet
