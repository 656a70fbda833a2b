// SPDX-License-Identifier: MIT
#include "limpet/app/cut_life.hpp"

#include <memory>
#include <utility>

namespace limpet {
namespace {

/// Nobody is there to hear, and the time is the one that was.
class JournalLink final : public AppLink {
 public:
  void Publish(std::string, Value, std::string) override {}
  void Subscribe(const std::string&, Seconds) override {}
  void SubscribeWildcard(const WildcardFilter&) override {}
  [[nodiscard]] Seconds Now() const override { return now_; }
  [[nodiscard]] bool is_replaying() const override { return !has_ended_; }

  void Advance(Seconds now) { now_ = now; }
  void EndReplay() { has_ended_ = true; }

 private:
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
                   const MailJournal& journal) {
  const std::optional<Seconds> begin = BeginOf(journal);
  if (!begin) return {};
  JournalLink link;
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
  app->End(life.end);
  life.warnings = app->warnings();
  return life;
}

}  // namespace limpet
