// SPDX-License-Identifier: MIT
// A file of its own: where the compiler sees both, it takes `free` for a mistake.
#include "tests/support/allocation_count.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> count{0};
}  // namespace

void* operator new(std::size_t size) {
  ++count;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
/// As the library's own would, of which a sanitizer has another one: what that allots must not be
/// freed here.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++count;
  return std::malloc(size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace limpet {

long AllocationCount() { return count; }

}  // namespace limpet
