// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace limpet {

inline std::string TextOfFile(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// What a user of the command sees.
struct CommandResult {
  int exit_code = -1;
  std::string out, err;
};

/// Runs the built `limpet`, which lies beside this program, in `folder` and waits for it.
inline CommandResult RunLimpet(const std::filesystem::path& folder,
                               std::vector<std::string> words) {
  const auto program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path().append("limpet").string();
  EXPECT_TRUE(std::filesystem::exists(program)) << program;
  const auto out = folder / ".stdout", err = folder / ".stderr";
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    std::vector<char*> argv{const_cast<char*>("limpet")};
    for (std::string& word : words)
      argv.push_back(word.data());
    argv.push_back(nullptr);
    const auto redirect = [](const std::filesystem::path& file, int stream) {
      ::dup2(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), stream);
    };
    redirect(out, STDOUT_FILENO);
    redirect(err, STDERR_FILENO);
    if (::chdir(folder.c_str()) == 0) ::execv(program.c_str(), argv.data());
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), TextOfFile(out),
          TextOfFile(err)};
}

}  // namespace limpet
