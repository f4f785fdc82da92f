// What a master on the APB reads of apb.v for what it wrote: accesses in their order, without
// clocks.
#pragma once

#include <optional>

#include "model/core/stream.h"

namespace apb_model {

using namespace cosim;

struct Params {};

#define APB_ACCESS(FIELD)                     \
  FIELD(write, 1, flag, "", "or it reads")    \
  FIELD(reg, 2, number, "", "which register") \
  FIELD(data, 32, bits, "", "what is written")
#define APB_RESULT(FIELD) FIELD(data, 32, bits, "", "prdata on the clock of pready")
COSIM_RECORD(Access, APB_ACCESS, Params);
COSIM_RECORD(Result, APB_RESULT, Params);

/// Begins an access with psel, sets penable a clock later, and holds both until pready.
class Master {
 public:
  static constexpr auto drives(const Params&) {
    return std::array{pin::wire("psel"), pin::wire("penable"), pin::wire("pwrite"),
                      pin::wire("paddr", 4), pin::wire("pwdata", 32)};
  }
  static constexpr auto reads(const Params&) { return std::array{pin::wire("pready")}; }

  void drive(const Access<Word>* access, std::span<Word> pins) {
    if (access == nullptr) return;  // all pins are 0
    enabled_ = selected_;
    selected_ = true;
    pins[0] = 1;
    pins[1] = enabled_ ? 1 : 0;
    pins[2] = access->write;
    pins[3] = access->reg << 2;
    pins[4] = access->data;
  }
  bool took(std::span<const Word> pins) {
    if (!enabled_ || pins[0] == 0) return false;
    selected_ = enabled_ = false;
    return true;
  }

 private:
  bool selected_ = false, enabled_ = false;
};

/// Sees what is read; pready is only set on the last clock of an access.
class Reader {
 public:
  static constexpr std::array<Pin, 0> drives(const Params&) { return {}; }
  static constexpr auto reads(const Params&) {
    return std::array{pin::wire("pready"), pin::wire("prdata", 32)};
  }
  void drive(bool, std::span<Word>) {}
  std::optional<Result<Word>> came(std::span<const Word> pins) {
    if (pins[0] == 0) return {};
    return Result<Word>{pins[1]};
  }
};

struct Design {
  using Params = apb_model::Params;
  static constexpr const char* name = "apb";
  static constexpr std::array<Parameter, 0> parameters(const Params&) { return {}; }
  static constexpr auto in(const Params&) { return stream<Access>("access").by<Master>(); }
  static constexpr auto out(const Params&) { return stream<Result>("result").by<Reader>(); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset_low("presetn")}; }

  static std::vector<Result<Word>> run(const Params&, const std::vector<Access<Word>>& accesses) {
    Word held[2] = {0, 0}, count = 0;
    std::vector<Result<Word>> results;
    for (const Access<Word>& access : accesses) {
      const Word all[4] = {held[0], held[1], low_bits(held[0] + held[1], 32), count++};
      results.push_back({all[access.reg]});
      if (access.write != 0 && access.reg < 2) held[access.reg] = access.data;
    }
    return results;
  }
};

}  // namespace apb_model
