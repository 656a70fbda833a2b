// SPDX-License-Identifier: MIT
// Measurement sources by name, as who describes and configures them sees them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/params.hpp"

namespace limpet {

class MeasurementSource;

/// One registered source before it exists: holds its parameters while a block is read into them.
class SourceFactory {
 public:
  virtual ~SourceFactory() = default;
  /// Declarations whose `set` writes into this factory, without the source's name before each;
  /// valid as long as it lives.
  [[nodiscard]] virtual std::vector<ParamSpec> Parameters() = 0;
  /// Whether it makes a MotionSensor.
  [[nodiscard]] virtual bool is_of_motion() const = 0;
  /// A source with the parameters as they are now. Throws ConfigError if they are impossible.
  [[nodiscard]] virtual std::unique_ptr<MeasurementSource> Make() const = 0;
};

/// Every registered name, in alphabetical order.
[[nodiscard]] std::vector<std::string> SourceNames();

/// A factory with the default parameters; for an unknown name the nearest known one is named.
[[nodiscard]] Expected<std::unique_ptr<SourceFactory>> FindSource(const std::string& name);

}  // namespace limpet
