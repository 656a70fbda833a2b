// SPDX-License-Identifier: MIT
// The parts of a preflight, for this library only. Each adds what it finds.
#pragma once

#include <filesystem>
#include <string_view>

#include "limpet/preflight/mission_reading.hpp"
#include "limpet/preflight/preflight.hpp"
#include "limpet/preflight/survey_facts.hpp"

namespace limpet::internal {

/// Throws ConfigError for what is there and no plain file, before it is opened: nobody may ever
/// write to a named pipe.
void RequirePlainFile(const std::filesystem::path& file);

// Syntax.
void CheckBlockNames(const MissionReading& reading, MissionProblems& found);
void CheckGlobals(const MissionReading& reading, MissionProblems& found);
/// Macros that a mission defines and nothing in its files uses: notes, but of a numbered series.
void CheckMacros(const MissionReading& reading, MissionProblems& found);
/// That the mission says which vehicle flies it, if it starts an app that needs to know. False: it
/// is to be known and is not.
[[nodiscard]] bool CheckVehicle(const MissionReading& reading, MissionProblems& found);
void CheckLaunches(const MissionReading& reading, MissionProblems& found);
void CheckBlocks(const MissionReading& reading, MissionProblems& found);
void CheckBehaviors(const MissionReading& reading, MissionProblems& found);
/// Who reads a behavior file: a mission of ours, or of other people's; nobody says whose it is.
enum class BehaviorReader { kOurs, kOthers, kUnknown };
/// Sorts the behaviors of a file into ours, which stay, and others', which are noted. A slip of the
/// pen is a problem unless others read the file, or nobody says who does and it may be a variant; a
/// name that no helm takes always is.
void SetStrangersAside(BehaviorFile& file, BehaviorReader reader, MissionProblems& found);
/// Of a helm that leads another one: that there is one, and that its behaviors take what it is
/// told.
void CheckLead(const MissionReading& reading, MissionProblems& found);
/// Parameters that are one fact and are said in several places.
void CheckAgreement(const MissionReading& reading, MissionProblems& found);
/// Whose block was written for a stock program.
[[nodiscard]] bool IsForStock(const MissionReading& reading, std::string_view process);
/// Where to say what is wrong with the block of an app that is launched: refused_here if it was
/// written for a stock program. What is there becomes a note, too, once all is checked.
[[nodiscard]] std::vector<ConfigProblem>& ListFor(const MissionReading& reading,
                                                  std::string_view process, MissionProblems& found);
/// Apps that others need to hear. Returns what the apps cannot be built with; where it is known
/// more exactly, that is said instead. Of apps whose block was written for a stock program it is a
/// note.
[[nodiscard]] std::vector<ConfigProblem> CheckRoles(const MissionReading& reading,
                                                    MissionProblems& found);

/// Notes of what scenario.yaml says that no run of the mission would show.
void CheckScenario(const MissionReading& reading, MissionProblems& found);

// Geometry, once the syntax is right.
void CheckView(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found);
void CheckDepths(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found);
/// False if the area has no extent or is beyond all bounds: nothing else can then be said.
[[nodiscard]] bool CheckArea(const MissionReading& reading, const SurveyFacts& survey,
                             MissionProblems& found);
/// Checks the shape of an area that is no plain rectangle.
void CheckShape(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found);
void CheckObjects(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found);
void CheckEndurance(const MissionReading& reading, const SurveyFacts& survey,
                    MissionProblems& found);
/// What of a session costs energy: the way out, which is transit and survey, the way home from the
/// farthest place, and the current that it may be against.
struct SessionWay {
  double out_m = 0.0;
  double home_m = 0.0;
  double current_mps = 0.0;
};
/// REQUIRES: a speed above 0.
void CheckEnergy(const MissionReading& reading, const SurveyFacts& survey, const SessionWay& way,
                 MissionProblems& found);
/// True if the mission turns the rule off, or does not launch pSafety.
[[nodiscard]] bool IsRuleOff(const MissionReading& reading, std::string_view rule);
/// `deepest`: where the survey is flown [m].
void CheckDepthLimit(const MissionReading& reading, double deepest, MissionProblems& found);
void CheckSafety(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found);
void CheckMotion(const MissionReading& reading, MissionProblems& found);

/// The known word that a slip of the pen (one letter in four, or two that changed places) would
/// make of `word`; "" if there is none or the word is known.
[[nodiscard]] std::string SlipOf(std::string_view word, const std::vector<std::string>& known);

/// Behaviors of MOOS-IvP that Limpet does not have: none of them is a slip.
[[nodiscard]] const std::vector<std::string>& StockBehaviors();

}  // namespace limpet::internal
