// SPDX-License-Identifier: MIT
// The one file that includes CLI11: it reads the words of a command as the command declares them.
#include <algorithm>
#include <iterator>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "limpet/console/command.hpp"
#include "limpet/core/config.hpp"

namespace limpet {
namespace {

/// The words behind a command, through CLI11.
class CommandReader final : public CLI::App {
 public:
  explicit CommandReader(const Command& command) : command_(command) {
    allow_extras();  // it sorts words and unknown options apart, which the complaints are for
    set_help_flag("-h,--help");
    for (const CommandOption& option : command.options)
      Declare(option);
  }

  Arguments Read(std::span<const std::string> words) {
    std::optional<std::string> complaint;
    try {
      std::vector<std::string> reversed = Prepared(words);
      std::ranges::reverse(reversed);
      parse(std::move(reversed));
    } catch (const CLI::ValidationError&) {
      complaint = complaint_;
    } catch (const CLI::ArgumentMismatch&) {
      complaint = words.back() + " needs a value";
    } catch (const CLI::RequiredError&) {
      complaint = TakesText();
    } catch (const CLI::CallForHelp&) {
      complaint.reset();
    }
    if (get_help_ptr()->count() == 0) {
      RefuseUnknown();
      if (complaint) throw UsageError(*complaint);
      RequireWords();
    }
    return Result();
  }

 private:
  void Declare(const CommandOption& option) {
    if (option.value.empty()) {
      CLI::Option* flag = add_flag(option.names, option.meaning);
      // CLI11 knows `--flag=false`; a flag of ours is there or not.
      flag->check(Check([flag](const std::string& value) {
        return value == "true" ? "" : NameOf(*flag) + " takes no value";
      }));
      declared_.push_back(flag);
      return;
    }
    CLI::Option* added = add_option(option.names, CLI::callback_t(), option.meaning);
    added->type_size(1)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    added->required(option.is_required);
    if (option.rule.accepts) {
      added->check(Check([added, rule = option.rule](const std::string& value) {
        if (rule.accepts(value)) return std::string();
        return fmt::format("{} takes {}, not {}", NameOf(*added), rule.allowed,
                           value.empty() ? "an empty word" : fmt::format("`{}`", value));
      }));
    }
    declared_.push_back(added);
  }

  /// CLI11 writes the option's name before a complaint; ours has it where it reads well.
  std::function<std::string(const std::string&)> Check(
      std::function<std::string(const std::string&)> complaint_about) {
    return [this, complaint_about = std::move(complaint_about)](const std::string& value) {
      complaint_ = complaint_about(value);
      return complaint_;
    };
  }

  static std::string NameOf(const CLI::Option& option) {
    return option.get_lnames().empty() ? "-" + option.get_snames().front()
                                       : "--" + option.get_lnames().front();
  }

  /// CLI11 2.1 would take the next word for the value of `--out=`.
  [[nodiscard]] std::vector<std::string> Prepared(std::span<const std::string> words) const {
    std::vector<std::string> prepared;
    for (const std::string& word : words) {
      const bool is_empty_value = word.starts_with("--") && word.find('=') + 1 == word.size();
      const std::string name = word.substr(0, word.size() - (is_empty_value ? 1 : 0));
      const CLI::Option* option = is_empty_value ? get_option_no_throw(name) : nullptr;
      if (option != nullptr && option->get_expected_max() > 0) {
        prepared.push_back(name);
        prepared.emplace_back();
      } else {
        prepared.push_back(word);
      }
    }
    return prepared;
  }

  void RefuseUnknown() const {
    for (const auto& [kind, word] : missing_) {
      if (kind == CLI::detail::Classifier::NONE ||
          kind == CLI::detail::Classifier::POSITIONAL_MARK) {
        continue;
      }
      const std::string name = word.substr(0, word.find('='));
      std::vector<std::string> known{"help"};
      for (const CLI::Option* option : declared_)
        std::ranges::copy(option->get_lnames(), std::back_inserter(known));
      const std::string nearest = NearestWord(name.substr(name.find_first_not_of('-')), known);
      throw UsageError(
          fmt::format("unknown option {}{}", name,
                      nearest.empty() ? "" : fmt::format("; did you mean --{}?", nearest)));
    }
  }

  [[nodiscard]] std::vector<std::string> Positionals() const {
    std::vector<std::string> words;
    for (const auto& [kind, word] : missing_) {
      if (kind == CLI::detail::Classifier::NONE) words.push_back(word);
    }
    return words;
  }

  void RequireWords() const {
    const std::size_t count = Positionals().size();
    if (count < command_.least_words || count > command_.most_words) throw UsageError(TakesText());
  }

  /// `survey takes one mission folder`.
  [[nodiscard]] std::string TakesText() const {
    constexpr std::string_view kProgram = "limpet ";
    const std::string& name = command_.name;
    return fmt::format("{} takes {}", name.substr(name.starts_with(kProgram) ? kProgram.size() : 0),
                       command_.takes);
  }

  [[nodiscard]] Arguments Result() const {
    std::map<std::string, Arguments::Given> given{{"help", {get_help_ptr()->results(), ""}}};
    for (std::size_t i = 0; i < declared_.size(); ++i) {
      const std::string name = NameOf(*declared_[i]);
      given[name.substr(name.find_first_not_of('-'))] = {declared_[i]->results(),
                                                         command_.options[i].fallback};
    }
    return {Positionals(), std::move(given)};
  }

  const Command& command_;
  std::vector<CLI::Option*> declared_;  ///< in the order of the command's
  std::string complaint_;               ///< about the last value that was checked
};

}  // namespace

Arguments ReadArguments(const Command& command, std::span<const std::string> words) {
  return CommandReader(command).Read(words);
}

}  // namespace limpet
