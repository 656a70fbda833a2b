// SPDX-License-Identifier: MIT
// Texts in which the broker tells of its clients and variables, as MOOS tools read them
// (docs/wire.md).
#pragma once

#include <string>

#include "limpet/pubsub/broker.hpp"

namespace limpet {

/// `name:SUBSCRIBED=,A,B,PUBLISHED=,C` of PROC_SUMMARY.
[[nodiscard]] std::string ProcessSummary(const Router& router, Router::Client client);
/// `name=A:B&C` of DB_RWSUMMARY.
[[nodiscard]] std::string ReadWriteSummary(const Router& router, Router::Client client);
/// All names joined by commas: VAR_SUMMARY.
[[nodiscard]] std::string VariableNames(const Router& router);
/// `type_mismatch=0,foreign_source=0,...` of DB_REFUSED.
[[nodiscard]] std::string RefusalSummary(const BrokerCounts& counts);
/// One line per variable: DB_VARSUMMARY.
[[nodiscard]] std::string VariableTable(const Broker& broker);
/// Writes per second since `started` [Hz].
[[nodiscard]] double WriteFrequency(const Router::VariableInfo& info, Seconds started);

}  // namespace limpet
