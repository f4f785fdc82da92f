// One table of fields for each record of a design: from it come the struct, the comparison, the
// printing and every list of names. A table is a macro of rows
//
//   FIELD(name, width, format, source, meaning)
//
// `name` is the RTL's port or register; `width` in bits may use p, the design's parameters;
// `format` is a name of Format, followed by with_fraction(n) if the lowest n bits are a fraction,
// by at("PATH") if the RTL has it by another name, below the top module or as a slice of a net, and
// by unreset() if it is a register that no reset reaches; `source` is the number of the pin or
// block in the source.
//
// An input that is a clock, one of several, has the format `rises`, or `falls` where registers take
// its falling edge: 1 on a step on which it does, in a row of width 1.
//
// An input in whose bits a synchronizer takes the new value of what it samples, and is no pin, is
// synchronizer("REGISTER"), in a row as wide as that register (synchronizer.h):
//
//   FIELD(w_first_new, 4, bits.synchronizer("w_first"), "", "bits that take the new value")
//
// array<N>(n) makes it an array of n elements of `width` bits each, n <= N and n may use p:
// the member is an Array<V, N>. In the RTL it is a memory, element i its word i, or a net whose
// bits the elements fill from bit 0 up. words<N>() makes it one number of `width` bits in words of
// 64, the last with what is left; `width` is at most 64 N.
//
//   FIELD(store, p.width, bits.array<16>(p.depth), "", "what waits")     reg [W-1:0] store [0:D-1]
//   FIELD(line, 512, bits.words<8>(), "", "a line of the memory")        input [511:0] line
//   FIELD(low, 4, bits.at("divider.count[3:0]"), "", "a slice of a net")
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>

#include "model/core/array.h"
#include "model/core/fields.h"
#include "model/core/input_error.h"

namespace cosim {

/// The formats by the names that a table's rows use.
namespace row {

/// N: the most elements of an array; 0 for a field that is none. e: of a clock, where registers
/// take it. of_synchronizer: it is no pin.
template <int N, Edge e = Edge::none, bool of_synchronizer = false>
struct Notation {
  static constexpr int capacity = N;
  static constexpr Edge edge = e;
  static constexpr bool is_choice = of_synchronizer;

  Format format;
  int fraction = 0;
  const char* net = nullptr;
  bool is_unreset = false;
  int count = N;                          ///< elements of an array
  bool is_split = false;                  ///< the width is that of all elements together
  const char* synchronizer_of = nullptr;  ///< the register's name

