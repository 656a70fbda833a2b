// SPDX-License-Identifier: MIT
// Every topic that travels as JSON, in the one translation unit that pays for the JSON library.
#include <array>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "limpet/core/lower_triangle.hpp"
#include "limpet/topics/energy.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/safety.hpp"
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

/// How a message says that there is no such landmark or object.
constexpr int kNoId = -1;

std::optional<int> IdFrom(const nlohmann::json& in) {
  const int id = in;
  return id < 0 ? std::nullopt : std::optional(id);
}

/// Which landmark it shows is said beside a box, where it is known.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Box, u, v, w, h, confidence, color)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Detections, frame, exposure, boxes)

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SonarPing, first, step, reach, ranges)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PosedSonar, north, east, down, roll, pitch, yaw, ping)

void to_json(nlohmann::json& out, const TrackShift& shift) {
  out = {{"steps", shift.steps}};
  if (!shift.sigmas.empty()) out["sigmas"] = shift.sigmas;
}

void from_json(const nlohmann::json& in, TrackShift& shift) {
  in.at("steps").get_to(shift.steps);
  if (in.contains("sigmas")) in.at("sigmas").get_to(shift.sigmas);
}

/// Under the names of its fields, not those of the statuses, as MAP_OPIS has always had it.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StatusPosterior, confirmed, removed, appeared, nothing)

