// SPDX-License-Identifier: MIT
#include "limpet/launch/processor_watch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limpet {
namespace {

constexpr Seconds kMeanOver(20.0);

}  // namespace

void ProcessorWatch::Hear(const std::vector<ProcessorUsage>& processes, Seconds now) {
  const double elapsed = (now - std::exchange(heard_, now)).value();
  const double weight = 1.0 - std::exp(-elapsed / kMeanOver.value());
  std::vector<Kept> kept;
  for (const ProcessorUsage& use : processes) {
    const auto former = std::ranges::find_if(
        kept_, [&use](const Kept& candidate) { return candidate.use.pid == use.pid; });
    Kept& is = kept.emplace_back(Kept{.use = use, .share = {}});
    if (former == kept_.end() || elapsed <= 0.0) continue;
    const double share = (use.used - former->use.used).value() / (elapsed * warp_);
    const double before = former->share.value_or(0.0);
    is.share = before + weight * (share - before);
  }
  kept_ = std::move(kept);
}

std::optional<ProcessorLoad> ProcessorWatch::busiest() const {
  const auto most = std::ranges::max_element(kept_, {}, &Kept::share);
  if (most == kept_.end() || !most->share) return std::nullopt;
  return ProcessorLoad{.percent = 100.0 * *most->share, .app = most->use.name};
}

}  // namespace limpet
