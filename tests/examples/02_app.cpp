// SPDX-License-Identifier: MIT
// Lesson 2: an app takes mail, thinks, and publishes. It runs here embedded, on virtual time; its
// own process needs one more file, a main.cpp of seven lines.
#include <optional>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "limpet/app/embedded.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {
namespace {

const Topic<bool> kDepthAlarm{"DEPTH_ALARM", "the vehicle is too deep, or nobody knows how deep"};

/// Raises DEPTH_ALARM while the vehicle is deeper than `max_depth_m`, or its depth is unknown.
class DepthWatchApp final : public App {
 public:
  struct Params {
    Meters max_depth{50.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("max_depth_m", max_depth, "Alarm below this depth",
            InRange(Meters(1.0), Meters(6000.0)));
    }
  };

  DepthWatchApp(const AppContext& context, const Params& params) : App(context), params_(params) {
    Subscribe(topics::kNavDepth, &DepthWatchApp::OnDepth);
  }

  void Tick(Seconds) override {
    // An unknown depth alarms too: a silent sensor must not look like a shallow vehicle.
    Publish(kDepthAlarm, !depth_ || *depth_ > params_.max_depth);
  }

 private:
  void OnDepth(const Stamped<double>& depth) { depth_ = Meters(depth.value); }

  Params params_;
  std::optional<Meters> depth_;
};

LIMPET_REGISTER_APP(DepthWatchApp, "pDepthWatch", 4.0);

std::string AlarmAt(EmbeddedCommunity& community, double depth) {
  community.Poke("NAV_DEPTH", depth);
  community.Step();
  return std::get<std::string>(community.database().Latest("DEPTH_ALARM")->value);
}

int Run() {
  EmbeddedSetup setup;
  setup.community = "harbour";
  setup.apps = {"pDepthWatch"};
  EmbeddedCommunity community(setup);
  fmt::print("at 10 m: {}", AlarmAt(community, 10.0));
  fmt::print(", at 60 m: {}\n", AlarmAt(community, 60.0));
  return 0;
}

}  // namespace
}  // namespace limpet

int main() { return limpet::Run(); }
