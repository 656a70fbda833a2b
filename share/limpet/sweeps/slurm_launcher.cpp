// SPDX-License-Identifier: MIT
#include "limpet/sweeps/slurm_launcher.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <signal.h>

#include "limpet/console/command_output.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/core/program_search.hpp"
#include "limpet/durable/durable_file.hpp"
#include "limpet/sweeps/child_process.hpp"

namespace limpet {
namespace {

constexpr const char* kJobFile = "job";
constexpr std::chrono::seconds kBetweenQuestions(1);
constexpr int kMostUnanswered = 300;

struct Answer {
  int exit_code = 0;
  std::string text;
};

/// Answer of a program of Slurm, with what it says on both of its outputs.
Answer Ask(const std::string& program, const std::vector<std::string>& words,
           const std::filesystem::path& log) {
  const int exit_code =
      WaitForChild(StartChild({.args = words, .log = log, .program = program}, SIGKILL));
  const Expected<std::string> text = ReadWhole(log);
  return {.exit_code = exit_code, .text = text ? *text : ""};
}

/// A word for a shell.
std::string Quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// `12` of `12` or `12;cluster`; empty if there is none.
std::string JobNumberIn(const std::string& text) {
  const std::vector<std::string> lines = Split(Trim(text), '\n');
  if (lines.empty()) return "";
  const std::string number = lines.back().substr(0, lines.back().find(';'));
  return ParseInteger(number) ? number : "";
}

}  // namespace

SlurmLauncher::SlurmLauncher(std::vector<std::string> words) : words_(std::move(words)) {
  if (!FindOnPath("sbatch")) {
    throw Refusal(
        "--runner slurm needs sbatch: run it where Slurm is (./limpet cluster installs "
        "it)");
  }
}

void SlurmLauncher::TakeUp(const std::filesystem::path& batch_folder) {
  folder_ = batch_folder;
  const Expected<std::string> job = ReadWhole(folder_ / kJobFile);
  job_ = job ? JobNumberIn(*job) : "";
}

void SlurmLauncher::Start(const std::filesystem::path& batch_folder, int workers) {
  folder_ = batch_folder;
  std::vector<std::string> words{"--parsable", "--job-name=limpet",
                                 fmt::format("--array=0-{}", workers - 1),
                                 fmt::format("--output={}/element-%a.txt", folder_.string()),
                                 fmt::format("--chdir={}", folder_.string())};
  words.insert(words.end(), words_.begin(), words_.end());
  words.push_back(fmt::format("--wrap=exec {} work {}",
                              Quoted((OwnProgram().parent_path() / "limpet").string()),
                              Quoted((folder_ / "tasks.json").string())));
  const Answer answer = Ask("sbatch", words, folder_ / "sbatch.txt");
  job_ = answer.exit_code == 0 ? JobNumberIn(answer.text) : "";
  if (job_.empty()) {
    throw std::runtime_error(fmt::format("sbatch failed: {}", OneLine(answer.text)));
  }
  if (const auto error = WriteDurably(folder_ / kJobFile, job_ + "\n")) {
    throw std::runtime_error(error->text);
  }
}

bool SlurmLauncher::IsAlive() {
  if (job_.empty()) return false;
  std::this_thread::sleep_for(kBetweenQuestions);
  const Answer answer = Ask("squeue", {"-h", "-j", job_, "-o", "%i"}, folder_ / "squeue.txt");
  const bool is_unknown = answer.text.find("Invalid job id") != std::string::npos;
  if (answer.exit_code != 0 && !is_unknown) {
    if (++unanswered_ < kMostUnanswered) return true;
    throw std::runtime_error(fmt::format("squeue does not answer: {}", OneLine(answer.text)));
  }
  unanswered_ = 0;
  if (is_unknown || Trim(answer.text).empty()) job_.clear();
  return !job_.empty();
}

void SlurmLauncher::Cancel() {
  if (job_.empty()) return;
  static_cast<void>(Ask("scancel", {job_}, folder_ / "scancel.txt"));
}

}  // namespace limpet
