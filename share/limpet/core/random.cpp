// SPDX-License-Identifier: MIT
#include "limpet/core/random.hpp"

#include "limpet/core/require.hpp"
#include "limpet/core/split_mix.hpp"

namespace limpet {

std::uint64_t MixSeed(std::uint64_t seed, std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char letter : name) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  }
  return SplitMixed(hash + seed * kGoldenStep);
}

Random::Random(std::uint64_t seed) : engine_(seed) {}
Random::Random(std::uint64_t seed, std::string_view name) : engine_(MixSeed(seed, name)) {}

double Random::Uniform(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(engine_);
}

double Random::Normal(double sigma) {
  return sigma * std::normal_distribution<double>(0.0, 1.0)(engine_);
}

bool Random::Chance(double probability) { return Uniform(0.0, 1.0) < probability; }

std::uint64_t Random::Index(std::uint64_t count) {
  LIMPET_REQUIRE(count > 0, "an index needs something to choose from");
  return std::uniform_int_distribution<std::uint64_t>(0, count - 1)(engine_);
}

}  // namespace limpet
