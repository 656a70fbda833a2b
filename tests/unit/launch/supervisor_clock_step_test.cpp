// SPDX-License-Identifier: MIT
// Somebody sets the date while a community is under way: as processes, with the wall clock of each
// stepped by a library that is preloaded (tests/support/wall_clock_shim.cpp).
#include <cmath>
#include <fstream>
#include <map>
#include <mutex>
#include <thread>

#include <gtest/gtest.h>

#include "limpet/core/clock.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/launch/supervisor.hpp"
#include "limpet/pubsub/tcp_client.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/topics/wall_clock.hpp"
#include "limpet/wire/message_conversion.hpp"
#include "tests/support/free_port.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr double kWarp = 5.0;
constexpr const char* kApps[] = {"uSimVehicle", "uSimSensors", "pNav", "pSurvey"};

/// What an onlooker hears: the latest of each variable, and how far the yaw is off at most.
class Onlooker {
 public:
  void Hear(const WireMessage& wire) {
    const Message message = MessageFrom(wire);
    const std::lock_guard lock(mutex_);
    latest_[message.name] = message;
    if (message.name == topics::kSimTruth.name) {
      if (const auto truth = TopicCodec<SimTruth>::Decode(message.value)) {
        truth_yaw_[message.time.value()] = truth->yaw;
        turned_ += std::abs(truth->r) * 0.02;
      }
    } else if (message.name == topics::kNavState.name) {
      NoteYaw(message);
    }
  }
  std::optional<Message> Latest(const std::string& name) {
    const std::lock_guard lock(mutex_);
    const auto found = latest_.find(name);
    return found == latest_.end() ? std::nullopt : std::optional(found->second);
  }
  std::string Text(const std::string& name) {
    const auto message = Latest(name);
    return message ? std::get<std::string>(message->value) : "";
  }
  /// [rad], of all NAV_STATE so far.
  double worst_yaw() {
    const std::lock_guard lock(mutex_);
    return worst_yaw_;
  }
  double turned() {
    const std::lock_guard lock(mutex_);
    return turned_;
  }
  bool has_gone_back() {
    const std::lock_guard lock(mutex_);
    return has_gone_back_;
  }

 private:
  void NoteYaw(const Message& message) {
    const auto state = TopicCodec<NavState>::Decode(message.value);
    has_gone_back_ = has_gone_back_ || message.time < last_nav_;
    last_nav_ = message.time;
    const auto truth = truth_yaw_.lower_bound(message.time.value() - 0.03);
    if (state && truth != truth_yaw_.end() && truth->first < message.time.value() + 0.03) {
      worst_yaw_ = std::max(worst_yaw_, std::abs(WrapAngle(state->yaw - truth->second)));
    }
  }

  std::mutex mutex_;
  std::map<std::string, Message> latest_;
  std::map<double, double> truth_yaw_;
  double worst_yaw_ = 0.0, turned_ = 0.0;
  Seconds last_nav_;
  bool has_gone_back_ = false;
};

class ClockStep : public testing::Test {
 protected:
  void SetUp() override {
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "a thread sanitizer takes no preloaded library";
#endif
    SetWallClock(0.0);
    fs::copy_file(fs::path(LIMPET_SOURCE_DIR) / "missions/basin/scenario.yaml",
                  folder_.path() / "scenario.yaml");
    WriteMission();
    Start("LimpetDB", true);
    onlooker_ = std::make_unique<TcpClient>(
        TcpClientOptions{.port = port_,
                         .name = "onlooker",
                         .warp = kWarp,
                         .on_mail = [this](const WireMessage& message) { heard_.Hear(message); },
                         .on_state = nullptr});
    for (const char* name : {"NAV_STATE", "SIM_TRUTH", "SURVEY_PHASE", "MISSION_END", "WALL_CLOCK",
                             "LIMPETDB_WARNINGS", "PNAV_WARNINGS", "PSURVEY_WARNINGS"}) {
      onlooker_->Subscribe(name, Seconds(0.0));
    }
    Await([this] { return onlooker_->state() == TcpClient::State::kConnected; });
  }

