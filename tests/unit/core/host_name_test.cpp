// SPDX-License-Identifier: MIT
#include "limpet/core/host_name.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(HostNameTest, TheNameHasNoRestOfItsBuffer) {
  const std::optional<std::string> name = HostName();
  ASSERT_TRUE(name.has_value());
  EXPECT_EQ(name->find('\0'), std::string::npos);
}

}  // namespace
}  // namespace limpet
