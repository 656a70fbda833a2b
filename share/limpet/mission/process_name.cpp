// SPDX-License-Identifier: MIT
#include "limpet/mission/process_name.hpp"

#include <algorithm>
#include <cctype>

namespace limpet {

bool IsNameOfMoosProcess(std::string_view name) {
  const auto is_upper = [](char letter) {
    return std::isupper(static_cast<unsigned char>(letter)) != 0;
  };
  const bool is_word = std::ranges::all_of(name, [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '-';
  });
  const bool has_form = name.size() > 2 &&
                        std::string_view("piu").find(name[0]) != std::string_view::npos &&
                        is_upper(name[1]);
  return name == "MOOSDB" || name == "LimpetDB" || (is_word && has_form);
}

}  // namespace limpet
