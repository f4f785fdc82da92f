// The models as they are compiled, beside what the exporter wrote of them.
#include "tests/clocked/models.h"

#include "tests/clocked/compare.h"

namespace cosim::clocked::test {
namespace {

TEST(ClockedModels, AreWhatTheExporterWrote) {
  for_each_model([]<class Model>(const std::string& name) { compare<Model>(name, 3000); });
}

TEST(ClockedModels, CellsHaveTheNamesOfTheirMembers) {
  std::string names;
  const auto add = [&](const Label& label, const auto& cell) {
    names += label.name + ':' + std::to_string(cell.width) + (label.is_unreset ? "? " : " ");
  };
  const Uart<4> uart{};
  for_each_cell(uart, add);
  EXPECT_EQ(names, "left:4 frame:9? divider.count:8 ");
  names.clear();
  const auto in = zero<Features::In>();
  for_each_cell(in, add);
  EXPECT_EQ(names, "entry.tag:5 entry.valid:1 at:3 key:4 words[0]:7 words[1]:7 words[2]:7 ");
  names.clear();
#ifdef COSIM_WITH_CIRCULAR
  const Circular<8> circular{};
  for_each_cell(circular, [&](const Label& label, const auto&) {
    names += label.name + '=' + std::string(label.block) + ' ';
  });
  EXPECT_EQ(names, "t4=4 t16=16 f=1 ct7=7 ct8=8 ");
#endif
  names.clear();
  const Features features{};
  for_each_cell(features, [&](const Label& label, const auto&) {
    if (label.is_auxiliary) names += label.name + ' ';
  });
  EXPECT_EQ(names, "copies ");
}

// The byte stands on the line behind its start bit, as uart.v has it.
TEST(ClockedModels, TheUartSendsAByte) {
  Uart<4> uart{};
  for (int byte = 0; byte < 256; ++byte) {
    std::string line;
    EXPECT_TRUE(uart.clock({.rst_n = 1, .valid = 1, .data = byte}).ready);
    while (uart.left != 0) {
      const auto out = uart.clock({.rst_n = 1, .valid = 0, .data = 0});
      line += out.tx ? '1' : '0';
    }
    std::string wanted(4, '0');
    for (int i = 0; i < 8; ++i) wanted += std::string(4, byte >> i & 1 ? '1' : '0');
    EXPECT_EQ(line, wanted + "1111");
  }
}

}  // namespace
}  // namespace cosim::clocked::test
