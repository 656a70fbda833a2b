// SPDX-License-Identifier: MIT
#include "limpet/app/shared_memory.hpp"

#include <cstdlib>
#include <utility>

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "limpet/core/number_text.hpp"

namespace limpet {

SharedMemory SharedMemory::Create(const char* name, std::size_t size) {
  SharedMemory made;
  made.descriptor_ = ::memfd_create(name, MFD_CLOEXEC);
  if (made.descriptor_ >= 0 && ::ftruncate(made.descriptor_, static_cast<off_t>(size)) == 0) {
    made.Map(made.descriptor_, size);
  }
  return made;
}

SharedMemory SharedMemory::Inherit(const char* variable, std::size_t size) {
  SharedMemory inherited;
  const char* text = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): no thread yet
  const auto number = ParseInteger(text != nullptr ? text : "");
  if (!number || *number <= STDERR_FILENO) return inherited;
  const int descriptor = static_cast<int>(*number);
  inherited.Map(descriptor, size);
  if (inherited.data_ != nullptr) {
    ::close(descriptor);
    ::unsetenv(variable);  // NOLINT(concurrency-mt-unsafe): no thread yet
  }
  return inherited;
}

SharedMemory::~SharedMemory() {
  if (data_ != nullptr) ::munmap(data_, size_);
  if (descriptor_ >= 0) ::close(descriptor_);
}

SharedMemory::SharedMemory(SharedMemory&& other) noexcept { *this = std::move(other); }

SharedMemory& SharedMemory::operator=(SharedMemory&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

void SharedMemory::Map(int descriptor, std::size_t size) {
  struct stat facts {};
  if (::fstat(descriptor, &facts) != 0 || facts.st_size < static_cast<off_t>(size)) return;
  void* memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
  if (memory == MAP_FAILED) return;
  data_ = memory;
  size_ = size;
}

}  // namespace limpet
