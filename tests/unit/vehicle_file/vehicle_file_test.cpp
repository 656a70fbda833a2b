// SPDX-License-Identifier: MIT
#include "limpet/vehicle_file/vehicle_file.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/vehicle/hydrodynamics.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;

const fs::path kShipped = fs::path(LIMPET_SOURCE_DIR) / "share" / "vehicles";

constexpr const char* kThrusterLines = R"(
    - {name: a, at_m: [0.2, 0.2, 0], push: [1, -1, 0]}
    - {name: b, at_m: [0.2, -0.2, 0], push: [1, 1, 0]}
    - {name: c, at_m: [-0.2, 0.2, 0], push: [1, 1, 0]}
    - {name: d, at_m: [-0.2, -0.2, 0], push: [1, -1, 0]}
    - {name: e, at_m: [0.2, 0, 0], push: [0, 0, 1]}
    - {name: f, at_m: [-0.2, 0, 0], push: [0, 0, 1]}
)";

std::string FileWith(const std::string& hull, const std::string& thrusters = kThrusterLines) {
  return fmt::format("name: Test\nhull:\n  {}\nthrusters:\n  list:{}", hull, thrusters);
}

/// Every problem, as a user reads it.
std::vector<std::string> ProblemsOf(const std::string& text) {
  std::vector<std::string> lines;
  try {
    static_cast<void>(ParseVehicleFile(text, "v.yaml"));
  } catch (const ConfigError& error) {
    for (const ConfigProblem& problem : error.problems())
      lines.push_back(problem.Format());
  }
  return lines;
}

TEST(VehicleFile, OfFeelHippoIsTheVehicleThatEveryFigureWasMeasuredWith) {
  const VehicleFile file = LoadVehicleFile(kShipped / "feelhippo.yaml");
  const VehicleParams usual;
  EXPECT_EQ(file.name, "FeelHippo");
  EXPECT_EQ(DeriveHydrodynamics(file.params).mass_matrix, DeriveHydrodynamics(usual).mass_matrix);
  EXPECT_EQ(DeriveHydrodynamics(file.params).quadratic_drag,
            DeriveHydrodynamics(usual).quadratic_drag);
  EXPECT_EQ(file.params.thrusters.WrenchPerThrust(), usual.thrusters.WrenchPerThrust());
  EXPECT_EQ(file.params.thrusters.max_thrust_n, usual.thrusters.max_thrust_n);
  EXPECT_EQ(file.params.antenna_B, usual.antenna_B);
}

TEST(VehicleFile, OfBlueRov2LeavesPitchToBuoyancy) {
  const VehicleFile file = LoadVehicleFile(kShipped / "bluerov2.yaml");
  EXPECT_THAT(file.params.thrusters.ControlledAxes(), ElementsAre(0, 1, 2, 5));
}

TEST(VehicleFile, OfFeelHippoHasTheSensorsThatTheSheetsHaveByDefault) {
  VehicleFile shipped = LoadVehicleFile(kShipped / "feelhippo.yaml");
  VehicleFile usual;
  usual.battery.is_present = usual.sensors.sonar.is_present = true;
  const std::vector<KeySection> is = VehicleFileSections(shipped);
  const std::vector<KeySection> should = VehicleFileSections(usual);
  for (std::size_t i = 2; i < is.size(); ++i) {
    for (std::size_t key = 0; key < is[i].keys.size(); ++key) {
      EXPECT_EQ(is[i].keys[key].example, should[i].keys[key].example)
          << is[i].name << "." << is[i].keys[key].name;
    }
  }
}

TEST(VehicleFile, OfBlueRov2HasNoFibreOpticGyroAndASlowerDvl) {
  const VehicleFile file = LoadVehicleFile(kShipped / "bluerov2.yaml");
  EXPECT_FALSE(file.sensors.fog.is_present);
  EXPECT_EQ(file.sensors.dvl.rate, Hertz(4.0));
  EXPECT_EQ(file.sensors.dvl.p_BD.x(), -0.15);
  EXPECT_NEAR(file.camera.fov_across.in_text_unit(), 60.0, 1e-12);
  EXPECT_EQ(file.camera.p_BC.x(), 0.15);
}

