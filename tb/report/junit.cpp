#include "tb/report/junit.h"

#include <fmt/core.h>

#include "tb/support/markup.h"
#include "tb/support/words.h"

namespace cosim {

std::string junit_text(const JunitCase& one) {
  std::string lines;
  for (const std::string& line : lines_in(one.text)) lines += markup(one_line(line)) + '\n';
  const std::string suite = markup(one_line(one.suite)), name = markup(one_line(one.name));
  const bool is_failure = one.end == JunitCase::End::failure;
  const bool is_error = one.end == JunitCase::End::error;
  std::string inner;
  if (is_failure || is_error) {
    const char* const element = is_failure ? "failure" : "error";
    inner = fmt::format("<{0} type=\"{1}\" message=\"{2}\">{3}</{0}>", element,
                        markup(one_line(one.type)), lines.substr(0, lines.find('\n')), lines);
  } else {
    inner = fmt::format("<system-out>{}</system-out>", lines);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"{0}\" tests=\"1\" failures=\"{1}\" errors=\"{2}\" skipped=\"0\" "
      "time=\"{3:.3f}\">\n"
      "<testcase classname=\"{0}\" name=\"{4}\" time=\"{3:.3f}\">{5}</testcase>\n"
      "</testsuite>\n",
      suite, is_failure ? 1 : 0, is_error ? 1 : 0, one.seconds, name, inner);
}

}  // namespace cosim
