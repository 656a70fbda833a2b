// SPDX-License-Identifier: MIT
#pragma once

#include <tuple>

#include "limpet/core/config.hpp"

namespace limpet {

/// What complaints are listed by, and told apart by: file, line, key, text. Refers to `problem`.
[[nodiscard]] inline auto OrderOf(const ConfigProblem& problem) {
  return std::tie(problem.where.file, problem.where.line, problem.key, problem.text);
}

}  // namespace limpet
