#include "tb/new/interface_ports.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/rtl/design.h"
#include "tb/util/pattern.h"

namespace cosim::cli {
namespace {

using rtl::Node;

std::string instance_of(const InterfacePort& port, const std::string& range,
                        const std::vector<std::string>& pins) {
  std::vector<std::string> values;
  for (const auto& [name, value] : port.values)
    values.push_back(fmt::format(".{}({})", name, value));
  return fmt::format("  {}{} {}{} ({});\n", port.interface,
                     values.empty() ? "" : fmt::format(" #({})", fmt::join(values, ", ")),
                     port.name, range.empty() ? "" : ' ' + range, fmt::join(pins, ", "));
}

// How the elements of an array of interfaces are counted, and the packed dimension of its ports.
struct Elements {
  std::string dimension, low, high;
};
Elements elements_of(const InterfacePort& port) {
  static const Pattern size(R"(\[([^\]:]+)\]\s*)"), bounds(R"(\[([^\]:]+):([^\]:]+)\]\s*)");
  if (const auto one = size.whole(port.range); !one.empty()) {
    const std::string high = fmt::format("({})-1", one[1]);
    return {fmt::format("[{}:0]", high), "0", high};
  }
  if (const auto two = bounds.whole(port.range); !two.empty()) {
    const std::string &a = two[1], &b = two[2];
    return {fmt::format("[{}:{}]", a, b), fmt::format("(({0}) < ({1}) ? ({0}) : ({1}))", a, b),
            fmt::format("(({0}) < ({1}) ? ({1}) : ({0}))", a, b)};
  }
  throw InputError(fmt::format(
      "{}: an interface as a port has one dimension at most: give a module around the top",
      port.name));
}

class Opening {
 public:
  Opening(const InterfacePort& port, const rtl::Tree& tree, const std::set<std::string>& pins)
      : port_(port), design_(tree), pins_(pins) {
    if (!port.range.empty()) elements_ = elements_of(port);
  }

  OpenedPort made() {
    const Node& interface = found();
    std::vector<std::string> own;  // ports of the interface, joined
    for (const Node* in : interface.in) {
      if (in->is("var")) vars_[in->has("name")] = in;
    }
    for (const auto& [name, var] : vars_) {
      if (!var->is_port()) continue;
      if (var->has("dir") != "input")
        throw refused(name, "is a port of the interface that is no input");
      if (pins_.contains(name)) {
        own.push_back(fmt::format(".{0}({0})", name));
        continue;
      }
      const std::string pin = add(true, name, *var, "");
      own.push_back(fmt::format(".{}({})", name, pin));
    }
    made_.body = instance_of(port_, port_.range, own);
    join(interface);
    return made_;
  }

 private:
  InputError refused(const std::string& member, const std::string& why) const {
    return InputError(fmt::format("{}.{}: {}: give a module around {}, whose ports are signals",
                                  port_.interface, member, why, port_.name));
  }

  const Node& found() const {
    for (const Node* in : design_.top().in) {
      if (!in->is("instance") || in->has("name") != port_.name) continue;
      if (const Node* of = design_.module(in->has("defName")); of != nullptr) return *of;
    }
    throw InputError(
        fmt::format("{}: Verilator does not say what {} has", port_.name, port_.interface));
  }

  // The members that the modport names.
  void join(const Node& interface) {
    const auto modport = std::ranges::find_if(interface.in, [&](const Node* in) {
      return in->is("modport") && in->has("name") == port_.modport;
    });
    if (modport == interface.in.end()) throw refused(port_.modport, "there is no such modport");
    const std::set<std::string> driven = driven_in(interface);
    std::string assignments;
    for (const Node* member : (*modport)->in) {
      const std::string& name = member->has("name");
      const std::string& way = member->has("direction");
      const auto var = vars_.find(name);
      if (!member->is("modportvarref") || var == vars_.end()) {
        throw refused(name, fmt::format("the modport {} names more than signals", port_.modport));
      }
      const bool is_input = way == "in" || way == "INPUT",
                 is_output = way == "out" || way == "OUTPUT";
      if (!is_input && !is_output) throw refused(name, "is neither an input nor an output");
      if (is_input && var->second->is_port()) continue;
      if (is_input && driven.contains(name)) {
        throw refused(name,
                      fmt::format("is an input of {}, and the interface drives it", port_.modport));
      }
      add(is_input, name, *var->second, is_input ? part_of(*var->second) : "");
    }
    if (port_.range.empty()) {
      for (const std::string& one : joined_) made_.body += fmt::format("  assign {};\n", one);
      return;
    }
    made_.body += fmt::format("  for (genvar i = {}; i <= {}; ++i) begin : {}_ports\n",
                              elements_.low, elements_.high, port_.name);
    for (const std::string& one : joined_) made_.body += fmt::format("    assign {};\n", one);
    made_.body += "  end\n";
  }

