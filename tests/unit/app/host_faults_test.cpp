// SPDX-License-Identifier: MIT
#include "limpet/app/host_faults.hpp"

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

/// As a process inherits it: a descriptor of its own.
HostFaults InheritedFrom(const HostFaultControl& control) {
  const std::string number = std::to_string(::dup(control.descriptor()));
  ::setenv(HostFaults::kVariable, number.c_str(), 1);
  return {};
}

TEST(HostFaults, OfALaunchWithoutAnyAreTheMachineAsItIs) {
  ::unsetenv(HostFaults::kVariable);
  const HostFaults host;
  EXPECT_FALSE(host.are_made());
  EXPECT_EQ(&host.disk(), &RealFileSystem());
  EXPECT_EQ(host.wall_ahead(), Seconds(0.0));
}

TEST(HostFaults, AreSeenByTheProcessFromTheMomentThatTheLauncherMakesThem) {
  const TemporaryFolder folder;
  HostFaultControl control;
  const HostFaults host = InheritedFrom(control);
  ASSERT_TRUE(host.are_made());
  EXPECT_EQ(std::getenv(HostFaults::kVariable), nullptr) << "programs below us have none";
  const auto open = [&] {
    return host.disk().Open(folder.path() / "x", FileSystem::Opening::kEmpty).trouble;
  };
  EXPECT_FALSE(open());
  control.FailDisk(FailingFileSystem::Fault::kFailing);
  EXPECT_EQ(open(), std::errc::io_error);
  control.FailDisk(FailingFileSystem::Fault::kNone);
  EXPECT_FALSE(open());
  control.SetWallAhead(Seconds(3600.0));
  EXPECT_EQ(host.wall_ahead(), Seconds(3600.0));
}

TEST(HostFaults, RoomIsTheDisksOwnWhereItIsNotLimited) {
  const TemporaryFolder folder;
  HostFaultControl control;
  const HostFaults host = InheritedFrom(control);
  EXPECT_GT(host.disk().Room(folder.path()).value(), 0U);
  control.LimitDisk(1000);
  EXPECT_EQ(host.disk().Room(folder.path()), 1000U);
  control.LimitDisk(std::nullopt);
  EXPECT_GT(host.disk().Room(folder.path()).value(), 1000U);
  control.FailDisk(FailingFileSystem::Fault::kFull);
  EXPECT_EQ(host.disk().Room(folder.path()), 0U);
}

}  // namespace
}  // namespace limpet
