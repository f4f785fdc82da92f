#include "tb/new/found.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <cctype>

#include "model/core/input_error.h"
#include "tb/new/found_shape.h"
#include "tb/rtl/read.h"
#include "tb/util/process.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

void take_registers(Found& found, const rtl::Registers& is) {
  for (const rtl::Clock& clock : is.clocks) {
    found.clocks.push_back({clock.name, clock.falls ? Edge::falling : Edge::rising});
  }
  for (const rtl::Reset& reset : is.resets) {
    found.asynchronous |= reset.kind != rtl::Reset::Kind::synchronous;
    found.resets.push_back(
        {reset.name, reset.is_active_low, reset.kind == rtl::Reset::Kind::inner, reset.values});
  }
  for (const rtl::Register& one : is.registers) {
    FoundNet net{one.name, {static_cast<int>(one.width)}, {static_cast<int>(one.words)}};
    const int all = net.width.number * std::max(net.words.number, 1);
    if (one.bits != std::vector{std::pair{all - 1, 0}}) net.bits = one.bits;
    net.is_reset = one.value.has_value();
    if (net.is_reset && *one.value != "0") net.value = *one.value;
    net.clocks = one.clocks;
    found.registers.push_back(net);
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

// What read_rtl() is asked of the files.
rtl::RtlAsked asked_of(const RtlQuestion& question, std::vector<std::string> files,
                       const fs::path& work) {
  const auto& clocks = question.clocks;
  rtl::RtlAsked asked{.verilator = verilator_program(),
                      .yosys = is_installed("yosys") ? "yosys" : "",
                      .folder = question.folder,
                      .files = std::move(files),
                      .options = question.options,
                      .top = question.top,
                      .clocks = clocks.empty() ? "?" : fmt::format("{}", fmt::join(clocks, ",")),
                      .work = work};
  if (clocks.size() > 1) asked.clocks += ',';
  if (!question.reset.empty()) asked.clocks += ':' + question.reset;
  for (const FoundParameter& p : question.parameters) asked.options.push_back(verilator_option(p));
  return asked;
}

// What Verilator and yosys say, and the shape; `question` gets the options that it takes to read
// it.
std::pair<rtl::Shape, rtl::RtlRead> read_all(RtlQuestion& question, const fs::path& work) try {
  fs::create_directory(work);
  std::vector<std::string> shape;
  for (const FoundParameter& p : question.parameters) shape.push_back(p.name + '=' + p.value);
  const auto asked = asked_of(question, plain_verilog(question, shape, work), work);
  rtl::RtlRead read = rtl::read_rtl(asked, run_for_rtl);
  question.options.insert(question.options.end(), read.verilator.begin(), read.verilator.end());
  return {rtl::shape_of(work / "tree"), std::move(read)};
} catch (const InputError& error) {
  require_room(work.parent_path());
  throw InputError(fmt::format("new: {}", error.what()));
}

}  // namespace

fs::path tree_in(const RtlQuestion& question, const fs::path& work) try {
  return rtl::write_tree(asked_of(question, question.files, work), run_for_rtl);
} catch (const InputError& error) {
  throw InputError(fmt::format("new: {}", error.what()));
}

Found found_in(const RtlQuestion& question) {
  const Scratch scratch;
  StateLine line;
  line.show(question.top + ": reading it, and trying each parameter");
  RtlQuestion again = question;
  const auto [is, read] = read_all(again, scratch.path() / "work");
  Found found;
  found.top = is.top;
  take_registers(found, read.found);
  read_shape(found, is);
  for (const auto& [name, value] : is.parameters) {
    if (value >= -(1L << 31) && value < 1L << 31 && !is_word(value))
      found.parameters.push_back({name, std::to_string(value)});
  }
  found.unread = read.unread;
  found.language = read.language;
  follow_parameters(found, is, again, scratch.path() / "tried", line);
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
