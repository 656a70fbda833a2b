// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "limpet/console/command.hpp"

namespace limpet {
namespace {

TEST(CommandHelp, IsMadeOfWhatTheCommandDeclares) {
  const Command command{
      .name = "limpet dive",
      .words = "<place>",
      .about =
          "Goes down where it is told to, looks around for as long as there is power, and "
          "comes up\nagain.\n\n  an indented line stays as it is",
      .options = {{.names = "--out", .value = "DIR", .meaning = "results", .is_required = true},
                  {.names = "-d,--depth,--moos_depth",
                   .value = "M",
                   .meaning = "how deep it may go, as long as nothing that lies on the way is "
                              "higher",
                   .fallback = "5"},
                  {.names = "--a-name-that-is-much-too-long",
                   .value = "N",
                   .meaning = "on a line of its own",
                   .is_repeatable = true}},
      .more = "  limpet dive bay --out here"};
  EXPECT_EQ(HelpText(command),
            R"(usage: limpet dive <place> --out DIR [options]

Goes down where it is told to, looks around for as long as there is power, and
comes up again.

  an indented line stays as it is

  --out DIR                   results
  -d, --depth M               how deep it may go, as long as nothing that lies
                              on the way is higher (default 5)
  --a-name-that-is-much-too-long N
                              on a line of its own; repeatable
  -h, --help                  this text

  limpet dive bay --out here
)");
}

}  // namespace
}  // namespace limpet