TEST(VehicleFile, LeavesToTheOneItIsBasedOnWhatItDoesNotSay) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "base.yaml") << FileWith("mass_kg: 20") << "dvl: {rate_hz: 3}\n";
  const std::string text = "based_on: base.yaml\nname: Own\nimu: {heading_sigma_deg: 3}\n";
  const VehicleFile file = ParseVehicleFile(text, (folder.path() / "v.yaml").string());
  EXPECT_EQ(file.name, "Own");
  EXPECT_EQ(file.params.mass, 20.0);
  EXPECT_EQ(file.sensors.dvl.rate, Hertz(3.0));
  EXPECT_EQ(file.sensors.imu.heading_sigma, Radians::FromTextUnit(3.0));
}

TEST(VehicleFile, HasABatteryIfItSaysAnythingOfOne) {
  EXPECT_FALSE(ParseVehicleFile(FileWith("mass_kg: 20"), "v.yaml").battery.is_present);
  const VehicleFile file =
      ParseVehicleFile(FileWith("mass_kg: 20") + "battery: {capacity_wh: 100}\n", "v.yaml");
  EXPECT_TRUE(file.battery.is_present);
  EXPECT_EQ(file.battery.capacity_wh, 100.0);
}

TEST(VehicleFile, RefusesABatteryThatIsEmptyAboveItsFullVoltage) {
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 20") + "battery: {empty_v: 30}\n"),
              ElementsAre(HasSubstr(
                  "battery.empty_v: `30` is not allowed; allowed: less than battery.full_v")));
}

TEST(VehicleFile, RefusesAnAntennaThatIsUnderWaterWhereTheVehicleFloats) {
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 20\n  antenna_m: [0, 0, 0.25]")),
              ElementsAre(HasSubstr("hull.antenna_m: does not stand above the body's origin")));
}

TEST(VehicleFile, RefusesACameraWhoseAxisMissesItsImage) {
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 20") + "camera: {width_px: 640, cx_px: 2000}\n"),
              ElementsAre(HasSubstr("camera.cx_px: `2000`: the axis does not meet the image")));
}

TEST(VehicleFile, RefusesACameraThatSeesTheHorizon) {
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 20") + "camera: {tilt_deg: 60}\n"),
              ElementsAre(HasSubstr("camera.tilt_deg: the camera looks up or to the horizon")));
}

TEST(VehicleFile, SaysTheLensOfTheCamera) {
  const VehicleFile file = ParseVehicleFile(
      FileWith("mass_kg: 20") +
          "camera: {fx_px: 500, cx_px: 310.5, distortion: [-0.2, 0.04, 0.001, -0.002, 0]}\n",
      "x.yaml");
  EXPECT_EQ(file.camera.pinhole().fx, 500.0);
  EXPECT_EQ(file.camera.pinhole().cx, 310.5);
  EXPECT_EQ(file.camera.lens_distortion().p2, -0.002);
  EXPECT_GT(file.camera.geometry().width_px, file.camera.width_px) << "a barrel shows more";
}

TEST(VehicleFile, ALensThatFoldsTheImageIsRefused) {
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 20") + "camera: {distortion: [-0.9, 0, 0, 0, 0]}\n"),
              ElementsAre(HasSubstr("camera.distortion: folds the image")));
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 20") + "camera: {distortion: [-0.1, 0]}\n"),
              ElementsAre(HasSubstr("allowed: [k1, k2, p1, p2, k3], each -10 to 10")));
}

TEST(VehicleFile, TakesPushesOfAnyLength) {
  const VehicleFile file = ParseVehicleFile(FileWith("mass_kg: 20"), "v.yaml");
  for (const Thruster& thruster : file.params.thrusters.thrusters) {
    EXPECT_NEAR(thruster.axis_B.norm(), 1.0, 1e-15);
  }
  EXPECT_EQ(file.params.mass, 20.0);
}

TEST(VehicleFile, NamesLineKeyValueAndWhatIsAllowed) {
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: -35")),
              ElementsAre("v.yaml:3: hull.mass_kg: `-35` is not allowed; allowed: 0.5 to 20000"));
  EXPECT_THAT(ProblemsOf(FileWith("mass_kgs: 35")),
              ElementsAre("v.yaml:3: hull.mass_kgs: unknown key; did you mean `mass_kg`?"));
  EXPECT_THAT(
      ProblemsOf(FileWith("antenna_m: [0, 0]")),
      ElementsAre(HasSubstr("`[0, 0]` is not allowed; allowed: [x, y, z], each -10 to 10 m")));
  EXPECT_THAT(ProblemsOf(FileWith("antenna_m: [0, 0, 0, 1]")), testing::SizeIs(1));
  EXPECT_THAT(ProblemsOf(FileWith("antenna_m: {x: 1}")), testing::SizeIs(1));
}

