// SPDX-License-Identifier: MIT
// How an operator sets the area before the dive.
#pragma once

#include <optional>
#include <string>

#include "limpet/topics/topic.hpp"

namespace limpet {

/// What an operator wants surveyed; what is absent stays as it is or, of zones, region and transit,
/// is none. Lists of points as in SurveyArea.
struct SurveyAreaRequest {
  std::string outline;
  std::optional<std::string> keep_out{}, operating_region{}, transit{};
  std::optional<double> margin{}, object_height_max{};  ///< [m]
  template <class V>
  void Describe(V& visit) {
    visit("area", outline), visit("keep_out", keep_out);
    visit("operating_region", operating_region), visit("transit", transit);
    visit("margin", margin), visit("object_height_max", object_height_max);
  }
};

struct SurveyAreaAnswer {
  std::string hash;  ///< of the request that is answered
  bool is_accepted = false;
  std::string why{};  ///< it is not, in braces; empty
  template <class V>
  void Describe(V& visit) {
    visit("hash", hash), visit("accepted", is_accepted), visit("why", why);
  }
};

namespace topics {
inline const auto kSurveyAreaRequest = Declare<std::string>(
    "SURVEY_AREA_REQUEST",
    "area to survey in place of the mission's, before the dive: "
    "[hash=h,]area={x,y:x,y:x,y}[,keep_out={..}{..}][,operating_region={..}][,transit={..}]"
    "[,margin=m][,object_height_max=m]; h, XXH3 (64 bits, hexadecimal) of all behind its comma, "
    "says that it came whole; the mission's zones, region and transit all go: those that are to "
    "stay are said again",
    {.unit = "m",
     .frame = "x east, y north",
     .rate = "on event",
     .writers = {"operator"},
     .is_command = true});
inline const auto kSurveyAreaAnswer = Declare<SurveyAreaAnswer>(
    "SURVEY_AREA_ANSWER",
    "whether SURVEY_AREA is now what the request of that hash says, or why not",
    {.rate = "on event", .writers = {"pSurvey"}});
}  // namespace topics

}  // namespace limpet
