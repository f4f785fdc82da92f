// VHDL run by GHDL.
#include "tb/equiv/vhdl_run.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tb/util/process.h"
#include "tb/util/scratch.h"

namespace cosim::equiv {
namespace {

class Vhdl : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_installed("ghdl")) GTEST_SKIP() << "no ghdl";
  }
  std::string file(const std::string& name, const std::string& text) const {
    const std::string path = (scratch_.path() / name).string();
    std::ofstream(path)
        << "library ieee;\nuse ieee.std_logic_1164.all;\nuse ieee.numeric_std.all;\n"
        << text;
    return path;
  }
  static VhdlRun run(const std::vector<std::string>& files, const VhdlStimulus& stimulus,
                     const std::vector<std::string>& generics = {}, int seconds = 60) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    return run_vhdl(files, "Top", generics, stimulus, until);
  }

 private:
  Scratch scratch_;
};

using Rows = std::vector<std::string>;

TEST_F(Vhdl, OutputsAreReadBeforeTheEdge) {
  const std::string top = file("top.vhd", R"(
entity top is
  generic (N : positive := 4);
  port (clk, rst_n : in std_logic; d : in unsigned(N-1 downto 0); q, y : out unsigned(N-1 downto 0));
end;
architecture a of top is begin
  process (clk, rst_n) begin
    if rst_n = '0' then q <= (others => '0'); elsif falling_edge(clk) then q <= d; end if;
  end process;
  y <= not d;
end;)");
  VhdlStimulus s{{"CLK"}, {{"CLK", true}}, {{"rst_n", 1}, {"D", 3}}, {{"q", 3}, {"y", 3}}, {}};
  s.rows = {"11011", "11101", "01001", "11001", "1111x", "00000"};
  const VhdlRun ran = run({top}, s, {"n=3"});
  EXPECT_EQ(ran.error, "");
  EXPECT_EQ(ran.inputs, s.rows);
  EXPECT_EQ(ran.rows, (Rows{"xxx100", "011010", "101110", "101110", "00100x", "000111"}));
}