/// The lines but the one of that name.
std::string Without(const std::string& name) {
  std::string lines = kThrusterLines;
  const std::size_t at = lines.find("    - {name: " + name + ",");
  return lines.erase(at, lines.find('\n', at) + 1 - at);
}

TEST(VehicleFile, MissesAThruster) {
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 35", Without("a"))),
              ElementsAre(HasSubstr("thrusters.list[0]: its counterpart on the other side is "
                                    "missing")));
  for (const char* name : {"b", "c", "d"}) {
    EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 35", Without(name))),
                ElementsAre(HasSubstr("its counterpart on the other side is missing")));
  }
  for (const char* name : {"e", "f"}) {
    EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 35", Without(name))),
                ElementsAre(HasSubstr("cannot push the vehicle down without pitching it")));
  }
  EXPECT_THAT(
      ProblemsOf(FileWith("mass_kg: 35", "\n    - {name: a, at_m: [0, 0, 0], push: [1, 0, 0]}\n")),
      ElementsAre(HasSubstr("thrusters.list: a list of 1 is not allowed; allowed: a list "
                            "of 4 to 8 thrusters")));
  EXPECT_THAT(ProblemsOf("name: Test\n"), ElementsAre(HasSubstr("thrusters.list: is missing")));
}

TEST(VehicleFile, OfAShippedVehicleMissesAnyOneOfItsThrusters) {
  for (const char* shipped : {"feelhippo.yaml", "bluerov2.yaml"}) {
    const VehicleFile whole = LoadVehicleFile(kShipped / shipped);
    EXPECT_FALSE(whole.params.thrusters.Unpaired().has_value()) << shipped;
    EXPECT_TRUE(whole.params.thrusters.HeavesLevel()) << shipped;
    for (std::size_t i = 0; i < whole.params.thrusters.thrusters.size(); ++i) {
      ThrusterLayout layout = whole.params.thrusters;
      layout.thrusters.erase(layout.thrusters.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_TRUE(layout.Unpaired().has_value() || !layout.HeavesLevel()) << shipped << i;
    }
  }
}

TEST(VehicleFile, TakesFiveThrustersAndEight) {
  std::string five = Without("e");
  five.replace(five.find("[-0.2, 0, 0]"), 12, "[0, 0, 0]");
  EXPECT_EQ(
      ParseVehicleFile(FileWith("mass_kg: 35", five), "v.yaml").params.thrusters.thrusters.size(),
      5U);
  const std::string eight = std::string(kThrusterLines) +
                            "    - {name: g, at_m: [0, 0.2, 0], push: [0, 0, 1]}\n"
                            "    - {name: h, at_m: [0, -0.2, 0], push: [0, 0, 1]}\n";
  const VehicleFile file = ParseVehicleFile(FileWith("mass_kg: 35", eight), "v.yaml");
  EXPECT_EQ(file.params.thrusters.thrusters.size(), 8U);
  EXPECT_NE(file.params.thrusters.WrenchPerThrust().col(7), Wrench::Zero());
}

TEST(VehicleFile, MissesWhatAThrusterIsCalledAndWhereItPushesWhichWay) {
  const auto with_first = [](const std::string& first) {
    std::string list = kThrusterLines;
    list.replace(list.find("{name: a"), list.find("}") + 1 - list.find("{name: a"), first);
    return ProblemsOf(FileWith("mass_kg: 35", list));
  };
  EXPECT_THAT(with_first("{name: a, push: [1, -1, 0]}"),
              ElementsAre(HasSubstr("thrusters.list[0].at_m: is missing")));
  EXPECT_THAT(with_first("{at_m: [0.2, 0.2, 0], push: [1, -1, 0]}"),
              ElementsAre(HasSubstr("thrusters.list[0].name: is missing")));
  EXPECT_THAT(with_first("{name: a, at_m: [0.2, 0.2, 0]}"),
              ElementsAre(HasSubstr("thrusters.list[0].push: is missing")));
  EXPECT_THAT(with_first("{name: b, at_m: [0.2, 0.2, 0], push: [1, -1, 0]}"),
              ElementsAre(HasSubstr("thrusters.list[1].name: `b` is the name of two thrusters")));
  EXPECT_THAT(with_first("thruster"), testing::SizeIs(1));
}

TEST(VehicleFile, RefusesASensorThatIsCarriedBesideTheVehicle) {
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 35") + "camera: {at_m: [3, 2, 1]}\n"),
              ElementsAre(HasSubstr("camera.at_m: stands 3.74 m from the body's origin, of a hull "
                                    "0.6 m long; allowed: 1.3 m")));
  EXPECT_THAT(ProblemsOf(FileWith("antenna_m: [0, 0, -2]")),
              ElementsAre(HasSubstr("hull.antenna_m: stands 2.00 m from")));
  EXPECT_THAT(ProblemsOf(FileWith("antenna_m: [0, 0, -1.2]")), testing::IsEmpty());
}

