#include "tests/cli/drawing.h"

#include <sstream>

namespace cosim::cli {

std::vector<std::vector<std::string>> Drawing::rows(const std::string& columns) const {
  std::vector<std::vector<std::string>> all;
  EXPECT_FALSE(csv.empty());
  if (csv.empty()) return all;
  EXPECT_EQ(csv.front(), columns);
  for (std::size_t i = 1; i < csv.size(); ++i) {
    std::istringstream line(csv[i]);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(line, cell, ',');) cells.push_back(cell);
    all.push_back(cells);
  }
  return all;
}

std::vector<StepRow> Drawing::steps(const std::string& first_column) const {
  std::vector<StepRow> all;
  for (const auto& cells : rows(first_column + ",dx,dy,x,y")) {
    StepRow row{};
    EXPECT_EQ(cells.size(), row.size());
    for (std::size_t i = 0; i < row.size() && i < cells.size(); ++i) row[i] = std::stoll(cells[i]);
    all.push_back(row);
  }
  return all;
}

Drawing draw(Arguments command) {
  const Folder folder;
  command.insert(command.end(), {"--csv", folder.path("csv"), "--report", folder.path("report")});
  Drawing d;
  d.ended = ends(0, cosim(command));
  EXPECT_EQ(d.ended.err, "");
  EXPECT_TRUE(d.ended.out.ends_with("\nverdict: match\n")) << d.ended.out;
  const std::string csv = folder.text("csv");
  EXPECT_TRUE(csv.ends_with('\n'));
  d.csv = lines(csv);
  d.report = nlohmann::json::parse(folder.text("report"), nullptr, false);
  EXPECT_EQ(d.report["verdict"], "match");
  return d;
}

}  // namespace cosim::cli