// Integers of a package, ranges that ascend, an x and a weak value.
TEST_F(Vhdl, TypesAreThoseOfThePorts) {
  const std::string top = file("top.vhd", R"(
use work.kinds.all;  -- entity top is port (
entity top is port (
  a : in small; b : in natural range 0 to 9; c : std_logic_vector(0 to 2) := "000"; e : in bit;
  f : in bit_vector(1 downto 0); g : in boolean; h : in signed(W downto 0);
  z : out small; y : buffer natural range 0 to 9; x : out std_logic_vector(0 to 2); v : out bit;
  u : out bit_vector(0 to 1); t : out boolean; s : out signed(0 to W); r, q : out std_ulogic);
end entity top;
architecture a of top is begin
  z <= a; y <= b; x <= c; v <= e; u <= f; t <= g; s <= h; r <= 'H'; q <= 'Z';
end;)");
  const std::string kinds = file(
      "kinds.vhd",
      "package kinds is subtype small is integer range -3 to 4; constant W : natural := 1; end;");
  const VhdlStimulus s{
      {},
      {},
      {{"a", 4}, {"b", 4}, {"c", 3}, {"e", 1}, {"f", 2}, {"g", 1}, {"h", 2}},
      {{"z", 4}, {"y", 4}, {"x", 3}, {"v", 1}, {"u", 2}, {"t", 1}, {"s", 2}, {"r", 1}, {"q", 1}},
      {"1101"
       "0101"
       "110"
       "1"
       "10"
       "1"
       "10",
       "0100"
       "1001"
       "0x1"
       "0"
       "01"
       "0"
       "01",
       "1000"
       "1111"
       "000"
       "0"
       "00"
       "0"
       "00"}};
  const VhdlRun ran = run({top, kinds}, s);
  EXPECT_EQ(ran.error, "");
  EXPECT_EQ(ran.rows, (Rows{"1101"
                            "0101"
                            "110"
                            "1"
                            "10"
                            "1"
                            "10"
                            "1x",
                            "0100"
                            "1001"
                            "0x1"
                            "0"
                            "01"
                            "0"
                            "01"
                            "1x",
                            "0000"
                            "0101"
                            "000"
                            "0"
                            "00"
                            "0"
                            "00"
                            "1x"}));
  EXPECT_EQ(ran.inputs.back(),
            "0000"
            "0101"
            "000"
            "0"
            "00"
            "0"
            "00");
}

TEST_F(Vhdl, WhatCannotBeRunIsALine) {
  const auto top = [&](const std::string& ports, const std::string& body) {
    return file("top.vhd",
                "entity top is port (" + ports + "); end;\narchitecture a of top is\n" + body);
  };
  const VhdlStimulus s{{}, {}, {{"d", 2}}, {{"q", 2}}, {"01", "10", "11"}};
  const std::string plain = "d : in unsigned(1 downto 0); q : out unsigned(1 downto 0)";
  const VhdlRun broken = run({top(plain, "begin q <= d + ; end;")}, s);
  EXPECT_NE(broken.error.find("top.vhd:6: "), std::string::npos) << broken.error;
  const VhdlRun open = run({top(plain,
                                "component c is port (d : in bit); end component;\nbegin u : c "
                                "port map (d => '0'); end;")},
                           s);
  EXPECT_NE(open.error.find("top.vhd:7: instance \"u\""), std::string::npos) << open.error;
  const VhdlRun odd =
      run({top("d : in severity_level; q : out unsigned(1 downto 0)", "begin end;")}, s);
  EXPECT_EQ(odd.error,
            "port d: its type is not std_logic, bit, boolean, an integer or a vector of these");
  const VhdlRun wide =
      run({top("d : in unsigned(2 downto 0); q : out unsigned(1 downto 0)", "begin end;")}, s);
  // Versions of GHDL find one or the other first.
  EXPECT_TRUE(wide.error == "port d: its type has no such value, or not so many bits" ||
              wide.error == odd.error)
      << wide.error;
  const VhdlRun stops =
      run({top(plain,
               "begin process (d) begin q <= d;\n"
               "if d = 2 then q <= to_unsigned(1 - to_integer(d), 2); end if; end process; end;")},
          s);
  EXPECT_EQ(stops.rows, Rows{"01"});
  EXPECT_NE(stops.error.find("top.vhd:7"), std::string::npos) << stops.error;
  EXPECT_EQ(run({top(plain, "begin end;")}, {{}, {}, {}, {}, {}}).error,
            "port d: no value is given");
  EXPECT_EQ(run({file("other.vhd", "")}, s).error, "no file has the entity Top");
  const VhdlRun late = run({top(plain, "signal k : bit; begin k <= not k; end;")}, s, {}, 0);
  EXPECT_EQ(late.error, "no time was left for GHDL");
}

TEST(VhdlEntity, IsFoundBesideCommentsAndOthers) {
  const auto found = entity_in(
      "library a; use a.b.all; entity one is end one; /* use x; */ library c; -- use d.all;\n"
      "entity Two is generic (G : string := \"a;(\"; H, I : natural := f(1, 2)); port (\n"
      "signal x, y : in t(G'length downto 0); z : out character := ')'); begin end;",
      "two");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->context, "library c;\n");
  EXPECT_EQ(found->generic_names, (Rows{"G", "H", "I"}));
  ASSERT_EQ(found->ports.size(), 3U);
  EXPECT_EQ(found->ports[1].name, "y");
  EXPECT_EQ(found->ports[1].type, "t(G'length downto 0)");
  EXPECT_EQ(found->ports[2].mode, "out");
  EXPECT_EQ(found->ports[2].type, "character");
}

}  // namespace
}  // namespace cosim::equiv
