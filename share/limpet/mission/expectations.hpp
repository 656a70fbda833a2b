// SPDX-License-Identifier: MIT
// expect.yaml: bounds that a mission's report must keep; tests and `limpet survey` compare. Where a
// vehicle has bounds of its own, they are in a file of its name: expect.bluerov2.yaml.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/mission/scenario.hpp"

namespace limpet {

/// One number of a session's report and where it may lie, inclusive.
struct ExpectedBound {
  std::string key;  ///< one of ExpectableNumbers()
  std::optional<double> min;
  std::optional<double> max;
  SourceLine where;
};

/// What is expected of one session, or of each.
struct SessionExpectation {
  std::string session;               ///< name of a session, or `each`
  std::optional<std::string> ended;  ///< home, aborted, timeout or lost
  std::vector<ExpectedBound> bounds;
};

struct Expectations {
  std::vector<SessionExpectation> sessions;
  /// Of many runs, at least this share must keep every bound.
  double share_of_runs = 1.0;
  /// Planner that they are for: runs with another are not compared.
  std::string planner = "limpet";
  std::string file;  ///< its name
};

/// Keys that may be bounded, named after report.json: `error_m` and `aligned_error_m` are the
/// largest of all objects, `missed`, `invented` and `wrong_statuses` are counts, and a `_95_` is a
/// coverage level. `wrong_when_sure` counts what was said with a probability of at least 0.95 and
/// is not so: statuses, or in a first session objects that are not there.
[[nodiscard]] const std::vector<std::string>& ExpectableNumbers();

/// Reads expect.yaml. Throws ConfigError with every problem: unknown keys and sessions (`each` and
/// `sessions` are known), bounds that no number can keep.
[[nodiscard]] Expectations ParseExpectations(const std::string& text, const std::string& file,
                                             const std::vector<std::string>& sessions);
/// Reads what a mission's folder expects of a vehicle, as VehicleFile names it (`bluerov2.yaml`),
/// with the sessions of the folder's scenario: `expect.bluerov2.yaml` if that exists, else
/// `expect.yaml`; nothing if there is neither. Throws as ParseExpectations.
[[nodiscard]] std::optional<Expectations> LoadExpectations(const std::filesystem::path& folder,
                                                           const Scenario& scenario,
                                                           const std::string& vehicle);
/// True of the names that such files have.
[[nodiscard]] bool IsExpectationsFile(const std::filesystem::path& name);

}  // namespace limpet
