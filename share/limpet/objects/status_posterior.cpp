// SPDX-License-Identifier: MIT
#include "limpet/objects/status_posterior.hpp"

#include <array>
#include <cmath>

#include "limpet/core/entropy.hpp"

namespace limpet {

double StatusPosterior::Entropy() const {
  return MinusPLogP(confirmed) + MinusPLogP(removed) + MinusPLogP(appeared) + MinusPLogP(nothing);
}

std::array<StatusPosterior::Share, 4> StatusPosterior::shares() const {
  return {{{Status::kConfirmed, confirmed},
           {Status::kRemoved, removed},
           {Status::kNew, appeared},
           {Status::kNothing, nothing}}};
}

StatusPosterior StatusPosterior::Times(const PresenceLikelihood& observation) const {
  return {.confirmed = confirmed * observation.if_present,
          .removed = removed * observation.if_absent,
          .appeared = appeared * observation.if_present,
          .nothing = nothing * observation.if_absent};
}

void StatusPosterior::Add(const StatusPosterior& other, double probability) {
  confirmed += probability * other.confirmed;
  removed += probability * other.removed;
  appeared += probability * other.appeared;
  nothing += probability * other.nothing;
}

StatusPosterior StatusPosterior::Normalized() const {
  const double all = sum();
  if (all <= 0.0) {
    return {};
  }
  return {confirmed / all, removed / all, appeared / all, nothing / all};
}

std::string_view NameOf(Status status) {
  switch (status) {
    case Status::kConfirmed:
      return "confirmed";
    case Status::kRemoved:
      return "removed";
    case Status::kNew:
      return "new";
    case Status::kMoved:
      return "moved";
    case Status::kNothing:
      return "nothing";
    case Status::kNotInspected:
      return "not_inspected";
    case Status::kUncertain:
      break;
  }
  return "uncertain";
}

std::optional<Status> StatusFromName(std::string_view name) {
  for (const Status status :
       std::array{Status::kUncertain, Status::kNotInspected, Status::kConfirmed, Status::kRemoved,
                  Status::kNew, Status::kMoved, Status::kNothing}) {
    if (NameOf(status) == name) return status;
  }
  return std::nullopt;
}

}  // namespace limpet
