// SPDX-License-Identifier: MIT
#include "limpet/core/config.hpp"
#include "tests/layers/layers.hpp"

namespace limpet::layers {
namespace {

Names NamesIn(std::string_view cell) {
  Names names;
  for (const std::string& part : Split(cell, ',')) {
    const std::string name(Trim(part));
    if (name == "each other") {
      names.insert("estimation");
    } else if (!name.empty() && name != "-") {
      names.insert(name);
    }
  }
  return names;
}

}  // namespace

LayerTable ReadLayerTable(std::string_view markdown) {
  LayerTable table;
  bool is_inside = false;
  for (const std::string& line : Split(markdown, '\n')) {
    const std::vector<std::string> cells = Split(line, '|');
    is_inside = line.starts_with("| library |") || (is_inside && line.starts_with('|'));
    if (!is_inside || cells.size() < 5 || cells[1].starts_with(" library") ||
        cells[1].starts_with(" -")) {
      continue;
    }
    std::string name(Trim(cells[1]));
    name = name.substr(0, name.find('/'));  // estimation/* is one layer of several folders
    table[name] = {.may_use = NamesIn(cells[3]), .hidden = NamesIn(cells[4])};
  }
  return table;
}

}  // namespace limpet::layers
