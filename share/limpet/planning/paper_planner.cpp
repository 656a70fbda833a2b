#include "limpet/planning/paper_planner.hpp"
namespace limpet {
PaperPlanner::PaperPlanner(const PaperParams& p, const Region& r, Random random)
    : params_(p), region_(r), random_(random) {}
std::optional<Option> PaperPlanner::Next(const Pose2&, const Ground&, const std::vector<OpiBelief>&,
                                         double) {
  return {};
}
}  // namespace limpet
