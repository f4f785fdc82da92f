#include "tb/rtl/vhdl.h"

namespace cosim::rtl {

const std::string_view numeric_vhd =
    R"vhdl(-- Functions of numeric_std that GHDL 2.0 synthesizes as something else, or not at all, by those that it
-- does right. vhdl.cpp declares these names in each architecture and package body, in front of the ones of
-- numeric_std. A declaration is one line, and its types are written out, for vhdl.cpp reads them.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

package cosim_numeric is
  function "=" (l : unsigned; r : natural) return boolean;
  function "=" (l : natural; r : unsigned) return boolean;
  function "=" (l : signed; r : integer) return boolean;
  function "=" (l : integer; r : signed) return boolean;
  function "/=" (l : unsigned; r : natural) return boolean;
  function "/=" (l : natural; r : unsigned) return boolean;
  function "/=" (l : signed; r : integer) return boolean;
  function "/=" (l : integer; r : signed) return boolean;
  function "<" (l : unsigned; r : natural) return boolean;
  function "<" (l : natural; r : unsigned) return boolean;
  function "<" (l : signed; r : integer) return boolean;
  function "<" (l : integer; r : signed) return boolean;
  function "<=" (l : unsigned; r : natural) return boolean;
  function "<=" (l : natural; r : unsigned) return boolean;
  function "<=" (l : signed; r : integer) return boolean;
  function "<=" (l : integer; r : signed) return boolean;
  function ">" (l : unsigned; r : natural) return boolean;
  function ">" (l : natural; r : unsigned) return boolean;
  function ">" (l : signed; r : integer) return boolean;
  function ">" (l : integer; r : signed) return boolean;
  function ">=" (l : unsigned; r : natural) return boolean;
  function ">=" (l : natural; r : unsigned) return boolean;
  function ">=" (l : signed; r : integer) return boolean;
  function ">=" (l : integer; r : signed) return boolean;
  function "+" (l : natural; r : unsigned) return unsigned;
  function "+" (l : integer; r : signed) return signed;
  function "-" (l : natural; r : unsigned) return unsigned;
  function "-" (l : integer; r : signed) return signed;
  function "*" (l : natural; r : unsigned) return unsigned;
  function "*" (l : integer; r : signed) return signed;
  function "+" (l : std_ulogic; r : unsigned) return unsigned;
  function "+" (l : std_ulogic; r : signed) return signed;
  function "-" (l : std_ulogic; r : unsigned) return unsigned;
  function "-" (l : std_ulogic; r : signed) return signed;
  function "*" (l : unsigned; r : natural) return unsigned;
  function "*" (l : signed; r : integer) return signed;
  function "/" (l : signed; r : integer) return signed;
  function "/" (l : integer; r : signed) return signed;
  function "mod" (l : signed; r : integer) return signed;
  function resize (arg : signed; new_size : natural) return signed;
  function resize (arg : signed; size_res : signed) return signed;
  function rotate_left (arg : unsigned; count : natural) return unsigned;
  function rotate_right (arg : unsigned; count : natural) return unsigned;
  function "rol" (arg : unsigned; count : integer) return unsigned;
  function "ror" (arg : unsigned; count : integer) return unsigned;
  function rotate_left (arg : signed; count : natural) return signed;
  function rotate_right (arg : signed; count : natural) return signed;
  function "rol" (arg : signed; count : integer) return signed;
  function "ror" (arg : signed; count : integer) return signed;
  function "sla" (arg : unsigned; count : integer) return unsigned;
  function "sra" (arg : unsigned; count : integer) return unsigned;
  function "sla" (arg : signed; count : integer) return signed;
  function "sra" (arg : signed; count : integer) return signed;

  -- The same of numeric_std_unsigned, for designs that use it.
  function "=" (l : std_ulogic_vector; r : natural) return boolean;
  function "=" (l : natural; r : std_ulogic_vector) return boolean;
  function "/=" (l : std_ulogic_vector; r : natural) return boolean;
  function "/=" (l : natural; r : std_ulogic_vector) return boolean;
  function "<" (l : std_ulogic_vector; r : natural) return boolean;
  function "<" (l : natural; r : std_ulogic_vector) return boolean;
  function "<=" (l : std_ulogic_vector; r : natural) return boolean;
  function "<=" (l : natural; r : std_ulogic_vector) return boolean;
  function ">" (l : std_ulogic_vector; r : natural) return boolean;
  function ">" (l : natural; r : std_ulogic_vector) return boolean;
  function ">=" (l : std_ulogic_vector; r : natural) return boolean;
  function ">=" (l : natural; r : std_ulogic_vector) return boolean;
  function "*" (l : std_ulogic_vector; r : natural) return std_ulogic_vector;
  function "*" (l : natural; r : std_ulogic_vector) return std_ulogic_vector;

