#include "tb/sim/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/sim/page_style.h"
#include "tb/util/markup.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

constexpr std::size_t most_page_lines = 300, most_page_text = 40'000;  // of a text shown whole
constexpr std::size_t most_page = 950'000;  // bytes, up to the end of an image

// Stands in a page once, before its waves.
constexpr const char* hatching =
    "<svg width=\"0\" height=\"0\" style=\"position:absolute\" aria-hidden=\"true\"><defs>"
    "<pattern id=\"off\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" "
    "patternTransform=\"rotate(45)\"><path class=\"hatch\" d=\"M0 0V6\"/></pattern></defs></svg>\n";

// The beginning of a long text, and how much of it is not there.
std::string cut(const std::string& text) {
  std::size_t end = 0, lines = 0;
  while (end < text.size() && lines < most_page_lines) {
    const std::size_t next = std::min(text.find('\n', end), text.size() - 1) + 1;
    if (next > most_page_text) break;
    end = next;
    ++lines;
  }
  if (end == text.size()) return markup(text);
  const auto left = std::count(text.begin() + static_cast<std::ptrdiff_t>(end), text.end(), '\n');
  return markup(text.substr(0, end)) +
         fmt::format("... left out: {}\n", count(static_cast<std::uint64_t>(left), "more line"));
}

std::string block(const std::string& text, const char* kind = "") {
  return fmt::format("<pre{}>{}</pre>\n", kind, cut(text));
}

std::string title_of(const Page& page) {
  if (!page.title.empty()) return page.title;
  std::string text;
  for (const Outcome& o : page.outcomes) {
    const std::string name = o.bench->design();
    if (&o == &page.outcomes.front()) text = page.outcomes.size() > 1 ? name : o.bench->title();
    if (text != name && page.outcomes.size() > 1) text = "several designs";
  }
  return text;
}

std::string paragraphs(const std::string& lines) {
  std::string text;
  for (const std::string& line : lines_in(lines)) {
    if (!line.empty()) text += fmt::format("<p>{}</p>\n", markup(line));
  }
  return text;
}

// Which clocks of the run are seen.
std::string shown(const WavePicture& p) {
  std::string text = p.first == p.last ? fmt::format("Shown: clock {}", p.first)
                                       : fmt::format("Shown: clocks {} to {}", p.first, p.last);
  text += fmt::format(" of {}", count(p.clocks, "clock"));
  const std::uint64_t after = p.clocks > p.last + 1 ? p.clocks - p.last - 1 : 0;
  if (p.first > 0) text += fmt::format("; left out: {} before them", p.first);
  if (after > 0)
    text += fmt::format("{} {} after them", p.first > 0 ? " and" : "; left out:", after);
  if (p.left_out > 0) {
    text +=
        fmt::format(". Not shown: {}, elements of arrays that do not change here{}",
                    count(p.left_out, "signal"), p.is_cut ? " and others, there are so many" : "");
  }
  return text + ".";
}

// What ran, and what was measured of it.
std::string matched(const Page& page) {
  if (page.outcomes.size() == 1 && page.title.empty()) {
    const Outcome& o = page.outcomes.front();
    return fmt::format("<h1>{}</h1>\n<p>{}: {}</p>\n", markup(o.bench->title()), markup(o.work),
                       markup(swept_text(o.result)));
  }
  std::string text = fmt::format("<h1>{}</h1>\n", markup(title_of(page)));
  if (page.outcomes.empty()) return text;
  text += "<div class=\"wide\"><table>\n";
  for (const Outcome& o : page.outcomes) {
    text += fmt::format("<tr><td class=\"one\">{}</td><td>{}</td><td>{}</td></tr>\n",
                        markup(o.bench->title()), markup(o.work), markup(swept_text(o.result)));
  }
  return text + "</table></div>\n";
}

std::string badge(const std::string& kind, const std::string& word) {
  return fmt::format("<span class=\"verdict {}\">{}</span>\n", kind, markup(word));
}

