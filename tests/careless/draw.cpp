#include "tests/careless/draw.h"

#include <algorithm>
#include <cctype>
#include <csignal>
#include <sstream>

#include "tb/util/random.h"
#include "tests/careless/scratch.h"

namespace cosim::careless {
namespace {

using Texts = std::vector<std::string>;

// The texts between the @ of a list.
Texts texts_of(const std::string& list) {
  Texts all;
  std::istringstream stream(list);
  for (std::string text; std::getline(stream, text, '@');) all.push_back(text);
  return all;
}

const std::string& any(Random& random, const Texts& all) { return all[random.below(all.size())]; }

bool one_in(Random& random, std::uint64_t n) { return random.below(n) == 0; }

// Small ones are drawn to their end; the others lie at limits and beyond them.
std::string number(Random& random) {
  static const Texts odd = texts_of(
      "0@65535@65536@4294967295@4294967296@2147483647@-1@-0@9223372036854775807@"
      "281474976710656@281474976710657@1099511627776@18446744073709551615@18446744073709551616@"
      "1000000@2000001@1.5@1e9@1e-9@nan@inf@0x10@+7@ 7@7x@@"
      "99999999999999999999999999999999999999999");
  if (one_in(random, 6)) return any(random, odd);
  const std::uint64_t size = std::uint64_t{1} << (1 + random.below(11));
  return (one_in(random, 20) ? "-" : "") + std::to_string(random.below(size));
}

// The words of a text that may be values: "best (default), greedy" has best, default and greedy.
Texts small_words(const std::string& text) {
  Texts words;
  std::string word;
  for (const char c : text + ' ') {
    if (std::islower(static_cast<unsigned char>(c)) != 0 || c == '-' ||
        (!word.empty() && std::isdigit(static_cast<unsigned char>(c)) != 0)) {
      word += c;
    } else {
      if (word.size() > 2 && word.front() != '-') words.push_back(word);
      word.clear();
    }
  }
  return words;
}

// A name that yosys, gnuplot, CMake, a shell or a terminal would read as more than a name, where it
// comes to them as it is.
std::string hostile_name(Random& random) {
  static const Texts pieces = texts_of(
      "a@ @\"@'@;@|@&@\\@\n@%s@#@*@[@]@{}@$1@\x1b[2J@-@~@<x@>x@\t@!@,@=@(@)@"
      "exec -- touch pwned@$(touch pwned)@`touch pwned`@!touch pwned@$ENV{HOME}@"
      "system \"touch pwned\"");
  std::string name;
  const std::uint64_t count = 1 + random.below(5);
  for (std::uint64_t i = 0; i < count; ++i) name += any(random, pieces);
  return name;
}

std::string file(Random& random, const std::string& help) {
  static const Texts names = texts_of(
      "a@b.csv@c.json@d.txt@none/x@sub/e@.f@g h@q'@-x@./i@../j@u\xc3\xa4@\xff@n\nl@@.@/@"
      "/dev/null@/dev/full@/dev/stdout@/proc/self/cmdline@" +
      std::string(300, 'l') + '@' + std::string(250, 'm'));
  std::string name = one_in(random, 5)   ? any(random, input_names())
                     : one_in(random, 4) ? hostile_name(random)
                                         : any(random, names);
  for (const char* ending : {".svg", ".png", ".fst", ".html"}) {
    if (help.find(ending) != std::string::npos && one_in(random, ending[1] == 's' ? 3 : 2)) {
      return (one_in(random, 6) ? name : "p") + ending;
    }
  }
  return name;
}

std::string value(Random& random, const Command& command, const Option& option) {
  const std::string& kind = option.value;
  if (one_in(random, 100)) return number(random);
  if (kind.find("FILE") != std::string::npos || kind == "DIR") return file(random, option.help);
  if (kind.find(',') != std::string::npos) {
    std::string list = number(random);
    for (const char c : kind) list += c == ',' && !one_in(random, 30) ? "," + number(random) : "";
    return list;
  }
  const Texts words = small_words(kind == "LIST" ? command.help : option.help);
  const bool named = kind == "HOW" || kind == "RULE" || kind == "UK" || kind == "LIST";
  if (words.empty() || !(named || one_in(random, 30))) return number(random);
  std::string one = any(random, words);
  while (kind == "LIST" && one_in(random, 2)) one += "," + any(random, words);
  return one;
}

// A command's example with the names of files that are there.
Texts example(const Command& command) {
  Texts all = command.example;
  for (std::string& word : all) {
    if (word.ends_with(".ngc")) word = "../in/good.ngc";
    if (word.ends_with(".stim")) word = "../in/good.stim";
  }
  return all;
}

void name(Case& one, const std::string& option, const std::string& value) {
  one.named.push_back({option, value});
}

// What the example writes counts as asked for.
void take_example(Case& one, const Command& command) {
  one.arguments = example(command);
  for (std::size_t i = 1; i < one.arguments.size(); ++i) {
    if (one.arguments[i - 1].starts_with("--")) name(one, one.arguments[i - 1], one.arguments[i]);
  }
}

// An option is given once, but for a few.
bool repeated(Random& random, const Case& one, const std::string& option) {
  const bool there =
      std::any_of(one.arguments.begin(), one.arguments.end(),
                  [&](const std::string& a) { return a == option || a.starts_with(option + "="); });
  return there && !one_in(random, 20);
}

// In the place of the example's value, where it has one.
bool replaced(Case& one, const std::string& option, const std::string& text) {
  for (std::size_t i = 0; i + 1 < one.arguments.size(); ++i) {
    if (one.arguments[i] != option) continue;
    one.arguments[i + 1] = text;
    return true;
  }
  return false;
}

void draw_options(Random& random, const Command& command, Case& one) {
  const std::uint64_t most = one_in(random, 10) ? 12 : 4;
  for (std::uint64_t n = random.below(most + 1); n > 0; --n) {
    const Option& option = command.options[random.below(command.options.size())];
    if (option.name.starts_with("-h") && !one_in(random, 10)) continue;
    const std::string spelt = option.name.substr(0, option.name.find(','));
    if (option.value.empty()) {
      if (!repeated(random, one, spelt)) one.arguments.push_back(spelt);
      continue;
    }
    const std::string text = value(random, command, option);
    if (repeated(random, one, spelt)) {
      if (replaced(one, spelt, text)) name(one, spelt, text);
      continue;
    }
    name(one, spelt, text);
    if (one_in(random, 4)) {
      one.arguments.push_back(spelt + "=" + text);
    } else {
      one.arguments.push_back(spelt);
      if (!one_in(random, 40)) one.arguments.push_back(text);
    }
  }
}

Stream stream(Random& random) {
  if (!one_in(random, 12)) return Stream::file;
  return static_cast<Stream>(1 + random.below(3));
}

}  // namespace

Case draw(const std::vector<Command>& commands, std::uint64_t seed, std::uint64_t at) {
  Random random = Random::for_case(seed, at);
  const Command& command = commands[random.below(commands.size())];
  Case one;
  if (command.example.empty() || one_in(random, 4)) {
    one.arguments = command.words;
    for (const std::string& positional : command.positionals) {
      if (one_in(random, 4)) continue;
      one.arguments.push_back(any(random, input_names()));
      name(one, positional, one.arguments.back());
    }
  } else {
    take_example(one, command);
  }
  draw_options(random, command, one);
  if (one_in(random, 30)) {
    one.arguments.insert(
        one.arguments.begin() + static_cast<std::ptrdiff_t>(random.below(one.arguments.size() + 1)),
        any(random, {"--", "-", "--no-such", "-x", "", "=", "--csv", "x", "--csv=", "--help"}));
  }
  if (one_in(random, 40)) one.arguments.erase(one.arguments.begin());
  // No word has more than the system takes; an argument cannot hold a zero either.
  one.in = one_in(random, 12) ? Stream::closed : Stream::file;
  one.out = stream(random);
  one.err = stream(random);
  if (one_in(random, 3)) {
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGINT, SIGTERM, SIGKILL};
    one.signal = signals[random.below(std::size(signals))];
    one.after = static_cast<int>(random.below(std::uint64_t{1} << (3 + random.below(8))));
  } else {
    one.signal = SIGTERM;
    one.after = 2000;
  }
  if (one_in(random, 25))
    one.largest_file = static_cast<long>(random.below(1U << random.below(20)));
  return one;
}

std::string command_line(const std::string& program, const Case& one) {
  std::ostringstream line;
  const auto quoted = [](const std::string& text) {
    std::string safe = "'";
    for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return safe + "'";
  };
  line << quoted(program);
  for (const std::string& argument : one.arguments) line << ' ' << quoted(argument);
  const auto redirected = [](Stream stream, const char* number) -> std::string {
    switch (stream) {
      case Stream::file:
        return "";
      case Stream::closed:
        return std::string(" ") + number + "&-";
      case Stream::full:
        return std::string(" ") + number + " /dev/full";
      case Stream::gone:
        return std::string(" ") + number + " >(true)";
    }
    return "";
  };
  line << redirected(one.in, "<") << redirected(one.out, ">") << redirected(one.err, "2>");
  line << "   # signal " << one.signal << " after " << one.after << " ms";
  if (one.largest_file != 0) line << ", files of at most " << one.largest_file << " bytes";
  return line.str();
}

}  // namespace cosim::careless
