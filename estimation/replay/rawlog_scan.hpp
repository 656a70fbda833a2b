// SPDX-License-Identifier: MIT
// Where observations begin in the bytes of a rawlog. An object begins with the length of its
// class's name, that name and a version; how long it is nobody says.
#pragma once

#include <cstddef>
#include <string_view>

namespace limpet {

/// Class of the object that begins with `bytes`, without MRPT's namespace, which older files leave
/// out; empty if none does.
[[nodiscard]] std::string_view ClassAt(std::string_view bytes);

/// Where the next observation of MRPT's begins at or behind `from`: an object of any class, alone
/// or in a sensory frame, whose name says that it is one. The end if there is none.
[[nodiscard]] std::size_t NextObservation(std::string_view bytes, std::size_t from);

}  // namespace limpet
