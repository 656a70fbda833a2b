// SPDX-License-Identifier: MIT
// Preloaded into a process (LD_PRELOAD): its wall clock is off by the nanoseconds, eight bytes,
// that the file named by WALL_CLOCK_SHIM_FILE holds at the moment. Monotonic clocks are as ever, as
// when somebody sets the date.
#include <cstdint>
#include <cstdlib>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

const volatile std::int64_t* Offset() {
  static const volatile std::int64_t* offset = [] {
    static const std::int64_t none = 0;
    const char* name = std::getenv("WALL_CLOCK_SHIM_FILE");
    const int file = name != nullptr ? ::open(name, O_RDONLY | O_CLOEXEC) : -1;
    void* place =
        file < 0 ? MAP_FAILED : ::mmap(nullptr, sizeof none, PROT_READ, MAP_SHARED, file, 0);
    return place == MAP_FAILED ? &none : static_cast<const std::int64_t*>(place);
  }();
  return offset;
}

std::int64_t WallNs() {
  timespec now{};
  ::syscall(SYS_clock_gettime, CLOCK_REALTIME, &now);
  return static_cast<std::int64_t>(now.tv_sec) * kSecond + now.tv_nsec + *Offset();
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
  if (clock != CLOCK_REALTIME && clock != CLOCK_REALTIME_COARSE) {
    return static_cast<int>(::syscall(SYS_clock_gettime, clock, now));
  }
  const std::int64_t ns = WallNs();
  now->tv_sec = static_cast<time_t>(ns / kSecond);
  now->tv_nsec = static_cast<long>(ns % kSecond);
  return 0;
}

int gettimeofday(timeval* now, void* /*zone*/) noexcept {
  const std::int64_t ns = WallNs();
  now->tv_sec = static_cast<time_t>(ns / kSecond);
  now->tv_usec = static_cast<suseconds_t>(ns % kSecond / 1000);
  return 0;
}

time_t time(time_t* now) noexcept {
  const auto seconds = static_cast<time_t>(WallNs() / kSecond);
  if (now != nullptr) {
    *now = seconds;
  }
  return seconds;
}

}  // extern "C"
