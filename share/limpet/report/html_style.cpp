// SPDX-License-Identifier: MIT
#include "limpet/report/html_style.hpp"

#include <fmt/format.h>

#include "limpet/figures/palette.hpp"

namespace limpet {
namespace {

constexpr const char* kLayout = R"(
*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--ink);line-height:1.55;font-size:16px;
 -webkit-text-size-adjust:100%}
main,header,footer{max-width:64rem;margin:0 auto;padding:0 1.5rem}
header{padding-top:3.2rem;padding-bottom:1rem}
h1{font-size:2.3rem;line-height:1.15;letter-spacing:-.02em;margin:0 0 .3rem;font-weight:650}
h2{font-size:1.55rem;letter-spacing:-.01em;margin:3.2rem 0 .2rem;font-weight:650}
h3{font-size:1.05rem;margin:2.2rem 0 .6rem;font-weight:650}
p{margin:.4rem 0 1rem;max-width:46rem}
.muted,figcaption,.eyebrow,dd{color:var(--muted)}
.eyebrow{font-size:.82rem;letter-spacing:.08em;text-transform:uppercase;font-weight:600;margin:0 0 .5rem}
.verdict{display:flex;gap:.7rem;align-items:flex-start;border-radius:.6rem;padding:.8rem 1.1rem;
 margin:1.3rem 0 0;font-weight:550;background:var(--card);border-left:.35rem solid var(--good)}
.verdict.bad{border-left-color:var(--bad)}
.cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(8.7rem,1fr));gap:.8rem;margin:1.3rem 0}
.card{background:var(--card);border-radius:.6rem;padding:.8rem 1rem}
.card b{display:block;font-size:1.5rem;font-weight:620;letter-spacing:-.01em;line-height:1.25;
 font-variant-numeric:tabular-nums}
.card span{font-size:.84rem;color:var(--muted);line-height:1.35;display:block}
.scroll{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-size:.93rem;font-variant-numeric:tabular-nums;margin:.4rem 0 1rem}
th{font-weight:550;color:var(--muted);font-size:.82rem;text-align:right;padding:.35rem .7rem;
 border-bottom:1.5px solid var(--rule);vertical-align:bottom}
td{text-align:right;padding:.42rem .7rem;border-bottom:1px solid var(--rule);white-space:nowrap}
th:first-child,td:first-child,.left{text-align:left!important}
th:first-child,td:first-child{padding-left:0}
td:first-child{font-weight:550}
.ok{color:var(--good);font-weight:600}
.no,.alarm{color:var(--bad);font-weight:600}
.warning{font-weight:600}
.note{color:var(--muted)}
.text{white-space:normal;min-width:20rem}
figure{margin:1.4rem 0 2rem;background:var(--card);border-radius:.7rem;padding:1rem 1rem .9rem}
figure svg{display:block;width:100%;height:auto}
.chips{display:flex;flex-wrap:wrap;gap:1.1rem 1.6rem;margin:.8rem 0 1.4rem;font-size:.9rem;color:var(--muted)}
.chips p{margin:0 0 .35rem;display:flex;gap:.35rem}
.chips img{display:block;height:6rem;width:auto;border-radius:.35rem}
.chips b{color:var(--ink);font-weight:550}
figcaption{font-size:.9rem;margin:.7rem .4rem 0;max-width:48rem}
code{font-family:ui-monospace,'Cascadia Mono','DejaVu Sans Mono',Menlo,Consolas,monospace;font-size:.9em}
pre{background:var(--card);border-radius:.5rem;padding:.8rem 1rem;overflow-x:auto;margin:.4rem 0 1rem}
dl{display:grid;grid-template-columns:minmax(9rem,14rem) 1fr;gap:.5rem 1.4rem;margin:.8rem 0}
dt{font-weight:550}
dd{margin:0}
nav a{color:var(--link);text-decoration:none;margin-right:1.2rem;font-weight:550}
nav a:hover{text-decoration:underline}
footer{padding-top:2rem;padding-bottom:3rem;font-size:.88rem;color:var(--muted)}
@media (max-width:40rem){dl{grid-template-columns:1fr;gap:.1rem}dd{margin-bottom:.7rem}}
@media print{body{background:#fff}figure,.card,.verdict{break-inside:avoid;border:1px solid #ccc}}
)";

/// Figures carry plain colours so that they stand alone; here they follow the page.
std::string Recolor(std::string_view from, const char* to) {
  return fmt::format(
      "figure svg [fill=\"{0}\"]{{fill:{1}}}figure svg [stroke=\"{0}\"]{{stroke:{1}}}\n", from, to);
}

}  // namespace

std::string PageStyle() {
  const std::string light = fmt::format(
      ":root{{color-scheme:light dark;--ink:{};--muted:{};--rule:{};--ground:#f5f7f8;--card:{};"
      "--good:#00795a;--bad:#b84700;--link:{}}}\nbody{{font-family:{}}}\n",
      palette::kInk, palette::kMuted, palette::kGrid, palette::kPaper, palette::kBlue,
      palette::kFont);
  const std::string dark =
      "@media (prefers-color-scheme:dark){\n:root{--ink:#e4ebef;--muted:#9db0bb;--rule:#2c3a44;"
      "--ground:#10181d;--card:#18232a;--good:#3fc79a;--bad:#ff8a4c;--link:#6fbdf0}\n" +
      Recolor(palette::kBlue, "#3d9fe0") + Recolor(palette::kVermillion, "#ee7733") + "}\n";
  return light + kLayout + Recolor(palette::kInk, "var(--ink)") +
         Recolor(palette::kMuted, "var(--muted)") + Recolor(palette::kGrid, "var(--rule)") +
         Recolor(palette::kPaper, "var(--card)") + dark;
}

}  // namespace limpet
