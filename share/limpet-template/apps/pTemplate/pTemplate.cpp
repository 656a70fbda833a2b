#include <optional>

#include "limpet/app/app.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/topics/navigation.hpp"

namespace {

const limpet::Topic<bool> kTooDeep{"PTEMPLATE_TOO_DEEP",
                                   "deeper than pTemplate's limit, or nobody knows how deep"};

/// Says whether the vehicle is deeper than `max_depth_m`.
class pTemplate final : public limpet::App {
 public:
  struct Params {
    limpet::Meters max_depth{50.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      using limpet::Meters;
      visit("max_depth_m", max_depth, "Below this it is too deep",
            limpet::InRange(Meters(1.0), Meters(6000.0)));
    }
  };

  pTemplate(const limpet::AppContext& context, const Params& params)
      : App(context), params_(params) {
    Subscribe(limpet::topics::kNavDepth, &pTemplate::OnDepth);
  }

  void Tick(limpet::Seconds) override {
    // An unknown depth counts, too: a silent sensor must not look like a shallow vehicle.
    Publish(kTooDeep, !depth_ || *depth_ > params_.max_depth);
  }

 private:
  void OnDepth(const limpet::Stamped<double>& depth) { depth_ = limpet::Meters(depth.value); }

  Params params_;
  std::optional<limpet::Meters> depth_;
};

LIMPET_REGISTER_APP(pTemplate, "pTemplate", 4.0);

}  // namespace
