#include "tb/rtl/design.h"

#include <algorithm>
#include <cstdlib>

#include "model/core/input_error.h"

namespace cosim::rtl {
namespace {

constexpr long two_to_31 = 1L << 31;
constexpr long two_to_32 = 1L << 32;

bool is_hexadecimal(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789abcdef") == text.npos;
}

long elements(const Node& type) {
  const auto of = bounds_of(type);
  return of.size() < 2 ? 1 : std::labs(of[0] - of[1]) + 1;
}
bool is_array(const Node& type) { return type.is("packarraydtype") || type.is("unpackarraydtype"); }

template <class Map>
auto value_or_null(const Map& map, std::string_view name) -> decltype(&map.begin()->second) {
  const auto found = map.find(name);
  return found == map.end() ? nullptr : &found->second;
}

}  // namespace

std::optional<long> constant(const Node* node) {
  if (node == nullptr || !node->is("const")) return {};
  const std::string& name = node->has("name");
  const std::size_t at = name.rfind('h');
  if (at == name.npos || at == 0) return {};
  const std::string digits = name.substr(at + 1);
  const bool is_number = name[at - 1] == '\'' || name.substr(0, at).ends_with("'s");
  if (!is_number || digits.size() > 8 || !is_hexadecimal(digits)) return {};
  const long value = std::stol(digits, nullptr, 16);
  return value >= two_to_31 && name.starts_with("32's") ? value - two_to_32 : value;
}

// Numbers with a sign, for [N-1:0] of an unsigned N of 0 is [-1:0].
std::vector<long> bounds_of(const Node& array) {
  std::vector<long> all;
  const auto range = std::ranges::find_if(array.in, [](const Node* in) { return in->is("range"); });
  if (range == array.in.end()) return all;
  for (const Node* in : (*range)->in) {
    if (const auto value = constant(in)) {
      all.push_back(*value >= two_to_31 ? *value - two_to_32 : *value);
    }
  }
  return all;
}

Design::Design(const Tree& tree) {
  for (const char* tag : {"module", "iface"}) {
    for (const Node* node : all_of(tree.root(), tag)) modules_[node->has("name")] = node;
  }
  packages_ = all_of(tree.root(), "package");
  for (const auto& [name, node] : modules_) {
    if (!node->has("topModule").empty()) top_ = node;
  }
  if (top_ == nullptr) throw InputError("Verilator names no top module");
  for (const Node* table : all_of(tree.root(), "typetable")) {
    for (const Node* type : table->in) types_[type->has("id")] = type;
  }
}

const Node* Design::module(std::string_view name) const {
  const auto* found = value_or_null(modules_, name);
  return found != nullptr ? *found : nullptr;
}

const Node& Design::type_of(const std::string& id) const {
  static const Node none{};
  const auto* found = value_or_null(types_, id);
  if (found == nullptr) return none;
  const Node& type = **found;
  const bool is_name = type.is("refdtype") || type.is("constdtype") || type.is("enumdtype") ||
                       type.is("memberdtype");
  const std::string& sub = type.has("sub_dtype_id");
  return is_name && !sub.empty() ? type_of(sub) : type;
}

long Design::size_of(const std::string& id) const {
  const Node& type = type_of(id);
  if (!type.has("left").empty()) {
    return std::labs(std::stol(type.has("left")) - std::stol(type.has("right"))) + 1;
  }
  if (is_array(type)) return elements(type) * size_of(type.has("sub_dtype_id"));
  long sum = 0, most = 0;
  for (const Node* member : type.in) {
    const std::string& of = member->has("sub_dtype_id");
    const long size = size_of(of.empty() ? member->has("id") : of);
    sum += size;
    most = std::max(most, size);
  }
  if (type.is("uniondtype")) return type.in.empty() ? 1 : most;
  const std::string& name = type.has("name");
  return sum != 0 ? sum : name == "double" || name == "real" ? 64 : 1;
}

bool Design::is_signed(const std::string& id) const {
  const Node& type = type_of(id);
  if (type.is("unpackarraydtype")) return is_signed(type.has("sub_dtype_id"));
  const std::string& is = type.has("signed");
  return !is.empty() && is != "0" && is != "false";
}

std::pair<std::vector<long>, std::string> Design::unpacked(const std::string& id) const {
  std::pair<std::vector<long>, std::string> is{{}, id};
  while (type_of(is.second).is("unpackarraydtype")) {
    is.first.push_back(elements(type_of(is.second)));
    is.second = type_of(is.second).has("sub_dtype_id");
  }
  return is;
}

void Design::declare(const Node& node, const std::string& path) {
  for (const Node* in : node.in) {
    const std::string& name = in->has("name");
    if (in->is("var")) {
      if (!in->has("param").empty() || !in->has("localparam").empty()) continue;
      Net net{in->has("dtype_id"), in->has("vartype")};
      // Of a memory of several dimensions all elements are words, those of the last index one
      // behind the other.
      const auto [sizes, word] = unpacked(net.type);
      for (const long size : sizes) net.words = std::max(net.words, 1L) * size;
      net.width = size_of(word);
      const std::string& tag = type_of(word).tag;
      const bool is_plain = tag.starts_with("basic") || tag.starts_with("packarray") ||
                            tag.starts_with("struct") || tag.starts_with("union");
      if (!is_plain) net.words = -1;
      net.is_signed = is_signed(net.type);
      if (net.words > 0) {
        const auto of = bounds_of(type_of(net.type));
        net.first = of.empty() ? 0 : *std::ranges::min_element(of);
      }
      nets_.insert_or_assign(path + name, net);
      by_name_[name].push_back(path + name);
      if (node.is("package")) in_packages_[name].push_back(path + name);
    } else if (in->is("instance")) {
      if (const Node* of = module(in->has("defName"))) declare(*of, path + name + '.');
    } else {
      const bool is_named = (in->is("begin") || in->is("task") || in->is("func")) && !name.empty();
      declare(*in, is_named ? path + name + '.' : path);
    }
  }
}

const Net* Design::net(std::string_view path) const { return value_or_null(nets_, path); }

const Scope& Design::scope_in(const Node& node, const std::string& path,
                              const Scope* around) const {
  scopes_.push_back({path, around});
  Scope& scope = scopes_.back();
  for (const Node* in : node.in) {
    const std::string& name = in->has("name");
    if (in->is("var") && net(path + name) != nullptr) scope.nets[name] = path + name;
    if (in->is("task") || in->is("func")) scope.tasks[name] = in;
  }
  return scope;
}

void Design::publish(const Scope& package) {
  for (const auto& [name, node] : package.tasks) tasks_of_packages_[name] = {node, &package};
}

Task Design::task(const std::string& name, const Scope& scope) const {
  for (const Scope* at = &scope; at != nullptr; at = at->around) {
    if (const auto* node = value_or_null(at->tasks, name)) return {*node, at};
  }
  const Task* found = value_or_null(tasks_of_packages_, name);
  return found != nullptr ? *found : Task();
}

std::vector<std::string> Design::nets_of(const Node& reference, const Scope& scope) const {
  const std::string &name = reference.has("name"), &dotted = reference.has("dotted");
  const auto those = [&](const auto& names) {
    const auto* found = value_or_null(names, name);
    return found != nullptr ? *found : std::vector<std::string>();
  };
  if (dotted.empty()) {
    std::vector<std::string> all = those(in_packages_);
    for (const Scope* at = &scope; at != nullptr; at = at->around) {
      const auto* net = value_or_null(at->nets, name);
      if (net == nullptr) continue;
      all.insert(all.begin(), *net);
      break;
    }
    return all;
  }
  for (std::string path = scope.path;;) {
    std::string in = path + dotted;
    for (const auto* to = value_or_null(aliases_, in); to != nullptr;) {
      in = *to;
      to = value_or_null(aliases_, in);
    }
    if (net(in + '.' + name) != nullptr) return {in + '.' + name};
    if (path.empty()) break;
    path.pop_back();  // the point
    path.resize(path.rfind('.') + 1);
  }
  return those(by_name_);
}

std::string Design::net_of(const Node& reference, const Scope& scope) const {
  const auto all = nets_of(reference, scope);
  return all.empty() ? "" : all.front();
}

}  // namespace cosim::rtl
