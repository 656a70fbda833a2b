// SPDX-License-Identifier: MIT
#include "apps/limpet_mpi/hand_out.hpp"

#include <chrono>
#include <cstddef>
#include <thread>

#include <mpi.h>

#include "limpet/core/interrupt.hpp"

namespace limpet {
namespace {

constexpr int kAsks = 1;   // a rank has nothing to do
constexpr int kGives = 2;  // its task, or kNoMore
constexpr int kNoMore = -1;

/// Waits for a message without burning a core, as a blocking receive would. False if interrupted.
bool AwaitMessage(int from, int tag, MPI_Status& status) {
  constexpr std::chrono::milliseconds kPause(5);
  int is_there = 0;
  while (!interrupt_requested) {
    MPI_Iprobe(from, tag, MPI_COMM_WORLD, &is_there, &status);
    if (is_there != 0) return true;
    std::this_thread::sleep_for(kPause);
  }
  return false;
}

}  // namespace

void HandOutTasks(int tasks, int ranks) {
  int next = 0;
  // Those that have nothing to do any more wait, asleep, until all are done: a rank that ends alone
  // would spin in MPI_Finalize.
  std::vector<int> idle;
  while (static_cast<int>(idle.size()) < ranks - 1) {
    MPI_Status status;
    if (!AwaitMessage(MPI_ANY_SOURCE, kAsks, status)) return;
    int nothing = 0;
    MPI_Recv(&nothing, 0, MPI_INT, status.MPI_SOURCE, kAsks, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (next == tasks) {
      idle.push_back(status.MPI_SOURCE);
      continue;
    }
    MPI_Send(&next, 1, MPI_INT, status.MPI_SOURCE, kGives, MPI_COMM_WORLD);
    ++next;
  }
  for (const int rank : idle)
    MPI_Send(&kNoMore, 1, MPI_INT, rank, kGives, MPI_COMM_WORLD);
}

bool TakeTasks(const BatchFolder& folder, const TaskBatch& batch) {
  while (true) {
    int task = kNoMore;
    MPI_Send(&task, 0, MPI_INT, 0, kAsks, MPI_COMM_WORLD);
    MPI_Status status;
    if (!AwaitMessage(0, kGives, status)) return false;
    MPI_Recv(&task, 1, MPI_INT, 0, kGives, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (task == kNoMore) return true;
    static_cast<void>(folder.RunTask(batch, static_cast<std::size_t>(task)));
    if (interrupt_requested) return false;
  }
}

}  // namespace limpet
