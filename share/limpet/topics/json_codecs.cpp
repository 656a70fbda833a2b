// SPDX-License-Identifier: MIT
// Every topic that travels as JSON, in the one translation unit that pays for the JSON library.
#include <nlohmann/json.hpp>

#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/sensors.hpp"

namespace nlohmann {
template <class D>
struct adl_serializer<limpet::Quantity<D>> {
  static void to_json(json& out, const limpet::Quantity<D>& value) { out = value.value(); }
  static void from_json(const json& in, limpet::Quantity<D>& value) {
    value = limpet::Quantity<D>(in.get<double>());
  }
};
template <>
struct adl_serializer<std::optional<double>> {
  static void to_json(json& out, const std::optional<double>& value) {
    out = value ? json(*value) : json(nullptr);
  }
  static void from_json(const json& in, std::optional<double>& value) {
    value = in.is_null() ? std::optional<double>() : in.get<double>();
  }
};
}  // namespace nlohmann

namespace limpet {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Box, u, v, w, h, confidence, color)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Detections, frame, exposure, boxes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Landmark, id, ned, cov, color, looks, is_confirmed, prior_id)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LandmarkJoint, ids, lower)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Landmarks, landmarks)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SightedBox, box, landmark)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Sight, frame, exposure, ned, roll, pitch, yaw, altitude, boxes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TrackShift, steps)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ChangePosterior, confirmed, removed, appeared, nothing)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OpiBelief, id, landmark, prior_id, ned, cov, centroid,
                                   centroid_sd, color, probability, posterior, decided, looks,
                                   entropy, log_likelihood_ratio)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OpiBeliefs, opis)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PriorOpi, id, ned, cov, color, log_likelihood_ratio, looks)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SessionPrior, session, opis, views, joint)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PathSegment, curvature, length)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HelmPath, id, north, east, yaw, segments, purpose)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OptionBid, behavior, value, weight, has_veto, why)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BiddenOption, source, length, total, rate, end, bids)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RevisitInterest, id, state, worth, fruitless)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HelmRevisits, objects)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HelmBids, path_id, cause, considered, options)

template <class T>
Value JsonCodec<T>::Encode(const T& value) {
  // Broken UTF-8 in a name must not throw here, where nothing may throw.
  return nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

template <class T>
std::optional<T> JsonCodec<T>::Decode(const Value& value) {
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) {
    return std::nullopt;
  }
  try {
    return nlohmann::json::parse(*text).get<T>();
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // text from another program need not be what we expect
  }
}

template struct JsonCodec<Detections>;
template struct JsonCodec<Landmarks>;
template struct JsonCodec<LandmarkJoint>;
template struct JsonCodec<Sight>;
template struct JsonCodec<TrackShift>;
template struct JsonCodec<OpiBeliefs>;
template struct JsonCodec<SessionPrior>;
template struct JsonCodec<HelmPath>;
template struct JsonCodec<HelmBids>;
template struct JsonCodec<HelmRevisits>;

}  // namespace limpet