  constexpr Notation with_fraction(int bits) const {
    Notation n = *this;
    n.fraction = bits;
    return n;
  }
  constexpr Notation at(const char* path) const {
    Notation n = *this;
    n.net = path;
    return n;
  }
  constexpr Notation unreset() const {
    Notation n = *this;
    n.is_unreset = true;
    return n;
  }
  constexpr Notation<0, Edge::none, true> synchronizer(const char* name) const {
    static_assert(N == 0 && e == Edge::none, "a synchronizer is no array, and no clock");
    return {format, fraction, net, is_unreset, 0, false, name};
  }
  template <int M>
  constexpr Notation<M> array(int elements = M) const {
    return {format, fraction, net, is_unreset, elements, false};
  }
  template <int M>
  constexpr Notation<M> words() const {
    return {format, fraction, net, is_unreset, M, true};
  }
};
inline constexpr Notation<0, Edge::rising> rises{Format::flag};
inline constexpr Notation<0, Edge::falling> falls{Format::flag};
inline constexpr Notation<0> flag{Format::flag};
inline constexpr Notation<0> bits{Format::bits};
inline constexpr Notation<0> number{Format::number};
inline constexpr Notation<0> twos_complement{Format::twos_complement};
inline constexpr Notation<0> ones_complement{Format::ones_complement};

constexpr int word_width = 64;

/// The member of a field: a value, or an array of them.
template <class V, int N>
using Member = std::conditional_t<N == 0, V, Array<V, std::max(N, 1)>>;

/// How many cells a field has beside its first.
constexpr std::size_t more_cells(int capacity) {
  return capacity > 1 ? static_cast<std::size_t>(capacity - 1) : 0;
}

/// How many elements of an array of N a shape has.
template <int N, Edge e, bool choice>
constexpr int elements(const Notation<N, e, choice>& n, int width) {
  return n.is_split ? (width + word_width - 1) / word_width : n.count;
}

/// The field, or the cells of an array of N.
template <int N, Edge e, bool choice>
constexpr auto field(const char* name, int width, const Notation<N, e, choice>& n,
                     const char* source, const char* meaning, const char* net) {
  if (e != Edge::none && width != 1) throw InputError(std::string(name) + ": a clock has 1 bit");
  Field whole{
      name,        width, n.format, source, meaning, n.fraction, n.net == nullptr ? net : n.net,
      n.is_unreset};
  whole.edge = e;
  whole.is_placed = n.net != nullptr;
  whole.synchronizer = n.synchronizer_of;
  if constexpr (N == 0) {
    return whole;
  } else {
    if (n.is_split && n.format != Format::bits) {
      throw InputError(std::string(name) + ": only bits can be words of a wide number");
    }
    const int present = elements(n, width);
    if (present < 1 || present > N) {
      throw InputError(std::string(name) + ": " + std::to_string(present) +
                       " elements, and its array holds 1 to " + std::to_string(N));
    }
    std::array<Field, N> cells{};
    for (int i = 0; i < N; ++i) {
      Field& cell = cells[static_cast<std::size_t>(i)];
      const int each = n.is_split ? std::min(word_width, width - word_width * i) : width;
      cell = whole;
      cell.width = i < present ? each : 0;
      cell.index = i;
      cell.is_word = n.is_split;
      cell.low = i * (n.is_split ? word_width : width);
    }
    return cells;
  }
}

/// Makes a clock, a member of the notation N, take its edge.
template <class N, class M>
constexpr void raise([[maybe_unused]] M& member) {
  if constexpr (N::edge != Edge::none) member = M(1);
}

/// All cells of a table, of what field() gives for each row. No tuple: one of two hundred rows
/// takes a compiler a minute.
template <std::size_t Size>
class Cells {
 public:
  template <class... Rows>
  constexpr explicit Cells(const Rows&... rows) {
    (add(rows), ...);
  }
  constexpr const std::array<Field, Size>& all() const { return all_; }

 private:
  constexpr void add(const Field& cell) { all_[at_++] = cell; }
  template <std::size_t N>
  constexpr void add(const std::array<Field, N>& row) {
    for (const Field& cell : row) add(cell);
  }
  std::array<Field, Size> all_{};
  std::size_t at_ = 0;
};

/// Makes the elements that a shape does not have 0.
template <class V, class N>
constexpr void trim(V&, const N&, int) {}
template <class V, int N>
constexpr void trim(Array<V, N>& array, const Notation<N>& n, int width) {
  for (int i = elements(n, width); i < N; ++i) array[i] = V(0);
}

}  // namespace row

}  // namespace cosim

// Names and sums of names, which parentheses would spoil.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define COSIM_CAPACITY(name, width, format, source, meaning) \
  capacity_##name = decltype(::cosim::row::format)::capacity,
#define COSIM_PLUS(name, width, format, source, meaning) +capacity_##name
#define COSIM_PLUS_CLOCK(name, width, format, source, meaning) \
  +(decltype(::cosim::row::format)::edge != ::cosim::Edge::none)
#define COSIM_PLUS_CHOICE(name, width, format, source, meaning) \
  +decltype(::cosim::row::format)::is_choice
#define COSIM_RAISE(name, width, format, source, meaning) \
  ::cosim::row::raise<decltype(::cosim::row::format)>(r.name);
#define COSIM_MEMBER(name, width, format, source, meaning) \
  ::cosim::row::Member<V, Table::capacity_##name> name{};
