// SPDX-License-Identifier: MIT
#include "limpet/logbook/blog.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(BlogMarker, RefusesWhatIsNone) {
  for (const char* text :
       {"", "x", "<MOOS_BINARY></MOOS_BINARY>", "<MOOS_BINARY>File=,Offset=1,Bytes=2</MOOS_BINARY>",
        "<MOOS_BINARY>File=a,Offset=-1,Bytes=2</MOOS_BINARY>", "<MOOS_BINARY>"}) {
    EXPECT_FALSE(ParseBlogMarker(text).has_value()) << text;
  }
}

TEST(BlogMarker, LeadsNowhereElse) {
  EXPECT_FALSE(ReadBlog("/nonexistent", {.file = "/etc/passwd", .offset = 0, .bytes = 1}));
}

}  // namespace
}  // namespace limpet
