// SPDX-License-Identifier: MIT
#include "limpet/session/object_chips.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/session/class_text.hpp"

namespace limpet {
namespace {

constexpr const char* kTable = "chips.csv";
constexpr std::string_view kChipHeader = "file,object,t,class,confidence,u_px,v_px,w_px,h_px";
constexpr std::size_t kChipColumns = 9;

std::optional<SavedChip> ParseChip(std::string_view row, const SessionFiles& files) {
  const std::vector<std::string> fields = Split(row, ',');
  if (fields.size() != kChipColumns) return std::nullopt;
  const auto picture = files.find(fields[0]);
  const auto object = ParseInteger(fields[1]);
  if (picture == files.end() || !object) return std::nullopt;
  SavedChip saved{.object = static_cast<int>(*object), .chip = {}};
  Box& box = saved.chip.box;
  double exposure = 0.0;
  std::size_t field = 2;
  for (double* value : {&exposure, &box.confidence, &box.u, &box.v, &box.w, &box.h}) {
    if (field == 3) ++field;  // the class
    const std::optional<double> number = ParseNumber(fields[field++]);
    if (!number) return std::nullopt;
    *value = *number;
  }
  box.color = ClassFrom(fields[3]);
  saved.chip.exposure = Seconds(exposure);
  saved.chip.jpeg = picture->second;
  return saved;
}

}  // namespace

std::vector<SavedChip> ChipsOf(const OpiBeliefs& objects, const BestChips& seen,
                               const std::vector<SavedChip>& saved) {
  std::vector<SavedChip> chips;
  for (const OpiBelief& object : objects.opis) {
    const std::vector<ObjectChip>& now = seen.Of(object.landmark);
    for (const ObjectChip& chip : now)
      chips.push_back({object.id, chip});
    if (!now.empty()) continue;
    std::ranges::copy_if(saved, std::back_inserter(chips),
                         [&object](const SavedChip& chip) { return chip.object == object.id; });
  }
  return chips;
}

void AddChips(const std::vector<SavedChip>& chips, SessionFiles& files) {
  if (chips.empty()) return;
  std::string table = std::string(kChipHeader) + "\n";
  for (std::size_t i = 0; i < chips.size(); ++i) {
    const ObjectChip& chip = chips[i].chip;
    const std::string file = fmt::format("chips/{:04d}.jpg", i);
    files[file] = chip.jpeg;
    table += fmt::format("{},{},{:.3f},{},{:.4f},{:.2f},{:.2f},{:.2f},{:.2f}\n", file,
                         chips[i].object, chip.exposure.value(), ClassText(chip.box.color),
                         chip.box.confidence, chip.box.u, chip.box.v, chip.box.w, chip.box.h);
  }
  files[kTable] = table;
}

Expected<std::vector<SavedChip>> ChipsFrom(const SessionFiles& files) {
  std::vector<SavedChip> chips;
  const auto table = files.find(kTable);
  if (table == files.end()) return chips;  // an older session, or one without images
  int line = 0;
  for (const std::string& row : Split(table->second, '\n')) {
    ++line;
    if (line == 1 || row.empty()) continue;
    const std::optional<SavedChip> chip = ParseChip(row, files);
    if (!chip) {
      return Error{fmt::format("{}: line {}: not a picture of an object, or its file is not there",
                               kTable, line)};
    }
    chips.push_back(*chip);
  }
  return chips;
}

}  // namespace limpet
