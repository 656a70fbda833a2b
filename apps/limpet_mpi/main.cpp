// SPDX-License-Identifier: MIT
// limpet_mpi <tasks.json>: what `--runner mpi` starts by mpirun; rank 0 hands the tasks out.
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <mpi.h>

#include "apps/limpet_mpi/hand_out.hpp"
#include "limpet/core/interrupt.hpp"

namespace {

void OnSignal(int) { limpet::interrupt_requested = true; }

/// False if interrupted, or without tasks that can be read.
bool Work(const std::filesystem::path& tasks_file) {
  const limpet::BatchFolder folder(std::filesystem::absolute(tasks_file).parent_path());
  const std::optional<limpet::TaskBatch> batch = folder.Batch();
  if (!batch) {
    fmt::print(stderr, "limpet_mpi: {} lists no tasks that can be read\n", tasks_file.string());
    return false;
  }
  const limpet::WorkerMark mark(folder.path());
  std::filesystem::current_path(batch->folder);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (rank != 0) return limpet::TakeTasks(folder, *batch);
  limpet::HandOutTasks(static_cast<int>(batch->tasks.size()), ranks);
  return !limpet::interrupt_requested;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr const char* kUsage = "usage: mpirun -n N limpet_mpi <tasks.json>\n";
  if (argc == 2 && std::string_view(argv[1]) == "--help") {
    fmt::print(
        "{}\nStarted by `limpet tables` and `limpet tune` with --runner mpi: rank 0 hands the "
        "tasks out,\n"
        "the others run them.\n",
        kUsage);
    return 0;
  }
  MPI_Init(&argc, &argv);
  std::signal(SIGTERM, OnSignal);
  std::signal(SIGINT, OnSignal);
  if (argc != 2) fmt::print(stderr, kUsage);
  if (argc != 2 || !Work(argv[1])) MPI_Abort(MPI_COMM_WORLD, 1);
  MPI_Finalize();
  return 0;
}
