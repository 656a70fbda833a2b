// SPDX-License-Identifier: MIT
#include "tests/layers/frame_suffixes.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet::layers {
namespace {

/// What a brace opens.
struct Scope {
  std::string type;  ///< name of the struct or class; empty: a namespace, a function, a list
  bool is_type = false;
  bool is_seen = true;    ///< by other files
  bool is_public = true;  ///< what stands here now is seen, too
  std::string before;     ///< what stands before the brace in its statement
};

std::string WithoutComments(const std::string& text) {
  static const std::regex kComment("//[^\n]*|#[^\n]*"), kBlank("\\s+");
  return std::regex_replace(std::regex_replace(text, kComment, " "), kBlank, " ");
}

/// Names of a statement `Type a = .., b;` of a vector's type; what stands in parentheses and braces
/// has been left out.
std::vector<std::string> VectorsIn(const std::string& statement) {
  static const std::regex kDeclaration(
      R"(^ ?(?:mutable |const |static |inline |constexpr )*(?:std::\w+<)*)"
      R"(Eigen::(?:Vector|Matrix)[23]d(?:, \w+)?>* (\w+.*)$)");
  static const std::regex kName(R"(^ ?(\w+) ?(?:=.*)?$)");
  std::vector<std::string> names;
  std::smatch declaration;
  if (!std::regex_match(statement, declaration, kDeclaration)) return names;
  for (const std::string& part : Split(declaration[1].str(), ',')) {
    std::smatch name;
    if (std::regex_match(part, name, kName)) names.push_back(name[1]);
  }
  return names;
}

/// Follows the braces of a header and hands out what stands in types that others see.
class MemberReader {
 public:
  std::vector<std::pair<std::string, std::string>> Read(const std::string& text) {
    for (const char c : WithoutComments(text)) {
      if (c == '(') ++parentheses_;
      if (parentheses_ == 0) Take(c);
      if (c == ')') {
        --parentheses_;
        statement_ += "()";
      }
    }
    return std::move(members_);
  }

 private:
  void Take(char c) {
    if (c == '{') {
      Open();
    } else if (c == '}') {
      Close();
    } else if (c == ';') {
      End();
    } else {
      statement_ += c;
      TakeAccess();
    }
  }

  void Open() {
    static const std::regex kType(R"(^(?:.* )?(struct|class) (\w+)(?: final)?(?: ?:.*)? ?$)");
    static const std::regex kSpace(R"(^ ?(?:inline )?namespace\b.*$)");
    std::smatch type;
    Scope scope;
    scope.is_seen = scopes_.empty() || scopes_.back().is_public;
    scope.before = statement_;
    if (std::regex_match(statement_, type, kType)) {
      scope.type = type[2];
      scope.is_type = true;
      scope.is_public = scope.is_seen && type[1] == "struct";
      scope.before.clear();
    } else {
      scope.is_public = scope.is_seen && std::regex_match(statement_, kSpace);
    }
    scopes_.push_back(std::move(scope));
    statement_.clear();
  }

  /// A list in braces belongs to its statement; a function's body ends one.
  void Close() {
    if (scopes_.empty()) return;
    const Scope& scope = scopes_.back();
    const bool is_body =
        scope.before.find("()") != std::string::npos && scope.before.find('=') == std::string::npos;
    statement_ = is_body ? "" : scope.before;
    scopes_.pop_back();
  }

  void End() {
    if (!scopes_.empty() && scopes_.back().is_type && scopes_.back().is_public) {
      for (std::string& name : VectorsIn(statement_)) {
        members_.emplace_back(scopes_.back().type, std::move(name));
      }
    }
    statement_.clear();
  }

  void TakeAccess() {
    static constexpr std::array<std::string_view, 3> kWords{"public:", "protected:", "private:"};
    if (scopes_.empty() || !scopes_.back().is_type || !statement_.ends_with(':')) return;
    for (const std::string_view word : kWords) {
      if (!statement_.ends_with(word)) continue;
      scopes_.back().is_public = scopes_.back().is_seen && word == kWords.front();
      statement_.clear();
      return;
    }
  }

  std::vector<Scope> scopes_;
  std::string statement_;
  int parentheses_ = 0;
  std::vector<std::pair<std::string, std::string>> members_;
};

}  // namespace

std::string ReadFrameLetters(std::string_view markdown) {
  static const std::regex kFrame(R"(\*\*[^*]* ([A-Z])\*\*)");
  const std::string text(markdown);
  std::string letters;
  for (std::sregex_iterator frame(text.begin(), text.end(), kFrame), end; frame != end; ++frame) {
    letters += (*frame)[1];
  }
  return letters;
}

std::vector<std::string> MembersWithoutFrame(const std::vector<SourceFile>& files,
                                             const std::string& letters) {
  const std::regex framed("^(?:J_\\w+|\\w+_[" + letters + "]+)$");
  std::vector<std::string> complaints;
  for (const SourceFile& file : files) {
    if (!file.path.ends_with(".hpp") || file.path.starts_with("tests/")) continue;
    for (const auto& [type, name] : MemberReader().Read(file.text)) {
      if (std::regex_match(name, framed)) continue;
      complaints.push_back(fmt::format("{}: {}::{}", file.path, type, name));
    }
  }
  return complaints;
}

}  // namespace limpet::layers
