// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/work.hpp"

#include "apps/limpet/cli.hpp"
#include "limpet/sweeps/task_batch.hpp"

namespace limpet {

int RunWork(std::span<const std::string> args) {
  const Command form{
      .name = "limpet work",
      .words = "<tasks.json>",
      .about =
          "Runs the tasks of a sweep, one after the other, until none is left that nobody else "
          "has taken: what the jobs of `limpet tables` and `limpet tune` with --runner slurm "
          "do. Started by hand on any machine that sees the same files, it helps.",
      .takes = "one list of tasks, <out>/batch/tasks.json",
      .least_words = 1,
      .most_words = 1};
  return RunCommand(form, args, [](const Arguments& given) -> int {
    return WorkOn(given.positionals()[0]) ? kOk : kFailed;
  });
}

}  // namespace limpet
