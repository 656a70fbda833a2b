// SPDX-License-Identifier: MIT
#include "limpet/app/cut_life.hpp"

#include <memory>
#include <utility>

namespace limpet {
namespace {

/// Nobody is there to hear, and the time is the one that was.
class JournalLink final : public AppLink {
 public:
  explicit JournalLink(std::string source) : source_(std::move(source)) {}

  void Publish(std::string name, Value value, std::string source_aux) override {
    if (!has_ended_) return;
    last_words_.push_back({.name = std::move(name),
                           .value = std::move(value),
                           .time = now_,
                           .source = source_,
                           .source_aux = std::move(source_aux),
                           .community = ""});
  }
  void Subscribe(const std::string&, Seconds) override {}
  void SubscribeWildcard(const WildcardFilter&) override {}
  [[nodiscard]] Seconds Now() const override { return now_; }
  [[nodiscard]] bool is_replaying() const override { return !has_ended_; }

  void Advance(Seconds now) { now_ = now; }
  void EndReplay() { has_ended_ = true; }
  [[nodiscard]] std::vector<Message>& last_words() { return last_words_; }

 private:
  std::string source_;
  std::vector<Message> last_words_;
  Seconds now_;
  bool has_ended_ = false;
};

/// Absent if the journal is empty.
std::optional<Seconds> BeginOf(const MailJournal& journal) {
  std::optional<Seconds> begin;
  journal.Replay([&begin](Seconds now, const MessagePtr&) { begin = begin.value_or(now); });
  return begin;
}

}  // namespace

CutLife EndCutLife(const AppEntry& entry, AppContext context, const ConfigBlock& block,
                   const MailJournal& journal, std::span<const Message> last_mail) {
  const std::optional<Seconds> begin = BeginOf(journal);
  if (!begin) return {};
  JournalLink link(context.name);
  link.Advance(*begin);
  context.link = &link;
  context.is_restarted = true;
  context.ends_cut_life = true;
  const std::unique_ptr<App> app = entry.create(context, block);
  CutLife life;
  journal.Replay([&](Seconds now, const MessagePtr& mail) {
    link.Advance(now);
    if (mail) {
      ++life.messages;
      app->Deliver(mail);
    } else {
      app->Iterate(now);
    }
  });
  link.EndReplay();
  life.end = link.Now();
  for (Message mail : last_mail) {
    mail.time = life.end;
    app->Deliver(std::make_shared<const Message>(std::move(mail)));
  }
  app->End(life.end);
  life.warnings = app->warnings();
  life.last_words = std::move(link.last_words());
  return life;
}

}  // namespace limpet
