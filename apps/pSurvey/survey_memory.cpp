// SPDX-License-Identifier: MIT
#include "apps/pSurvey/survey_memory.hpp"

#include "limpet/core/record.hpp"
#include "limpet/durable/durable_file.hpp"

namespace limpet {
namespace {

constexpr const char* kFile = "survey_state.txt";

}  // namespace

void SurveyKeeper::Keep(const SurveyMemory& memory) {
  jobs_.Put([this, text = EncodeRecord(memory)] {
    outcome_ = Outcome{WriteDurably(run_folder_ / kFile, text, disk_)};
  });
}

std::optional<SurveyKeeper::Outcome> SurveyKeeper::TakeOutcome() {
  return jobs_.is_idle() ? std::exchange(outcome_, std::nullopt) : std::nullopt;
}

std::optional<SurveyMemory> RecallSurvey(const std::filesystem::path& run_folder) {
  const Expected<std::string> text = ReadWhole(run_folder / kFile);
  return text ? DecodeRecord<SurveyMemory>(*text) : std::nullopt;
}

}  // namespace limpet
