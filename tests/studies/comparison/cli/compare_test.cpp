// cosim compare: figures that follow from the sources.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/cli/help.h"
#include "tests/cli/picture.h"
#include "tests/support/members.h"
#include "tests/support/root.h"

namespace cosim::cli {
namespace {

using nlohmann::json;
using Compare = InAFolder;

const std::string kFlange = (test::project_root() / "tests/toolpaths/flange.ngc").string();

std::map<std::string, json> compared(const Arguments& arguments) {
  const Folder folder;
  const Ended ended =
      ends(0, cosim(joined({"compare", "--report", folder.path("r.json")}, arguments)));
  EXPECT_TRUE(has(ended.out, "verdict: match"));
  std::map<std::string, json> all;
  const json report = json::parse(folder.text("r.json"));
  for (const json& one : report["algorithms"]) {
    all[one["algorithm"]] = one;
    EXPECT_TRUE(has(ended.out, "\n" + one["algorithm"].get<std::string>() + " "));
  }
  return all;
}

TEST_F(Compare, PageHasTheFiguresThatArePrinted) {
  const auto page_of = [&](const Arguments& more, const std::string& verdict) {
    const Ended e = ends(
        0, cosim(joined({"compare", "--line", "27,9", "--html", folder.path("x.html")}, more)));
    const std::string page = folder.text("x.html");
    EXPECT_TRUE(has(page, ">" + verdict + "</span>\n<h1>BP = 27, MP = 9</h1>"));
    const std::size_t table = e.out.find("         "), end = e.out.find("\n\n", table);
    EXPECT_TRUE(has(page, "<pre>" + e.out.substr(table, end + 1 - table) + "</pre>")) << e.out;
    return page;
  };
  page_of({}, "match");
  page_of({"--algorithms", "bresenham"}, "nothing compared");
}

// The picture of --plot stands in the page itself.
TEST_F(Compare, PageHasThePlot) {
  if (!can_plot()) GTEST_SKIP() << "no gnuplot";
  ends(0, cosim({"compare", "--line", "27,9", "--html", folder.path("x.html"), "--plot",
                 folder.path("p.png")}));
  const std::string page = folder.text("x.html"), begin = "src=\"data:image/png;base64,";
  const std::size_t at = page.find(begin) + begin.size();
  const std::string coded = folder.write("coded", page.substr(at, page.find('"', at) - at));
  const std::string decode = "base64 -d " + coded + " > " + folder.path("decoded");
  ASSERT_EQ(std::system(decode.c_str()), 0);
  EXPECT_EQ(folder.text("decoded"), folder.text("p.png"));
}

// The printed line: Table 3's minor steps are on 2 6 8 10 14 18 22 24 26.
TEST_F(Compare, OfThePrintedLine) {
  const auto all = compared({"--line", "27,9"});
  const json& machine = all.at("su1631518-greedy");
  test::expect_members(machine, R"({"clocks": 4, "steps": 27, "combinations": 2})");
  EXPECT_DOUBLE_EQ(machine["gaps"][0].get<double>(), 2 / 3.0);
  EXPECT_DOUBLE_EQ(machine["gaps"][1].get<double>(), 4 / 3.0);
  double worst = 0;
  long minor = 0;
  for (long q = 1; q <= 27; ++q) {
    for (const long step : {2, 6, 8, 10, 14, 18, 22, 24, 26}) minor += step == q;
    worst = std::max(worst, std::fabs(static_cast<double>(minor) - static_cast<double>(q) / 3));
  }
  EXPECT_DOUBLE_EQ(machine["axial_deviation"]["max"].get<double>(), worst);
  EXPECT_NEAR(machine["radial_deviation"]["max"].get<double>(), worst * 3 / std::sqrt(10), 1e-12);

  EXPECT_EQ(all.at("rate-multiplier")["clocks"], 32 / 8);  // 2^5 positions, 8 a clock
  EXPECT_EQ(all.at("bresenham")["clocks"], 27);
  EXPECT_LE(all.at("bresenham")["axial_deviation"]["max"].get<double>(), 0.5);
  EXPECT_EQ(all.at("dda")["clocks"], 32 + 1);  // 2^(6 - 1), and one shift
  for (const auto& [name, one] : all) EXPECT_EQ(one["end_error"], 0) << name;
}

// The printed arc: 17 steps, and the clock of the sector change.
TEST_F(Compare, OfThePrintedArc) {
  const auto all = compared({"--arc", "12"});
  const json& machine = all.at("su1665343");
  test::expect_members(machine, R"({"steps": 17, "clocks": 18, "machine": "circular W=4"})");
  EXPECT_LT(machine["axial_deviation"]["max"].get<double>(), 0.5);
  EXPECT_EQ(all.at("midpoint")["axial_deviation"], machine["axial_deviation"]);
  EXPECT_EQ(all.at("single-axis")["steps"], 24);
  EXPECT_EQ(all.at("single-axis")["combinations"], 2);
  EXPECT_GT(all.at("su875343")["end_error"].get<double>(), 4);
  EXPECT_EQ(all.size(), 8U);
}

TEST_F(Compare, OfAToolpath) {
  const auto all = compared({kFlange, "--steps-per-mm", "2"});
  EXPECT_EQ(all.at("su1631518")["paths"], all.at("bresenham")["paths"]);
  EXPECT_EQ(all.at("su1665343")["paths"], all.at("midpoint")["paths"]);
  EXPECT_EQ(all.at("su1665343")["steps"], all.at("midpoint")["steps"]);
}

// SU 875343 can draw an arc that starts before 45 degrees, and none that starts behind.
TEST_F(Compare, SaysWhatIsLeftOut) {
  const std::string before = "G0 X100 Y0\nG3 X60 Y80 I-100\n";
  const std::string why = "su875343 cannot draw an arc that starts at 45 degrees or behind";
  const auto says = [&](const std::string& program, const Arguments& more) {
    return cosim(joined({"compare", folder.write("p.ngc", program), "--steps-per-mm", "1"}, more));
  };
  const Ended all = says(before, {});
  EXPECT_EQ(all.status, 0) << all.err;
  EXPECT_TRUE(has(all.out, "\nsu875343 "));
  EXPECT_FALSE(has(all.out, "left out"));
  const std::string beyond = before + "G3 X0 Y100 I-60 J-80\n";
  const Ended some = says(beyond, {});
  EXPECT_EQ(some.status, 0) << some.err;
  EXPECT_FALSE(has(some.out, "\nsu875343 "));
  EXPECT_TRUE(has(some.out, "\nleft out: " + why + "\n"));
  EXPECT_EQ(refusal(says(beyond, {"--algorithms", "su875343"})),
            "cosim: --algorithms: " + why + "\n");
}

TEST_F(Compare, OnlyWhatIsAskedFor) {
  EXPECT_EQ(compared({"--arc", "40", "--algorithms", "dda,midpoint"}).size(), 2U);
}

void expect_refused_compare(const Arguments& arguments, const std::string& error) {
  const Ended ended = ends(2, cosim(joined({"compare"}, arguments)));
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(ended.err, "cosim: " + error + "\n");
}

TEST_F(Compare, OfNoMachineComparesNothing) {
  ends(0, cosim({"compare", "--line", "27,9", "--algorithms", "bresenham", "--report",
                 folder.path("r")}));
  const json report = json::parse(folder.text("r"));
  EXPECT_EQ(report["verdict"], "nothing compared");
  EXPECT_EQ(report["algorithms"].size(), 1U);
}

TEST_F(Compare, RefusesWhatItCannotCompare) {
  const std::string one = "compare: one of --line, --arc and FILE is needed, ";
  expect_refused_compare({}, one + "none is given");
  expect_refused_compare({"--line", "27,9", "--arc", "12"}, one + "more are given");
  expect_refused_compare({"--line", "27"}, "--line: '27' is not BP,MP");
  expect_refused_compare({"--line", "9,27"}, "--line: MP: '27' is not a whole number from 0 to 9");
  expect_refused_compare({"--arc", "70000"},
                         "--arc: '70000' is not a whole number from 1 to 65535");
  expect_refused_compare({"--line", "27,9", "--algorithms", "midpoint"},
                         "--algorithms: 'midpoint' cannot do this work; there are su1631518, "
                         "su1631518-greedy, rate-multiplier, dda, dda-half, bresenham");
  expect_refused_compare({"--line", "27,9", "--algorithms", "dda,bresenham,dda"},
                         "--algorithms: 'dda' is given twice");
  EXPECT_EQ(cosim({"compare", "--line", "5,3", "--algorithms", ""}).err,
            "cosim: --algorithms: names none\n");
  expect_refused_compare(
      {kFlange, "--steps-per-mm", "2", "--algorithms", "fast"},
      "--algorithms: 'fast' cannot do this work; there are su1631518, "
      "su1631518-greedy, rate-multiplier, dda, dda-half, bresenham, su1665343, "
      "su875343, dda, dda-half, dda-sequential, dda-sequential-half, midpoint, single-axis");
}

TEST_F(Compare, HasAHelpThatNamesEveryOption) {
  expect_in(help({"compare"}),
            {"FILE", "--steps-per-mm S", "--line BP,MP", "--arc R", "--algorithms LIST",
             "--plot FILE", "--html FILE.html", "--report FILE"});
}

// Two algorithms of each machine.
TEST_F(Compare, HasAReportThatNamesAMachineOnce) {
  ASSERT_EQ(cosim({"compare", "--line", "27,9", "--report", folder.path("r")}).status, 0);
  const json r = json::parse(folder.text("r"));
  EXPECT_EQ(r["runs"].size(), 4U);
  EXPECT_EQ(r["design"], (json{"linear", "dda"}));
  EXPECT_EQ(r["parameters"], json::parse(R"([{"M": 5, "N": 2}, {"W": 6}])"));
}

// Each format, of each kind of work; of a line it is the picture of the help's example.
TEST_F(Compare, DrawsArcsAndPrograms) {
  if (!can_plot()) GTEST_SKIP() << "no gnuplot";
  for (const Arguments& plain :
       {Arguments{"compare", "--arc", "12"}, {"compare", kFlange, "--steps-per-mm", "1"}}) {
    const Folder pictures;
    for (const char* name : {"a.svg", "a.png"}) {
      const Ended ended = ends(0, cosim(joined(plain, {"--plot", pictures.path(name)})));
      EXPECT_EQ(ended.out, cosim(plain).out);
    }
    EXPECT_EQ(pictures.text("a.png").substr(1, 3), "PNG");
    EXPECT_TRUE(has(pictures.text("a.svg"), "step along the path"));
  }
}

}  // namespace
}  // namespace cosim::cli