#define COSIM_INDEX(name, width, format, source, meaning) \
  index_##name,                                           \
      final_index_##name = index_##name + ::cosim::row::more_cells(Table::capacity_##name),
#define COSIM_VISIT(name, width, format, source, meaning) \
  visit(&Self::name, std::integral_constant<std::size_t, index_##name>());
#define COSIM_POINTER(name, width, format, source, meaning) &Self::name,
#define COSIM_TRIM(name, width, format, source, meaning) \
  ::cosim::row::trim(r.name, ::cosim::row::format, width);
#define COSIM_FIELD(name, width, format, source, meaning) \
  ::cosim::row::field(#name, width, ::cosim::row::format, source, meaning, #name),
#define COSIM_FIELD_Q(name, width, format, source, meaning) \
  ::cosim::row::field(#name, width, ::cosim::row::format, source, meaning, #name "_q"),

/// Defines `template <class V> struct Record` with one member a row of TABLE, and its table as
/// data. Params is the type of p in the rows' widths.
#define COSIM_RECORD(Record, TABLE, Params) COSIM_RECORD_OF(Record, TABLE, COSIM_FIELD, Params)

/// The same of registers whose nets have the suffix _q in the RTL and not in the table.
#define COSIM_REGISTERS(Record, TABLE, Params) COSIM_RECORD_OF(Record, TABLE, COSIM_FIELD_Q, Params)

#define COSIM_RECORD_OF(Record, TABLE, ROW, Params)                                            \
  /* What follows from the rows' types, for which p need only be a name. */                    \
  struct Record##Table {                                                                       \
    [[maybe_unused]] static const Params p;                                                    \
    enum Capacity : int { TABLE(COSIM_CAPACITY) sum = 0 TABLE(COSIM_PLUS) };                   \
    enum Clocks : int { clocks = 0 TABLE(COSIM_PLUS_CLOCK) };                                  \
    enum Choices : int { choices = 0 TABLE(COSIM_PLUS_CHOICE) };                               \
    /* Every clock takes its edge. */                                                          \
    template <class R>                                                                         \
    static constexpr void raise_clocks([[maybe_unused]] R& r) {                                \
      TABLE(COSIM_RAISE)                                                                       \
    }                                                                                          \
  };                                                                                           \
  template <class V>                                                                           \
  struct Record {                                                                              \
    using Table = Record##Table;                                                               \
    TABLE(COSIM_MEMBER)                                                                        \
    enum Index : std::size_t { TABLE(COSIM_INDEX) index_end };                                 \
    static constexpr std::size_t size = index_end; /* cells */                                 \
    static constexpr bool has_arrays = Table::sum != 0;                                        \
    static constexpr auto members() { /* of a table without arrays */                          \
      using Self = Record;                                                                     \
      return std::array<V Self::*, size>{TABLE(COSIM_POINTER)};                                \
    }                                                                                          \
    template <class Visit>                                                                     \
    static constexpr void each_member([[maybe_unused]] Visit& visit) {                         \
      using Self [[maybe_unused]] = Record;                                                    \
      TABLE(COSIM_VISIT)                                                                       \
    }                                                                                          \
    static constexpr std::array<Field, size> fields([[maybe_unused]] const Params& p) {        \
      if constexpr (has_arrays) {                                                              \
        return ::cosim::row::Cells<size>{TABLE(ROW)}.all();                                    \
      } else {                                                                                 \
        return {TABLE(ROW)};                                                                   \
      }                                                                                        \
    }                                                                                          \
    /* Elements that a shape does not have become 0. */                                        \
    static constexpr void trim([[maybe_unused]] const Params& p, [[maybe_unused]] Record& r) { \
      TABLE(COSIM_TRIM)                                                                        \
    }                                                                                          \
    /* No parameter may have the name of a field. */                                           \
    friend Record select(Condition<V> when, const Record& then, const Record& other) {         \
      return select_record(when, then, other);                                                 \
    }                                                                                          \
  }
// NOLINTEND(bugprone-macro-parentheses)
