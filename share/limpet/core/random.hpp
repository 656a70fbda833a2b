// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace limpet {

/// A seeded stream of random numbers. Each user takes a stream of its own by name, so that one more
/// draw in one place changes no other place. Not thread-safe.
class Random {
 public:
  explicit Random(std::uint64_t seed);
  /// The stream of `name` under `seed`, independent of all other names.
  Random(std::uint64_t seed, std::string_view name);

  /// Uniform in [low, high).
  [[nodiscard]] double Uniform(double low, double high);
  /// Normal with mean 0.
  [[nodiscard]] double Normal(double sigma);
  [[nodiscard]] bool Chance(double probability);
  /// Uniform in 0 .. count - 1. REQUIRES: count > 0.
  [[nodiscard]] std::uint64_t Index(std::uint64_t count);
  [[nodiscard]] std::uint64_t Bits() { return engine_(); }
  [[nodiscard]] std::mt19937_64& engine() { return engine_; }

 private:
  std::mt19937_64 engine_;
};

/// Mixes a seed and a name to a new seed (FNV-1a, then SplitMix64's finalizer).
[[nodiscard]] std::uint64_t MixSeed(std::uint64_t seed, std::string_view name);

}  // namespace limpet
