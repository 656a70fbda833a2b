// SPDX-License-Identifier: MIT
#include "limpet/helm/post_filter.hpp"

namespace limpet {

bool PostFilter::Passes(const std::string& owner, const BehaviorPost& post) {
  if (post.is_repeated) {
    return true;
  }
  const std::string key = owner + '\n' + post.variable + '\n' + post.key;
  const auto [last, is_new] = last_.try_emplace(key, post.value);
  if (!is_new && last->second == post.value) {
    return false;
  }
  last->second = post.value;
  return true;
}

}  // namespace limpet
