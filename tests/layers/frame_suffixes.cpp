// SPDX-License-Identifier: MIT
#include "tests/layers/frame_suffixes.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet::layers {
namespace {

/// A vector in W by its type, which stands beside a parameter's name, but not where a member is
/// read.
constexpr std::string_view kPlace = "PlanePoint";

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

bool IsHeader(const SourceFile& file) {
  return file.path.ends_with(".hpp") && !file.path.starts_with("tests/");
}

/// A vector or matrix of two or three rows, or what holds some, as a regular expression: Eigen's
/// own names, and those that headers give them.
std::string VectorTypes(const std::vector<SourceFile>& files) {
  static const std::regex kAlias(R"(using (\w+) = Eigen::(?:Vector|Matrix)[23]d;)");
  std::string types = "Eigen::(?:Vector|Matrix)[23]d";
  for (const SourceFile& file : files) {
    if (!IsHeader(file)) continue;
    for (std::sregex_iterator alias(file.text.begin(), file.text.end(), kAlias), end; alias != end;
         ++alias) {
      types += "|(?!cv::)(?:\\w+::)?" + (*alias)[1].str();
    }
  }
  return "(?:std::\\w+<)*(?:" + types + ")(?:, \\w+)?>*";
}

/// Names of a statement `Type a = .., b;` of a vector's type, which `declares` knows; what stands
/// in parentheses and braces has been left out.
std::vector<std::string> VectorsIn(const std::string& statement, const std::regex& declares) {
  static const std::regex kName(R"(^ ?(\w+) ?(?:=.*)?$)");
  std::vector<std::string> names;
  std::smatch declaration;
  if (!std::regex_match(statement, declaration, declares)) return names;
  for (const std::string& part : Split(declaration[1].str(), ',')) {
    std::smatch name;
    if (std::regex_match(part, name, kName)) names.push_back(name[1]);
  }
  return names;
}

/// Follows the braces of a header and hands out what stands in types that others see.
class MemberReader {
 public:
  explicit MemberReader(const std::regex& declares) : declares_(&declares) {}

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
      for (std::string& name : VectorsIn(statement_, *declares_)) {
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

  const std::regex* declares_;
  std::vector<Scope> scopes_;
  std::string statement_;
  int parentheses_ = 0;
  std::vector<std::pair<std::string, std::string>> members_;
};

/// Names that say their frame: the letters of one or more at their end, or that they are pixels of
/// an image. A Jacobian `J_x` has none of its own.
std::regex FramedName(const std::string& letters) {
  return std::regex("^(?:J_\\w+|\\w+_(?:[" + letters + "]+|px))$");
}

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
  const std::regex framed = FramedName(letters);
  const std::regex declares("^ ?(?:mutable |const |static |inline |constexpr )*" +
                            VectorTypes(files) + " (\\w+.*)$");
  std::vector<std::string> complaints;
  for (const SourceFile& file : files) {
    if (!IsHeader(file)) continue;
    for (const auto& [type, name] : MemberReader(declares).Read(file.text)) {
      if (std::regex_match(name, framed)) continue;
      complaints.push_back(fmt::format("{}: {}::{}", file.path, type, name));
    }
  }
  return complaints;
}

std::vector<std::string> ParametersWithoutFrame(const std::vector<SourceFile>& files,
                                                const std::string& letters) {
  static const std::regex kEmpty(R"(\{\}|\(\))"), kFunction(R"((\w+) ?\(([^(){};]*)\))");
  const std::regex framed = FramedName(letters);
  const std::regex parameter("^ ?(?:const )?" + VectorTypes(files) + "&? (\\w+)(?: ?=.*)?$");
  std::vector<std::string> complaints;
  for (const SourceFile& file : files) {
    if (!IsHeader(file)) continue;
    const std::string text = std::regex_replace(WithoutComments(file.text), kEmpty, "");
    for (std::sregex_iterator function(text.begin(), text.end(), kFunction), end; function != end;
         ++function) {
      for (const std::string& part : Split((*function)[2].str(), ',')) {
        std::smatch name;
        if (!std::regex_match(part, name, parameter)) continue;
        if (part.find(kPlace) != std::string::npos) continue;
        if (std::regex_match(name[1].str(), framed)) continue;
        complaints.push_back(
            fmt::format("{}: {}({})", file.path, (*function)[1].str(), name[1].str()));
      }
    }
  }
  return complaints;
}

}  // namespace limpet::layers
