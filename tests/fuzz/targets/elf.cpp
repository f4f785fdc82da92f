// An executable: it is read, or refused in a line.
#include "model/core/elf.h"

#include "tests/fuzz/run.h"

namespace cosim::fuzz {

FUZZ_TARGET(elf) {
  static const Scratch scratch;
  static const std::string path = (scratch.path() / "program.elf").string();
  write(path, text);
  accepted(path, [&] {
    for (const Elf::Segment& s : read_elf(path).segments) {
      expect(s.bytes.size() <= text.size(), "a segment is not larger than the file");
    }
  });
}

}  // namespace cosim::fuzz
