// SPDX-License-Identifier: MIT
#include "limpet/durable/journal_format.hpp"

#include <array>

namespace limpet {
namespace {

constexpr std::size_t kSizeBytes = 4;

void PutNumber(std::string& out, std::uint64_t number, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i) {
    out += static_cast<char>((number >> (8 * i)) & 0xffU);
  }
}

std::uint64_t NumberAt(std::string_view bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    number |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return number;
}

/// FNV-1a of 64 bits, begun with the sum before and the size, so that a block of zeros is no record
/// without content.
std::uint64_t SumOf(std::uint64_t chain, std::string_view payload) {
  constexpr std::uint64_t kBasis = 0xcbf29ce484222325U, kPrime = 0x100000001b3U;
  std::uint64_t sum = (chain ^ kBasis) + payload.size();
  for (const char c : payload) {
    sum = (sum ^ static_cast<unsigned char>(c)) * kPrime;
  }
  return sum * kPrime;
}

}  // namespace

void AppendJournalRecord(std::string& out, std::uint64_t& chain, std::string_view payload) {
  chain = SumOf(chain, payload);
  PutNumber(out, payload.size(), kSizeBytes);
  PutNumber(out, chain, kJournalRecordHead - kSizeBytes);
  out += payload;
}

JournalReader::JournalReader(std::istream& in, std::uint64_t size) : in_(in), size_(size) {
  std::string header(kJournalHeader.size(), '\0');
  if (size_ >= header.size() && Read(header.data(), header.size()) && header == kJournalHeader) {
    end_ = header.size();
  }
}

bool JournalReader::Read(char* out, std::uint64_t count) {
  return static_cast<bool>(in_.read(out, static_cast<std::streamsize>(count)));
}

bool JournalReader::Next(std::string& payload) {
  std::array<char, kJournalRecordHead> head{};
  if (end_ == 0 || size_ - end_ < head.size() || !Read(head.data(), head.size())) {
    return false;
  }
  const std::string_view numbers(head.data(), head.size());
  const std::uint64_t count = NumberAt(numbers.substr(0, kSizeBytes));
  if (size_ - end_ - head.size() < count) {
    return false;
  }
  payload.resize(count);
  if (!Read(payload.data(), count)) {
    return false;
  }
  const std::uint64_t sum = SumOf(chain_, payload);
  if (NumberAt(numbers.substr(kSizeBytes)) != sum) {
    return false;
  }
  chain_ = sum;
  end_ += head.size() + count;
  return true;
}

}  // namespace limpet
