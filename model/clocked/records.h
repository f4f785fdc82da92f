// The records of a design: cells that are words, the same record for each shape.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "model/clocked/cells.h"
#include "model/clocked/leaves.h"
#include "model/core/array.h"
#include "model/core/fields.h"
#include "model/core/job_table.h"

namespace cosim::clocked {

/// What a shape is, of its design's.
struct Shape {
  int number = 0;
};

/// What a value is in a record: its number, with a sign where it has one, or its code.
template <bool is_code, Value T>
constexpr Word word_of(const T& value) {
  if constexpr (is_code && Base<T>::is_signed) {
    return static_cast<Word>(Inside::rep(code_of(value)));
  } else {
    return static_cast<Word>(Inside::rep(Inside::base(value)));
  }
}

// Names with an end, and the fields of one struct.
template <class M>
class Names {
  // Behind the name of each register in the RTL.
  static constexpr std::string_view suffix = [] {
    if constexpr (requires { M::register_suffix; }) {
      return std::string_view(M::register_suffix);
    } else {
      return std::string_view();
    }
  }();
  static constexpr std::size_t length = [] {
    std::size_t sum = 1;
    for (const Leaf& leaf : leaves_of<M>) {
      sum += 2 * leaf.name.size + suffix.size() + leaf.path.size() + leaf.block.size() +
             leaf.sampled.size() + 4;
    }
    return sum;
  }();
  struct Text {
    std::array<char, length> text{};
    std::array<std::array<std::size_t, 4>, leaves_of<M>.size()> at{};
  };
  static constexpr Text all = [] {
    Text t;
    std::size_t end = 0, i = 0;
    const auto add = [&](std::string_view words) {
      const std::size_t begin = end;
      for (const char c : words) t.text[end++] = c;
      t.text[end++] = '\0';
      return begin;
    };
    for (const Leaf& leaf : leaves_of<M>) {
      const std::string_view name = leaf.name.view();
      const std::size_t at = add(name);
      std::size_t path = at;
      if (!leaf.path.empty()) {
        path = add(leaf.path);
      } else if (!suffix.empty()) {
        path = add(leaf.name.and_then(suffix).view());
      }
      t.at[i++] = {at, path, add(leaf.block), add(leaf.sampled)};
    }
    return t;
  }();

 public:
  enum Which { name, path, block, sampled };
  static constexpr const char* of(std::size_t leaf, Which which) {
    return all.text.data() + all.at[leaf][which];
  }
};

/// The cells of the structs T, one for each shape of a design.
template <class... T>
struct RecordTable {
  using First = std::tuple_element_t<0, std::tuple<T...>>;
  static constexpr std::size_t leaves = leaves_of<First>.size();
  static_assert(((leaves_of<T>.size() == leaves) && ...),
                "all shapes of a design have the same members");

  static constexpr int words(const Leaf& leaf) { return (leaf.width + 63) / 64; }
  /// The most elements of each leaf, or words of a wide number; 0: it is one word.
  static constexpr std::array<int, leaves> capacity = [] {
    std::array<int, leaves> most{};
    const auto see = [&](const auto& all) {
      for (std::size_t i = 0; i < leaves; ++i) {
        const int many = all[i].elements > 0 ? all[i].elements
                         : words(all[i]) > 1 ? words(all[i])
                                             : 0;
        most[i] = std::max(most[i], many);
      }
    };
    (see(leaves_of<T>), ...);
    return most;
  }();
  static constexpr std::array<std::size_t, leaves + 1> first = [] {
    std::array<std::size_t, leaves + 1> all{};
    for (std::size_t i = 0; i < leaves; ++i) {
      all[i + 1] = all[i] + std::size_t(std::max(capacity[i], 1));
    }
    return all;
  }();
  static constexpr std::size_t size = first[leaves];
  static constexpr int clocks = [] {
    int n = 0;
    for (const Leaf& leaf : leaves_of<First>) n += leaf.edge != 0;
    return n;
  }();
  static constexpr int choices = [] {
    int n = 0;
    for (const Leaf& leaf : leaves_of<First>) n += !leaf.sampled.empty();
    return n;
  }();

