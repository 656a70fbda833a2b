// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/change.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "apps/pMap/map_app.hpp"
#include "apps/pMap/map_conversions.hpp"
#include "limpet/core/config.hpp"
#include "limpet/session/session_memory.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

struct LoadedSession {
  SessionFacts facts;
  SessionMemory memory;
};

LoadedSession Load(const std::string& folder) {
  const auto refuse = [&folder](const std::string& why) {
    return ConfigError(ConfigProblem{.where = {.file = folder, .line = 0}, .key = "", .text = why});
  };
  Expected<StoredSession> stored = LoadSession(folder);
  if (!stored) throw refuse(stored.error().text);
  Expected<SessionMemory> memory = MemoryOf(stored->files);
  if (!memory) throw refuse(memory.error().text);
  return {stored->facts, *std::move(memory)};
}

/// Objects of the saved session that its smoother had as landmarks.
Landmarks LandmarksOf(const OpiBeliefs& objects) {
  Landmarks landmarks;
  for (const OpiBelief& opi : objects.opis) {
    if (opi.landmark < 0) continue;
    landmarks.landmarks.push_back({.id = opi.landmark,
                                   .ned = opi.ned,
                                   .cov = opi.cov,
                                   .color = opi.color,
                                   .looks = opi.looks,
                                   .is_confirmed = true,
                                   .prior_id = -1});
  }
  return landmarks;
}

/// What session B, replayed, believes about the objects of both.
StatusBook Compare(const LoadedSession& a, const LoadedSession& b) {
  const MapApp::Params params;
  StatusBook book(params.status, params.camera.geometry());
  const SessionPrior prior = PriorOf(a.facts, a.memory);
  book.SetFormerViews(FormerViewsOf(prior));
  book.SetFormer(FormerOf(prior));
  for (const Sight& sight : b.memory.sights) {
    if (sight.altitude && *sight.altitude <= params.highest_view.value()) {
      book.AddSight(RecordOf(sight));
    }
  }
  book.SetLandmarks(ConfirmedOf(LandmarksOf(b.memory.objects)));
  return book;
}

OrderedJson JsonOf(const ObjectStatus& object) {
  const StatusPosterior& p = object.posterior;
  const Eigen::Vector3d& ned = object.object.ned;
  return {
      {"decided", NameOf(object.decided)},
      {"color", object.object.color},
      {"ned_m", {ned.x(), ned.y(), ned.z()}},
      {"id_a", object.former >= 0 ? OrderedJson(object.former) : OrderedJson(nullptr)},
      {"landmark_b", object.landmark >= 0 ? OrderedJson(object.landmark) : OrderedJson(nullptr)},
      {"posterior",
       {{"confirmed", p.confirmed},
        {"removed", p.removed},
        {"new", p.appeared},
        {"nothing", p.nothing}}},
      {"looks_b", object.looks},
      {"looks_with_box_b", object.looks_with_box},
      {"log_likelihood_ratio_b", object.lambda}};
}

OrderedJson JsonOf(const SessionFacts& facts) {
  return {{"mission", facts.mission},
          {"session", facts.session},
          {"seed", facts.seed},
          {"saved_at_s", facts.saved_at}};
}

}  // namespace

int RunChange(std::span<const std::string> args) {
  const Arguments given(args, {"session-a", "session-b"}, {"json", "help"});
  if (given.Has("help")) {
    fmt::print(
        "usage: limpet change --session-a DIR --session-b DIR\n\nWhat changed from session A to "
        "session B, from their saved frames and objects, as JSON.\nDIR is a session's run folder "
        "or the session folder in it.\n");
    return kOk;
  }
  if (!given.Find("session-a") || !given.Find("session-b") || !given.positionals().empty()) {
    throw UsageError("change takes --session-a DIR and --session-b DIR");
  }
  const LoadedSession a = Load(*given.Find("session-a"));
  const LoadedSession b = Load(*given.Find("session-b"));
  StatusBook book = Compare(a, b);
  OrderedJson objects = OrderedJson::array();
  for (const ObjectStatus& object : book.Assess()) {
    objects.push_back(JsonOf(object));
  }
  const FrameOffset& offset = book.offset();
  const OrderedJson out{{"session_a", JsonOf(a.facts)},
                        {"session_b", JsonOf(b.facts)},
                        {"offset",
                         {{"north_m", offset.shift.x()},
                          {"east_m", offset.shift.y()},
                          {"turn_deg", DegreesFromRadians(offset.turn)}}},
                        {"changes", objects}};
  fmt::print("{}\n", out.dump(1));
  return kOk;
}

}  // namespace limpet
