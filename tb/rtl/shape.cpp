#include "tb/rtl/shape.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace cosim::rtl {
namespace {

// Words with points between them.
bool is_path(const std::string& name) {
  char before = '.';
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && (c != '.' || before == '.'))
      return false;
    before = c;
  }
  return before != '.' || name.empty();
}

class ShapeReader {
 public:
  explicit ShapeReader(const Tree& tree) : design_(tree) {
    design_.declare(design_.top(), "");
    read_enums();
    shape_.top = design_.top().has("origName");
    for (const auto& [path, net] : design_.nets()) {
      Shape::Net& is = shape_.nets[path];
      is = {static_cast<int>(net.width), static_cast<int>(net.words), net.is_signed};
      if (net.words == 0) is.parts = parts_of(net);
    }
    read_ports();
  }
  const Shape& shape() const { return shape_; }

 private:
  using Names = std::vector<std::string>;

  // Enums with values from 0 on. Verilator 5.006 has of a net's type the number of its bits and the
  // enum's name; names of one that is another thing elsewhere are left out.
  void read_enums() {
    for (const auto& [id, type] : design_.types()) {
      if (!type->is("enumdtype")) continue;
      std::map<long, std::string> values;
      bool is_plain = true;
      for (const Node* item : type->in) {
        if (!item->is("enumitem")) continue;
        const auto value = constant(item->in.empty() ? nullptr : item->in[0]);
        is_plain = is_plain && value;
        if (value) values[*value] = item->has("name");
      }
      is_plain = is_plain && !values.empty() && values.begin()->first == 0 &&
                 values.rbegin()->first == static_cast<long>(values.size()) - 1;
      Names names;
      for (const auto& [value, name] : values) names.push_back(name);
      if (!is_plain) names.clear();
      const std::string& path = type->has("name");
      const std::string name = path.substr(path.find_last_of(".:") + 1);
      const auto [known, is_new] = enums_.try_emplace(name, names);
      if (!is_new && known->second != names) known->second.clear();
    }
  }
  std::string enum_of(const std::string& name) {
    const auto found = enums_.find(name);
    if (found == enums_.end() || found->second.empty()) return "";
    shape_.enums[name] = found->second;
    return name;
  }

  std::vector<Part> parts_of(const Net& net) {
    std::vector<Part> parts;
    add_parts("", net.type, 0, parts);
    if (parts.size() == 1) parts[0].type = enum_of(net.type_name);
    const bool has_names = std::ranges::all_of(parts, is_path, &Part::name);
    if (!has_names || (parts.size() == 1 && parts[0].type.empty())) parts.clear();
    return parts;
  }
  // Those of a type whose lowest bit is `low`.
  void add_parts(const std::string& name, const std::string& id, long low,
                 std::vector<Part>& parts) const {
    const Node& type = design_.type_of(id);
    long at = low + design_.size_of(id);
    if (!type.is("structdtype")) {
      parts.push_back(
          {name, static_cast<int>(at - 1), static_cast<int>(low), design_.is_signed(id)});
      return;
    }
    for (const Node* member : type.in) {
      const std::string& sub = member->has("sub_dtype_id");
      const std::string& of = sub.empty() ? member->has("id") : sub;
      at -= design_.size_of(of);
      add_parts((name.empty() ? "" : name + '.') + member->has("name"), of, at, parts);
    }
  }

  void read_ports() {
    std::vector<const Node*> ports;
    for (const Node* in : design_.top().in) {
      if (in->is_port()) ports.push_back(in);
      if (!in->is("var") || in->has("param").empty()) continue;
      std::optional<long> value;
      for (const Node* one : in->in) {
        if (!value) value = constant(one);
      }
      const std::string& type = in->has("dtype_id");
      const bool is_number = design_.type_of(type).is("basicdtype") && design_.size_of(type) == 32;
      if (value && is_number) shape_.parameters.emplace_back(in->has("name"), *value);
    }
    std::ranges::stable_sort(ports, {}, [](const Node* port) {
      const std::string& place = port->has("pinIndex");
      return place.empty() ? 0 : std::stoi(place);
    });
    for (const Node* port : ports) shape_.ports.emplace_back(port->has("dir"), port->has("name"));
  }

  Design design_;
  Shape shape_;
  std::map<std::string, Names> enums_;  // none where it is not plain
};

}  // namespace

Shape shape_of(const std::filesystem::path& tree) {
  const Tree read(tree);
  return ShapeReader(read).shape();
}

}  // namespace cosim::rtl