  /// Of each cell whether its register holds all ones for 0.
  static constexpr std::array<bool, size> has_minus_zero = [] {
    std::array<bool, size> all{};
    std::size_t i = 0;
    for (const Leaf& leaf : leaves_of<First>) {
      for (std::size_t k = first[i]; k < first[i + 1]; ++k) all[k] = leaf.has_minus_zero;
      ++i;
    }
    return all;
  }();

  static constexpr const std::array<Field, size>& fields(const Shape& shape) {
    return fields_[std::size_t(shape.number)];
  }
  static constexpr std::array<JobField, leaves> job_fields(const Shape& shape) {
    std::array<JobField, leaves> all{};
    int number = 0;
    const auto see = [&](const auto& list, auto names) {
      for (std::size_t i = 0; number == shape.number && i < leaves; ++i) {
        all[i] = {names.of(i, names.name), list[i].low, list[i].high, ""};
      }
      ++number;
    };
    (see(leaves_of<T>, Names<T>()), ...);
    return all;
  }
  /// Every clock of a record takes its edge.
  template <class R>
  static constexpr void raise_clocks(R& r) {
    R::each_member_of_clocks(r);
  }

 private:
  static constexpr Format format(const Leaf& leaf) {
    if (leaf.is_ones_complement) return Format::ones_complement;
    if (leaf.width > 64 || (leaf.is_hex && leaf.width > 1)) return Format::bits;
    if (leaf.is_signed) return Format::twos_complement;
    return leaf.width == 1 ? Format::flag : Format::number;
  }
  template <class S>
  static constexpr std::array<Field, size> fields_of() {
    std::array<Field, size> all{};
    const auto& list = leaves_of<S>;
    for (std::size_t i = 0; i < leaves; ++i) {
      using N = Names<S>;
      const Leaf& leaf = list[i];
      Field whole{N::of(i, N::name), leaf.width,        format(leaf),   N::of(i, N::block), "",
                  leaf.fraction,     N::of(i, N::path), leaf.is_unreset};
      whole.edge = leaf.edge > 0 ? Edge::rising : leaf.edge < 0 ? Edge::falling : Edge::none;
      whole.is_placed = !leaf.path.empty();
      whole.names = leaf.names.data();
      whole.named = leaf.names.size();
      if (!leaf.sampled.empty()) whole.synchronizer = N::of(i, N::sampled);
      const bool is_wide = leaf.elements == 0;
      const int present = is_wide ? words(leaf) : leaf.elements;
      for (int k = 0; k < std::max(capacity[i], 1); ++k) {
        Field& cell = all[first[i] + std::size_t(k)];
        cell = whole;
        if (capacity[i] == 0) continue;
        const int each = is_wide ? std::min(64, leaf.width - 64 * k) : leaf.width;
        cell.width = k < present ? each : 0;
        cell.index = k;
        cell.is_word = is_wide;
        cell.low = k * (is_wide ? 64 : leaf.width);
      }
    }
    return all;
  }
  static constexpr std::array<std::array<Field, size>, sizeof...(T)> fields_{fields_of<T>()...};
};

/// The same of the registers: an Auxiliary is as a cell that the shape does not have.
template <class... T>
struct RegisterTable : RecordTable<T...> {
  using Base = RecordTable<T...>;
  static constexpr const std::array<Field, Base::size>& fields(const Shape& shape) {
    return fields_[std::size_t(shape.number)];
  }

 private:
  static constexpr std::size_t shapes = sizeof...(T);
  static constexpr auto fields_ = [] {
    std::array<std::array<Field, Base::size>, shapes> all{};
    for (std::size_t number = 0; number != shapes; ++number) {
      all[number] = Base::fields({static_cast<int>(number)});
      std::size_t i = 0;
      for (const Leaf& leaf : leaves_of<typename Base::First>) {
        for (std::size_t k = Base::first[i]; k < Base::first[i + 1]; ++k) {
          if (leaf.is_auxiliary) all[number][k].width = 0;
        }
        ++i;
      }
    }
    return all;
  }();
};

/// A value, or an array of them.
template <class V, int N>
using RecordValue = std::conditional_t<N == 0, V, cosim::Array<V, std::max(N, 1)>>;

template <class V, std::size_t I, int CAPACITY>
struct RecordMember {
  RecordValue<V, CAPACITY> value{};
};
template <class V, class Table, class Leaves>
struct RecordMembers;
template <class V, class Table, std::size_t... I>
struct RecordMembers<V, Table, std::index_sequence<I...>>
    : RecordMember<V, I, Table::capacity[I]>... {};

/// A record of such cells: the struct of each shape as words.
template <class V, class Of>
struct ModelRecord : RecordMembers<V, Of, std::make_index_sequence<Of::leaves>> {
  using Table = Of;
  static constexpr std::size_t size = Of::size;

