// The members of the structs of a model that `cosim new` begins: a port or a register each; of one
// that is a struct in the RTL, or of registers of an instance, a struct of members.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "tb/new/found.h"

namespace cosim::cli {

/// What a struct of a model can have, model/clocked/reflect.h.
inline constexpr std::size_t most_members = 256;

/// The enums of a design in C++.
class EnumTypes {
 public:
  /// `title`: of the model, with which their names begin.
  EnumTypes(const std::string& title, const std::map<std::string, std::vector<std::string>>& enums);
  /// "FifoState", "" where there is none.
  std::string of(const std::string& type) const;
  /// "FifoState::idle"; "" where the number has no name.
  std::string value(const std::string& type, const std::string& number) const;
  /// What declares them.
  std::string text() const;

 private:
  struct Type {
    std::string name;
    std::vector<std::string> values;
  };
  std::map<std::string, Type> types_;
};

struct Member {
  std::string name;  ///< its path in the struct: "count", "request.address"
  std::string type;
  FoundNet net;
  int high = 0, low = 0;   ///< its bits in the net
  bool is_signed = false;  ///< it is a number with a sign
  std::string value = {};  ///< of a register that is reset
};

/// `taken`: names that no member can have.
std::vector<Member> input_members(const std::vector<FoundNet>& nets, const std::string& taken);
std::vector<Member> output_members(const std::vector<FoundNet>& nets, const std::string& taken,
                                   const EnumTypes& enums);
/// A register below the top has its own name where no other one has it, or its path if there are
/// more than most_members.
std::vector<Member> register_members(const std::vector<FoundNet>& nets, const std::string& taken,
                                     const EnumTypes& enums);

/// Lines that declare them.
std::string declared(const std::vector<Member>& members, const std::string& indent);
/// ".a = 0", ".request = {.address = 0, .write = 0}": of each member of the struct.
std::vector<std::string> zeros_of(const std::vector<Member>& members);
/// A value of the net, in hexadecimal, as that of the member, in C++.
std::string value_of(const std::string& hex, const Member& member);

}  // namespace cosim::cli
