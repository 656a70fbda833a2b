// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "estimation/matching/session_matching.hpp"

namespace limpet {

/// Where a former session's frame is looked for that lies elsewhere than its fixes and compass say:
/// another datum, another map, a compass that nobody calibrated.
struct FrameSearchParams {
  double radius_m = 50.0;
  Radians turn = Radians::FromTextUnit(60.0);
};

/// A frame, and how much likelier the objects are with it than without any relation of the two
/// sessions, as MatchEvidence has it.
struct FoundFrame {
  FrameOffset offset;
  double evidence = 0.0;
};

/// The frame in which most of the former objects lie where one of now does: pairs of neighbours
/// that are as far apart as two of now propose frames, the likeliest are refined. Nothing if none
/// is clearly likelier than no relation and than every other frame. Objects that went or came have
/// no part in it. Each object's covariance is its own, own_covariance.hpp.
[[nodiscard]] std::optional<FoundFrame> SearchFrame(const std::vector<ObjectEstimate>& former,
                                                    const std::vector<ObjectEstimate>& now,
                                                    const MatchingParams& params,
                                                    const FrameSearchParams& search = {});

/// The objects as a frame that is off by `offset` has them.
[[nodiscard]] std::vector<ObjectEstimate> Moved(std::vector<ObjectEstimate> objects,
                                                const FrameOffset& offset);

}  // namespace limpet