  // What an assignment, or an instance, in the interface writes.
  static std::set<std::string> driven_in(const Node& node) {
    std::set<std::string> all;
    const auto add_all = [&](const Node& target) {
      if (target.is_reference()) all.insert(target.has("name"));
      for (const Node* below : rtl::all_of(target, "varref")) all.insert(below->has("name"));
    };
    for (const Node* in : node.in) {
      const bool assigns = in->tag.starts_with("assign") || in->is("contassign");
      if (assigns && !in->in.empty()) add_all(*in->in.back());
      if (in->is("port") && in->has("direction") != "in") add_all(*in);
      all.merge(driven_in(*in));
    }
    return all;
  }

  // An enum takes no bits without a cast; its range does.
  std::string part_of(const Node& var) const {
    const Node& type = design_.type_of(var.has("dtype_id"));
    if (!type.is("basicdtype") || type.has("left").empty()) return "";
    return fmt::format("[{}:{}]", type.has("left"), type.has("right"));
  }

  // A port for the member, whose name it gives.
  std::string add(bool is_input, const std::string& member, const Node& var,
                  const std::string& part) {
    std::string name = port_.name + '_' + member;
    if (pins_.contains(name))
      throw refused(member, fmt::format("there is a port {} already", name));
    std::string id = var.has("dtype_id"), dimensions;
    while (design_.type_of(id).is("unpackarraydtype")) {
      const Node& array = design_.type_of(id);
      const std::vector<long> of = rtl::bounds_of(array);
      if (of.size() != 2) throw refused(member, "is an array whose bounds are no numbers");
      dimensions += fmt::format("[{}:{}]", of[0], of[1]);
      id = array.has("sub_dtype_id");
    }
    if (!dimensions.empty() && !port_.range.empty()) {
      throw refused(member, "is an array in an array of interfaces");
    }
    const bool is_own = is_input && var.is_port();  // one pin for all elements
    made_.ports.push_back(fmt::format("{} wire {} {}{}", is_input ? "input" : "output",
                                      text_of(id, member, is_own ? "" : elements_.dimension), name,
                                      dimensions.empty() ? "" : ' ' + dimensions));
    const std::string element = port_.range.empty() ? "" : "[i]";
    const std::string inner = port_.name + element + '.' + member, outer = name + element;
    if (!is_own) joined_.push_back(is_input ? inner + part + " = " + outer : outer + " = " + inner);
    return name;
  }

  // The type, with a packed dimension around it.
  std::string text_of(const std::string& id, const std::string& member,
                      const std::string& around) const {
    static const std::set<std::string> of_no_bits{"string", "real", "double", "event", "chandle"};
    const Node& type = design_.type_of(id);
    const std::string& name = type.has("name");
    const bool is_struct = type.is("structdtype") || type.is("uniondtype");
    const bool is_packed = is_struct || type.is("packarraydtype") ||
                           (type.is("basicdtype") && !of_no_bits.contains(name));
    if (!is_packed) throw refused(member, "has no bits that can be a port's");
    std::string text = name, dimensions = around;
    if (!is_struct || !is_of_package(name)) {
      text = around.empty() && design_.is_signed(id) ? "logic signed" : "logic";
      const bool is_bit = type.is("basicdtype") && type.has("left").empty();
      if (!is_bit) dimensions += fmt::format("[{}:0]", design_.size_of(id) - 1);
    }
    return dimensions.empty() ? text : text + ' ' + dimensions;
  }

  // PACKAGE::TYPE, a name that the package has.
  bool is_of_package(const std::string& name) const {
    const std::size_t at = name.find("::");
    if (at == std::string::npos) return false;
    return std::ranges::any_of(design_.packages(), [&](const Node* package) {
      return package->has("name") == name.substr(0, at) &&
             std::ranges::any_of(package->in, [&](const Node* in) {
               return in->is("typedef") && in->has("name") == name.substr(at + 2);
             });
    });
  }

  const InterfacePort& port_;
  rtl::Design design_;
  const std::set<std::string>& pins_;
  Elements elements_;
  std::map<std::string, const Node*> vars_;
  std::vector<std::string> joined_;
  OpenedPort made_;
};

}  // namespace

std::string probe_of(const std::string& name, const std::vector<InterfacePort>& ports) {
  std::string body;
  for (const InterfacePort& port : ports) body += instance_of(port, "", {});
  return fmt::format("module {};\n{}endmodule\n", name, body);
}

OpenedPort opened(const InterfacePort& port, const rtl::Tree& tree,
                  const std::set<std::string>& pins) {
  return Opening(port, tree, pins).made();
}

}  // namespace cosim::cli
