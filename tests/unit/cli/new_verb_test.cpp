// SPDX-License-Identifier: MIT
// What `limpet new` takes for a name. What it makes is built by tests/own_repository.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/command_line.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

struct New {
  int exit_code = 0;
  std::string err;
};

New Make(const std::string& kind, const std::string& name) {
  const TemporaryFolder folder;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  const int code = RunCommandLine({"new", kind, name, "--out", (folder.path() / "own").string()});
  static_cast<void>(::testing::internal::GetCapturedStdout());
  return {code, ::testing::internal::GetCapturedStderr()};
}

TEST(NewVerb, RefusesNamesOfAppsThatNeitherCppNorALauncherWouldTake) {
  for (const char* name : {"int", "class", "all", "test", "main", "Deep", "p", "p2", "pdeep", "pD",
                           "pDe-ep", "p/Deep", "MOOSDB"}) {
    const New made = Make("app", name);
    EXPECT_EQ(made.exit_code, kUsage) << name;
    EXPECT_THAT(made.err, ::testing::AnyOf(HasSubstr("as `pName`"), HasSubstr("Limpet's own")));
  }
  EXPECT_THAT(Make("app", "Deep").err, HasSubstr("p, i or u and a capital letter"));
}

TEST(NewVerb, TakesNamesAsMoosHasThem) {
  for (const char* name : {"pDeep", "iModem2", "uLook_at"})
    EXPECT_EQ(Make("app", name).exit_code, kOk) << name;
  EXPECT_EQ(Make("behavior", "BHV_KeepOff").exit_code, kOk);
  EXPECT_EQ(Make("behavior", "KeepOff").exit_code, kUsage);
}

}  // namespace
}  // namespace limpet
