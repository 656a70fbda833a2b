// SPDX-License-Identifier: MIT
// The way of a camera's frame to a verdict, as docs/architecture.md has it, held against the code.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/layers/layers.hpp"

namespace limpet::layers {

/// One room of the walk: who takes the frame there, as what, and whom it calls or tells next.
struct FrameStep {
  std::string file;      ///< from the repository root; its folder is the room
  std::string function;  ///< `Class::Name` of the file
  std::string type;      ///< struct that carries the frame; empty where only a part of it comes
  std::string next;      ///< word of the function's own file: a call, or a variable's constant
  [[nodiscard]] std::string room() const;
};

/// Reads the Markdown table whose header begins `| file |`.
[[nodiscard]] std::vector<FrameStep> ReadFrameWalk(std::string_view markdown);

/// One complaint per step that the code does not take: no such file, or the file lacks the
/// function, or neither it nor its header names the type, or it does not call what is said to come
/// next.
[[nodiscard]] std::vector<std::string> StepsNotTaken(const std::vector<FrameStep>& walk,
                                                     const std::vector<SourceFile>& files);

[[nodiscard]] Names RoomsOf(const std::vector<FrameStep>& walk);
[[nodiscard]] Names TypesOf(const std::vector<FrameStep>& walk);

}  // namespace limpet::layers
