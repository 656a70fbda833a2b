// SPDX-License-Identifier: MIT
// Who of the ranks does what: rank 0 hands tasks out, one at a time, to those that ask.
#pragma once

#include "limpet/sweeps/task_batch.hpp"

namespace limpet {

/// Rank 0: until every task was handed out and every other rank has asked once more.
void HandOutTasks(int tasks, int ranks);

/// Every other rank: does what it is given until there is no more. False if interrupted.
[[nodiscard]] bool TakeTasks(const BatchFolder& folder, const TaskBatch& batch);

}  // namespace limpet
