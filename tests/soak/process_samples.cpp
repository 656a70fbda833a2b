// SPDX-License-Identifier: MIT
#include "tests/soak/process_samples.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "limpet/launch/process_memory.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

std::optional<SampledProcess> SampleOf(pid_t pid) {
  SampledProcess sample;
  sample.pid = pid;
  std::ifstream(fmt::format("/proc/{}/comm", pid)) >> sample.name;
  const std::optional<double> resident = ResidentMib(pid);
  std::error_code gone;
  const fs::directory_iterator open(fmt::format("/proc/{}/fd", pid), gone);
  if (sample.name.empty() || !resident || gone) return std::nullopt;
  sample.resident_mib = *resident;
  for (auto file = open; !gone && file != fs::directory_iterator(); file.increment(gone)) {
    ++sample.descriptors;
  }
  return sample;
}

}  // namespace

std::vector<SampledProcess> ChildrenOf(pid_t parent) {
  if (!fs::exists("/proc/thread-self/children")) {
    throw std::runtime_error("this system's /proc names no children of a process");
  }
  std::vector<SampledProcess> children;
  std::error_code gone;
  const fs::path tasks = fmt::format("/proc/{}/task", parent);
  for (fs::directory_iterator task(tasks, gone); !gone && task != fs::directory_iterator();
       task.increment(gone)) {
    const fs::path list = task->path() / "children";
    std::ifstream in(list);
    for (pid_t pid = 0; in >> pid;) {
      if (const auto sample = SampleOf(pid)) children.push_back(*sample);
    }
  }
  return children;
}

}  // namespace limpet