nlohmann::json TripleOf(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Vector3d VectorFrom(const nlohmann::json& in) {
  const auto v = in.get<std::array<double, 3>>();
  return {v[0], v[1], v[2]};
}

/// Stands among the fields of whoever has it; the covariance as its upper triangle: nn, ne, nd, ee,
/// ed, dd.
void AddEstimate(const ObjectEstimate& object, nlohmann::json& out) {
  const Eigen::Matrix3d& S = object.cov_W;
  out["ned"] = TripleOf(object.p_W);
  out["cov"] = {S(0, 0), S(0, 1), S(0, 2), S(1, 1), S(1, 2), S(2, 2)};
  out["color"] = object.color;
  if (object.size) {
    out["radius_m"] = object.size->radius;
    out["radius_sd_m"] = object.size->sd;
  }
}

ObjectEstimate EstimateFrom(const nlohmann::json& in) {
  const auto cov = in.at("cov").get<std::array<double, 6>>();
  ObjectEstimate object{.p_W = VectorFrom(in.at("ned")), .cov_W = {}, .color = in.at("color")};
  object.cov_W << cov[0], cov[1], cov[2],  //
      cov[1], cov[3], cov[4],              //
      cov[2], cov[4], cov[5];
  if (in.contains("radius_m") && in.contains("radius_sd_m"))
    object.size = ObjectSize{.radius = in.at("radius_m"), .sd = in.at("radius_sd_m")};
  return object;
}

/// `prior_candidates` is there only while the match is undecided, `prior_p` only where it is
/// below 1. `is_confirmed` says of every landmark what being one means, for those who ask.
void to_json(nlohmann::json& out, const Landmark& landmark) {
  out = {{"id", landmark.id},
         {"looks", landmark.detections},
         {"is_confirmed", true},
         {"prior_id", landmark.former.id.value_or(kNoId)}};
  if (landmark.former.id && landmark.former.probability < 1.0) {
    out["prior_p"] = landmark.former.probability;
  }
  for (const FormerCandidate& candidate : landmark.former.candidates) {
    out["prior_candidates"].push_back({{"id", candidate.id}, {"p", candidate.probability}});
  }
  AddEstimate(landmark.object, out);
}

void from_json(const nlohmann::json& in, Landmark& landmark) {
  landmark = {.id = in.at("id"),
              .object = EstimateFrom(in),
              .detections = in.at("looks"),
              .former = {.id = IdFrom(in.at("prior_id")), .probability = in.value("prior_p", 1.0)}};
  for (const nlohmann::json& candidate : in.value("prior_candidates", nlohmann::json::array())) {
    landmark.former.candidates.push_back(
        {.id = candidate.at("id"), .probability = candidate.at("p")});
  }
}

/// Matrices that are none come as empty ones.
Eigen::MatrixXd SymmetricFrom(const nlohmann::json& lower) {
  return FromLowerTriangle(lower.get<std::vector<double>>()).value_or(Eigen::MatrixXd());
}

void to_json(nlohmann::json& out, const LandmarkCovariance& joint) {
  out = {{"ids", joint.ids}, {"lower", LowerTriangleOf(joint.cov_W)}};
}

void from_json(const nlohmann::json& in, LandmarkCovariance& joint) {
  in.at("ids").get_to(joint.ids);
  joint.cov_W = SymmetricFrom(in.at("lower"));
}

/// `probability` and `entropy` follow from the posterior, and are written for those who read only
/// them.
void to_json(nlohmann::json& out, const OpiBelief& opi) {
  out = {{"id", opi.id},
         {"landmark", opi.landmark.value_or(kNoId)},
         {"prior_id", opi.former_id.value_or(kNoId)},
         {"centroid", TripleOf(opi.centroid_W)},
         {"centroid_sd", TripleOf(opi.centroid_sd_W)},
         {"probability", opi.posterior.present()},
         {"posterior", opi.posterior},
         {"decided", NameOf(opi.decided)},
         {"looks", opi.looks},
         {"entropy", opi.posterior.Entropy()},
         {"log_likelihood_ratio", opi.log_likelihood_ratio}};
  if (opi.moved_probability) out["moved_probability"] = *opi.moved_probability;
  AddEstimate(opi.object, out);
}

void from_json(const nlohmann::json& in, OpiBelief& opi) {
  opi = {
      .id = in.at("id"),
      .landmark = IdFrom(in.at("landmark")),
      .former_id = IdFrom(in.at("prior_id")),
      .object = EstimateFrom(in),
      .log_likelihood_ratio = in.at("log_likelihood_ratio"),
      .looks = in.at("looks"),
      .posterior = in.at("posterior"),
      .decided = StatusFromName(in.at("decided").get<std::string>()).value_or(Status::kUncertain),
      .centroid_W = VectorFrom(in.at("centroid")),
      .centroid_sd_W = VectorFrom(in.at("centroid_sd"))};
  if (in.contains("moved_probability")) opi.moved_probability = in.at("moved_probability");
}

void to_json(nlohmann::json& out, const FormerObject& former) {
  out = {{"id", former.id},
         {"log_likelihood_ratio", former.log_likelihood_ratio},
         {"looks", former.looks}};
  AddEstimate(former.object, out);
}

void from_json(const nlohmann::json& in, FormerObject& former) {
  former = {.id = in.at("id"),
            .object = EstimateFrom(in),
            .log_likelihood_ratio = in.at("log_likelihood_ratio"),
            .looks = in.at("looks")};
}

void to_json(nlohmann::json& out, const Landmarks& all) { out = {{"landmarks", all.landmarks}}; }

/// What another program writes that is not confirmed is no landmark.
void from_json(const nlohmann::json& in, Landmarks& all) {
  for (const auto& one : in.at("landmarks").get<std::vector<nlohmann::json>>()) {
    const Landmark landmark = one;
    if (one.at("is_confirmed").get<bool>()) all.landmarks.push_back(landmark);
  }
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OpiBeliefs, opis)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Obstacle, id, outline, top)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Obstacles, obstacles)

