// SPDX-License-Identifier: MIT
#include "limpet/launch/launch.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "limpet/app/run_app.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/launch/community_watch.hpp"
#include "limpet/launch/deployment.hpp"
#include "limpet/launch/launch_check.hpp"
#include "limpet/launch/launch_faults.hpp"
#include "limpet/launch/launch_plan.hpp"
#include "limpet/launch/launch_report.hpp"
#include "limpet/launch/launch_warnings.hpp"
#include "limpet/launch/processor_watch.hpp"
#include "limpet/launch/run_folders.hpp"
#include "limpet/launch/supervisor.hpp"
#include "limpet/launch/surfacing.hpp"
#include "limpet/mission/outside.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/safety.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr auto kPollPeriod = std::chrono::milliseconds(50);
constexpr Seconds kStatusPeriod(5.0);  ///< a database that was started again has forgotten (real)
constexpr Seconds kLoadPeriod(5.0);    ///< (real)
constexpr Seconds kPatience(8.0);      ///< for an app to finish its files
constexpr Seconds kLastFiles(1.0);     ///< apps write them on the mail that ends the launch, too
constexpr Seconds kDepthAge(3.0);      ///< a depth heard longer ago is none (real)
constexpr Seconds kZeroWithin(1.0);    ///< for the last command to be heard by the database (real)

void Sleep(Seconds duration) {
  std::this_thread::sleep_for(std::chrono::duration<double>(duration.value()));
}

CommunityWatch::Settings WatchSettings(const LaunchPlan& plan, const std::string& until) {
  return {.port = static_cast<std::uint16_t>(
              ParseNumber(plan.mission.Global("ServerPort")).value_or(9000.0)),
          .warp = plan.warp,
          .until = until};
}

class Launch {
 public:
  Launch(LaunchCommand command, LaunchPlan plan, RunFolders folders)
      : command_(std::move(command)),
        plan_(std::move(plan)),
        folders_(std::move(folders)),
        report_(plan_.mission.Global("Community"), plan_.warp, MoosTime(plan_.warp)),
        deployment_(command_.deploys),
        supervisor_(folders_.run / command_.session, Environment(),
                    [this](const std::string& text) { Alert(events::kProcess, text); }),
        processor_(plan_.warp),
        faults_(plan_) {}

  int Run() {
    Say(fmt::format("{} processes, time warp {:g}, run folder {}", plan_.items.size(), plan_.warp,
                    folders_.run.string()));
    for (const ConfigProblem& note : plan_.notes) {
      fmt::print(stderr, "pLaunch: note: {}\n", note.Format());
    }
    if (!folders_.prior.empty()) {
      Say("compares with " + folders_.prior.string());
    }
    faults_.Prepare(supervisor_);
    for (const LaunchItem& item : plan_.items) {
      supervisor_.Start(item);
      Sleep(plan_.between);
    }
    CommunityWatch watch(WatchSettings(plan_, command_.until));
    faults_.Listen(watch);
    while (!EndIsRequested() && !watch.has_heard_the_end() && supervisor_.Poll() &&
           !IsOverForGood()) {
      Mind(watch);
      std::this_thread::sleep_for(kPollPeriod);
    }
    if (watch.has_heard_the_end()) {
      Say(command_.until + " was heard");
      Sleep(kLastFiles);
    }
    End(watch);
    return supervisor_.has_given_up() || LacksVitalProgram() ? 1 : 0;
  }

