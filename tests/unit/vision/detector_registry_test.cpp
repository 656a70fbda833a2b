// SPDX-License-Identifier: MIT
#include "limpet/vision/detector_registry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

/// Takes the whole image for an object, if it is told to.
class WholeImageDetector final : public Detector {
 public:
  struct Params {
    double confidence = 0.5;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("confidence", confidence, "Of the only box", InRange(0.0, 1.0));
    }
  };
  explicit WholeImageDetector(const Params& params) : params_(params) {}
  [[nodiscard]] std::vector<Box> Detect(const ImageView& image) override {
    return {{.u = 0.5 * image.width_px,
             .v = 0.5 * image.height_px,
             .w = static_cast<double>(image.width_px),
             .h = static_cast<double>(image.height_px),
             .confidence = params_.confidence,
             .color = "white"}};
  }

 private:
  Params params_;
};
LIMPET_REGISTER_DETECTOR(WholeImageDetector, "whole_image");

TEST(DetectorRegistry, KnowsWhatOneFileRegistered) {
  EXPECT_THAT(DetectorNames(), Contains("whole_image"));
  const std::unique_ptr<Detector> detector = MakeDetector("whole_image");
  EXPECT_EQ(detector->Detect({nullptr, 64, 48}).at(0).confidence, 0.5);
}

TEST(DetectorRegistry, AFactoryMakesWhatItsParametersSay) {
  const auto factory = FindDetector("whole_image");
  ASSERT_TRUE(factory);
  const std::vector<ParamSpec> parameters = (*factory)->Parameters();
  ASSERT_EQ(parameters.size(), 1U);
  EXPECT_EQ(parameters[0].name, "confidence");
  EXPECT_TRUE(parameters[0].set("1.5").has_value()) << "out of its range";
  EXPECT_FALSE(parameters[0].set("0.75").has_value());
  EXPECT_EQ((*factory)->Make()->Detect({nullptr, 64, 48}).at(0).confidence, 0.75);
  EXPECT_EQ(MakeDetector("whole_image")->Detect({nullptr, 64, 48}).at(0).confidence, 0.5)
      << "one factory's parameters reached another";
}

TEST(DetectorRegistry, NamesTheNearestOfAMisspeltDetector) {
  const auto factory = FindDetector("whole_imgae");
  ASSERT_FALSE(factory);
  EXPECT_THAT(factory.error().text, HasSubstr("did you mean `whole_image`?"));
}

TEST(DetectorRegistryDeathTest, TwoDetectorsOfOneNameAreABug) {
  EXPECT_DEATH(RegisterDetector("whole_image", [] { return nullptr; }), "whole_image");
}

}  // namespace
}  // namespace limpet
