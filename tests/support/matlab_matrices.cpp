// SPDX-License-Identifier: MIT
#include "tests/support/matlab_matrices.hpp"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <zlib.h>

namespace limpet {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kHeader = 128;              // bytes before the first element
constexpr std::uint32_t kInt32 = 5, kDouble = 9;  // types of elements
constexpr std::uint32_t kMatrix = 14, kCompressed = 15;
constexpr std::uint8_t kDoubleClass = 6;
constexpr std::size_t kLargest = 1U << 28;  // [bytes] of an element that is believed

std::uint32_t Word(Bytes bytes) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data(), sizeof word);
  return word;
}

struct Element {
  std::uint32_t type = 0;
  Bytes data;
  std::size_t end = 0;  ///< where the next one begins
};

/// The element at the front; small ones have their data in the tag.
std::optional<Element> Front(Bytes bytes) {
  if (bytes.size() < 8) return std::nullopt;
  const std::uint32_t first = Word(bytes), size = first >> 16U;
  if (size > 0) {
    if (size > 4) return std::nullopt;
    return Element{first & 0xffffU, bytes.subspan(4, size), 8};
  }
  const std::size_t length = Word(bytes.subspan(4));
  if (length > bytes.size() - 8) return std::nullopt;
  const std::size_t padded = first == kCompressed ? length : (length + 7) / 8 * 8;
  return Element{first, bytes.subspan(8, length), std::min(8 + padded, bytes.size())};
}

std::optional<std::vector<std::uint8_t>> Inflated(Bytes bytes) {
  std::vector<std::uint8_t> out(4 * bytes.size() + 64);
  while (out.size() <= kLargest) {
    uLongf size = out.size();
    const int code = uncompress(out.data(), &size, bytes.data(), bytes.size());
    if (code == Z_OK) {
      out.resize(size);
      return out;
    }
    if (code != Z_BUF_ERROR) return std::nullopt;
    out.resize(2 * out.size());
  }
  return std::nullopt;
}

/// Name and values of a matrix element's content; an empty name if it is no matrix of doubles.
std::optional<std::pair<std::string, Eigen::MatrixXd>> MatrixOf(Bytes bytes) {
  std::vector<Element> parts;  // flags, dimensions, name, values
  while (parts.size() < 4) {
    const std::optional<Element> part = Front(bytes);
    if (!part) return std::nullopt;
    parts.push_back(*part);
    bytes = bytes.subspan(part->end);
  }
  if (parts[0].data.empty() || parts[0].data[0] != kDoubleClass || parts[3].type != kDouble) {
    return std::pair<std::string, Eigen::MatrixXd>();
  }
  if (parts[1].type != kInt32 || parts[1].data.size() != 8) return std::nullopt;
  const std::size_t rows = Word(parts[1].data), columns = Word(parts[1].data.subspan(4));
  if (rows > kLargest || columns > kLargest ||
      rows * columns * sizeof(double) != parts[3].data.size()) {
    return std::nullopt;
  }
  Eigen::MatrixXd values(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  if (values.size() > 0) std::memcpy(values.data(), parts[3].data.data(), parts[3].data.size());
  return std::pair(std::string(parts[2].data.begin(), parts[2].data.end()), std::move(values));
}

}  // namespace

Expected<std::map<std::string, Eigen::MatrixXd>> ReadMatlabMatrices(
    const std::filesystem::path& file) {
  std::ifstream input(file, std::ios::binary);
  const std::vector<std::uint8_t> all{std::istreambuf_iterator<char>(input), {}};
  if (all.size() < kHeader) {
    return Error{fmt::format("{}: not a MATLAB file", file.string())};
  }
  std::map<std::string, Eigen::MatrixXd> matrices;
  for (std::size_t at = kHeader; at < all.size();) {
    const Error damaged{fmt::format("{}: damaged at byte {}", file.string(), at)};
    std::optional<Element> element = Front(Bytes(all).subspan(at));
    if (!element) return damaged;
    at += element->end;
    std::optional<std::vector<std::uint8_t>> inflated;
    if (element->type == kCompressed) {
      inflated = Inflated(element->data);
      if (!inflated) return damaged;
      element = Front(*inflated);
      if (!element) return damaged;
    }
    if (element->type != kMatrix) continue;
    auto matrix = MatrixOf(element->data);
    if (!matrix) return damaged;
    if (!matrix->first.empty()) matrices.insert(std::move(*matrix));
  }
  return matrices;
}

}  // namespace limpet
