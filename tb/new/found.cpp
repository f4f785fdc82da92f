#include "tb/new/found.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <cctype>
#include <map>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/new/found_shape.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

// "7:4,0:0"
std::vector<std::pair<int, int>> ranges_of(const std::string& text) {
  std::vector<std::pair<int, int>> all;
  for (const std::string& range : parts_in(text, ',')) {
    all.emplace_back(std::stoi(range), std::stoi(range.substr(range.find(':') + 1)));
  }
  return all;
}

// What cosim_rtl prints (tb/rtl/registers.h).
void read_found(Found& found, const std::string& text) {
  std::map<std::string, std::string> values;
  std::map<std::string, std::vector<std::string>> clocks;  // of registers
  for (const std::string& line : lines_in(text)) {
    std::istringstream words(line);
    std::string what, name, bits;
    words >> what >> name;
    if (what == "clock") {
      const bool falls = words >> bits && name == "falling";
      found.clocks.push_back({falls ? bits : name, falls ? Edge::falling : Edge::rising});
    } else if (what == "clocked") {
      words >> clocks[name].emplace_back();
    } else if (what == "reset" || what == "inner" || what == "synchronous") {
      FoundReset reset;
      reset.active_low = name == "low";
      if (reset.active_low) words >> name;
      reset.name = name;
      reset.is_inner = what == "inner";
      found.asynchronous |= what != "synchronous";
      found.resets.push_back(reset);
    } else if (what == "value") {
      words >> values[name];
    } else if (what == "given") {
      const auto reset = std::ranges::find(found.resets, name, &FoundReset::name);
      std::string value;
      words >> bits >> value;
      if (reset != found.resets.end()) reset->values.emplace_back(bits, value);
    } else if (what == "register") {
      FoundNet net{name, {}};
      words >> net.width.number >> net.words.number >> bits;
      net.bits = ranges_of(bits);
      const int all = net.width.number * std::max(net.words.number, 1);
      if (net.bits == std::vector{std::pair{all - 1, 0}}) net.bits.clear();
      found.registers.push_back(net);
    }
  }
  for (FoundNet& net : found.registers) {
    const auto value = values.find(net.name);
    net.is_reset = value != values.end();
    if (net.is_reset && value->second != "0") net.value = value->second;
    net.clocks = clocks[net.name];
  }
}

// Whether the value of a parameter is rather a word of four letters, "FAST".
bool is_word(long value) {
  for (int i = 0; i < 4; ++i) {
    const auto byte = static_cast<unsigned char>(static_cast<std::uint64_t>(value) >> (8 * i));
    if (std::isalnum(byte) == 0 && byte != '_') return false;
  }
  return true;
}

// A record names its fields in their order. Of registers that reset others each stands before those
// that it resets itself.
void order_resets(Found& found) {
  const auto place = [&](const FoundReset& reset) {
    return std::ranges::find(found.inputs, reset.name, &FoundNet::name);
  };
  auto& all = found.resets;
  std::ranges::stable_sort(all, {}, place);
  const auto gives = [](const FoundReset& by, const FoundReset& to) {
    return std::ranges::any_of(by.values,
                               [&](const auto& value) { return value.first == to.name; });
  };
  for (auto next = all.begin(); next != all.end(); ++next) {
    const auto first = std::find_if(next, all.end(), [&](const FoundReset& reset) {
      return !reset.is_inner || std::none_of(next, all.end(), [&](const FoundReset& other) {
        return other.name != reset.name && gives(other, reset);
      });
    });
    if (first != all.end()) std::rotate(next, first, std::next(first));
  }
  if (found.has_inner_reset() && all.front().is_inner) {
    throw InputError(
        fmt::format("new: {}: a register that resets others at once, and no input resets anything",
                    all.front().name));
  }
}

