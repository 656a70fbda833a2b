// SPDX-License-Identifier: MIT
// Every topic that travels as JSON, filled at random: it comes back the same, and whatever another
// program sends in its place is refused without a crash.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limpet/core/random.hpp"
#include "limpet/topics/energy.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

using Json = nlohmann::json;

class Maker {
 public:
  explicit Maker(Random& random) : random_(random) {}
  double Real() { return random_.Uniform(-100.0, 100.0); }
  int Whole() { return static_cast<int>(random_.Index(1000)); }
  std::size_t Few() { return 1 + random_.Index(3); }
  std::string Word() {
    const std::array<const char*, 4> words{"orange", "a \"quoted\" word", "Ärger", "two\nlines"};
    return words[random_.Index(words.size())];
  }
  Eigen::Vector3d Place() { return {Real(), Real(), Real()}; }
  Eigen::MatrixXd Symmetric(Eigen::Index size) {
    const Eigen::MatrixXd half =
        Eigen::MatrixXd::NullaryExpr(size, size, [this] { return random_.Uniform(-1.0, 1.0); });
    return half * half.transpose();
  }
  ObjectEstimate Object() {
    return {Place(), Symmetric(3), Word(), ObjectSize{.radius = Real(), .sd = Real()}};
  }
  Box OneBox() {
    return {.u = Real(), .v = Real(), .w = Real(), .h = Real(), .confidence = 0.5, .color = Word()};
  }

  void Fill(Detections& out) {
    out = {.frame = Whole(), .exposure = Seconds(Real()), .boxes = {}};
    for (std::size_t i = Few(); i > 0; --i)
      out.boxes.push_back(OneBox());
  }
  void Fill(Landmarks& out) {
    for (std::size_t i = Few(); i > 0; --i) {
      out.landmarks.push_back(
          {.id = Whole(),
           .object = Object(),
           .detections = Whole(),
           .former = {.id = Whole(), .candidates = {{Whole(), 0.25}, {Whole(), 0.5}}}});
    }
  }
  void Fill(LandmarkCovariance& out) { out = {{Whole(), Whole()}, Symmetric(6)}; }
  void Fill(ObservedFrame& out) {
    out = {.frame = Whole(),
           .exposure = Seconds(Real()),
           .X_WB = {Place(), 0.1, -0.2, 0.3},
           .altitude = 4.5,
           .boxes = {OneBox(), OneBox()}};
    out.boxes[1].landmark = Whole();
  }
  void Fill(TrackShift& out) {
    for (std::size_t i = Few(); i > 0; --i)
      out.steps.push_back({Real(), 1.0, 2.0, 3.0, Real()});
  }
  void Fill(OpiBeliefs& out) {
    for (std::size_t i = Few(); i > 0; --i) {
      OpiBelief opi;
      opi.id = Whole();
      opi.landmark = Whole();
      opi.former_id = Whole();
      opi.object = Object();
      opi.log_likelihood_ratio = Real();
      opi.looks = Whole();
      opi.posterior = {.confirmed = 0.4, .removed = 0.3, .appeared = 0.2, .nothing = 0.1};
      opi.decided = Status::kConfirmed;
      opi.centroid_W = Place();
      opi.centroid_sd_W = Place();
      out.opis.push_back(opi);
    }
  }
  void Fill(SessionPrior& out) {
    out.session = Word();
    for (std::size_t i = Few(); i > 0; --i) {
      out.former.objects.push_back({Whole(), Object(), Real(), Whole()});
      ObservedFrame frame;
      Fill(frame);
      out.views.push_back({.frame = frame, .altitude_age = Seconds(Real())});
    }
    out.map_parameters = {{"camera_width_px", "640"}, {Word(), Word()}};
    out.former.joint_cov_W = Symmetric(static_cast<Eigen::Index>(3 * out.former.objects.size()));
    out.water = WaterVisibility{.visibility = Meters(Real()), .sd = Meters(Real())};
  }
  void Fill(WaterRecord& out) {
    out = {.visibility = Real(),
           .estimate = {.visibility = Meters(Real()), .sd = Meters(Real())},
           .contrasts = {{.from = Real(), .clear = 1, .log_contrast = Real()}}};
  }
  void Fill(HelmPath& out) {
    out = {.id = Whole(),
           .north = Real(),
           .east = Real(),
           .yaw = Real(),
           .segments = {},
           .purpose = Word()};
    for (std::size_t i = Few(); i > 0; --i)
      out.segments.push_back({Real(), Real()});
  }
  void Fill(HelmBids& out) {
    out = {.path_id = Whole(),
           .cause = Word(),
           .considered = Whole(),
           .order = random_.Chance(0.5) ? OptionOrder::kBySum : OptionOrder::kPerMetre,
           .options = {}};
    for (std::size_t i = Few(); i > 0; --i) {
      Bid bid{.value = Real()};
      if (random_.Chance(0.5)) {
        bid.veto = Word();
      } else {
        bid.why = {{"useful", Real()}, {"length", Real()}};
      }
      out.options.push_back({.source = Word(),
                             .length = Real(),
                             .total = Real(),
                             .rate = Real(),
                             .end = {Real(), Real()},
                             .bids = {{Word(), Real(), bid}}});
    }
  }
  void Fill(HelmMotion& out) {
    out = {.course_deg = Real(), .speed_mps = Real(), .depth_m = {}, .opinions = {}};
    for (std::size_t i = Few(); i > 0; --i)
      out.opinions.push_back({Word(), "course", Real(), Real(), Real(), Real(), {}});
  }
  void Fill(HelmRevisits& out) {
    for (std::size_t i = Few(); i > 0; --i)
      out.objects.push_back({Whole(), "open", Real(), 2});
  }
  void Fill(CourseCost& out) {
    for (std::size_t i = Few(); i > 0; --i)
      out.metres.push_back(Real());
  }

