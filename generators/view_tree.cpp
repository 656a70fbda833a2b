// SPDX-License-Identifier: MIT
#include "limpet/planning/view_tree.hpp"

#include <algorithm>
#include <iterator>

#include "limpet/helm/generator_registry.hpp"

namespace limpet {
namespace {

/// Branches of a tree of views, grown away from seen ground and rewired.
class ViewTreeGenerator final : public OptionGenerator {
 public:
  struct Params {
    int nodes = 100;
    int offers = 5;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("tree_nodes", nodes, "Generator view_tree: its nodes", InRange(10, 100000));
      visit("tree_offers", offers, "Generator view_tree: branches offered", InRange(1, 1000));
    }
  };
  ViewTreeGenerator(const Params& params, Random random) : params_(params), random_(random) {}

  void Offer(const Situation& now, const SearchGoals& goals,
             std::vector<Option>& options) override {
    if (!goals.objective.SeeksAnything()) {
      return;
    }
    ViewTreeParams tree;
    tree.turn_radius = now.turn_radius;
    tree.nodes = params_.nodes;
    tree.offers = params_.offers;
    std::ranges::move(ViewTree(now.pose, *now.ground, *now.region, goals.objective, tree, random_),
                      std::back_inserter(options));
  }

 private:
  Params params_;
  Random random_;
};

}  // namespace

LIMPET_REGISTER_GENERATOR(ViewTreeGenerator, "view_tree");

}  // namespace limpet
