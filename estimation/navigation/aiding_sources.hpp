// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/navigation/measurement_source.hpp"
#include "estimation/navigation/named_state.hpp"
#include "estimation/navigation/time_gate.hpp"
#include "estimation/smoothing/smoother.hpp"

namespace limpet {

/// Counts of one source's observations, since the start.
struct SourceCounts {
  int taken = 0;
  int refused = 0;  ///< off their prediction
  int refused_in_row = 0;
  int late = 0;    ///< older than the chain's head
  int unused = 0;  ///< of which the source itself made nothing
};

/// Slow errors of a source as estimated now, with 1-sigma, in the units of its names.
struct SourceErrorEstimate {
  Eigen::Vector3d value = Eigen::Vector3d::Zero(), sd = Eigen::Vector3d::Zero();
};

/// The sensors beside those of dead reckoning: keeps their observations until their time comes,
/// holds them against what is predicted, and hands the smoother what can be true. One that stays
/// off its prediction is believed in the end: then the prediction is what is wrong. `smoother` must
/// outlive it.
class AidingSources {
 public:
  explicit AidingSources(Smoother& smoother) : smoother_(smoother) {}

  /// Adds a source and returns its number. REQUIRES: Begin has not been called.
  int Add(std::unique_ptr<MeasurementSource> source);
  /// The smoother has its first pose: slow errors become variables of its.
  void Begin();

  /// Counts an observation as taken that says nothing of the pose.
  void NoteTaken(int source) { ++At(source).counts.taken; }
  void Keep(int source, std::shared_ptr<mrpt::obs::CObservation> seen);
  /// Time of the oldest observation that waits [s]; nothing if none does.
  [[nodiscard]] std::optional<double> NextTime() const;
  /// Forgets the oldest: it came too late.
  void Drop();
  /// What the oldest says of the pose at its time, if its source makes something of it.
  struct Offer {
    int source = 0;
    Term term;
  };
  [[nodiscard]] std::optional<Offer> Take();
  /// Uses it at `node`, the smoother's newest pose. True if it was taken and is a fix.
  bool Use(Offer offer, int node);

  [[nodiscard]] int size() const { return static_cast<int>(entries_.size()); }
  [[nodiscard]] const MeasurementSource& source(int i) const { return *At(i).source; }
  [[nodiscard]] const SourceCounts& counts(int i) const { return At(i).counts; }
  /// Nothing of a source without slow errors, or before Begin.
  [[nodiscard]] std::optional<SourceErrorEstimate> ErrorsOf(int i) const;
  /// The slow errors of a source, by their names; none where ErrorsOf() says nothing.
  [[nodiscard]] std::vector<NamedState> NamedErrorsOf(int i) const;

 private:
  struct Entry {
    std::unique_ptr<MeasurementSource> source;
    std::optional<int> errors;  ///< slot
    PersistenceGate gate;
    SourceCounts counts;
  };
  struct Waiting {
    double t = 0.0;
    int source = 0;
    std::shared_ptr<mrpt::obs::CObservation> seen;
  };
  [[nodiscard]] const Entry& At(int i) const { return entries_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] Entry& At(int i) { return entries_[static_cast<std::size_t>(i)]; }
  /// How far it is off, in sigmas of what pose, slow errors and noise allow together.
  [[nodiscard]] double Misfit(const Term& term) const;

  Smoother& smoother_;
  std::vector<Entry> entries_;
  std::deque<Waiting> waiting_;  ///< by time
};

}  // namespace limpet
