// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <thread>

namespace limpet {

/// A thread that no signal of the process is delivered to: those belong to the program's own, which
/// ends its apps in order.
[[nodiscard]] std::thread BackgroundThread(std::function<void()> run);

}  // namespace limpet
