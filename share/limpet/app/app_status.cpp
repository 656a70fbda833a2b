// SPDX-License-Identifier: MIT
#include "limpet/app/app_status.hpp"

#include <fstream>
#include <set>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "limpet/core/clock.hpp"
#include "limpet/core/letter_case.hpp"

namespace limpet {
namespace {

Seconds SecondsOf(const timeval& time) {
  return Seconds(static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec));
}

/// MOOS ends each name with a comma, the last too.
std::string Listed(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += name + ",";
  }
  return text;
}

}  // namespace

ProcessUse UseOfThisProcess() {
  ProcessUse use;
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) == 0) {
    use.cpu = SecondsOf(usage.ru_utime) + SecondsOf(usage.ru_stime);
    use.memory_max_kb = usage.ru_maxrss;
  }
  std::ifstream statm("/proc/self/statm");
  std::int64_t all_pages = 0, resident_pages = 0;
  if (statm >> all_pages >> resident_pages) {
    use.memory_kb = resident_pages * sysconf(_SC_PAGESIZE) / 1024;
  }
  return use;
}

AppStatus::AppStatus(const std::string& name, Seconds started)
    : name_(name),
      variable_(UpperCase(name) + "_STATUS"),
      started_(started),
      last_cpu_(UseOfThisProcess().cpu),
      last_time_(SteadyTime()) {}

std::string AppStatus::Text(std::int64_t iteration, const LiveLink& link) {
  return Text(iteration, link.Now(), link.published(), link.subscribed());
}

std::string AppStatus::Text(std::int64_t iteration, Seconds now) {
  return Text(iteration, now, {}, {});
}

std::string AppStatus::Text(std::int64_t iteration, Seconds moos_now,
                            const std::set<std::string>& published,
                            const std::set<std::string>& subscribed) {
  const ProcessUse use = UseOfThisProcess();
  const Seconds now = SteadyTime();
  const double load = now > last_time_ ? 100.0 * ((use.cpu - last_cpu_) / (now - last_time_)) : 0.0;
  last_cpu_ = use.cpu;
  last_time_ = now;
  return fmt::format(
      "AppErrorFlag=false,Uptime={:.2f},cpuload={:.4g},memory_kb={},memory_max_kb={},Iterations={},"
      "MOOSName={},Publishing=\"{}\",Subscribing=\"{}\"",
      (moos_now - started_).value(), load, use.memory_kb, use.memory_max_kb, iteration, name_,
      Listed(published), Listed(subscribed));
}

}  // namespace limpet