TEST(VehicleFile, RefusesAHullThickerThanLongAndOneThatCannotBePushedUnder) {
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 120")),
              ElementsAre(HasSubstr("hull.mass_kg: a hull of 120 kg, 0.6 m long and 0.36 m wide")));
  EXPECT_THAT(ProblemsOf(FileWith("net_buoyancy_n: 300")),
              ElementsAre(HasSubstr("push down with 25.0 N at most: it could not dive")));
}

TEST(VehicleFile, RefusesThrustersThatCannotMoveTheVehicle) {
  std::string flat = kThrusterLines;
  for (std::size_t at = flat.find("[0, 0, 1]"); at != std::string::npos;
       at = flat.find("[0, 0, 1]")) {
    flat.replace(at, 9, "[1, 0, 0]");
  }
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 35", flat)),
              ElementsAre(HasSubstr("cannot push the vehicle ahead, aside and down")));
  std::string idle = kThrusterLines;
  idle.replace(idle.find("[0, 0, 1]"), 9, "[0, 0, 0]");
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 35", idle)),
              ElementsAre(HasSubstr("a thruster pushes some way")));
}

TEST(VehicleFile, RefusesABodyThatContradictsItself) {
  EXPECT_THAT(ProblemsOf(FileWith("width_m: 0.7")), ElementsAre(HasSubstr("longer than wide")));
  EXPECT_THAT(ProblemsOf(FileWith("surfaced_depth_m: 0.4")),
              ElementsAre(HasSubstr("allowed: less than hull.submerged_depth_m")));
}

TEST(VehicleFile, RefusesWhatIsNoYamlAndWhatIsNoMap) {
  EXPECT_THAT(ProblemsOf("name: [unclosed"), ElementsAre(HasSubstr("not YAML")));
  EXPECT_THAT(ProblemsOf("- a\n- b\n"), testing::SizeIs(1));
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 35") + "name: Again\n"),
              ElementsAre(HasSubstr("is given twice")));
}

TEST(VehicleFile, RefusesASecondDocumentWhichNobodyWouldRead) {
  EXPECT_THAT(ProblemsOf(FileWith("mass_kg: 35") + "---\nhull:\n  mass_kg: 50\n"),
              ElementsAre(HasSubstr("a second document")));
  EXPECT_THAT(ProblemsOf("---\n" + FileWith("mass_kg: 35") + "...\n"), testing::IsEmpty());
}

TEST(VehicleFile, LiesBesideTheMissionBeforeItIsLookedForAmongTheShipped) {
  const TemporaryFolder folder;
  const auto beside = [&] { return LoadMissionVehicle("feelhippo.yaml", folder.path()).name; };
  EXPECT_EQ(beside(), "FeelHippo");
  std::ofstream(folder.path() / "feelhippo.yaml") << FileWith("mass_kg: 35");
  EXPECT_EQ(beside(), "Test");
}

TEST(VehicleFile, ThatIsNowhereIsNamedWithThoseThereAre) {
  const TemporaryFolder folder;
  try {
    static_cast<void>(LoadMissionVehicle("feelhipo.yaml", folder.path()));
    FAIL() << "found";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("there is no `feelhipo.yaml`"));
    EXPECT_THAT(error.what(), HasSubstr("feelhippo.yaml"));
  }
}

TEST(VehicleFile, DeclaresEveryKeyOnceWithUnitRangeAndMeaning) {
  VehicleFile vehicle;
  for (const KeySection& section : VehicleFileSections(vehicle)) {
    for (const ParamSpec& key : section.keys) {
      EXPECT_FALSE(key.help.empty()) << section.name << "." << key.name;
      EXPECT_THAT(key.allowed, AnyOf(HasSubstr(" to "), "true or false"))
          << section.name << "." << key.name;
      EXPECT_EQ(key.default_text.empty(), key.is_required) << section.name << "." << key.name;
    }
  }
}

}  // namespace
}  // namespace limpet
