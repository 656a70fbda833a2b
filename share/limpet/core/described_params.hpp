// SPDX-License-Identifier: MIT
// What the registries ask of a class's parameters, so that they can say in a sentence what it
// lacks.
#pragma once

#include <concepts>

#include "limpet/core/params.hpp"

namespace limpet {

/// The class says which parameters it has, if only that it has none.
template <class T>
concept HasParams = requires {
  typename T::Params;
};

/// Every parameter has a default, and Describe declares it.
template <class T>
concept HasDescribedParams = HasParams<T> && std::default_initializable<typename T::Params> &&
    requires(typename T::Params& params, ParamCollector& visit) {
  params.Describe(visit);
};

}  // namespace limpet
