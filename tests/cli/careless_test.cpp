// What a careless or hostile person hands in for a file: it works, or one line says what is wrong;
// and it never takes more memory than a few times what the file holds.
// Needs: linear, circular, toolpath
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "tests/cli/program.h"
#include "tests/support/sanitized.h"

namespace cosim::cli {
namespace {

/// What the program reads, and a good one of each.
enum class Reads { program, stimulus, checkpoint };

constexpr const char* good_program = "G21 G90\nG0 X1 Y2\nG1 X3\n";
constexpr const char* good_stimulus =
    "cosim stimulus 1\n"
    "machine linear M=5 N=2\n"
    "origin a line\n"
    "clock initial_set_n reset write_bp write_uk start data\n"
    "0     1             0     1        0        0     27\n"
    "1     1             0     0        1        0     10\n"
    "2     1             0     0        0        1     0\n"
    "3-9   1             0     0        0        0     0\n"
    "end\n";

Ended read(Reads kind, const std::string& path) {
  switch (kind) {
    case Reads::program:
      return cosim({"path", path, "--steps-per-mm", "1"});
    case Reads::stimulus:
      return cosim({"replay", path});
    case Reads::checkpoint:
      break;
  }
  return cosim({"sweep", "linear", "--random", "5", "--checkpoint", path});
}

void expect_match(const Ended& ended) {
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(has(ended.out, "verdict: match\n"));
}

void expect_unread(const Ended& ended, const std::string& line) {
  EXPECT_EQ(ended.status, 2);
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(ended.err.rfind("cosim: " + line, 0), 0U) << ended.err.substr(0, 1000);
  EXPECT_EQ(lines(ended.err).size(), 1U) << ended.err.substr(0, 1000);
  EXPECT_LT(ended.err.size(), 1000U);
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
  return text;
}

using Careless = InAFolder;

TEST_F(Careless, EndsOfLinesAndMarksAreTakenAsTheyAre) {
  for (const auto& [kind, text] :
       {std::pair{Reads::program, good_program}, {Reads::stimulus, good_stimulus}}) {
    const std::string good = text;
    expect_match(read(kind, folder.write("good", good)));
    expect_match(read(kind, folder.write("no end", good.substr(0, good.size() - 1))));
    expect_match(read(kind, folder.write("dos", replaced(good, "\n", "\r\n"))));
    expect_match(read(kind, folder.write("mark", "\xef\xbb\xbf" + good)));
    expect_match(read(kind, folder.write("lines", replaced(good, "\n", "\n\n\n"))));
  }
}

TEST_F(Careless, BytesThatAreNoTextAreNamed) {
  const auto nul = [](const std::string& text) {
    return replaced(text, "3", std::string("3\0", 2));
  };
  std::string path = folder.write("nul", nul(good_program));
  expect_unread(read(Reads::program, path), path + ":3:6: NUL byte: this is not a text file");
  path = folder.write("nul", replaced(good_stimulus, "27", std::string("27\0", 3)));
  expect_unread(read(Reads::stimulus, path), path + ":5: data: '27?' is no value of 5 bits");
  path = folder.write("utf16", std::string("\xff\xfeG\0\n\0", 6));
  expect_unread(read(Reads::program, path), path + ":1:1: unexpected byte 0xff");
  expect_unread(read(Reads::stimulus, path), path + ":1: is not 'cosim stimulus 1'");
  expect_unread(read(Reads::checkpoint, path), path + ": no checkpoint");
  path = folder.write("empty", "");
  expect_unread(read(Reads::program, path), path + ":1:1: the program ends without a motion");
  expect_unread(read(Reads::stimulus, path), path + ":1: is not 'cosim stimulus 1'");
  expect_unread(read(Reads::checkpoint, path), path + ": no checkpoint");
}

// What a stimulus says of its origin goes to the terminal: nothing there may move its cursor.
TEST_F(Careless, AnOriginIsOneLineOfPlainText) {
  const std::string text = replaced(good_stimulus, "a line", std::string("a \x1b[2J\0\rline", 12));
  const Ended ended = read(Reads::stimulus, folder.write("origin", text));
  expect_match(ended);
  for (const char c : ended.out) EXPECT_TRUE(c == '\n' || c >= ' ') << static_cast<int>(c);
}

TEST_F(Careless, WhatIsNoFileIsSaid) {
  const std::string no_file = folder.path("folder"), pipe = folder.path("pipe");
  fs::create_directory(no_file);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expect_unread(read(Reads::program, no_file), no_file + ": is a directory, not a file");
  expect_unread(read(Reads::stimulus, no_file), no_file + "/stimulus.stim: no such file");
  expect_unread(read(Reads::checkpoint, no_file), no_file + ": cannot write: Is a directory");
  // None of these may wait for somebody to write into the pipe.
  for (const std::string& path : {pipe, std::string("/dev/full"), std::string("/dev/zero")}) {
    expect_unread(read(Reads::program, path), path + ": is not a regular file");
    expect_unread(read(Reads::stimulus, path), path + ": is not a regular file");
    expect_unread(read(Reads::checkpoint, path), path + ": no checkpoint: not a regular file");
  }
}

TEST_F(Careless, OutputsThatAreNoFileAreSaid) {
  const std::string no_file = folder.path("folder");
  fs::create_directory(no_file);
  const auto line = [](const std::string& option, const std::string& path) {
    return cosim({"line", "--major", "5", "--minor", "1", option, path});
  };
  expect_unread(line("--wave", no_file), "--wave: " + no_file + " does not end in .fst");
  fs::create_directory(folder.path("w.fst"));
  expect_unread(line("--wave", folder.path("w.fst")),
                folder.path("w.fst") + ": cannot write: Is a directory");
  ASSERT_EQ(mkfifo(folder.path("pipe.fst").c_str(), 0600), 0);
  expect_unread(line("--wave", folder.path("pipe.fst")),
                "--wave: " + folder.path("pipe.fst") + " cannot be replaced by a file");
  // A wave takes the place of a link; what it led to is left alone.
  fs::create_symlink("/dev/full", folder.path("full.fst"));
  expect_match(line("--wave", folder.path("full.fst")));
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder.path("full.fst"))));
}

