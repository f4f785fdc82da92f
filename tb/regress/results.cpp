// A log that is only appended to, a line a shard, each with a hash of itself: a line that is cut
// off is seen, and what comes behind it is still read.
#include "tb/regress/results.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "model/core/input_error.h"
#include "tb/util/hash.h"
#include "tb/util/json.h"
#include "tb/util/json_at.h"
#include "tb/util/words.h"

namespace cosim::regress {
namespace {

namespace fs = std::filesystem;

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

bool ends_in_a_line(int file) {
  struct stat now {};
  if (fstat(file, &now) != 0 || now.st_size == 0) return true;
  char last = 0;
  return pread(file, &last, 1, now.st_size - 1) == 1 && last == '\n';
}

bool write_all(int file, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t n = ::write(file, text.data() + at, text.size() - at);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += static_cast<std::size_t>(n);
  }
  return true;
}

constexpr double most_seconds = 1e9;

// Of a line without its hash.
std::string hash_of_line(const std::string& run, const Json& json) {
  return hash_of(run + json_text(json));
}

// None where it is cut off or changed.
std::optional<Line> line_of(const std::string& run, const std::string& path,
                            const std::string& text) {
  try {
    const JsonAt all(path, text);
    Json json = all.json();
    const std::string hash = all.at("hash").text();
    json.erase("hash");
    if (hash != hash_of_line(run, json)) return std::nullopt;
    Line line;
    line.shard = all.at("shard").whole();
    line.host = all.at("host").text();
    line.seconds = all.at("seconds").number(0, most_seconds);
    if (const auto error = all.find("error")) {
      line.error = error->text();
    } else {
      line.result = all.at("result").json();
      if (!line.result.is_object()) return std::nullopt;
    }
    return line;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

void append(const fs::path& path, const std::string& run, const Line& line) {
  Json json{{"shard", line.shard}, {"host", line.host}, {"seconds", line.seconds}};
  if (line.error.empty()) {
    json["result"] = line.result;
  } else {
    json["error"] = line.error;
  }
  json["hash"] = hash_of_line(run, json);
  std::string text = json_text(json) + '\n';
  const Descriptor file(open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  // Several programs of one host write the same file. Where nothing can be locked, a mixed line is
  // a torn one.
  if (file.number() >= 0) flock(file.number(), LOCK_EX);
  if (file.number() >= 0 && !ends_in_a_line(file.number())) text.insert(0, 1, '\n');
  if (file.number() < 0 || !write_all(file.number(), text) || fsync(file.number()) != 0) {
    throw InputError(fmt::format("{}: cannot write: {}", path.string(), std::strerror(errno)));
  }
}

std::uint64_t Results::finished() const {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(done, [](const auto& one) { return one.has_value(); }));
}

bool Results::failed(std::uint64_t shard) const {
  return done[shard] && done[shard]->result.contains("failed");
}

Results read_results(const fs::path& folder, const std::string& run, std::uint64_t shards) {
  Results results;
  results.done.resize(shards);
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& path : files) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(path.string() + ": cannot be read");
    for (std::string text; std::getline(file, text);) {
      std::optional<Line> line = line_of(run, path.string(), text);
      // Without its '\n' even a whole line may be that of another number.
      if (!line || file.eof() || line->shard >= shards) {
        ++results.torn;
      } else if (!line->error.empty()) {
        results.errors[line->shard] = one_line(line->error);
      } else if (results.done[line->shard]) {
        ++results.twice;
      } else {
        results.done[line->shard] = std::move(line);
      }
    }
  }
  std::erase_if(results.errors,
                [&](const auto& error) { return results.done[error.first].has_value(); });
  return results;
}

}  // namespace cosim::regress
