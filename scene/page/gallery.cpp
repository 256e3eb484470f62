#include "scene/page/gallery.h"

#include <fmt/format.h>
#include <string_view>

#include "scene/text.h"

namespace solitaire {
namespace {

constexpr std::string_view kStyle = R"css(
:root { color-scheme: light dark; --page: #f4f3f0; --card: #fff; --ink: #1d2126; --soft: #5a616b; --line: #dcd9d2; --link: #0b5cad; }
@media (prefers-color-scheme: dark) {
  :root { --page: #16181b; --card: #202327; --ink: #e9eaec; --soft: #a6adb7; --line: #353a41; --link: #7db8f5; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 100rem; padding: 1.5rem clamp(1rem, 4vw, 3rem) 3rem; background: var(--page); color: var(--ink); font: 1rem/1.45 system-ui, sans-serif; }
h1 { margin: 0 0 .3rem; font-size: 1.7rem; overflow-wrap: anywhere; }
h2 { margin: 0; font-size: 1rem; overflow-wrap: anywhere; }
a { color: var(--link); }
dl { display: flex; flex-wrap: wrap; gap: .2rem 1.6rem; margin: 0 0 1.4rem; }
dl div { display: flex; gap: .4rem; }
dt, .facts { color: var(--soft); }
dd { margin: 0; overflow-wrap: anywhere; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(19rem, 100%), 1fr)); gap: 1rem; }
article { display: flex; flex-direction: column; background: var(--card); border: 1px solid var(--line); border-radius: .6rem; overflow: hidden; }
.plan { flex: 1; display: grid; place-items: center; padding: .8rem; color: var(--soft); border-bottom: 1px solid var(--line); }
.plan svg { display: block; width: 100%; height: auto; max-height: 26rem; }
article img { display: block; width: 100%; height: auto; background: #ecebea; border-bottom: 1px solid var(--line); }
summary { padding: .5rem .9rem; cursor: pointer; }
.text { padding: .7rem .9rem .8rem; }
.value { margin: .3rem 0; font: .85rem/1.5 ui-monospace, monospace; overflow-wrap: anywhere; white-space: pre-wrap; }
.remark { margin: .3rem 0; font-size: .875rem; overflow-wrap: anywhere; }
.alone { flex: 1; margin: 0; padding: .9rem; border-bottom: 1px solid var(--line); }
.facts { display: flex; flex-wrap: wrap; gap: .2rem 1rem; margin: .3rem 0 0; font-size: .875rem; }
)css";

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// Returns a link to the file, whatever characters its name has. "./" keeps "a:b.glb" from being a scheme.
std::string href(std::string_view file) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  std::string link = "./";
  for (const char c : file) {
    if (kPlain.find(c) != std::string_view::npos) {
      link += c;
    } else {
      link += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return link;
}

std::string fact(std::string_view name, std::string_view value) {
  return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escape_markup(name), escape_markup(value));
}

std::string header(const GalleryInfo& info, std::size_t solutions) {
  std::string facts = fact("solutions", std::to_string(solutions));
  if (!info.program.empty()) facts += fact("program", info.program);
  if (!info.seed.empty()) facts += fact("seed", info.seed);
  for (const auto& [name, value] : info.options) facts += fact(name, value);
  return fmt::format("<header>\n<h1>{}</h1>\n<dl>\n{}</dl>\n</header>\n", escape_markup(info.title), facts);
}

std::string plan(const GalleryEntry& entry) {
  return fmt::format("<div class=\"plan\">{}</div>\n", entry.plan);
}

/// Returns the picture, which shows the plan when somebody asks for it.
std::string picture(const GalleryEntry& entry) {
  return fmt::format(
      "<img src=\"{}\" alt=\"Picture of {}\" "
      "loading=\"lazy\">\n<details><summary>Plan</summary>{}</details>\n",
      href(entry.picture), escape_markup(entry.name), plan(entry));
}

std::string view(const GalleryEntry& entry) {
  if (!entry.picture.empty()) return picture(entry);
  if (!entry.plan.empty()) return plan(entry);
  return fmt::format("<p class=\"value alone\">{}</p>\n",
                     entry.value.empty() ? "no value" : escape_markup(entry.value));
}

std::string link(std::string_view file, std::string_view text, std::string_view of) {
  if (file.empty()) return "";
  return fmt::format("<a href=\"{}\" title=\"{}\">{}</a>", href(file), escape_markup(of), text);
}

std::string card(const GalleryEntry& entry) {
  const bool value_below = !entry.plan.empty() && !entry.value.empty();
  const std::string value =
      value_below ? fmt::format("<p class=\"value\">{}</p>\n", escape_markup(entry.value)) : "";
  std::string remarks;
  for (const std::string& remark : entry.remarks) {
    if (!remark.empty()) remarks += fmt::format("<p class=\"remark\">{}</p>\n", escape_markup(remark));
  }
  return fmt::format(
      "<article id=\"solution-{}\">\n{}<div class=\"text\"><h2>{}</h2>\n{}{}<p "
      "class=\"facts\"><span>{}</span>{}{}</p>"
      "</div>\n</article>\n",
      entry.index, view(entry), escape_markup(entry.name), value, remarks, counted(entry.choices, "choice"),
      link(entry.glb, "3D scene (.glb)", entry.glb), link(entry.json, "data (.json)", entry.json));
}

}  // namespace

std::string gallery_html(const GalleryInfo& info, const std::vector<GalleryEntry>& entries) {
  std::string cards;
  for (const GalleryEntry& entry : entries) cards += card(entry);
  if (entries.empty()) cards = "<p>No solution.</p>\n";
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"Solitaire\">\n<title>{}: "
      "{}</title>\n<style>{}</style>\n</head>\n<body>\n"
      "{}<main>\n{}</main>\n</body>\n</html>\n",
      escape_markup(info.title), counted(entries.size(), "solution"), kStyle, header(info, entries.size()),
      cards);
}

}  // namespace solitaire