  -- Both operands of a comparison, as wide as either.
  function wide (x : unsigned) return unsigned;
  function wide (x : natural; like : unsigned) return unsigned;
  function wide (x : signed) return signed;
  function wide (x : integer; like : signed) return signed;
end package;

package body cosim_numeric is
  function wide (x : unsigned) return unsigned is begin return resize(x, maximum(x'length, 31)); end;
  function wide (x : natural; like : unsigned) return unsigned is
  begin
    return to_unsigned(x, maximum(like'length, 31));
  end;
  function wide (x : signed) return signed is begin return resize(x, maximum(x'length, 32)); end;
  function wide (x : integer; like : signed) return signed is
  begin
    return to_signed(x, maximum(like'length, 32));
  end;

  function "=" (l : unsigned; r : natural) return boolean is begin return wide(l) = wide(r, l); end;
  function "=" (l : natural; r : unsigned) return boolean is begin return wide(l, r) = wide(r); end;
  function "=" (l : signed; r : integer) return boolean is begin return wide(l) = wide(r, l); end;
  function "=" (l : integer; r : signed) return boolean is begin return wide(l, r) = wide(r); end;
  function "/=" (l : unsigned; r : natural) return boolean is begin return not (wide(l) = wide(r, l)); end;
  function "/=" (l : natural; r : unsigned) return boolean is begin return not (wide(l, r) = wide(r)); end;
  function "/=" (l : signed; r : integer) return boolean is begin return not (wide(l) = wide(r, l)); end;
  function "/=" (l : integer; r : signed) return boolean is begin return not (wide(l, r) = wide(r)); end;
  function "<" (l : unsigned; r : natural) return boolean is begin return wide(l) < wide(r, l); end;
  function "<" (l : natural; r : unsigned) return boolean is begin return wide(l, r) < wide(r); end;
  function "<" (l : signed; r : integer) return boolean is begin return wide(l) < wide(r, l); end;
  function "<" (l : integer; r : signed) return boolean is begin return wide(l, r) < wide(r); end;
  function "<=" (l : unsigned; r : natural) return boolean is begin return wide(l) <= wide(r, l); end;
  function "<=" (l : natural; r : unsigned) return boolean is begin return wide(l, r) <= wide(r); end;
  function "<=" (l : signed; r : integer) return boolean is begin return wide(l) <= wide(r, l); end;
  function "<=" (l : integer; r : signed) return boolean is begin return wide(l, r) <= wide(r); end;
  function ">" (l : unsigned; r : natural) return boolean is begin return wide(l) > wide(r, l); end;
  function ">" (l : natural; r : unsigned) return boolean is begin return wide(l, r) > wide(r); end;
  function ">" (l : signed; r : integer) return boolean is begin return wide(l) > wide(r, l); end;
  function ">" (l : integer; r : signed) return boolean is begin return wide(l, r) > wide(r); end;
  function ">=" (l : unsigned; r : natural) return boolean is begin return wide(l) >= wide(r, l); end;
  function ">=" (l : natural; r : unsigned) return boolean is begin return wide(l, r) >= wide(r); end;
  function ">=" (l : signed; r : integer) return boolean is begin return wide(l) >= wide(r, l); end;
  function ">=" (l : integer; r : signed) return boolean is begin return wide(l, r) >= wide(r); end;
  function "+" (l : natural; r : unsigned) return unsigned is begin return to_unsigned(l, r'length) + r; end;
  function "+" (l : integer; r : signed) return signed is begin return to_signed(l, r'length) + r; end;
  function "-" (l : natural; r : unsigned) return unsigned is begin return to_unsigned(l, r'length) - r; end;
  function "-" (l : integer; r : signed) return signed is begin return to_signed(l, r'length) - r; end;
  function "*" (l : natural; r : unsigned) return unsigned is begin return to_unsigned(l, r'length) * r; end;
  function "*" (l : integer; r : signed) return signed is begin return to_signed(l, r'length) * r; end;
  function "+" (l : std_ulogic; r : unsigned) return unsigned is
  begin
    return resize(unsigned'(0 downto 0 => l), r'length) + r;
  end;
  function "+" (l : std_ulogic; r : signed) return signed is
  begin
    return signed(resize(unsigned'(0 downto 0 => l), r'length)) + r;
  end;
  function "-" (l : std_ulogic; r : unsigned) return unsigned is
  begin
    return resize(unsigned'(0 downto 0 => l), r'length) - r;
  end;
  function "-" (l : std_ulogic; r : signed) return signed is
  begin
    return signed(resize(unsigned'(0 downto 0 => l), r'length)) - r;
  end;
  function "*" (l : unsigned; r : natural) return unsigned is begin return l * to_unsigned(r, l'length); end;
  function "*" (l : signed; r : integer) return signed is begin return l * to_signed(r, l'length); end;
  -- Whether so many bits hold it; a divisor that needs more gives 0.
  function fits (x : integer; size : natural) return boolean is
  begin
    if size >= 32 then return true; end if;
    return x >= -(2 ** (size - 1)) and x < 2 ** (size - 1);
  end;
  function "/" (l : signed; r : integer) return signed is
  begin
    if fits(r, l'length) then return l / to_signed(r, l'length); end if;
    return to_signed(0, l'length);
  end;
  -- Divided by -1 a power of two, which is below 0, has more bits than it: the highest is taken for a sign.
  function "/" (l : integer; r : signed) return signed is
    constant x : signed(31 downto 0) := to_signed(l, 32);
    constant y : unsigned(31 downto 0) := unsigned(-x);
  begin
    if fits(l, r'length) then return to_signed(l, r'length) / r; end if;
    if l < 0 and (not r) = 0 and (y and (y - 1)) = 0 then
      return shift_left(to_signed(1, r'length), r'length - 1);
    end if;
    return resize(x / resize(r, maximum(r'length, 32)), r'length);
  end;
  function "mod" (l : signed; r : integer) return signed is
  begin
    return resize(wide(l) mod wide(r, l), l'length);
  end;
  function resize (arg : signed; new_size : natural) return signed is
    alias x : signed(arg'length - 1 downto 0) is arg;
  begin
    if new_size >= arg'length then return ieee.numeric_std.resize(arg, new_size); end if;
    if new_size <= 1 then return x(x'left downto arg'length - new_size); end if;
    return x(x'left) & x(new_size - 2 downto 0);
  end;
  function resize (arg : signed; size_res : signed) return signed is
  begin
    return resize(arg, size_res'length);
  end;
  function rotate_left (arg : unsigned; count : natural) return unsigned is
    constant u : unsigned(arg'length - 1 downto 0) := unsigned(arg);
    constant n : natural := count mod arg'length;
  begin
    return unsigned(shift_left(u, n) or shift_right(u, u'length - n));
  end;
  function rotate_right (arg : unsigned; count : natural) return unsigned is
  begin
    return rotate_left(arg, arg'length - count mod arg'length);
  end;
  function "rol" (arg : unsigned; count : integer) return unsigned is
  begin
    return rotate_left(arg, count mod arg'length);
  end;
  function "ror" (arg : unsigned; count : integer) return unsigned is
  begin
    return rotate_left(arg, (-count) mod arg'length);
  end;
  function rotate_left (arg : signed; count : natural) return signed is
    constant u : unsigned(arg'length - 1 downto 0) := unsigned(arg);
    constant n : natural := count mod arg'length;
  begin
    return signed(shift_left(u, n) or shift_right(u, u'length - n));
  end;
  function rotate_right (arg : signed; count : natural) return signed is
  begin
    return rotate_left(arg, arg'length - count mod arg'length);
  end;
  function "rol" (arg : signed; count : integer) return signed is
  begin
    return rotate_left(arg, count mod arg'length);
  end;
  function "ror" (arg : signed; count : integer) return signed is
  begin
    return rotate_left(arg, (-count) mod arg'length);
  end;
  function "sla" (arg : unsigned; count : integer) return unsigned is
  begin
    if count >= 0 then return shift_left(arg, count); end if;
    return shift_right(arg, -count);
  end;
  function "sra" (arg : unsigned; count : integer) return unsigned is
  begin
    if count >= 0 then return shift_right(arg, count); end if;
    return shift_left(arg, -count);
  end;
  function "sla" (arg : signed; count : integer) return signed is
  begin
    if count >= 0 then return shift_left(arg, count); end if;
    return shift_right(arg, -count);
  end;
  function "sra" (arg : signed; count : integer) return signed is
  begin
    if count >= 0 then return shift_right(arg, count); end if;
    return shift_left(arg, -count);
  end;
  function "=" (l : std_ulogic_vector; r : natural) return boolean is begin return unsigned(l) = r; end;
  function "=" (l : natural; r : std_ulogic_vector) return boolean is begin return l = unsigned(r); end;
  function "/=" (l : std_ulogic_vector; r : natural) return boolean is begin return unsigned(l) /= r; end;
  function "/=" (l : natural; r : std_ulogic_vector) return boolean is begin return l /= unsigned(r); end;
  function "<" (l : std_ulogic_vector; r : natural) return boolean is begin return unsigned(l) < r; end;
  function "<" (l : natural; r : std_ulogic_vector) return boolean is begin return l < unsigned(r); end;
  function "<=" (l : std_ulogic_vector; r : natural) return boolean is begin return unsigned(l) <= r; end;
  function "<=" (l : natural; r : std_ulogic_vector) return boolean is begin return l <= unsigned(r); end;
  function ">" (l : std_ulogic_vector; r : natural) return boolean is begin return unsigned(l) > r; end;
  function ">" (l : natural; r : std_ulogic_vector) return boolean is begin return l > unsigned(r); end;
  function ">=" (l : std_ulogic_vector; r : natural) return boolean is begin return unsigned(l) >= r; end;
  function ">=" (l : natural; r : std_ulogic_vector) return boolean is begin return l >= unsigned(r); end;
  function "*" (l : std_ulogic_vector; r : natural) return std_ulogic_vector is
  begin
    return std_ulogic_vector(unsigned(l) * r);
  end;
  function "*" (l : natural; r : std_ulogic_vector) return std_ulogic_vector is
  begin
    return std_ulogic_vector(l * unsigned(r));
  end;
end package body;
)vhdl";

}  // namespace cosim::rtl
