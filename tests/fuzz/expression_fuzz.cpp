// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "limpet/tuning/parameter_space.hpp"
#include "limpet/tuning/report_expression.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  static const auto kReport = limpet::ReportValues::FromJson(
      R"({"seed": 1, "sessions": {"d": {"path_m": 2.5, "level": null, "opis": [1, 2]}}})");
  if (const auto expression = limpet::ReportExpression::Parse(text)) {
    static_cast<void>(expression->Evaluate(*kReport));
    static_cast<void>(expression->UnknownKey(*kReport));
  }
  if (const auto report = limpet::ReportValues::FromJson(std::string(text))) {
    static_cast<void>(report->Keys());
  }
  if (const auto parameter = limpet::VariedParameter::Parse(text)) {
    static_cast<void>(parameter->ValueAt(0.5));
  }
  return 0;
}