// What is above all else.
std::string head(const Page& page) {
  if (const Page::Verdict& v = page.verdict; !v.word.empty()) {
    return badge(v.kind, v.word) + fmt::format("<h1>{}</h1>\n", markup(page.title)) +
           block(v.lines, " class=\"first\"") + "<div class=\"soft\">" + paragraphs(v.conditions) +
           "</div>\n";
  }
  const bool match = all_match(page.outcomes);
  const std::string verdict = verdict_of(page.outcomes);
  const bool is_good = verdict == "match";
  std::string text = badge(is_good ? "good" : match ? "none" : "bad", verdict);
  if (match) text += matched(page);
  for (const Outcome& o : page.outcomes) {
    if (o.result.match()) continue;
    text +=
        fmt::format("<h1>{}</h1>\n<p>{}</p>\n", markup(o.bench->title()), markup(o.result.failed));
    text += o.result.mismatch
                ? block(difference_text(*o.result.mismatch), " class=\"first\"")
                : block("RTL and model agree, but the checker reports: " + o.result.checked.error +
                            '\n',
                        " class=\"first\"");
  }
  return text + "<div class=\"soft\">" + paragraphs(comparison_text(page.outcomes)) + "</div>\n";
}

// What the colours of a wave mean, of those that it has.
std::string legend(const WavePicture& p) {
  std::string text;
  if (p.wave.find("class=\"mark\"") != std::string::npos) {
    text += fmt::format(
        "<span class=\"e\">{}</span> is what {} has, <span class=\"a\">{}</span> what {} has; red "
        "is "
        "where they differ, the yellow column the first clock that does. ",
        p.sides.expected, p.sides.has_expected, p.sides.actual, p.sides.has_actual);
  }
  if (p.wave.find("class=\"off\"") != std::string::npos) {
    text += "Hatched is what means nothing on that clock and is not compared.";
  }
  return text.empty() ? "" : "<p class=\"soft\">" + text + "</p>\n";
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t three = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      three = three << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += at + i <= bytes.size() ? digits[three >> (18 - 6 * i) & 63] : '=';
    }
  }
  return text;
}

// A picture in the page itself, of which there is so much before.
std::string image_text(const std::string& file, std::size_t before) {
  const std::string bytes = read_file(file);
  if (before + bytes.size() / 3 * 4 > most_page) {
    return fmt::format("<p>Left out: {}, {} kB are too much for a page.</p>\n", markup(file),
                       bytes.size() / 1000);
  }
  return fmt::format("<div class=\"wide\"><img alt=\"{}\" src=\"data:image/{};base64,{}\"></div>\n",
                     markup(file), file.ends_with(".svg") ? "svg+xml" : "png", base64(bytes));
}

std::string part_text(const Page::Part& part, std::size_t before) {
  const WavePicture& p = part.picture;
  std::string text = fmt::format("<h2>{}</h2>\n{}", markup(part.heading), paragraphs(part.text));
  if (!part.table.empty()) text += block(part.table);
  if (!part.image.empty()) text += image_text(part.image, before + text.size());
  if (!p.wave.empty()) text += fmt::format("<p>{}</p>\n{}", shown(p), p.wave + legend(p));
  if (!part.stimulus.empty()) {
    text += "<details open><summary>Its stimulus</summary>" + block(part.stimulus) + "</details>\n";
  }
  return text;
}

std::string path_text(const WavePicture& p) {
  return fmt::format(
      "<h2>The path, clocks {} to {}</h2>\n<p>x and y of the wave, in steps{}</p>\n{}",
      p.path_first, p.path_last,
      p.path.find("class=\"ring\"") == std::string::npos
          ? "."
          : ": <span class=\"e\">expected</span>, <span class=\"a\">actual</span>; the ring is "
            "where "
            "they part.",
      p.path);
}

std::string framed(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" "
      "href=\"data:,\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n"
      "</html>\n",
      markup(title), page_style, body);
}

}  // namespace

std::string page_text(const Page& page) {
  std::string body = hatching + head(page);
  for (const Page::Part& part : page.parts) {
    if (!part.picture.wave.empty() || !part.table.empty() || !part.image.empty()) {
      body += part_text(part, body.size());
    }
  }
  for (const Page::Part& part : page.parts) {
    if (part.picture.path.empty()) continue;
    body += path_text(part.picture);
    break;
  }
  if (!page.commands.empty()) {
    body += "<h2>To go on</h2>\n<dl>\n";
    for (const Page::Command& c : page.commands) {
      body += fmt::format("<dt>{}</dt><dd><pre>{}</pre></dd>\n", markup(c.what), markup(c.words));
    }
    body += "</dl>\n";
  }
  for (const Outcome& o : page.outcomes) {
    if (!o.result.mismatch) continue;
    body += "<details><summary>The clocks around the difference as a table</summary>" +
            block(table_text(*o.result.mismatch)) + "</details>\n";
  }
  const std::string word =
      page.verdict.word.empty() ? verdict_of(page.outcomes) : page.verdict.word;
  return framed(fmt::format("{}: {}", word, title_of(page)), body);
}

}  // namespace cosim
