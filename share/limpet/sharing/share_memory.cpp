// SPDX-License-Identifier: MIT
#include "limpet/sharing/share_memory.hpp"

#include <charconv>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet {
namespace {

constexpr std::size_t kLargestFile = 100'000;  ///< a thousand senders need half of that

std::optional<std::uint64_t> ParseHex(const std::string& text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value, 16);
  return result.ec == std::errc{} && result.ptr == end ? std::optional(value) : std::nullopt;
}

}  // namespace

ShareMemory ShareMemory::Parse(std::string_view text) {
  ShareMemory memory;
  for (const std::string& line : Split(text, '\n')) {
    const std::vector<std::string> words = Split(line, ' ');
    if (words.size() == 2 && words[0] == "own") {
      memory.own_epoch = ParseHex(words[1]).value_or(memory.own_epoch);
    } else if (words.size() == 3) {
      const auto sender = ParseHex(words[0]), epoch = ParseHex(words[1]),
                 counter = ParseHex(words[2]);
      if (sender && epoch && counter) {
        memory.heard[*sender] = {.epoch = *epoch, .counter = *counter};
      }
    }
  }
  return memory;
}

std::string ShareMemory::Text() const {
  std::string text = fmt::format("own {:016x}\n", own_epoch);
  for (const auto& [sender, heard_of] : heard) {
    text += fmt::format("{:016x} {:016x} {:016x}\n", sender, heard_of.epoch, heard_of.counter);
  }
  return text;
}

ShareMemory ShareMemory::Load(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(kLargestFile, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return Parse(text);
}

std::optional<Error> ShareMemory::Save(const std::filesystem::path& file) const {
  const std::filesystem::path aside = file.string() + ".new";
  {
    std::ofstream out(aside, std::ios::binary | std::ios::trunc);
    out << Text();
    if (!out.flush()) {
      return Error{fmt::format("{} cannot be written", aside.string())};
    }
  }
  std::error_code error;
  std::filesystem::rename(aside, file, error);
  return error ? std::optional(Error{fmt::format("{}: {}", file.string(), error.message())})
               : std::nullopt;
}

}  // namespace limpet
