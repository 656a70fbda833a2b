// SPDX-License-Identifier: MIT
// The Debian packages, looked at as dpkg does, and unpacked and run without being installed.
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/shell.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// Both packages, made once of this build.
class DebianPackages : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    has_tools_ = Shell("dpkg-deb --version && dpkg-shlibdeps --version").exit_code == 0;
    if (!has_tools_) return;
    folder_ = std::make_unique<TemporaryFolder>();
    const ShellResult packed =
        Shell(fmt::format("cd {} && {} -G DEB -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip --config "
                          "{}/CPackConfig.cmake -B {}",
                          LIMPET_BUILD, LIMPET_CPACK, LIMPET_BUILD, folder_->path().string()));
    ASSERT_EQ(packed.exit_code, 0) << packed.text;
  }
  static void TearDownTestSuite() { folder_.reset(); }
  void SetUp() override {
    if (!has_tools_) GTEST_SKIP() << "dpkg-deb or dpkg-shlibdeps (dpkg-dev) is missing";
  }
  /// The file of a package.
  static std::string File(const std::string& package) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_->path())) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(package + "_") && name.ends_with(".deb")) return entry.path().string();
    }
    return "no " + package;
  }
  static std::string Field(const std::string& package, const std::string& field) {
    return Shell("dpkg-deb --field " + File(package) + " " + field).text;
  }
  static std::string Contents(const std::string& package) {
    return Shell("dpkg-deb --contents " + File(package)).text;
  }
  static fs::path Unpacked(const std::string& package) {
    fs::path root = folder_->path() / ("of_" + package);
    if (!fs::exists(root)) {
      EXPECT_EQ(Shell("dpkg-deb --extract " + File(package) + " " + root.string()).exit_code, 0);
    }
    return root;
  }

 private:
  static inline bool has_tools_ = false;
  static inline std::unique_ptr<TemporaryFolder> folder_;
};

TEST_F(DebianPackages, SayWhatTheyNeed) {
  EXPECT_EQ(Field("limpet", "Package"), "limpet\n");
  EXPECT_THAT(Field("limpet", "Depends"), HasSubstr("libc6 (>= "));
  EXPECT_THAT(Field("limpet", "Depends"), HasSubstr("libopencv-core")) << "by what it is linked to";
  EXPECT_THAT(Field("limpet-dev", "Depends"),
              HasSubstr(fmt::format("limpet (= {})", LIMPET_VERSION)));
  EXPECT_THAT(Field("limpet", "Description"), HasSubstr("survey the seabed"));
}

TEST_F(DebianPackages, HoldWhatAnInstallationHasEachInOne) {
  const std::string programs = Contents("limpet"), headers = Contents("limpet-dev");
  for (const char* file : {"/usr/bin/limpet\n", "/usr/bin/pHelm\n", "/usr/bin/LimpetDB\n",
                           "/usr/share/limpet/missions/table1/", "/usr/share/doc/limpet/copyright",
                           "/usr/share/limpet/share/limpet-template/"}) {
    EXPECT_THAT(programs, HasSubstr(file));
  }
  EXPECT_THAT(headers, HasSubstr("/usr/include/limpet/helm/behavior.hpp"));
  EXPECT_THAT(headers, HasSubstr("LimpetConfig.cmake"));
  EXPECT_THAT(headers, HasSubstr("/usr/share/doc/limpet-dev/copyright"));
  EXPECT_THAT(programs, Not(HasSubstr("/usr/include/")));
  EXPECT_THAT(headers, Not(HasSubstr("/usr/bin/")));
  EXPECT_THAT(programs, Not(HasSubstr("unit_"))) << "no test";
}

TEST_F(DebianPackages, RunWhereTheyAreUnpacked) {
  const std::string bin = (Unpacked("limpet") / "usr/bin").string();
  EXPECT_THAT(Shell(bin + "/limpet --version").text, HasSubstr(LIMPET_VERSION));
  const std::string mission = (Unpacked("limpet") / "usr/share/limpet/missions/table1").string();
  const ShellResult check = Shell(bin + "/limpet check " + mission);
  EXPECT_EQ(check.exit_code, 0) << check.text;
}

TEST_F(DebianPackages, HaveAManualPageForEachProgramIfHelp2manIsThere) {
  if (Shell("help2man --version").exit_code != 0) GTEST_SKIP() << "help2man is missing";
  const fs::path root = Unpacked("limpet");
  for (const fs::directory_entry& program : fs::directory_iterator(root / "usr/bin")) {
    const std::string name = program.path().filename().string();
    const fs::path page = root / "usr/share/man/man1" / (name + ".1.gz");
    ASSERT_TRUE(fs::exists(page)) << page;
    const std::string text = Shell("gzip -dc " + page.string()).text;
    EXPECT_THAT(text, HasSubstr("\n" + name + " \\- ")) << "its name and what it does";
    EXPECT_THAT(text, HasSubstr("usage: ")) << name;
  }
}

TEST_F(DebianPackages, HaveAManualPageForEachVerbIfHelp2manIsThere) {
  if (Shell("help2man --version").exit_code != 0) GTEST_SKIP() << "help2man is missing";
  const fs::path root = Unpacked("limpet");
  std::istringstream help(Shell((root / "usr/bin/limpet").string() + " --help").text);
  int verbs = 0;
  for (std::string line; std::getline(help, line);) {
    if (!line.starts_with("  ")) continue;  // `  survey     survey twice, embedded, ...`
    const std::string verb = line.substr(2, line.find(' ', 2) - 2);
    const fs::path page = root / "usr/share/man/man1" / ("limpet-" + verb + ".1.gz");
    ASSERT_TRUE(fs::exists(page)) << page;
    const std::string text = Shell("gzip -dc " + page.string()).text;
    EXPECT_THAT(text, HasSubstr("\nlimpet-" + verb + " \\- ")) << "its name and what it does";
    EXPECT_THAT(text, HasSubstr("usage: limpet " + verb)) << verb;
    ++verbs;
  }
  EXPECT_GT(verbs, 20);
}

TEST_F(DebianPackages, AreWithoutErrorsForLintianIfThatIsThere) {
  if (Shell("lintian --version").exit_code != 0) GTEST_SKIP() << "lintian is missing";
  for (const char* package : {"limpet", "limpet-dev"}) {
    const ShellResult found = Shell("lintian --allow-root --fail-on error " + File(package));
    EXPECT_EQ(found.exit_code, 0) << found.text;
  }
}

}  // namespace
}  // namespace limpet
