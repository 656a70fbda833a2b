// SPDX-License-Identifier: MIT
#include "limpet/sweeps/mpi_launcher.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include "limpet/console/command_output.hpp"
#include "limpet/core/program_search.hpp"
#include "limpet/sweeps/child_process.hpp"
#include "limpet/sweeps/task_batch.hpp"

namespace limpet {
namespace {

std::filesystem::path RankProgram() { return OwnProgram().parent_path() / "limpet_mpi"; }

/// What Open MPI takes from the environment, and other makes of mpirun do not mind.
std::vector<std::string> OpenMpiEnvironment() {
  // Rank 0 sleeps nearly always: it needs no core of its own.
  std::vector<std::string> words{"OMPI_MCA_rmaps_base_oversubscribe=1",
                                 "OMPI_MCA_mpi_yield_when_idle=1"};
  // Who runs this as root has decided so already.
  if (::geteuid() == 0) {
    words.emplace_back("OMPI_ALLOW_RUN_AS_ROOT=1");
    words.emplace_back("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1");
  }
  words.emplace_back("mpirun");
  return words;
}

}  // namespace

MpiLauncher::MpiLauncher(std::vector<std::string> words) : words_(std::move(words)) {
  if (!std::filesystem::exists(RankProgram())) {
    throw Refusal(
        fmt::format("--runner mpi needs limpet_mpi beside limpet: it is built where MPI "
                    "is found (`ninja limpet_mpi`)"));
  }
  if (!FindOnPath("mpirun")) {
    throw Refusal("--runner mpi needs mpirun: ./limpet cluster installs it");
  }
}

MpiLauncher::~MpiLauncher() { MpiLauncher::Cancel(); }

void MpiLauncher::Start(const std::filesystem::path& batch_folder, int workers) {
  earlier_.clear();
  ChildRun run{.args = OpenMpiEnvironment(), .log = batch_folder / "mpirun.txt", .program = "env"};
  run.args.insert(run.args.end(), words_.begin(), words_.end());
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
