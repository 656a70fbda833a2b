// SPDX-License-Identifier: MIT
#include "limpet/console/key_reader.hpp"

#include <algorithm>
#include <array>

namespace limpet {
namespace {

using Code = Key::Code;

struct Sequence {
  std::string_view bytes;  ///< behind ESC [ or ESC O
  Code code;
};
constexpr std::array kSequences{Sequence{"A", Code::kUp},      Sequence{"B", Code::kDown},
                                Sequence{"5~", Code::kPageUp}, Sequence{"6~", Code::kPageDown},
                                Sequence{"H", Code::kHome},    Sequence{"F", Code::kEnd},
                                Sequence{"1~", Code::kHome},   Sequence{"4~", Code::kEnd},
                                Sequence{"7~", Code::kHome},   Sequence{"8~", Code::kEnd}};
constexpr std::size_t kLongestSequence = 16;

Key PlainKey(char byte) {
  if (byte >= 0x20 && byte < 0x7F) {
    return {Code::kCharacter, byte};
  }
  if (byte == '\r' || byte == '\n') {
    return {Code::kEnter};
  }
  return {byte == 0x7F || byte == '\b' ? Code::kBackspace : Code::kOther};
}

}  // namespace

std::vector<Key> KeyReader::Feed(std::string_view bytes) {
  pending_ += bytes;
  std::vector<Key> keys;
  while (!pending_.empty()) {
    Key key;
    if (pending_[0] != '\033') {
      key = PlainKey(pending_[0]);
      pending_.erase(0, 1);
    } else if (!TakeSequence(key)) {
      break;
    }
    keys.push_back(key);
  }
  return keys;
}

/// False if its end has not come yet.
bool KeyReader::TakeSequence(Key& key) {
  const bool is_sequence = pending_.size() > 1 && (pending_[1] == '[' || pending_[1] == 'O');
  if (!is_sequence) {
    key = {Code::kEscape};
    pending_.erase(0, 1);
    return true;
  }
  const auto end = std::find_if(pending_.begin() + 2, pending_.end(),
                                [](char c) { return c >= '@' && c <= '~'; });
  if (end == pending_.end() && pending_.size() < kLongestSequence) {
    return false;
  }
  const auto stop = end == pending_.end() ? end : end + 1;
  const std::string body(pending_.begin() + 2, stop);
  const auto known = std::ranges::find(kSequences, body, &Sequence::bytes);
  key = {known == kSequences.end() ? Code::kOther : known->code};
  pending_.erase(pending_.begin(), stop);
  return true;
}

}  // namespace limpet
