// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/console/frame.hpp"
#include "limpet/console/key_reader.hpp"
#include "limpet/console/scope_columns.hpp"
#include "limpet/console/terminal.hpp"
#include "limpet/console/variable_table.hpp"

namespace limpet {

/// What is so at the moment of a frame.
struct ScopeScene {
  ScopeMoment moment;
  std::string community;
  std::string place;       ///< host:port
  std::string trouble;     ///< why there is no connection; empty: there is one
  std::uint64_t lost = 0;  ///< messages that came faster than they were looked at
};

/// The live table: what the keys have made of it, and how it looks. Knows no terminal.
class ScopeScreen {
 public:
  struct Settings {
    ScopeFilter filter{};
    ScopeSort sort = ScopeSort::kName;
    std::string history_of{};  ///< begin with this variable's history
  };
  explicit ScopeScreen(Settings settings);

  void Press(const Key& key);
  [[nodiscard]] bool wants_to_quit() const { return wants_to_quit_; }
  /// The picture stands still until space is pressed again; whoever draws keeps the table for it.
  [[nodiscard]] bool is_paused() const { return is_paused_; }
  /// `size.lines` lines of at most `size.columns` columns.
  [[nodiscard]] Frame Draw(const VariableTable& table, const ScopeScene& scene, ScreenSize size);

 private:
  enum class Mode { kTable, kFilter, kHistory };

  void PressInFilter(const Key& key);
  void PressCharacter(char character);
  void Move(const Key& key);
  void PlaceCursor(const std::vector<const VariableRow*>& rows, std::size_t lines);
  void DrawTable(const std::vector<const VariableRow*>& rows, const ScopeScene& scene,
                 ScreenSize size, Frame& frame);
  void DrawHistory(const VariableTable& table, const ScopeScene& scene, ScreenSize size,
                   Frame& frame);
  [[nodiscard]] FrameLine Title(const ScopeScene& scene, const std::string& right,
                                std::size_t width) const;
  [[nodiscard]] FrameLine HelpLine(std::size_t width) const;

  Settings settings_;
  Mode mode_ = Mode::kTable;
  bool wants_to_quit_ = false;
  bool is_paused_ = false;
  bool is_reversed_ = false;
  bool has_cursor_ = false;   ///< from the first arrow key on
  bool has_moved_ = false;    ///< the cursor, since the last frame
  std::string typed_before_;  ///< filter to go back to
  std::string chosen_;        ///< variable under the cursor
  std::size_t cursor_ = 0;    ///< row
  std::size_t top_ = 0;       ///< first row shown
  std::size_t history_top_ = 0;
  std::size_t page_ = 10;  ///< rows of the last frame
};

}  // namespace limpet