void to_json(nlohmann::json& out, const ObservedFrame& frame) {
  const Pose& X_WB = frame.X_WB;
  nlohmann::json boxes = nlohmann::json::array();
  for (const Box& box : frame.boxes) {
    boxes.push_back({{"box", box}, {"landmark", box.landmark.value_or(kNoId)}});
  }
  out = {{"frame", frame.frame},       {"exposure", frame.exposure}, {"ned", TripleOf(X_WB.p_WB)},
         {"roll", X_WB.roll},          {"pitch", X_WB.pitch},        {"yaw", X_WB.yaw},
         {"altitude", frame.altitude}, {"boxes", std::move(boxes)}};
  if (frame.sigma) {
    out["sd_absolute"] = frame.sigma->absolute;
    out["sd_beside"] = frame.sigma->beside;
  }
}

void from_json(const nlohmann::json& in, ObservedFrame& frame) {
  in.at("frame").get_to(frame.frame);
  in.at("exposure").get_to(frame.exposure);
  frame.X_WB = {VectorFrom(in.at("ned")), in.at("roll"), in.at("pitch"), in.at("yaw")};
  in.at("altitude").get_to(frame.altitude);
  for (const nlohmann::json& entry : in.at("boxes")) {
    frame.boxes.push_back(entry.at("box").get<Box>());
    frame.boxes.back().landmark = IdFrom(entry.at("landmark"));
  }
  if (in.contains("sd_absolute") && in.contains("sd_beside")) {
    frame.sigma = PlaceSigma{.absolute = in.at("sd_absolute"), .beside = in.at("sd_beside")};
  }
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WaterVisibility, visibility, sd)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ContrastBin, from, clear, log_contrast, faint, log_limit)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WaterRecord, visibility, estimate, contrasts)

/// A view is t [s], north, east, down [m], roll, pitch, yaw [rad], altitude [m] and its age [s];
/// its boxes stand apart, each with the view's index.
void to_json(nlohmann::json& out, const SessionPrior& prior) {
  nlohmann::json views = nlohmann::json::array(), boxes = nlohmann::json::array();
  for (const FormerView& view : prior.views) {
    const ObservedFrame& frame = view.frame;
    const Pose& X_WB = frame.X_WB;
    for (const Box& box : frame.boxes) {
      boxes.push_back({{"view", views.size()}, {"box", box}});
    }
    views.push_back({frame.exposure, X_WB.p_WB.x(), X_WB.p_WB.y(), X_WB.p_WB.z(), X_WB.roll,
                     X_WB.pitch, X_WB.yaw, frame.altitude.value_or(0.0), view.altitude_age});
  }
  out = {{"session", prior.session},
         {"opis", prior.former.objects},
         {"views", std::move(views)},
         {"boxes", std::move(boxes)},
         {"map_parameters", prior.map_parameters},
         {"joint", LowerTriangleOf(prior.former.joint_cov_W)}};
  if (prior.water) {
    out["visibility_m"] = prior.water->visibility.value();
    out["visibility_sd_m"] = prior.water->sd.value();
  }
  if (!prior.obstacles.empty()) out["obstacles"] = prior.obstacles;
}

void from_json(const nlohmann::json& in, SessionPrior& prior) {
  in.at("session").get_to(prior.session);
  in.at("opis").get_to(prior.former.objects);
  for (const auto& [t, north, east, down, roll, pitch, yaw, altitude, age] :
       in.at("views").get<std::vector<std::array<double, 9>>>()) {
    prior.views.push_back({.frame = {.exposure = Seconds(t),
                                     .X_WB = {{north, east, down}, roll, pitch, yaw},
                                     .altitude = altitude},
                           .altitude_age = Seconds(age)});
  }
  for (const nlohmann::json& box : in.at("boxes")) {
    const auto view = box.at("view").get<std::size_t>();
    if (view < prior.views.size()) {  // text from another program may point anywhere
      prior.views[view].frame.boxes.push_back(box.at("box").get<Box>());
    }
  }
  in.at("map_parameters").get_to(prior.map_parameters);
  if (in.contains("visibility_m") && in.contains("visibility_sd_m")) {
    prior.water = WaterVisibility{.visibility = in.at("visibility_m").get<Meters>(),
                                  .sd = in.at("visibility_sd_m").get<Meters>()};
  }
  prior.obstacles = in.value("obstacles", std::vector<Obstacle>());
  prior.former.joint_cov_W = SymmetricFrom(in.at("joint"));
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PathSegment, curvature, length)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HelmPath, id, north, east, yaw, segments, purpose)