  template <std::size_t I>
  constexpr auto& leaf() {
    return RecordMember<V, I, Of::capacity[I]>::value;
  }
  template <std::size_t I>
  constexpr const auto& leaf() const {
    return RecordMember<V, I, Of::capacity[I]>::value;
  }
  template <class Visit>
  static constexpr void each_member([[maybe_unused]] Visit& visit) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (visit(pointer<I>(), std::integral_constant<std::size_t, Of::first[I]>()), ...);
    }
    (std::make_index_sequence<Of::leaves>());
  }
  static constexpr const auto& fields(const Shape& shape) { return Of::fields(shape); }
  static constexpr auto job_fields(const Shape& shape) { return Of::job_fields(shape); }
  static constexpr void each_member_of_clocks(ModelRecord& r) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      const auto raise = [&](auto i) {
        constexpr std::size_t at = decltype(i)::value;
        constexpr Leaf leaf = std::get<at>(leaves_of<typename Of::First>);
        if constexpr (leaf.edge != 0) r.template leaf<at>() = V(1);
      };
      (raise(std::integral_constant<std::size_t, I>()), ...);
    }
    (std::make_index_sequence<Of::leaves>());
  }

 private:
  template <std::size_t I>
  static constexpr auto pointer() {
    using Member = RecordMember<V, I, Of::capacity[I]>;
    return static_cast<RecordValue<V, Of::capacity[I]> ModelRecord::*>(&Member::value);
  }
};

/// A struct as words.
template <class Record, bool are_codes = false, class T>
constexpr Record record_of(const T& object) {
  Record r{};
  for_each_leaf(object, [&](const auto& leaf, auto i) {
    using L = std::remove_cvref_t<decltype(leaf)>;
    auto& to = r.template leaf<decltype(i)::value>();
    if constexpr (ArrayLike<L>) {
      static_assert(L::Element::width <= 64, "an Array of numbers of more than 64 bits");
      for (int k = 0; k < L::size; ++k) to[k] = word_of<are_codes>(leaf[k]);
    } else if constexpr (L::width > 64) {
      constexpr int n = (L::width + 63) / 64;
      const auto words = resized<Words<n>, false>(Inside::rep(UInt<L::width>(leaf)));
      for (int k = 0; k < n; ++k) to[k] = static_cast<Word>(words[k]);
    } else if constexpr (std::same_as<std::remove_cvref_t<decltype(to)>, Word>) {
      to = word_of<are_codes>(leaf);
    } else {
      to[0] = word_of<are_codes>(leaf);
    }
  });
  return r;
}
/// The same as codes.
template <class Record, class T>
constexpr Record codes_of(const T& object) {
  constexpr bool are_codes = true;
  return record_of<Record, are_codes>(object);
}
/// And back: of numbers or of codes.
template <class Record, class T>
constexpr void take_record(const Record& r, T& object) {
  for_each_leaf(object, [&](auto& leaf, auto i) {
    using L = std::remove_cvref_t<decltype(leaf)>;
    const auto& from = r.template leaf<decltype(i)::value>();
    const auto set = [](auto& cell, const auto& number) {
      using B = Base<std::remove_reference_t<decltype(cell)>>;
      static_cast<B&>(cell) = B(number);
    };
    if constexpr (ArrayLike<L>) {
      for (int k = 0; k < L::size; ++k) set(leaf[k], from[k]);
    } else if constexpr (L::width > 64) {
      constexpr int n = (L::width + 63) / 64;
      Words<n> words;
      for (int k = 0; k < n; ++k) words[k] = static_cast<std::uint64_t>(from[k]);
      using U = UInt<L::width>;
      set(leaf, U(Inside{}, wrapped<L::width, false>(resized<typename U::Rep, false>(words))));
    } else if constexpr (std::same_as<std::remove_cvref_t<decltype(from)>, Word>) {
      set(leaf, from);
    } else {
      set(leaf, from[0]);
    }
  });
}

}  // namespace cosim::clocked
