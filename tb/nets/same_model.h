// What an exporter wrote of a golden model against the model itself, on random clocks. They differ
// where clock() depends on what is no member of it, or where a block of merge() changes what it
// does not name.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "model/core/input_error.h"
#include "model/core/synchronizer.h"
#include "tb/nets/model.h"
#include "tb/nets/runs.h"
#include "tb/support/random.h"

namespace cosim::nets {

inline constexpr int model_rounds = 100'000 / 64;  ///< of 64 clocks each

/// A random number of a field, in two's complement.
inline Word random_code(Random& random, const Field& field) {
  const Word code = random.one_in_power(1)
                        ? random.corner(field.width)
                        : cosim::low_bits(static_cast<Word>(random.next()), field.width);
  // The ones' complement has one number less.
  const bool is_none =
      field.format == Format::ones_complement && code == cosim::shift_left(1, field.width - 1);
  return is_none ? 0 : code;
}

/// InputError, which begins with `title`, where the nets of a design differ from its model.
template <class Design>
void require_same(const Model& model, const typename Design::Params& p, const std::string& title) {
  using State = typename Design::template State<Word>;
  using Inputs = typename Design::template Inputs<Word>;
  using Outputs = typename Design::template Outputs<Word>;
  constexpr std::size_t lanes = 64;
  const Synchronizers<Design> taking(p);
  Random random(1);
  // Codes of the cells of a record that its shape has.
  const auto codes = [&](const auto& record) {
    const auto fields = record.fields(p);
    const auto words = to_words(record);
    std::vector<Word> all;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].width == 0) continue;
      all.push_back(cosim::low_bits(words[i], fields[i].width));
    }
    return all;
  };
  for (int round = 0; round < model_rounds; ++round) {
    std::vector<std::uint64_t> given(model.graph.inputs().size());
    std::array<std::vector<Word>, lanes> states, outputs;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      std::size_t next = 0;
      const auto draw = [&](auto& r, bool are_codes) {
        using Record = std::remove_reference_t<decltype(r)>;
        const auto fields = Record::fields(p);
        auto words = to_words(r);
        for (std::size_t i = 0; i < fields.size(); ++i) {
          if (fields[i].width == 0) continue;
          const Word code = random_code(random, fields[i]);
          words[i] = is_signed(fields[i]) && !are_codes
                         ? from_twos_complement(code, fields[i].width)
                         : code;
          for (int b = 0; b < fields[i].width; ++b, ++next) {
            given[next] |= std::uint64_t{cosim::bit(code, b)} << lane;
          }
        }
        r = from_words<Record>(words);
      };
      Inputs in{};
      State s{};
      draw(in, true);
      draw(s, false);
      const auto step = clock_of<Design, Word>(p, s, in);
      states[lane] = codes(taking.taken(p, s, in, step.state));
      outputs[lane] = codes(Outputs(step.outputs));
    }
    const auto gates = run(model.graph, given);
    const auto compare = [&](const std::vector<Wire>& wires, const auto& expected) {
      for (std::size_t i = 0; i < wires.size(); ++i) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          std::uint64_t code = 0;
          for (std::size_t b = 0; b < wires[i].code.size(); ++b) {
            code |= (in_runs(gates, wires[i].code[b]) >> lane & 1) << b;
          }
          const Word wanted = expected[lane][i];
          if (static_cast<Word>(code) == wanted) continue;
          throw InputError(title + ": " + label_of(wires[i].field) + " is " +
                           std::to_string(wanted) + " in the model, and " + std::to_string(code) +
                           " in what its exporter made of it: clock() may depend on its members "
                           "and on In alone, and merge() names all that its block changes");
        }
      }
    };
    compare(model.machine.next, states);
    compare(model.machine.outputs, outputs);
  }
}

}  // namespace cosim::nets