void to_json(nlohmann::json& out, const WeightedBid& weighted) {
  out = {{"behavior", weighted.behavior},
         {"value", weighted.bid.value},
         {"weight", weighted.weight},
         {"has_veto", weighted.bid.veto.has_value()},
         {"why", WhyText(weighted.bid)}};
}

void from_json(const nlohmann::json& in, WeightedBid& weighted) {
  weighted = {
      .behavior = in.at("behavior"), .weight = in.at("weight"), .bid = {.value = in.at("value")}};
  const std::string why = in.at("why");
  if (in.at("has_veto").get<bool>()) {
    weighted.bid.veto = why;
  } else {
    weighted.bid.why = ReasonsIn(why);
  }
}

void to_json(nlohmann::json& out, const BiddenOption& option) {
  out = {{"source", option.source}, {"length", option.length}, {"total", option.total},
         {"rate", option.rate},     {"end", option.end},       {"bids", option.bids}};
  if (option.rate_length) out["rate_length"] = *option.rate_length;
}

void from_json(const nlohmann::json& in, BiddenOption& option) {
  option = {.source = in.at("source"),
            .length = in.at("length"),
            .total = in.at("total"),
            .rate = in.at("rate"),
            .rate_length = std::nullopt,
            .end = in.at("end"),
            .bids = in.at("bids")};
  if (const auto shared = in.find("rate_length"); shared != in.end()) option.rate_length = *shared;
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MotionOpinion, behavior, variables, weight, value, summit,
                                   flat_half_width, base_half_width)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HelmMotion, course_deg, speed_mps, depth_m, opinions)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RevisitInterest, id, state, worth, fruitless)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HelmRevisits, objects)

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CourseCost, metres)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SafetyRuleState, rule, margin, stands)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SafetyState, action, rule, since, rules)

constexpr const char* kByRate = "rate";
constexpr const char* kByTotal = "total";

void to_json(nlohmann::json& out, const HelmBids& bids) {
  out = {{"path_id", bids.path_id},
         {"cause", bids.cause},
         {"considered", bids.considered},
         {"ranked_by", bids.order == OptionOrder::kBySum ? kByTotal : kByRate},
         {"options", bids.options}};
}

/// A log that does not say by what options were ranked is an old one: it was by rate.
void from_json(const nlohmann::json& in, HelmBids& bids) {
  static const nlohmann::json kOrders = {{kByRate, false}, {kByTotal, true}};
  const bool is_by_sum = kOrders.at(in.value("ranked_by", std::string(kByRate)));
  bids = {.path_id = in.at("path_id"),
          .cause = in.at("cause"),
          .considered = in.at("considered"),
          .order = is_by_sum ? OptionOrder::kBySum : OptionOrder::kPerMetre,
          .options = in.at("options")};
}

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
template struct JsonCodec<LandmarkCovariance>;
template struct JsonCodec<ObservedFrame>;
template struct JsonCodec<TrackShift>;
template struct JsonCodec<SonarPing>;
template struct JsonCodec<PosedSonar>;
template struct JsonCodec<OpiBeliefs>;
template struct JsonCodec<Obstacles>;
template struct JsonCodec<WaterRecord>;
template struct JsonCodec<SessionPrior>;
template struct JsonCodec<HelmPath>;
template struct JsonCodec<HelmBids>;
template struct JsonCodec<HelmMotion>;
template struct JsonCodec<HelmRevisits>;
template struct JsonCodec<CourseCost>;
template struct JsonCodec<SafetyState>;

}  // namespace limpet