/// A file of 100 MB: a head, then `piece` again and again, then a tail. Written in parts, for the
/// memory of the test counts as the program's.
std::string write_huge(const Folder& folder, const std::string& head, const std::string& piece,
                       const std::string& tail) {
  constexpr std::size_t size = 100'000'000, part = 100'000;
  std::string many;
  while (many.size() < part) many += piece;
  std::ofstream file(folder.path("huge"), std::ios::binary);
  file << head;
  for (std::size_t written = 0; written < size; written += many.size()) file << many;
  file << tail;
  return folder.path("huge");
}

// The file, its longest line, and the program.
constexpr long most_memory = 600'000'000 + test::kept_back;

TEST_F(Careless, ProgramsOfHugeLinesAreReadInBoundedMemory) {
  const auto huge = [&](const std::string& head, const std::string& piece,
                        const std::string& tail = "") {
    const Ended ended = read(Reads::program, write_huge(folder, head, piece, tail));
    EXPECT_LT(ended.peak, most_memory) << head << piece;
    return ended;
  };
  const std::string place = folder.path("huge") + ":1:";
  expect_match(huge("G0 X1 (", "x", ")\n"));
  expect_match(huge("G0 X1", " \t", "Y2"));
  expect_match(huge("G0 X1", "\r\n"));
  expect_match(huge("G0 X1.", "1"));
  expect_unread(huge("G0 X", "1"), place + "4: the number of X is out of range");
  expect_unread(huge("", "X"), place + "1: X needs a number");
  expect_unread(huge("G0 ", "X1 "), place + "7: X is given twice in the block");
  expect_unread(huge("", "("), place + "1: the comment is not closed on its line");
}

TEST_F(Careless, StimuliOfHugeLinesAreReadInBoundedMemory) {
  const std::string good = good_stimulus;
  const auto huge = [&](const std::string& before, const std::string& head,
                        const std::string& piece) {
    const std::size_t at = good.find(before);
    const Ended ended = read(Reads::stimulus, write_huge(folder, good.substr(0, at) + head, piece,
                                                         '\n' + good.substr(at)));
    EXPECT_LT(ended.peak, most_memory) << head << piece;
    return ended;
  };
  const std::string place = folder.path("huge") + ":";
  expect_match(huge("clock", "# ", "a "));
  expect_match(huge("clock", "origin ", "a "));
  expect_match(huge("clock", "", " "));
  expect_match(huge("clock", "", "\n"));
  expect_unread(huge("cosim", "", "x"), place + "1: is not 'cosim stimulus 1'");
  expect_unread(huge("machine", "", "a "), place + "2: more than 10000 words in a line");
  expect_unread(huge("machine", "machine ", "a"), place + "2: no machine 'aaaa");
  expect_unread(huge("clock", "", "a "), place + "4: more than 10000 words in a line");
  expect_unread(huge("clock", "state ", "a"), place + "4: 'aaaa");
  expect_unread(huge("3-9", "", "a "), place + "8: more than 10000 words in a line");
  expect_unread(huge("3-9", "3 1 0 0 0 0 ", "1"), place + "8: data: '1111");
}

TEST_F(Careless, CheckpointsOfHugeSizeAreRefused) {
  for (const char* piece : {"[", "x", "[],", " "}) {
    const std::string path = write_huge(folder, "{\"state\":[", piece, "]}");
    const Ended ended = read(Reads::checkpoint, path);
    expect_unread(ended, path + ": no checkpoint: larger than 4 MiB");
    EXPECT_LT(ended.peak, most_memory);
  }
}

}  // namespace
}  // namespace cosim::cli
