// SPDX-License-Identifier: MIT
#include "limpet/report/html_explanations.hpp"

#include <fmt/format.h>

namespace limpet {
namespace {

struct Explanation {
  const char* term;
  const char* meaning;
};

constexpr Explanation kExplanations[] = {
    {"North, east, down", "Metres from the mission\u2019s datum; down is depth below the surface."},
    {"Way",
     "True distance travelled. Ways to a coverage count from the moment the vehicle was at survey "
     "altitude at its "
     "start point; the way of a session counts everything."},
    {"Bottom",
     "One jittered point per 0.25 m cell of the area; a point counts once it has been inside the "
     "camera\u2019s true "
     "footprint. Nothing the vehicle believes enters."},
    {"Band",
     "Objects float, and higher up the image is narrower. Samples are object centres at random "
     "heights between one "
     "object radius and the greatest height; one counts once 60 % of its disc was inside the image "
     "in three frames."},
    {"Lanes, reckoned",
     "What parallel lanes in the best direction, number and order would take over the same area, "
     "from the same start and home again, with the same turns, flown exactly and without a look at "
     "any object. Less than 1.00 of that: this survey beat them."},
    {"Whose options were flown",
     "Generators of options (plan, beam, tour, home ...), how far the vehicle flew on what each "
     "had offered, and in how many decisions it was chosen."},
    {"Error, aligned",
     "Distance in three dimensions between where the smoother places an object and where it is. "
     "Aligned: after removing "
     "the session\u2019s common shift and heading, which GPS and the first heading leave and "
     "nothing under water can undo."},
    {"Sd", "One standard deviation [m], as the smoother itself says."},
    {"Looks", "Independent looks at an object in this session, with or without a detection."},
    {"P",
     "Probability of what was decided; for objects of a discovery session, that an object is "
     "there."},
    {"Found, missed, invented, misplaced",
     "Reported and true objects are matched one to one, nearest first, within 2.5 m. A true object "
     "without a report is "
     "missed; a report without an object is invented; an object found more than 1 m off is "
     "misplaced. Reported is also what the vehicle holds to be there now with a probability of 0.9 "
     "or more, though it leaves open whether it was there before."},
    {"Confirmed, removed, new, moved",
     "There in both sessions; only in the former; only in this one; in both, elsewhere. Uncertain: "
     "the vehicle will not say; such a status is open, neither right nor wrong."},
    {"Position error",
     "Between estimate, as known at the time, and truth, from the start of the survey; rms over "
     "time. At the end: as the vehicle begins its last ascent, before GPS returns; so is dead "
     "reckoning\u2019s, for a fair comparison."},
    {"Dead reckoning",
     "Integrating the DVL\u2019s velocity alone from the first GPS fix, for comparison."},
    {"NEES",
     "Squared error over the estimator\u2019s own variance, summed over three axes: 3 is "
     "consistent, more is "
     "overconfident, less is cautious."},
    {"Warnings",
     "What apps warned of before the mission ended, in seconds after the session\u2019s begin. An "
     "alarm: vehicle, mission or data were at stake. A warning: something worked less well than it "
     "should. A note: worth knowing."},
    {"Real time", "Duration of the session over the time the computer took."}};

}  // namespace

std::string Explanations() {
  std::string out = "<section id=\"meaning\">\n<h2>What the numbers mean</h2>\n<dl>\n";
  for (const Explanation& entry : kExplanations) {
    out += fmt::format("<dt>{}</dt><dd>{}</dd>\n", entry.term, entry.meaning);
  }
  return out + "</dl>\n</section>\n";
}

}  // namespace limpet
