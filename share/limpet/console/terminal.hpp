// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "limpet/console/frame.hpp"
#include "limpet/console/key_reader.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

struct ScreenSize {
  std::size_t columns = 80;
  std::size_t lines = 24;
  [[nodiscard]] bool operator==(const ScreenSize&) const = default;
};

/// The bytes that turn what a screen shows into `lines`: cursor moves, the lines that differ, and
/// erasing to the end of each. Empty if nothing differs. Nothing is ever erased before it is
/// written again, so nothing flickers.
class FrameWriter {
 public:
  explicit FrameWriter(bool has_colors) : has_colors_(has_colors) {}
  [[nodiscard]] std::string Update(const Frame& frame, ScreenSize size);
  /// The screen holds something else now: the next update writes every line.
  void Forget() { shown_.clear(); }

 private:
  bool has_colors_;
  ScreenSize size_;
  std::vector<std::string> shown_;
};

/// The whole terminal, while it lives: alternate screen, keys as they are pressed, no cursor. The
/// terminal is as before once it is gone, also after SIGINT, SIGTERM, SIGHUP, SIGQUIT, a crash, and
/// while the program is stopped by Ctrl-Z. There is one at a time.
class Terminal {
 public:
  /// True if both input and output are one that obeys escape codes.
  [[nodiscard]] static bool IsThere();

  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] ScreenSize Size() const;
  /// Shows a frame in one write.
  void Show(const Frame& frame);
  /// Keys pressed until now; waits up to `wait` for the first, less if the size changes or a signal
  /// comes.
  [[nodiscard]] std::vector<Key> ReadKeys(Seconds wait);
  /// False once the terminal has gone.
  [[nodiscard]] bool is_open() const { return is_open_; }

 private:
  void StopIfAsked();

  FrameWriter writer_;
  KeyReader keys_;
  bool is_open_ = true;
};

}  // namespace limpet
