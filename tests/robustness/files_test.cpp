// SPDX-License-Identifier: GPL-3.0-or-later
// Readers of ball files under a rain of damage: bytes flipped, cut, repeated, numbers made huge. A file is
// read or refused with a sentence; what is read can be written and read again. Meant for sanitizers.
#include <files/ball_file.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace {

using vbm::files::BallFile;

uint64_t next(uint64_t &state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return state >> 33;
}

BallFile sample() {
  BallFile balls;
  for (int i = 0; i < 12; ++i) {
    balls.centers.insert(balls.centers.end(), {i * .1, 1. / (i + 1), -1e9 * i});
    balls.radii.push_back(.5 + i);
  }
  balls.triangles = {0, 1, 2, 3, 4, 5};
  balls.edges = {6, 7, 8, 9};
  return balls;
}

bool same(const BallFile &a, const BallFile &b) {
  return a.centers == b.centers && a.radii == b.radii && a.triangles == b.triangles &&
         a.edges == b.edges && a.attributes == b.attributes;
}

std::string damaged(std::string bytes, uint64_t &state) {
  static const char *const kWords[] = {"4294967295", "-1", "1e999",  "nan", "99999999999999999999",
                                       "\n",         " ",  "\r",     "#",   "list",
                                       "\0\0\0\0",   ",",  "vertex", "0x1", "property list uint int q\n"};
  for (uint64_t times = 1 + next(state) % 3; times--;) {
    const std::size_t at = bytes.empty() ? 0 : next(state) % bytes.size();
    switch (next(state) % 6) {
    case 0:
      if (!bytes.empty()) bytes[at] = char(next(state));
      break;
    case 1:
      bytes.resize(at);
      break;
    case 2:
      bytes.insert(at, kWords[next(state) % (sizeof kWords / sizeof *kWords)]);
      break;
    case 3:
      bytes.erase(at, next(state) % 20);
      break;
    case 4:
      bytes.insert(at, bytes.substr(next(state) % (bytes.size() + 1), next(state) % 60));
      break;
    default:
      for (std::size_t i = at; i < bytes.size() && i < at + 4; ++i) bytes[i] = '\xff';
    }
  }
  return bytes;
}

const char *const kBigEndian = "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\n"
                               "property float y\nproperty float z\nproperty float radius\nproperty int part\n"
                               "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

const char *const kAscii = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                           "property float z\nproperty list uchar int odd\nproperty float radius\n"
                           "property int level\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
                           "end_header\n1 2 3 2 7 8 4 5\n1 2 3 0 4 5\n0 1\n";

TEST(Files, DamageIsReadOrRefused) {
  BallFile plain = sample();
  plain.triangles.clear();
  plain.edges.clear();
  plain.attributes["part"] = std::vector<int32_t>(12, 3);
  std::string big = kBigEndian;
  big += std::string("\x3f\x80\0\0\x3f\x80\0\0\x3f\x80\0\0\x3f\x80\0\0\0\0\0\x02", 20) +
         std::string("\x03\0\0\0\0\0\0\0\0\0\0\0\0", 13);
  const struct {
    std::string extension, bytes;
  } seeds[] = {{".ply", format_balls(sample(), ".ply")}, {".ma", format_balls(sample(), ".ma")},
               {".csv", format_balls(plain, ".csv")},    {".ply", format_balls(plain, ".ply")},
               {".ply", big},                            {".ply", kAscii}};
  uint64_t state = 7;
  std::size_t read = 0, refused = 0;
  for (const auto &[extension, bytes] : seeds) {
    ASSERT_NO_THROW(vbm::files::parse_balls(bytes, extension)) << extension;
    for (int i = 0; i < 20000; ++i) {
      const std::string hurt = damaged(bytes, state);
      try {
        const BallFile balls = vbm::files::parse_balls(hurt, extension);
        ++read;
        ASSERT_EQ(balls.centers.size(), 3 * balls.radii.size());
        ASSERT_LE(balls.radii.size() + balls.triangles.size() / 3, hurt.size());
        ASSERT_TRUE(same(vbm::files::parse_balls(format_balls(balls, ".ply"), ".ply"), balls));
      } catch (const vbm::files::BadFile &error) {
        ++refused;
        ASSERT_NE(std::string(error.what()), "");
        ASSERT_LT(std::string(error.what()).size(), 400u);
      }
    }
  }
  std::printf("%zu read, %zu refused\n", read, refused);
  EXPECT_GT(read, 5000u);
  EXPECT_GT(refused, 20000u);
}

TEST(Files, EveryPrefix) {
  for (const char *extension : {".ply", ".ma"}) {
    const std::string bytes = format_balls(sample(), extension);
    for (std::size_t size = 0; size + 1 < bytes.size(); ++size)
      EXPECT_THROW(vbm::files::parse_balls(bytes.substr(0, size), extension), vbm::files::BadFile)
          << extension << " " << size;
  }
}

} // namespace
