// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace limpet {

/// A piece of memory that a launcher makes and a process that it starts has mapped as well. What
/// lies in it must be lock-free atomics.
class SharedMemory {
 public:
  /// None.
  SharedMemory() = default;
  /// A new one of zeros; none if the system gives none.
  [[nodiscard]] static SharedMemory Create(const char* name, std::size_t size);
  /// The one whose descriptor the environment names, if it is large enough; what this process
  /// starts does not inherit it. To be called before any thread.
  [[nodiscard]] static SharedMemory Inherit(const char* variable, std::size_t size);
  ~SharedMemory();
  SharedMemory(SharedMemory&& other) noexcept;
  SharedMemory& operator=(SharedMemory&& other) noexcept;
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  /// Null if there is none.
  [[nodiscard]] void* data() const { return data_; }
  /// Descriptor to be inherited by a process; closed in all others. -1 if there is none, and of one
  /// that was inherited.
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  void Map(int descriptor, std::size_t size);

  void* data_ = nullptr;
  std::size_t size_ = 0;
  int descriptor_ = -1;
};

}  // namespace limpet