  void WriteMission() {
    std::ofstream(folder_.path() / "mission.moos")
        << "ServerHost = localhost\nServerPort = " << port_
        << "\nCommunity = limpet\nMOOSTimeWarp = " << kWarp
        << "\nLatOrigin = 43.721\nLongOrigin = 10.283\nVehicleFile = feelhippo.yaml\n"
           "ProcessConfig = uSimVehicle\n{\n  scenario = scenario.yaml\n}\n"
           "ProcessConfig = uSimSensors\n{\n  scenario = scenario.yaml\n}\n"
           "ProcessConfig = pNav\n{\n  opi_radius_m = 0.3\n  camera_fov_across_deg = 80\n"
           "  camera_fov_along_deg = 60\n  camera_width_px = 640\n  camera_height_px = 480\n}\n"
           "ProcessConfig = pSurvey\n{\n  area_north_min_m = -10\n  area_north_max_m = 10\n"
           "  area_east_min_m = -10\n  area_east_max_m = 10\n  altitude_m = 3\n  align_s = 10\n"
           "  object_height_max_m = 1.5\n"
           "  max_time_s = 1800\n}\n";
  }
  void Start(const std::string& name, bool is_database = false) {
    const fs::path programs = fs::read_symlink("/proc/self/exe").parent_path();
    ASSERT_TRUE(fs::exists(programs / name)) << name;
    supervisor_.Start({.name = name,
                       .program = programs / name,
                       .args = {(folder_.path() / "mission.moos").string()},
                       .is_database = is_database});
  }
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> Environment() const {
    const fs::path shim = fs::read_symlink("/proc/self/exe").parent_path() / "wall_clock_shim.so";
    return {{"LD_PRELOAD", shim.string()},
            {"ASAN_OPTIONS", "verify_asan_link_order=0"},
            {"WALL_CLOCK_SHIM_FILE", OffsetFile().string()}};
  }
  [[nodiscard]] fs::path OffsetFile() const { return folder_.path() / "offset"; }
  /// Every process's wall clock is off by that from now on [s].
  void SetWallClock(double off) const {
    const auto ns = static_cast<std::int64_t>(1e9 * off);
    std::fstream file(OffsetFile(), std::ios::binary | std::ios::in | std::ios::out);
    if (!file.is_open()) {
      file.open(OffsetFile(), std::ios::binary | std::ios::out);
    }
    file.write(reinterpret_cast<const char*>(&ns), sizeof ns);
  }

  /// Turns the vehicle on the spot meanwhile: a heading that misses a second shows.
  template <class Condition>
  void Await(Condition condition) {
    const Seconds begin = SteadyTime();
    while (!condition() && SteadyTime() - begin < Seconds(40.0)) {
      EXPECT_TRUE(supervisor_.Poll());
      onlooker_->PublishValue(
          "THRUSTER_COMMAND",
          TopicCodec<ThrusterCommand>::Encode({.t1 = -0.1, .t2 = 0.1, .t3 = -0.1, .t4 = 0.1}));
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ASSERT_TRUE(condition());
  }
  void TurnBy(double angle) {
    const double until = heard_.turned() + angle;
    Await([&] { return heard_.turned() > until; });
  }

  TemporaryFolder folder_;
  std::uint16_t port_ = FreePort();
  Supervisor supervisor_{folder_.path(), Environment(), [](const std::string&) {}};
  Onlooker heard_;
  std::unique_ptr<TcpClient> onlooker_;
};

TEST_F(ClockStep, TurnsNoVehicleAndEndsNoSurvey) {
  SetWallClock(-7.0);  // the apps are started by another clock than the database was
  for (const char* name : kApps) {
    Start(name);
  }
  Await([this] { return heard_.Latest("NAV_STATE").has_value(); });
  EXPECT_NE(heard_.Text("LIMPETDB_WARNINGS").find("CLOCK_STEPPED"), std::string::npos);
  onlooker_->Publish("DEPLOY", "true");
  Await([this] { return heard_.Text("SURVEY_PHASE") == "DIVE"; });
  for (const double off : {3600.0, 3599.0, 3589.0}) {  // an hour ahead, then 1 s and 10 s back
    SetWallClock(off);
    TurnBy(0.5);
    Await([&] {
      const auto clock = TopicCodec<WallClock>::Decode(heard_.Text("WALL_CLOCK"));
      return clock && std::abs(clock->ahead - off) < 0.4;
    });
    const auto nav = heard_.Latest("NAV_STATE");
    EXPECT_LT(std::abs((onlooker_->Now() - nav->time).value()), 2.0 * kWarp) << off;
  }
  EXPECT_NE(heard_.Text("LIMPETDB_WARNINGS").find("CLOCK_STEPPED"), std::string::npos);
  EXPECT_EQ(heard_.Text("LIMPETDB_WARNINGS").find("STAMP"), std::string::npos);
  EXPECT_EQ(heard_.Text("PNAV_WARNINGS").find("STAMP"), std::string::npos);
  EXPECT_FALSE(heard_.has_gone_back());
  EXPECT_LT(heard_.worst_yaw(), 0.15);
  EXPECT_EQ(heard_.Text("SURVEY_PHASE"), "DIVE");
  EXPECT_FALSE(heard_.Latest("MISSION_END").has_value());
  SetWallClock(0.0);
  Await([this] { return heard_.Text("LIMPETDB_WARNINGS") == "none"; });
}

}  // namespace
}  // namespace limpet
