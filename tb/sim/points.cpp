#include "tb/sim/asked.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "model/core/input_error.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::coverage {
namespace {

namespace fs = std::filesystem;

template <class Number>
Number number_in(const std::string& text, const std::string& line) {
  Number number = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || end.ec != std::errc() || end.ptr != text.data() + text.size()) {
    throw InputError(fmt::format("no count of coverage: {}", line));
  }
  return number;
}

// What Verilator writes as "__024" is "$", and so on.
std::string name_in(std::string text) {
  for (std::size_t at = 0; (at = text.find("__0", at)) != std::string::npos; ++at) {
    unsigned char c = 0;
    const char* const code = text.data() + at + 3;
    const auto end =
        std::from_chars(code, std::min<const char*>(code + 2, text.data() + text.size()), c, 16);
    if (end.ptr == code + 2 && c > ' ') text.replace(at, 5, 1, static_cast<char>(c));
  }
  return text;
}

// "TOP.top.a.b" or, of several instances, "TOP.top.*".
std::string below_top(const std::string& path) {
  const std::size_t top = path.find('.');
  const std::size_t below = top == std::string::npos ? top : path.find('.', top + 1);
  return below == std::string::npos ? "" : path.substr(below + 1);
}

// C '\1KEY\2VALUE\1KEY\2VALUE...' HITS
Point point_in(const std::string& line) {
  const std::size_t end = line.rfind("' ");
  if (!line.starts_with("C '\1") || end == std::string::npos) {
    throw InputError(fmt::format("no count of coverage: {}", line));
  }
  std::map<char, std::string> has;
  for (const std::string& word : parts_in(line.substr(4, end - 4), '\1')) {
    const std::size_t middle = word.find('\2');
    if (middle == std::string::npos) continue;
    const std::string key = word.substr(0, middle);
    has[key == "page" ? 'p' : key.front()] = word.substr(middle + 1);
  }
  // The page is "v_KIND/MODULE".
  const std::string page = has['p'].substr(0, has['p'].find('/'));
  return {page.starts_with("v_") ? page.substr(2) : page,
          has['f'],
          number_in<int>(has['l'], line),
          number_in<int>(has['n'], line),
          name_in(has['o']),
          number_in<std::uint64_t>(line.substr(end + 2), line),
          {below_top(name_in(has['h']))}};
}

// DESIGN, what is a way's in the file of its model, and hits.
Point way_in(const std::string& line) {
  const auto words = parts_in(line, '\t');
  if (words.size() != 6) throw InputError(fmt::format("no count of a way: {}", line));
  return {"model " + words[1],
          words[2],
          number_in<int>(words[3], line),
          0,
          words[4],
          number_in<std::uint64_t>(words[5], line),
          {""}};
}

}  // namespace

std::string name_in_model(const Point& p) {
  return fmt::format("{}\t{}\t{}\t{}", p.kind.substr(p.kind.find(' ') + 1), p.file, p.line, p.what);
}

bool is_same(const Point& a, const Point& b) {
  const auto place = [](const Point& p) {
    return std::tie(p.file, p.line, p.column, p.kind, p.what);
  };
  return place(a) == place(b);
}

Points read_points(const std::string& folder) {
  using Place = std::tuple<std::string, int, int, std::string, std::string>;
  struct Seen {
    std::uint64_t hits = 0;
    std::set<std::string> instances;
  };
  std::map<Place, Seen> places;
  Points all;
  std::set<fs::path> paths;
  for (const auto& file : fs::recursive_directory_iterator(folder)) {
    if (file.is_regular_file() && file.path().filename() != "progress") paths.insert(file.path());
  }
  for (const fs::path& path : paths) {
    const std::string name_of_file = path.filename().string();
    const bool cases = name_of_file.starts_with("cases.");
    const bool ways = name_of_file.starts_with("ways.");
    const bool before = name_of_file.starts_with("before.");
    for (const std::string& line : lines_in(read_file(path.string()))) {
      if (cases) {
        // DESIGN, name and hits, a tabulator between two.
        const std::size_t name = line.find('\t') + 1, hits = line.rfind('\t') + 1;
        const Count count{line.substr(name, hits - 1 - name),
                          number_in<std::uint64_t>(line.substr(hits), line)};
        const auto same = std::ranges::find(all.cases, count.name, &Count::name);
        if (same == all.cases.end()) {
          all.cases.push_back(count);
        } else {
          same->hits += count.hits;
        }
      } else if (!line.starts_with('#')) {
        const Point p = ways ? way_in(line) : point_in(line);
        Seen& seen = places[{p.file, p.line, p.column, p.kind, p.what}];
        seen.hits += before && p.kind == "toggle" ? 0 : p.hits;
        seen.instances.insert(p.instances.front());
      }
    }
  }
  for (const auto& [place, seen] : places) {
    const auto& [file, line, column, kind, what] = place;
    all.places.push_back({kind,
                          file,
                          line,
                          column,
                          what,
                          seen.hits,
                          {seen.instances.begin(), seen.instances.end()}});
  }
  return all;
}

}  // namespace cosim::coverage
