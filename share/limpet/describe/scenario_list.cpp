// SPDX-License-Identifier: MIT
#include "limpet/describe/scenario_list.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "limpet/describe/key_sections.hpp"
#include "limpet/mission/fault_kinds.hpp"
#include "limpet/mission/scenario.hpp"

namespace limpet {
namespace {

constexpr const char* kScenarioPageHead = R"(# What a simulated world does beyond the data sheets

`scenario.yaml` is the truth, for the simulator and the scorer alone; whoever navigates never reads it. `missions/table1/scenario.yaml` shows what each scenario says: seabed, water, start, objects, camera, and how large the sensors' errors are. Real vehicles have more: tides, brackets that are not square, clocks that are late, iron near the compass. The keys below bring such things in. Each is off by default, and a scenario without them gives the same run as before, bit for bit. What they draw comes from the mission's seed, each from a stream of its own.

`errors:` is what differs from the vehicle's file, which the rest of the mission goes on believing:
```yaml
water:  {visibility_m: 8, current_north_mps: 0.1, current_east_mps: 0, tide_period_s: 1800, tide_swing_deg: 60, shear_per_m: 0.05}
errors:
  camera: {pitch_deg: 2, off_m: [0.1, 0, 0], stamp_delay_s: 0.1}
  dvl:    {yaw_deg: 0.5, beam_loss_share: 0.1}
```
`limpet check` notes what a scenario says and no run of the mission would show: a tide without a period or a current, a gyro's drift where the vehicle has none, gravel where the camera's pictures are plain. A stamp that is too late comes with its message: nothing arrives before its stamp. Objects seen through a rolling shutter are where its rows see them; the texture of the seabed in rendered images is not. An object that moves is judged by its place in the scenario, and sound meets it there. A current that changes is one for the whole area.

`obstacles:` stand up from the seabed, the same in every session, and must not be touched: `{name, shape: column, north_m, east_m, radius_m, height_m}` or `{name, shape: box, north_m, east_m, size_m: [northwards, eastwards], height_m}`, the height above the seabed below the middle. Sonar and DVL beams meet them; the camera does not show them, but sees no object behind them ([obstacles](obstacles.md)); a vehicle that is steered into one goes through, and the report says so (`obstacle_distance_m` is 0).
```yaml
obstacles:
  - {name: pile, shape: column, north_m: -10, east_m: -2, radius_m: 0.4, height_m: 9}
```

`image:` says how rendered pictures look. `image: {look: real}` alone switches every stage on, at the defaults below; a stage is switched off by its zero. What each does: [image formation](image-formation.md). Objects may have other shapes than spheres then; navigation, sonar and the boxes camera go on taking them for spheres of `radius_m`. `sensors.false_detections_per_image` is no false box but litter that lies there, so many pieces in a picture from 4 m.

The models are one file each in `share/limpet/simulation` and `share/limpet/imaging`, those of the former used by the simulated vehicle and by the streams of `tests/support/simulated_stream` alike. Generated: `limpet describe scenario --markdown > docs/scenario-file.md`.
)";

constexpr const char* kFaultsHead = R"(
## faults

What fails on demand, to see what the vehicle makes of it ([safety](safety.md)): a list, each line with `what`, and if wanted `when` (a condition as in `.bhv` files on any variable; the fault's time begins to count when it first holds, else with the session), `at_s` (so long after that; 0), `for_s` (to the end), `size`. A fault is a function of time and mail: the same seed fails alike. Those that the host makes are made by pLaunch in a live mission, of its own processes, and by the session in an embedded one.
```yaml
faults:
  - {what: dvl_stuck, when: SURVEY_PHASE = SURVEY, at_s: 20, for_s: 60}
  - {what: app_hangs, app: pHelm, at_s: 400}
```

| what | meaning | size | made by |
| --- | --- | --- | --- |
)";

std::string SizeText(const FaultKind& kind) {
  if (kind.size_meaning.empty()) return "";
  return fmt::format("{}: {:g}; {:g} to {:g}", kind.size_meaning, kind.size, kind.least, kind.most);
}

std::string FaultsMarkdown() {
  std::string page = kFaultsHead;
  for (const FaultKind& kind : FaultKinds()) {
    page += fmt::format("| `{}` | {} | {} | {} |\n", kind.what, kind.meaning, SizeText(kind),
                        kind.made_by);
  }
  return page;
}

}  // namespace

std::string ScenarioKeysText() { return KeysText(DeclaredScenarioSections()); }
std::string ScenarioKeysJson() { return KeysJson(DeclaredScenarioSections()); }
std::string ScenarioKeysMarkdown() {
  return kScenarioPageHead + KeysMarkdown(DeclaredScenarioSections()) + FaultsMarkdown();
}

std::string FaultsText() {
  std::string text;
  for (const FaultKind& kind : FaultKinds()) {
    text += fmt::format("{:<16}{} ({})\n", kind.what, kind.meaning, kind.made_by);
    if (const std::string size = SizeText(kind); !size.empty()) {
      text += fmt::format("{:<16}  size: {}\n", "", size);
    }
  }
  return text;
}

}  // namespace limpet
