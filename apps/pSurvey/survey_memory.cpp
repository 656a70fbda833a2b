// SPDX-License-Identifier: MIT
#include "apps/pSurvey/survey_memory.hpp"

#include "limpet/core/record.hpp"
#include "limpet/session/durable_file.hpp"

namespace limpet {
namespace {

constexpr const char* kFile = "survey_state.txt";

}  // namespace

std::optional<Error> KeepSurvey(const SurveyMemory& memory,
                                const std::filesystem::path& run_folder) {
  return WriteDurably(run_folder / kFile, EncodeRecord(memory));
}

std::optional<SurveyMemory> RecallSurvey(const std::filesystem::path& run_folder) {
  const Expected<std::string> text = ReadWhole(run_folder / kFile);
  return text ? DecodeRecord<SurveyMemory>(*text) : std::nullopt;
}

}  // namespace limpet
