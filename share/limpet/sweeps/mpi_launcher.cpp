// SPDX-License-Identifier: MIT
#include "limpet/sweeps/mpi_launcher.hpp"

#include <cstdlib>

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include "limpet/console/command_output.hpp"
#include "limpet/sweeps/child_process.hpp"
#include "limpet/sweeps/program_path.hpp"
#include "limpet/sweeps/task_batch.hpp"

namespace limpet {
namespace {

std::filesystem::path RankProgram() { return OwnProgram().parent_path() / "limpet_mpi"; }

/// Words that other makes of mpirun do not know: Open MPI takes them from the environment, too.
void SetUpOpenMpi() {
  // Rank 0 sleeps nearly always: it needs no core of its own.
  ::setenv("OMPI_MCA_rmaps_base_oversubscribe", "1", 0);
  ::setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
  if (::geteuid() != 0) return;
  // Who runs this as root has decided so already.
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 0);
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 0);
}

}  // namespace

MpiLauncher::MpiLauncher(std::vector<std::string> words) : words_(std::move(words)) {
  if (!std::filesystem::exists(RankProgram())) {
    throw Refusal(
        fmt::format("--runner mpi needs limpet_mpi beside limpet: it is built where MPI "
                    "is found (`ninja limpet_mpi`)"));
  }
  if (!FindInPath("mpirun")) {
    throw Refusal("--runner mpi needs mpirun: ./limpet cluster installs it");
  }
}

MpiLauncher::~MpiLauncher() { MpiLauncher::Cancel(); }

void MpiLauncher::Start(const std::filesystem::path& batch_folder, int workers) {
  SetUpOpenMpi();
  earlier_.clear();
  ChildRun run{.args = words_, .log = batch_folder / "mpirun.txt", .program = "mpirun"};
  for (const std::string& word : {std::string("-n"), std::to_string(workers + 1),
                                  RankProgram().string(), (batch_folder / "tasks.json").string()}) {
    run.args.push_back(word);
  }
  mpirun_ = StartChild(run, SIGTERM);
}

bool MpiLauncher::IsAlive() {
  if (mpirun_ && ReapChild(*mpirun_)) mpirun_.reset();
  return mpirun_ || (!earlier_.empty() && WorkerMark::IsAnyIn(earlier_));
}

void MpiLauncher::Cancel() {
  if (!mpirun_) return;
  ::kill(*mpirun_, SIGTERM);
  WaitForChild(*mpirun_);
  mpirun_.reset();
}

}  // namespace limpet
