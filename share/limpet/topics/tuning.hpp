// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/topics/topic.hpp"

namespace limpet::topics {

inline const auto kTuneEvent = Declare<std::string>(
    "TUNE_EVENT",
    "JSON: who changed which parameter of a behavior, from what to what, whether the helm applied "
    "it, and what can be undone",
    {.rate = "on event", .writers = {"limpet tune --live"}});

}  // namespace limpet::topics