 private:
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> Environment() const {
    const auto absolute = [](const fs::path& path) {
      return path.empty() ? std::string() : fs::absolute(path).string();
    };
    return {{"LIMPET_RUN_FOLDER", absolute(folders_.run / command_.session)},
            {"LIMPET_PRIOR_FOLDER", absolute(folders_.prior)},
            {"LIMPET_SESSION", command_.session},
            {"LIMPET_SEED", command_.seed},
            {kAllowOutside, command_.allows_outside ? "1" : ""},
            {kClockOriginVariable, TextOf(OwnClockOrigin())}};
  }
  [[nodiscard]] bool LacksVitalProgram() const {
    const auto vital = std::ranges::find_if(plan_.missing, &MissingProgram::is_vital);
    if (vital == plan_.missing.end()) {
      return false;
    }
    fmt::print(stderr, "pLaunch: the mission ran without {}\n", vital->name);
    return true;
  }
  [[nodiscard]] std::vector<Supervisor::Report> Reports() const {
    return WithMissing(supervisor_.Reports(), plan_.missing);
  }
  void Mind(CommunityWatch& watch) {
    for (const std::string& name : watch.TakeArrivals()) {
      Say(name + " is up");
    }
    faults_.Apply(watch, supervisor_, MoosTime(plan_.warp));
    Deploy(watch);
    MindDatabase(watch);
    BringUpIfHopeless(watch);
    TellStatus(watch);
    TellLoad(watch);
    TellReport(watch);
  }
  [[nodiscard]] bool AllUp(const CommunityWatch& watch) const {
    return std::ranges::all_of(plan_.items, [&watch](const LaunchItem& item) {
      return item.is_database || watch.IsUp(item.name);
    });
  }
  [[nodiscard]] bool HasProgram(std::string_view begin) const {
    return std::ranges::any_of(plan_.items, [begin](const LaunchItem& item) {
      return item.program.filename().string().starts_with(begin);
    });
  }
  [[nodiscard]] DeploymentSigns SignsOf(const CommunityWatch& watch) const {
    const auto helm = watch.Latest(topics::kHelmState.name);
    return {.is_all_up = AllUp(watch),
            .has_helm = HasProgram("pHelm"),
            .has_survey = HasProgram("pSurvey"),
            .helm_words = helm ? helm->times : 0,
            .deploy = watch.TextOf(topics::kDeploy.name),
            .helm_stop = watch.TextOf(topics::kHelmAllStop.name),
            .phase = watch.TextOf(topics::kSurveyPhase.name),
            .has_ended = watch.Latest(topics::kMissionEnd.name).has_value()};
  }
  void Deploy(CommunityWatch& watch) {
    if (surfacing_.has_begun()) {
      return;
    }
    const Deployment::Step step = deployment_.Mind(SignsOf(watch), SteadyTime());
    if (step.writes) {
      watch.client().Publish(topics::kDeploy.name, "true");
    }
    if (!deployment_.warning().empty() && !step.says.empty()) {
      Alert(events::kDeployment, step.says);
    } else if (!step.says.empty()) {
      Say(step.says);
    }
  }
  /// A database that was started again without its former values must be told again.
  void MindDatabase(CommunityWatch& watch) {
    if (!watch.HasDatabase()) {
      watch.ForgetDatabase();
      has_lost_database_ = deployment_.has_written();
    } else if (has_lost_database_ && AllUp(watch)) {
      has_lost_database_ = false;
      if (!watch.Latest(topics::kDeploy.name) && !surfacing_.has_begun()) {
        Say("all up again, with an empty database; DEPLOY = true");
        watch.client().Publish(topics::kDeploy.name, "true");
      }
    }
  }
  /// Ends the mission at the surface once an app is given up that it cannot do without.
  void BringUpIfHopeless(CommunityWatch& watch) {
    const Seconds now = MoosTime(plan_.warp);
    const std::optional<std::string> lost = supervisor_.LostVital();
    if (lost && !surfacing_.has_begun() && !watch.Latest(topics::kMissionEnd.name)) {
      surfacing_.Begin(*lost + " is given up", now);
      Alert(events::kSurfacing, "the mission cannot go on: " + surfacing_.why() +
                                    "; thrusters off, the vehicle floats up");
      watch.client().Publish(topics::kSessionSave.name, surfacing_.why());
      watch.client().Publish(topics::kManualOverride.name, "true");
    }
    if (surfacing_.is_under_way()) {
      WriteZeroThrust(watch);
    }
    const std::string deploy = watch.TextOf(topics::kDeploy.name);
    const auto depth = watch.Latest(topics::kNavDepth.name);
    const bool is_recent = depth && SteadyTime() - depth->at < kDepthAge;
    if (surfacing_.EndsNow({.was_deployed = ParseFlag(deploy).value_or(false),
                            .depth_m = is_recent ? std::optional(depth->number) : std::nullopt},
                           now)) {
      watch.client().Publish(topics::kMissionEnd.name, "aborted");
      Alert(events::kSurfacing, "MISSION_END = aborted: " + surfacing_.why());
    }
  }
  /// A mission that was brought up, and nothing left to wait for: nobody can hear of its end.
  [[nodiscard]] bool IsOverForGood() const {
    return surfacing_.has_ended() &&
           (supervisor_.HasLostDatabase() || command_.until == topics::kMissionEnd.name);
  }
  static void WriteZeroThrust(CommunityWatch& watch) {
    watch.client().Publish(topics::kThrusterCommand.name, EncodeRecord(ThrusterCommand{}));
  }
  /// Who may command thrust ends first; then zero is written; then those that hear it end, the
  /// driver and the loggers, and the database last.
  void End(CommunityWatch& watch) {
    Say("ending");
    supervisor_.End(
        kPatience,
        [&watch](const std::string& name) {
          return watch.Hears(name, topics::kThrusterCommand.name);
        },
        [this, &watch] { LeaveAtRest(watch); });
  }
  void LeaveAtRest(CommunityWatch& watch) {
    if (!watch.Latest(topics::kThrusterCommand.name)) {
      return;  // nobody here has ever commanded thrust
    }
    // Without the interval that would keep the answer back.
    watch.client().Unsubscribe(topics::kThrusterCommand.name);
    watch.client().Subscribe(topics::kThrusterCommand.name, Seconds(0.0));
    WriteZeroThrust(watch);
    const Seconds deadline = SteadyTime() + kZeroWithin;
    while (SteadyTime() < deadline) {
      if (watch.Latest(topics::kThrusterCommand.name)->source == "pLaunch") {
        Say("thrusters off");
        return;
      }
      Sleep(Seconds(0.01));
    }
    Alert(events::kThrustNotZeroed,
          "the database did not take the last command, zero thrust; the driver stops by itself");
  }
  /// Publishes the status on every change, and now and then.
  void TellStatus(CommunityWatch& watch) {
    const Seconds now = SteadyTime();
    std::string status = supervisor_.Status() + StatusOfMissing(plan_.missing);
    if (status != told_status_ || now - told_at_ >= kStatusPeriod) {
      watch.client().Publish(topics::kLaunchStatus.name, status);
      const std::optional<double> made_up = faults_.memory_mib();
      if (const auto mib = made_up ? made_up : supervisor_.ResidentMib()) {
        watch.client().Publish(topics::kLaunchMemory.name, *mib);
      }
      told_status_ = std::move(status);
      told_at_ = now;
    }
  }
  void TellLoad(CommunityWatch& watch) {
    const Seconds now = SteadyTime();
    if (now - load_seen_at_ < kLoadPeriod) return;
    load_seen_at_ = now;
    processor_.Hear(supervisor_.ProcessorUse(), now);
    const std::optional<ProcessorLoad> made_up = faults_.processor();
    if (const auto load = made_up ? made_up : processor_.busiest()) {
      watch.client().Publish(topics::kLaunchProcessor.name, EncodeRecord(*load));
    }
  }
  void TellReport(CommunityWatch& watch) {
    const Seconds now = MoosTime(plan_.warp);
    for (const std::string& request : watch.TakeRequests()) {
      report_.OnRequest(request, now);
    }
    const std::vector<Supervisor::Report> processes = Reports();
    report_.Watch(processes, now);
    report_.SetWarning(warnings::kNotUnderWay, deployment_.warning(), now);
    report_.SetWarning(warnings::kMissionLost,
                       surfacing_.has_begun()
                           ? surfacing_.why() + (surfacing_.has_ended() ? ": mission aborted"
                                                                        : ": being brought up")
                           : "",
                       now);
    if (const auto news = report_.TakeWarnings(now)) {
      watch.client().Publish(WarningsVariable("pLaunch"), *news);
    }
    if (const auto cast = report_.Take(processes, watch.WhoIsUp(), now)) {
      watch.client().Publish(topics::kAppCast.name, *cast);
    }
  }
  void Say(const std::string& text) const {
    if (!command_.is_quiet) {
      fmt::print(stderr, "pLaunch: {}\n", text);
    }
  }
  /// What goes wrong: said even if quiet, and kept for viewers.
  void Alert(const EventId& event, const std::string& text) {
    fmt::print(stderr, "pLaunch: {}\n", text);
    report_.AddEvent(event, text, MoosTime(plan_.warp));
  }

  LaunchCommand command_;
  LaunchPlan plan_;
  RunFolders folders_;
  LaunchReport report_;
  Deployment deployment_;
  Surfacing surfacing_;
  Supervisor supervisor_;
  ProcessorWatch processor_;
  LaunchFaults faults_;
  Seconds load_seen_at_;
  bool has_lost_database_ = false;
  std::string told_status_;
  Seconds told_at_;
};

}  // namespace

int RunLaunch(const std::string& caller, const std::vector<std::string>& args) {
  try {
    LaunchCommand command = ReadLaunchCommand(args);
    if (command.wants_help) {
      fmt::print("{}", LaunchHelp(caller));
      return 0;
    }
    LaunchPlan plan = PlanLaunch(command, fs::read_symlink("/proc/self/exe").parent_path());
    if (const int refused = RefuseToLaunch(plan.mission_file); refused != 0) {
      return refused;
    }
    RunFolders folders = ChooseRunFolders(command);
    CatchEndSignals();
    return Launch(std::move(command), std::move(plan), std::move(folders)).Run();
  } catch (const ConfigError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}

}  // namespace limpet
