// Files that are whole, by what each kind must begin and end with.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/careless/judge.h"

namespace cosim::careless {
namespace {

using Json = nlohmann::json;

// JSON has no figure that is not finite: who writes one writes null.
bool has_null(const Json& json) {
  if (json.is_null()) return true;
  return json.is_structured() && std::any_of(json.begin(), json.end(), has_null);
}

std::string unsound_json(std::istream& file) {
  const Json json = Json::parse(file, nullptr, false);
  if (json.is_discarded()) return "is no JSON";
  return has_null(json) ? "a figure of it is null" : "";
}

// A header of names, then rows of as many whole numbers.
std::string unsound_csv(std::istream& file, const std::string& header) {
  const auto commas = std::count(header.begin(), header.end(), ',');
  std::size_t row = 1;
  for (std::string line; std::getline(file, line); ++row) {
    if (file.eof()) return "its last row is cut";
    const bool digits = std::all_of(line.begin(), line.end(), [](unsigned char c) {
      return std::isdigit(c) != 0 || c == ',' || c == '-';
    });
    if (!digits || std::count(line.begin(), line.end(), ',') != commas) {
      return "row " + std::to_string(row) + " is " + line;
    }
  }
  return "";
}

}  // namespace

std::string unsound(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) return "";
  std::ifstream file(path, std::ios::binary);
  std::string first, last;
  std::getline(file, first);
  if (first.empty() && file.eof()) return "is empty";
  const auto begins = [&](const char* text) { return first.starts_with(text); };
  const bool lines = !file.eof();
  if (begins("{")) return file.seekg(0), unsound_json(file);
  if (begins("tick,") || begins("clock,") || begins("segment,")) {
    return lines ? unsound_csv(file, first) : "its header is cut";
  }
  file.clear();
  file.seekg(0, std::ios::end);
  const std::streamoff size = file.tellg();
  last.resize(static_cast<std::size_t>(std::min<std::streamoff>(size, 12)));
  file.seekg(size - static_cast<std::streamoff>(last.size()));
  file.read(last.data(), static_cast<std::streamsize>(last.size()));
  const auto ends = [&](const char* text) { return last.find(text) != std::string::npos; };
  if (begins("\x89PNG")) return ends("IEND") ? "" : "the picture is cut";
  if (begins("<!DOCTYPE html>")) return ends("</html>") ? "" : "the page is cut";
  if (begins("<?xml")) {
    return ends("</svg>") ? "" : ends("testsuite") ? "" : "the picture or the list of tests is cut";
  }
  if (path.ends_with(".fst")) return size > 500 ? "" : "the wave is cut";
  return last.ends_with('\n') ? "" : "its last line is cut";
}

}  // namespace cosim::careless
