// SPDX-License-Identifier: GPL-3.0-or-later
// The fuzz target without libFuzzer: inputs that once failed, from files, and so many made up.
//   vbm_fuzz_replay COUNT [FILE...]
#include "shapes.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int main(int argc, char **argv) {
  for (int i = 2; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
    if (!file) return std::fprintf(stderr, "cannot read %s\n", argv[i]), 1;
    std::printf("%s\n", argv[i]);
    std::fflush(stdout);
    LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t *>(bytes.data()), bytes.size());
  }
  const long count = argc > 1 ? std::atol(argv[1]) : 0;
  for (long i = 0; i < count; ++i) {
    shapes::Random random{uint64_t(i)};
    std::vector<uint8_t> bytes(random.bits() % 700);
    for (uint8_t &b : bytes) b = uint8_t(random.bits());
    // For whoever looks at a failure: the input as a file.
    if (const char *name = std::getenv("VBM_FUZZ_LAST")) {
      std::ofstream file(name, std::ios::binary);
      file.write(reinterpret_cast<const char *>(bytes.data()), std::streamsize(bytes.size()));
    }
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  std::printf("%d files, %ld made up\n", argc > 2 ? argc - 2 : 0, count);
  return 0;
}
