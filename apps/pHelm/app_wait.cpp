// SPDX-License-Identifier: MIT
#include "apps/pHelm/app_wait.hpp"

#include "limpet/core/config.hpp"

namespace limpet {

AppWait::AppWait(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    for (const std::string& name : Split(line, ',')) {
      if (!Trim(name).empty()) missing_.emplace(Trim(name));
    }
  }
}

void AppWait::Hear(std::string_view clients) {
  for (const std::string& client : Split(clients, ',')) {
    if (const auto found = missing_.find(Trim(client)); found != missing_.end()) {
      missing_.erase(found);
    }
  }
}

std::string AppWait::MissingText() const {
  std::string text;
  for (const std::string& name : missing_) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace limpet
