// SPDX-License-Identifier: MIT
// A parser that takes long is as bad as one that crashes: a mission file of a page must not hold up
// a launch.
#pragma once

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace limpet {

/// Ends the fuzzer if an input of up to 4 KiB took more than a second of the processor, sanitizers
/// included.
class TimeBound {
 public:
  explicit TimeBound(std::size_t input_bytes) : is_bounded_(input_bytes <= 4096) {}
  ~TimeBound() {
    const double took_s = static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
    if (is_bounded_ && took_s > 1.0) {
      std::fprintf(stderr, "an input of up to 4 KiB took %.2f s\n", took_s);
      std::abort();
    }
  }
  TimeBound(const TimeBound&) = delete;
  TimeBound& operator=(const TimeBound&) = delete;

 private:
  bool is_bounded_;
  std::clock_t start_ = std::clock();
};

}  // namespace limpet