 private:
  Random& random_;
};

template <class T>
class JsonProperty : public ::testing::Test {
 protected:
  std::string Next() {
    T made{};
    Maker(random_).Fill(made);
    return std::get<std::string>(TopicCodec<T>::Encode(made));
  }
  /// `change` gets every value below `node` that has a key, with its path.
  template <class Change>
  static void EachField(Json& node, const std::string& path, const Change& change) {
    if (node.is_object()) {
      for (auto field = node.begin(); field != node.end(); ++field) {
        change(path + "/" + field.key());
        EachField(field.value(), path + "/" + field.key(), change);
      }
    } else if (node.is_array() && !node.empty()) {
      EachField(node[0], path + "/0", change);
    }
  }
  static std::string LastName(const std::string& path) { return path.substr(path.rfind('/') + 1); }
  Random random_{23, "json"};
};

using JsonTopics = ::testing::Types<Detections, Landmarks, LandmarkCovariance, ObservedFrame,
                                    TrackShift, OpiBeliefs, SessionPrior, WaterRecord, HelmPath,
                                    HelmBids, HelmMotion, HelmRevisits, CourseCost>;
TYPED_TEST_SUITE(JsonProperty, JsonTopics);

TYPED_TEST(JsonProperty, ComesBackTheSame) {
  for (int run = 0; run < 30; ++run) {
    const std::string text = this->Next();
    const auto back = TopicCodec<TypeParam>::Decode(text);
    ASSERT_TRUE(back) << text;
    EXPECT_EQ(std::get<std::string>(TopicCodec<TypeParam>::Encode(*back)), text);
  }
}

TYPED_TEST(JsonProperty, IsNoneWithoutAFieldThatNothingElseSays) {
  // Who reads only these finds them; what is read back follows from the posterior.
  const std::vector<std::string> may_lack{"prior_candidates", "probability",     "entropy",
                                          "visibility_m",     "visibility_sd_m", "radius_m",
                                          "radius_sd_m",      "ranked_by"};
  const Json whole = Json::parse(this->Next());
  Json walked = whole;
  this->EachField(walked, "", [&](const std::string& path) {
    Json lacking = whole;
    const Json::json_pointer field(path);
    lacking[field.parent_pointer()].erase(field.back());
    const bool may = std::ranges::find(may_lack, this->LastName(path)) != may_lack.end();
    EXPECT_EQ(TopicCodec<TypeParam>::Decode(lacking.dump()).has_value(), may) << path;
  });
}

TYPED_TEST(JsonProperty, IsNoneWithAFieldOfAnotherType) {
  const std::vector<std::string> unread{"probability", "entropy"};
  const Json whole = Json::parse(this->Next());
  Json walked = whole;
  this->EachField(walked, "", [&](const std::string& path) {
    if (std::ranges::find(unread, this->LastName(path)) != unread.end()) return;
    Json spoilt = whole;
    Json& field = spoilt[Json::json_pointer(path)];
    field = field.is_string() ? Json(7) : Json("seven");
    EXPECT_FALSE(TopicCodec<TypeParam>::Decode(spoilt.dump())) << path;
  });
}

TYPED_TEST(JsonProperty, SurvivesBytesThatSomethingHasSpoilt) {
  const std::string text = this->Next();
  for (int run = 0; run < 300; ++run) {
    std::string spoilt = text;
    for (std::uint64_t hits = 1 + this->random_.Index(4); hits > 0; --hits) {
      spoilt[this->random_.Index(spoilt.size())] = static_cast<char>(this->random_.Index(256));
    }
    spoilt.resize(spoilt.size() - this->random_.Index(spoilt.size() / 2));
    const auto decoded = TopicCodec<TypeParam>::Decode(spoilt);
    if (decoded) {
      EXPECT_NO_THROW(static_cast<void>(TopicCodec<TypeParam>::Encode(*decoded)));
    }
  }
}

TYPED_TEST(JsonProperty, IsNoneWhenCutAnywhere) {
  const std::string text = this->Next();
  for (std::size_t length = 0; length < text.size(); length += 1 + text.size() / 60) {
    EXPECT_FALSE(TopicCodec<TypeParam>::Decode(text.substr(0, length))) << length;
  }
}

}  // namespace
}  // namespace limpet
