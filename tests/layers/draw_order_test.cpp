// SPDX-License-Identifier: MIT
#include "tests/layers/draw_order.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/layers/tree_files.hpp"

namespace limpet::layers {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> DrawnTwice(const std::string& text) {
  return CallsThatDrawTwice({{"a.cpp", text}});
}

TEST(DrawOrder, IsTheSameWithAnyCompiler) {
  EXPECT_THAT(CallsThatDrawTwice(TreeFiles()), IsEmpty());
}

TEST(DrawOrder, OfArgumentsOfOneCallIsComplainedAbout) {
  EXPECT_THAT(DrawnTwice("int a;\nconst Vector2d at(random.Normal(1.0), random_.Normal(2.0));\n"
                         "Place(Near(noise->Uniform(0, 1)),\n      Size(2, random));\n"
                         "const auto list = std::vector<int>(random.Index(3), random.Index(4));\n"),
              ElementsAre("a.cpp:2: const Vector2d at(random.Normal(1.0), random_.Normal(2.0));",
                          "a.cpp:3: Place(Near(noise->Uniform(0, 1)),",
                          "a.cpp:5: const auto list = std::vector<int>(random.Index(3), "
                          "random.Index(4));"));
}

TEST(DrawOrder, ThatIsSaidIsNot) {
  EXPECT_THAT(DrawnTwice("const double north = random.Normal(1.0), east = random.Normal(1.0);\n"
                         "const Vector2d at{random.Normal(1.0), random.Normal(1.0)};\n"
                         "Turn(north, random.Normal(1.0), east);\n"
                         "Draw(Random& random, Size(const Random& random));\n"
                         "Log(\"random.Normal(), random.Normal()\", random.Bits());  // f(random)\n"
                         "for (int i = random.Index(3); i < random.Index(4); ++i) Go(i, random);\n"
                         "Each([&] { a(random); b(random); }, random.Chance(0.5) ? 1 : 2);\n"),
              ElementsAre("a.cpp:7: Each([&] { a(random); b(random); }, random.Chance(0.5) ? 1 : "
                          "2);"));
}

TEST(DrawOrder, IsNotAskedOfUnitTests) {
  EXPECT_THAT(CallsThatDrawTwice({{"tests/unit/a.cpp", "f(random.Bits(), random.Bits());"}}),
              IsEmpty());
}

}  // namespace
}  // namespace limpet::layers
