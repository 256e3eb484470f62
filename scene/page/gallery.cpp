#include "scene/page/gallery.h"

#include <fmt/format.h>
#include <string_view>

#include "base/counted.h"
#include "scene/text.h"

namespace solitaire {
namespace {

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

std::string image(std::string_view file, std::string_view what, const GalleryEntry& entry) {
  return fmt::format("<img src=\"{}\" alt=\"{} of {}\" loading=\"lazy\"{}>\n", relative_link(file), what,
                     escape_markup(entry.name), entry.has_sharp_pixels ? " class=\"sharp\"" : "");
}

std::string view(const GalleryEntry& entry) {
  if (!entry.picture.empty()) return image(entry.picture, "Picture", entry);
  if (!entry.plan.empty()) return image(entry.plan, "Drawing", entry);
  return fmt::format("<p class=\"value alone\">{}</p>\n",
                     entry.value.empty() ? "no value" : escape_markup(entry.value));
}

std::string link(std::string_view file, std::string_view text, std::string_view of) {
  if (file.empty()) return "";
  return fmt::format("<a href=\"{}\" title=\"{}\">{}</a>", relative_link(file), escape_markup(of), text);
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
      "<article id=\"solution-{0}\" data-facts=\"{1}\">\n{2}<div class=\"text\"><h2><a href=\"#open-{0}\">{3}"
      "</a></h2>\n{4}{5}<p class=\"facts\"><span>{6}</span>{7}{8}</p></div>\n</article>\n",
      entry.index, escape_markup(entry.facts), view(entry), escape_markup(entry.name), value, remarks,
      counted(entry.choices, "choice"), link(entry.glb, "3D scene (.glb)", entry.glb),
      link(entry.json, "data (.json)", entry.json));
}

}  // namespace

std::string gallery_html(const GalleryInfo& info, const std::vector<GalleryEntry>& entries) {
  std::string cards;
  for (const GalleryEntry& entry : entries) cards += card(entry);
  if (entries.empty()) cards = "<p>No solution.</p>\n";
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"Solitaire\">\n<title>{}: {}</title>\n"
      "<link rel=\"stylesheet\" href=\"./page/page.css\">\n<script src=\"./page/page.js\" defer></script>\n"
      "</head>\n<body>\n{}<main data-facts=\"{}\">\n{}</main>\n</body>\n</html>\n",
      escape_markup(info.title), counted(entries.size(), "solution"), header(info, entries.size()),
      escape_markup(info.facts), cards);
}

}  // namespace solitaire
