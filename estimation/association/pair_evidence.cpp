// SPDX-License-Identifier: MIT
#include "estimation/association/pair_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "limpet/core/probability.hpp"

namespace limpet {
namespace {

constexpr double kFalseThere = 0.05;  // share of the image where a false box is taken for an object
constexpr Interval kWeakerBox{.low = 0.5, .high = 0.95};  // of two: no evidence against them

}  // namespace

double ClassCost(const TrackedObject& a, const TrackedObject& b, double confused) {
  std::set<std::string> classes;
  for (const auto& [name, votes] : a.observations.votes())
    classes.insert(name);
  for (const auto& [name, votes] : b.observations.votes())
    classes.insert(name);
  if (classes.size() < 2) return 0.0;
  // Likelihood of an object's boxes per class, its greatest 1. What makes a detector take an object
  // for another class once, its dim side or glare, lasts for all boxes of a pass: however many they
  // are, they are one witness.
  const double per_vote = std::log((1.0 - confused) / confused);
  const auto likelihood = [&](const TrackedObject& object, const std::string& name) {
    const auto votes = object.observations.votes().find(name);
    const double behind = object.observations.votes().at(object.color()) -
                          (votes == object.observations.votes().end() ? 0.0 : votes->second);
    return std::exp(-per_vote * std::max(behind, 0.0)) + confused;
  };
  double one = 0.0, all_a = 0.0, all_b = 0.0;
  for (const std::string& name : classes) {
    const double of_a = likelihood(a, name), of_b = likelihood(b, name);
    one += of_a * of_b, all_a += of_a, all_b += of_b;
  }
  return -2.0 * std::log(std::min(one / (all_a * all_b), 1.0));
}

double TogetherCost(const TrackedObject& a, const TrackedObject& b) {
  double cost = 0.0;
  auto i = a.observations.rbegin();
  auto j = b.observations.rbegin();
  while (i != a.observations.rend() && j != b.observations.rend() && cost < kTwoObjectsCost) {
    if (i->frame == j->frame) {
      const double weaker = std::min(i->confidence, j->confidence);
      cost += 2.0 * LogOddsOf(weaker, kWeakerBox) - 2.0 * std::log(kFalseThere);
      ++i, ++j;
    } else {
      (i->frame > j->frame ? i : j)++;
    }
  }
  return cost;
}

double OverlapCost(const Eigen::Vector3d& d, const Eigen::Matrix3d& covariance, double radius) {
  const double n = std::max(d.norm(), 1e-6);
  const Eigen::Vector3d u = d / n;
  const double along = u.dot(covariance * u);
  const double distance = std::sqrt(n * n + std::max(covariance.trace() - along, 0.0));
  const double apart = NormalShareBelow(distance - radius, along);
  return -2.0 * std::log(std::max(apart, 1e-6));
}

}  // namespace limpet
