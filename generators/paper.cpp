// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "limpet/helm/generator_registry.hpp"
#include "limpet/planning/paper_tree.hpp"

namespace limpet {
namespace {

constexpr const char* kSource = "paper";

/// Branches of the tree of [Bucci 2025] as printed, of which the motion to the first view is flown;
/// the rest of the chosen branch is where the next tree begins. Knows no way into the region.
class PaperGenerator final : public OptionGenerator {
 public:
  struct Params {
    int nodes = 100;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("paper_nodes", nodes, "Generator paper: nodes of its tree", InRange(10, 100000));
    }
  };
  PaperGenerator(const Params& params, Random random) : params_(params), random_(random) {}

  void Offer(const Situation& now, const SearchGoals& goals,
             std::vector<Option>& options) override {
    if (!goals.objective.SeeksAnything() || now.region->Outside(now.pose) > 0.0) {
      return;
    }
    PaperTreeParams tree;
    tree.turn_radius = now.turn_radius;
    tree.nodes = params_.nodes;
    std::ranges::move(PaperTree(now.pose, kept_, *now.ground, *now.region, tree, random_),
                      std::back_inserter(options));
    kept_.clear();
  }
  void OnChoice(const Option& option) override {
    kept_.clear();
    if (option.source == kSource && !option.views.empty()) {
      kept_.assign(option.views.begin() + 1, option.views.end());
    }
  }

 private:
  Params params_;
  Random random_;
  std::vector<Pose2> kept_;  ///< views of the chosen branch after the one that is flown to
};

}  // namespace

LIMPET_REGISTER_GENERATOR(PaperGenerator, kSource);

}  // namespace limpet