void read_shape(Found& found, const rtl::Shape& shape) {
  for (const auto& [way, name] : shape.ports) {
    const rtl::Shape::Net& is = shape.nets.at(name);
    FoundNet net{name, {is.width}, {is.words}, is.is_signed};
    net.parts = is.parts;
    const auto clock = std::ranges::find(found.clocks, name, &FoundClock::name);
    if (clock == found.clocks.end()) {
      (way == "input" ? found.inputs : found.outputs).push_back(net);
    } else if (found.clocks_are_inputs()) {
      found.inputs.push_back(net);
      found.inputs.back().edge = clock->edge;
    }
  }
  for (FoundNet& net : found.registers) {
    const auto is = shape.nets.find(net.name);
    if (is == shape.nets.end()) continue;
    net.is_signed = is->second.is_signed;
    net.parts = is->second.parts;
  }
  for (const auto* nets : {&found.outputs, &found.registers}) {
    for (const FoundNet& net : *nets) {
      if (net.parts.size() != 1 || net.parts.front().type.empty()) continue;
      found.enums[net.parts.front().type] = shape.enums.at(net.parts.front().type);
    }
  }
  order_resets(found);
}

}  // namespace

Found found_in(const RtlQuestion& question) {
  const Scratch scratch;
  const fs::path reader = write_reader(scratch), work = scratch.path() / "work";
  fs::create_directory(work);
  StateLine line;
  line.show(question.top + ": reading it, and trying each parameter");
  std::vector<std::string> shape, files;
  for (const FoundParameter& p : question.parameters) shape.push_back(p.name + '=' + p.value);
  try {
    files = plain_verilog(question, shape, work);
  } catch (const InputError& error) {
    require_room(scratch.path());
    throw InputError(fmt::format("new: {}", error.what()));
  }
  const auto& clocks = question.clocks;
  std::string clock = clocks.empty() ? "?" : fmt::format("{}", fmt::join(clocks, ","));
  if (clocks.size() > 1) clock += ',';
  const Ended ended = cosim::run_program(
      {"env", "-C", question.folder.string(), "cmake", "-DTOP=" + question.top,
       fmt::format("-DCLOCK={}{}{}", clock, question.reset.empty() ? "" : ":", question.reset),
       fmt::format("-DSHAPE={}", fmt::join(shape, " ")),
       fmt::format("-DFILES={}", fmt::join(files, ";")),
       fmt::format("-DOPTIONS={}", fmt::join(question.options, ";")),
       fmt::format("-DYOSYS={}", fmt::join(question.options, " ")), "-DWORK=" + work.string(),
       fmt::format("-DREADER={};cosim_rtl", fs::read_symlink("/proc/self/exe").string()), "-P",
       (reader / "new" / "found_rtl.cmake").string()});
  if (ended.status == 127) throw InputError("needs cmake");
  if (ended.status != 0) {
    const fs::path error = work / "error.txt";
    if (fs::exists(error)) {
      const std::string why = read_file(error.string());
      throw InputError(why.starts_with("new: ") ? why : "new: " + why);
    }
    throw InputError("new: cmake: " + ended.text);
  }
  const rtl::Shape is = [&] {
    try {
      return rtl::shape_of(work / "tree");
    } catch (const InputError& error) {
      throw InputError(fmt::format("new: {}", error.what()));
    }
  }();
  Found found;
  found.top = is.top;
  read_found(found, read_file((work / "found.txt").string()));
  read_shape(found, is);
  for (const auto& [name, value] : is.parameters) {
    if (value >= -(1L << 31) && value < 1L << 31 && !is_word(value))
      found.parameters.push_back({name, std::to_string(value)});
  }
  if (const fs::path unread = work / "unread.txt"; fs::exists(unread)) {
    found.unread = read_file(unread.string());
  }
  RtlQuestion again = question;
  if (const fs::path language = work / "language.txt"; fs::exists(language)) {
    found.language = read_file(language.string());
    again.options.emplace_back("+1364-2005ext+v");
  }
  follow_parameters(found, is, again, lines_in(read_file((work / "verilator.txt").string())),
                    scratch.path() / "tried", line);
  for (const FoundParameter& p : question.parameters) {
    const auto same = std::ranges::find(found.parameters, p.name, &FoundParameter::name);
    if (same == found.parameters.end()) {
      found.parameters.push_back(p);
    } else {
      *same = p;
    }
  }
  return found;
}

}  // namespace cosim::cli
