// SPDX-License-Identifier: MIT
// Bids on the motion as text that displays of MOOS-IvP read (BHV_IPF): pieces over the points of
// the helm's domain, linear in the points' indices.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "limpet/helm/motion_decision.hpp"
#include "limpet/helm/motion_domain.hpp"

namespace limpet {

/// The function of one bid, e.g. `H,4,7:go,1,2,1,100,D,speed;0;1;21,G,20,F,0,10,10,0,11,...`, over
/// those variables that it is about; "" if it is about none. Values are 0 to 100: the mean over its
/// preferences (each peak by its share, and the table), of whose shares the weight says the sum,
/// times the behavior's. So weight times value is what the helm adds up, times 100. Peaks are exact
/// at the domain's points but for rounding; tables to half of one in a hundred.
[[nodiscard]] std::string IpfText(const OwnedMotionBid& owned, const MotionDomain& domain,
                                  std::int64_t iteration);

/// How many pieces the function of such a text has.
[[nodiscard]] int IpfPieces(const std::string& text);

/// The text cut into packets of at most 2000 bytes, `P,<behavior>^<iteration>,<packets>,<n>,...`
/// with n from 1; none of an empty text.
[[nodiscard]] std::vector<std::string> IpfPackets(const std::string& text,
                                                  const std::string& behavior,
                                                  std::int64_t iteration);

}  // namespace limpet
