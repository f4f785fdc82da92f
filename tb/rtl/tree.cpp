#include "tb/rtl/tree.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "model/core/input_error.h"
#include "tb/rtl/files.h"

namespace cosim::rtl {

const std::string& Node::has(std::string_view name) const {
  static const std::string none;
  const auto found = attributes.find(name);
  return found == attributes.end() ? none : found->second;
}

std::vector<const Node*> all_of(const Node& node, std::string_view tag) {
  std::vector<const Node*> all;
  for (const Node* in : node.in) {
    if (in->is(tag)) all.push_back(in);
    const auto below = all_of(*in, tag);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

namespace {

using JsonOfTree = nlohmann::ordered_json;

bool is_in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The text of an attribute, whose signs are &quot; and the like.
std::string with_signs(std::string_view text) {
  static constexpr std::pair<std::string_view, char> signs[] = {
      {"&apos;", '\''}, {"&quot;", '"'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}};
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const auto sign = std::ranges::find_if(
        signs, [&](const auto& one) { return text.substr(at).starts_with(one.first); });
    const bool is_sign = text[at] == '&' && sign != std::end(signs);
    all += is_sign ? sign->second : text[at];
    at += is_sign ? sign->first.size() : 1;
  }
  return all;
}

}  // namespace

Node* Tree::add(std::string tag) {
  nodes_.push_back({std::move(tag), {}, {}});
  return &nodes_.back();
}

// As Verilator writes it: each attribute in double quotes, and no text between the tags.
void Tree::read_xml(std::string_view text) {
  std::vector<Node*> open{add("")};
  for (std::size_t at = text.find('<'); at != text.npos; at = text.find('<', at)) {
    ++at;
    if (at < text.size() && text[at] == '/' && open.size() > 1) open.pop_back();
    const auto word = [&] {
      const std::size_t begin = at;
      while (at < text.size() && (is_in_name(text[at]) || text[at] == ':')) ++at;
      return std::string(text.substr(begin, at - begin));
    };
    std::string tag = word();
    if (tag.empty()) continue;
    Node* const node = add(std::move(tag));
    open.back()->in.push_back(node);
    while (at < text.size() && text[at] != '>' && text[at] != '/') {
      if (!is_in_name(text[at])) {
        ++at;
        continue;
      }
      const std::string name = word();
      const std::size_t begin = text.find('"', at) + 1, end = text.find('"', begin);
      if (begin == 0 || end == text.npos) throw InputError("the XML of Verilator ends in a tag");
      node->attributes[name] = with_signs(text.substr(begin, end - begin));
      at = end + 1;
    }
    if (at < text.size() && text[at] == '>') open.push_back(node);
  }
}

// The JSON in the words of the XML.
class Tree::Json {
 public:
  explicit Json(Tree& tree) : tree_(tree) {}
  void read(const std::string& text) {
    const auto json = JsonOfTree::parse(text, nullptr, false);
    if (!json.is_object()) throw InputError("the tree of Verilator is neither XML nor JSON");
    add(json);
    for (const auto& [address, node] : at_) {
      if (node->is("instance")) {
        if (const Node* module = at(node->has("modp")))
          node->attributes["defName"] = module->has("name");
      } else if (node->is("module")) {
        give_places(*node);
      } else if (const Node* inner = node->is("port") ? at(node->has("modVarp")) : nullptr) {
        const std::string& way = inner->has("dir");
        node->attributes["name"] = inner->has("name");
        node->attributes["direction"] = way == "input" ? "in" : way == "output" ? "out" : way;
      }
    }
  }

 private:
  const Node* at(const std::string& address) const {
    const auto found = at_.find(address);
    return found == at_.end() ? nullptr : found->second;
  }
  static void give_places(Node& module) {
    if (module.has("level") == "1") module.attributes["topModule"] = "1";
    int place = 0;
    for (Node* in : module.in) {
      if (in->is_port()) in->attributes["pinIndex"] = std::to_string(++place);
    }
  }
  Node* add(const JsonOfTree& json) {
    Node* const node = tree_.add("");
    for (const auto& [key, value] : json.items()) {
      if (value.is_array()) {
        add_all(*node, key, value);
      } else {
        node->attributes[key] = value.is_string() ? value.get<std::string>() : value.dump();
      }
    }
    const std::string type = node->has("type");
    static const std::map<std::string, std::string> tags{{"ASSIGNW", "contassign"},
                                                         {"CELL", "instance"},
                                                         {"GENBLOCK", "begin"},
                                                         {"LOOP", "while"},
                                                         {"PIN", "port"}};
    const auto tag = tags.find(type);
    node->tag = tag != tags.end() ? tag->second : in_small_letters(type);
    const auto copy = [&](const char* to, const char* from) {
      if (const std::string& text = node->has(from); !text.empty()) node->attributes[to] = text;
    };
    copy("id", "addr");
    copy("dtype_id", "dtypep");
    copy("sub_dtype_id", "refDTypep");
    if (const std::string range = node->has("range"); !range.empty()) {
      node->attributes["left"] = range.substr(0, range.find(':'));
      node->attributes["right"] = range.substr(range.find(':') + 1);
    }
    if (type == "VAR") {
      if (const auto& way = node->has("direction"); way != "NONE") {
        node->attributes["dir"] = in_small_letters(way);
      }
      if (node->has("varType") == "GPARAM") node->attributes["param"] = "true";
      if (node->has("varType") == "LPARAM") node->attributes["localparam"] = "true";
    }
    if (const auto& width = node->has("widthConst"); type == "SEL" && !width.empty()) {
      char digits[32];
      std::snprintf(digits, sizeof digits, "32'h%lx", std::stoul(width));
      node->in.push_back(tree_.add("const"));
      node->in.back()->attributes["name"] = digits;
    }
    if (const auto& address = node->has("addr"); !address.empty()) at_[address] = node;
    return node;
  }
  void add_all(Node& node, const std::string& key, const JsonOfTree& list) {
    std::vector<Node*> nodes;
    for (const JsonOfTree& one : list) {
      if (!one.is_object()) throw InputError("the JSON of Verilator has a list of no nodes");
      nodes.push_back(add(one));
    }
    // The two ways of a condition have a block each, an empty one too.
    if (key == "thensp" || key == "elsesp") {
      Node* const block = tree_.add("begin");
      block->in = std::move(nodes);
      nodes = {block};
    }
    if (key == "elsesp" && node.in.size() == 1) node.in.push_back(tree_.add("begin"));
    for (Node* one : nodes) {
      // What a static variable of a function begins with is not written at each call.
      if (one->is("initialstaticstmt")) continue;
      // An assignment is what a module has, not the process around it.
      const std::vector<Node*> itself{one};
      const bool is_around = one->has("keyword") == "cont_assign";
      const std::vector<Node*>& given = is_around ? one->in : itself;
      node.in.insert(node.in.end(), given.begin(), given.end());
    }
  }
  static std::string in_small_letters(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
  }

  Tree& tree_;
  std::map<std::string, Node*> at_;  // by their addresses
};

Tree::Tree(const std::filesystem::path& file) {
  const std::string text = text_of(file);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != text.npos && text[first] == '<') {
    read_xml(text);
  } else {
    Json(*this).read(text);
  }
}

std::vector<std::string> tree_options(const std::string& verilator, const Run& run) {
  if (run({verilator, "--xml-only", "--version"}).status == 0)
    return {"--xml-only", "--xml-output"};
  return {"--json-only", "--json-only-output"};
}

}  // namespace cosim::rtl
