// SPDX-License-Identifier: MIT
#include "tests/unit/launch/live_mission.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "limpet/core/clock.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/mission/expanded_text.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

const fs::path kLiveSource = fs::path(LIMPET_SOURCE_DIR);
constexpr Seconds kMinute(60.0);
constexpr Seconds kNap(0.005);

/// As far as it can be read: a process ends while one reads of it.
std::string WholeText(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// What is launched of the mission: without camera and map there is nothing to see, and less to do.
constexpr const char* kFlown = "LimpetDB uSimVehicle uSimSensors pNav pSurvey pHelm pPilot";

bool IsFlown(const std::string& process) {
  const std::vector<std::string> flown = Split(kFlown, ' ');
  return std::ranges::find(flown, process) != flown.end();
}

/// The mission's lines, with the options and lines that are wanted.
std::string Edited(const std::string& text, std::uint16_t port,
                   const LiveMission::Lines& run_options, const LiveMission::Lines& block_lines) {
  std::istringstream lines(text);
  std::string result, block;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first, equals, name;
    words >> first >> equals >> name;
    if (first == "ServerPort") {
      line = "ServerPort = " + std::to_string(port);
    } else if (first == "MSBetweenLaunches") {
      line = "  MSBetweenLaunches = 0";
    } else if (first == "Run" && IsFlown(name)) {
      const auto found = run_options.find(name);
      const std::string options = found == run_options.end() ? "" : ", " + found->second;
      const bool is_patient = options.find("HungAfter_s") != std::string::npos;
      line = "  Run = " + name + " @ NewConsole = false" + (is_patient ? "" : ", HungAfter_s = 2") +
             options;
    } else if (first == "ProcessConfig") {
      block = name;
    } else if (const auto more = block_lines.find(block);
               first == "AppTick" && more != block_lines.end() &&
               more->second.find("AppTick") != std::string::npos) {
      continue;
    }
    result += line + "\n";
    if (const auto more = block_lines.find(block); first == "{" && more != block_lines.end()) {
      result += more->second + "\n";
    }
  }
  return result;
}

}  // namespace

LiveMission::LiveMission(const Lines& run_options, const Lines& block_lines) {
  Lines lines{{"pSurvey", "  align_s = 1\n  last_fix_s = 0\n  home_radius_m = 50"},
              {"pPilot", "  AppTick = 50"}};
  for (const auto& [process, text] : block_lines) {
    lines[process] = text;
  }
  const auto copy = [this](const fs::path& folder) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (entry.is_regular_file()) {
        fs::copy_file(entry.path(), folder_.path() / entry.path().filename(),
                      fs::copy_options::overwrite_existing);
      }
    }
  };
  copy(kLiveSource / "plugs");
  copy(kLiveSource / "missions" / "basin");
  const fs::path file = folder_.path() / "mission.moos";
  const std::string text = ExpandedText(WholeText(file), file);
  std::ofstream(file) << "surface_depth_m = 5\n" << Edited(text, port_, run_options, lines);
}

LiveMission::~LiveMission() {
  if (launcher_ > 0) {
    ::kill(launcher_, SIGTERM);
    AwaitEnd();
  }
  if (launcher_ > 0) {
    ::kill(launcher_, SIGKILL);
    ::waitpid(launcher_, nullptr, 0);
  }
}

void LiveMission::AppendToScenario(const std::string& lines) const {
  std::ofstream(folder_.path() / "scenario.yaml", std::ios::app) << lines;
}

void LiveMission::Launch(const std::string& option) {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "pLaunch";
  const std::string mission = (folder_.path() / "mission.moos").string();
  const std::string run = "--run_folder=" + run_folder().string();
  const std::string said = (folder_.path() / "said").string();
  launcher_ = ::fork();
  if (launcher_ == 0) {
    const int file = ::open(said.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    ::dup2(file, STDOUT_FILENO);
    ::dup2(file, STDERR_FILENO);
    ::execl(program.c_str(), program.c_str(), mission.c_str(), kFlown, run.c_str(), "--deploy",
            option.c_str(), nullptr);
    ::_exit(127);
  }
  client_ = std::make_unique<TcpClient>(TcpClientOptions{
      .port = port_,
      .name = "uTest",
      .learns_warp = true,
      .on_mail =
          [this](const WireMessage& message) {
            const std::lock_guard lock(mutex_);
            const bool is_number = message.data_type == wire_data::kDouble;
            heard_[std::string(message.key)] = {
                is_number ? limpet::TextOf(message.number) : std::string(message.text),
                std::string(message.source)};
          },
      .on_state = nullptr});
  for (const char* variable :
       {"SIM_THRUST", "SURVEY_PHASE", "PLAUNCH_STATUS", "MISSION_END", "THRUSTER_COMMAND", "DEPLOY",
        "IVPHELM_ALLSTOP", "SIM_TRUTH", "PPILOT_WARNINGS", "PLAUNCH_MEMORY", "PLAUNCH_PROCESSOR",
        "WALL_CLOCK", "PSURVEY_WARNINGS"}) {
    client_->Subscribe(variable, Seconds(0.0));
  }
}

std::string LiveMission::Latest(const std::string& variable) const {
  const std::lock_guard lock(mutex_);
  const auto found = heard_.find(variable);
  return found == heard_.end() ? "" : found->second.text;
}

std::string LiveMission::SourceOf(const std::string& variable) const {
  const std::lock_guard lock(mutex_);
  const auto found = heard_.find(variable);
  return found == heard_.end() ? "" : found->second.source;
}

std::optional<SimThrust> LiveMission::Thrust() const {
  return DecodeRecord<SimThrust>(Latest("SIM_THRUST"));
}

bool LiveMission::Await(const std::function<bool()>& holds) {
  const Seconds deadline = SteadyTime() + kMinute;
  while (!holds()) {
    const Seconds before = SteadyTime();
    if (before > deadline) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(kNap.value()));
    lateness_ = std::max(lateness_, SteadyTime() - before - kNap);
  }
  return true;
}

bool LiveMission::AwaitDive() {
  return Await([this] {
    const std::optional<SimThrust> thrust = Thrust();
    return Latest("SURVEY_PHASE") == "DIVE" && thrust && thrust->greatest > 0.1;
  });
}

pid_t LiveMission::PidOf(const std::string& process) const {
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
    const auto pid = ParseInteger(entry.path().filename().string());
    std::istringstream stat(pid ? WholeText(entry.path() / "stat") : "");
    std::string number, name, state;
    pid_t parent = 0;
    if (stat >> number >> name >> state >> parent && parent == launcher_ &&
        name == "(" + process + ")") {
      return static_cast<pid_t>(*pid);
    }
  }
  return 0;
}

int LiveMission::AwaitEnd() {
  int status = 0;
  const bool has_ended =
      Await([this, &status] { return ::waitpid(launcher_, &status, WNOHANG) == launcher_; });
  if (!has_ended) {
    return -1;
  }
  launcher_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string LiveMission::Said() const { return WholeText(folder_.path() / "said"); }

}  // namespace limpet
