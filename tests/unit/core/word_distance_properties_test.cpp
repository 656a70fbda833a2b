// SPDX-License-Identifier: MIT
// The distance that finds the word somebody meant is a distance.
#include <algorithm>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/core/word_distance.hpp"

namespace limpet {
namespace {

std::string DrawWord(Random& random, std::size_t longest) {
  std::string word(random.Index(longest + 1), 'a');
  for (char& letter : word)
    letter = static_cast<char>('a' + random.Index(4));
  return word;
}

std::string Upper(std::string word) {
  for (char& letter : word)
    letter = static_cast<char>(letter - 'a' + 'A');
  return word;
}

TEST(WordDistanceProperties, IsZeroOfAWordToItselfInAnyCaseAndElsePositive) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const std::string a = DrawWord(random, 8), b = DrawWord(random, 8);
    EXPECT_EQ(WordDistance(a, Upper(a)), 0U);
    EXPECT_EQ(WordDistance(a, b) == 0, a == b);
  }
}

TEST(WordDistanceProperties, IsTheSameBothWaysAndNoDetourIsShorter) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const std::string a = DrawWord(random, 7), b = DrawWord(random, 7), c = DrawWord(random, 7);
    EXPECT_EQ(WordDistance(a, b), WordDistance(b, a));
    EXPECT_LE(WordDistance(a, c), WordDistance(a, b) + WordDistance(b, c));
  }
}

TEST(WordDistanceProperties, IsAtLeastTheDifferenceOfLengthsAndAtMostTheLongerWord) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const std::string a = DrawWord(random, 10), b = DrawWord(random, 10);
    const std::size_t distance = WordDistance(a, b);
    EXPECT_GE(distance, std::max(a.size(), b.size()) - std::min(a.size(), b.size()));
    EXPECT_LE(distance, std::max(a.size(), b.size()));
    EXPECT_EQ(WordDistance(a, ""), a.size());
  }
}

TEST(WordDistanceProperties, OneSlipOfThePenIsOne) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const std::string word = DrawWord(random, 9) + "a";
    const std::size_t at = random.Index(word.size());
    std::string lost = word, doubled = word, changed = word;
    lost.erase(at, 1);
    doubled.insert(at, 1, 'z');
    changed[at] = 'z';
    EXPECT_EQ(WordDistance(word, lost), 1U);
    EXPECT_EQ(WordDistance(word, doubled), 1U);
    EXPECT_EQ(WordDistance(word, changed), 1U);
  }
}

TEST(WordDistanceProperties, WhatWordsShareAtTheirEndsDoesNotCount) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const std::string a = DrawWord(random, 5), b = DrawWord(random, 5);
    const std::string before = DrawWord(random, 4), after = DrawWord(random, 4);
    EXPECT_EQ(WordDistance(before + a + after, before + b + after), WordDistance(a, b));
  }
}

}  // namespace
}  // namespace limpet
