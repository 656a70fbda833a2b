// SPDX-License-Identifier: MIT
// What the compiler says to somebody who registers a class that lacks something.
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/shell.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// All that the compiler of this build says about a source text.
std::string Complaints(std::string_view text) {
  const TemporaryFolder folder;
  const std::filesystem::path source = folder.path() / "mine.cpp";
  std::ofstream(source) << text;
  const ShellResult said = Shell(
      fmt::format("{} -std=c++20 -fsyntax-only -I{root} -I{root}/share {} {}", LIMPET_COMPILER,
                  LIMPET_COMPILER_INCLUDES, source.string(), fmt::arg("root", LIMPET_SOURCE_DIR)));
  EXPECT_NE(said.exit_code, 0) << "it compiles: " << text;
  return said.text;
}

constexpr std::string_view kApps = R"(
#include "limpet/app/registry.hpp"
namespace limpet {
struct Params {
  double depth = 1.0;
  template <class V> void Describe(V& visit) { visit("depth_m", depth, "to go to"); }
};
struct RightApp : App {
  using Params = limpet::Params;
  RightApp(const AppContext& context, const Params&) : App(context) {}
};
LIMPET_REGISTER_APP(RightApp, "pRight", 4.0);

struct Stranger {
  using Params = limpet::Params;
  Stranger(const AppContext&, const Params&) {}
};
LIMPET_REGISTER_APP(Stranger, "pStranger", 4.0);

struct NoParamsApp : App {
  explicit NoParamsApp(const AppContext& context) : App(context) {}
};
LIMPET_REGISTER_APP(NoParamsApp, "pNoParams", 4.0);

struct SilentApp : App {
  struct Params { double depth = 1.0; };
  SilentApp(const AppContext& context, const Params&) : App(context) {}
};
LIMPET_REGISTER_APP(SilentApp, "pSilent", 4.0);

struct HalfApp : App {
  using Params = limpet::Params;
  HalfApp(const AppContext& context, const Params&) : App(context) {}
  virtual void Later() = 0;
};
LIMPET_REGISTER_APP(HalfApp, "pHalf", 4.0);

struct ClosedApp : App {
  using Params = limpet::Params;
  explicit ClosedApp(const AppContext& context) : App(context) {}
};
LIMPET_REGISTER_APP(ClosedApp, "pClosed", 4.0);
}  // namespace limpet
)";

TEST(Registration, TellsInASentenceWhatAnAppLacks) {
  const std::string said = Complaints(kApps);
  EXPECT_THAT(said, HasSubstr("an app derives from limpet::App"));
  EXPECT_THAT(said, HasSubstr("an app has a public `struct Params`"));
  EXPECT_THAT(said, HasSubstr("an app's Params has a default for each member"));
  EXPECT_THAT(said, HasSubstr("an app defines every pure virtual function"));
  EXPECT_THAT(said, HasSubstr("an app has a public constructor"));
  EXPECT_THAT(said, Not(HasSubstr("RightApp")));
}

constexpr std::string_view kBehaviors = R"(
#include "limpet/helm/registry.hpp"
namespace limpet {
struct Params {
  double depth = 1.0;
  template <class V> void Describe(V& visit) { visit("depth_m", depth, "to go to"); }
};
struct BHV_Right : Behavior {
  using Params = limpet::Params;
  explicit BHV_Right(const Params&) {}
};
LIMPET_REGISTER_BEHAVIOR(BHV_Right);

struct BHV_Stranger {
  using Params = limpet::Params;
  explicit BHV_Stranger(const Params&) {}
};
LIMPET_REGISTER_BEHAVIOR(BHV_Stranger);

struct BHV_NoParams : Behavior {};
LIMPET_REGISTER_BEHAVIOR(BHV_NoParams);

struct BHV_Silent : Behavior {
  struct Params { double depth = 1.0; };
  explicit BHV_Silent(const Params&) {}
};
LIMPET_REGISTER_BEHAVIOR(BHV_Silent);

struct BHV_Half : Behavior {
  using Params = limpet::Params;
  explicit BHV_Half(const Params&) {}
  virtual void Later() = 0;
};
LIMPET_REGISTER_BEHAVIOR(BHV_Half);

class BHV_Closed : public Behavior {
 public:
  using Params = limpet::Params;
 private:
  explicit BHV_Closed(const Params&) {}
};
LIMPET_REGISTER_BEHAVIOR(BHV_Closed);
}  // namespace limpet
)";

TEST(Registration, TellsInASentenceWhatABehaviorLacks) {
  const std::string said = Complaints(kBehaviors);
  EXPECT_THAT(said, HasSubstr("a behavior derives from limpet::Behavior"));
  EXPECT_THAT(said, HasSubstr("a behavior has a public `struct Params`"));
  EXPECT_THAT(said, HasSubstr("a behavior's Params has a default for each member"));
  EXPECT_THAT(said, HasSubstr("a behavior defines every pure virtual function"));
  EXPECT_THAT(said, HasSubstr("a behavior has a public constructor"));
  EXPECT_THAT(said, Not(HasSubstr("BHV_Right")));
}

}  // namespace
}  // namespace limpet
