// SPDX-License-Identifier: GPL-3.0-or-later
// Medial meshes as Q-MAT and the programs after it exchange them (Li et al., "Q-MAT: computing medial
// axis transform by quadratic error minimization", 2015): a line of counts, then a line for every
// vertex, edge and face. Further columns, which some of them write, are skipped; so are empty lines and
// comments (#). Lines may be in any order.
#include "files/formats.h"
#include "files/text.h"

#include <array>

namespace vbm::files {
namespace {

/// Bytes that the shortest line of a vertex, an edge, a face takes.
constexpr uint64_t kShortest[] = {9, 5, 7};
constexpr const char *kNames[] = {"vertices", "edges", "faces"};

} // namespace

BallFile read_ma(const std::string &bytes) {
  BallFile balls;
  std::array<uint64_t, 3> announced{};
  std::vector<std::string_view> words;
  std::vector<std::size_t> edge_lines, face_lines;
  std::vector<std::string_view> corners; // of edges, then of faces: checked when all balls are known
  std::vector<std::string_view> face_corners;
  bool header = false;
  for (Lines lines(bytes); lines.next();) {
    split_words(lines.line(), words);
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i].front() == '#') words.resize(i);
    if (words.empty()) continue;
    const std::size_t n = lines.number();
    if (!header) {
      if (words.size() < 2 || words.size() > 3)
        bad_line(n, "the first line must be the numbers of vertices, edges and faces");
      for (std::size_t i = 0; i < words.size(); ++i)
        announced[i] = whole_number(words[i], n, "a number of elements");
      uint64_t left = bytes.size() - lines.position();
      for (std::size_t i = 0; i < 3; ++i) {
        if (announced[i] > (left + 1) / kShortest[i] || announced[i] > INT32_MAX)
          bad_line(n, std::to_string(announced[i]) + " " + kNames[i] +
                          " are announced, more than the file has room for");
        left -= std::min(left, announced[i] * kShortest[i]);
      }
      balls.centers.reserve(3 * announced[0]);
      balls.radii.reserve(announced[0]);
      header = true;
      continue;
    }
    const auto at_least = [&](std::size_t count, const char *what) {
      if (words.size() <= count) bad_line(n, what);
    };
    if (words[0] == "v") {
      at_least(4, "a vertex needs x, y, z and a radius");
      for (std::size_t i = 1; i < 4; ++i)
        balls.centers.push_back(finite_number(words[i], n, "a coordinate"));
      balls.radii.push_back(radius_number(words[4], n));
    } else if (words[0] == "e") {
      at_least(2, "an edge needs two vertices");
      edge_lines.push_back(n);
      corners.insert(corners.end(), words.begin() + 1, words.begin() + 3);
    } else if (words[0] == "f") {
      at_least(3, "a face needs three vertices");
      face_lines.push_back(n);
      face_corners.insert(face_corners.end(), words.begin() + 1, words.begin() + 4);
    } else {
      bad_line(n, shown(words[0]) + " begins no line of a medial mesh: v, e or f do");
    }
  }
  if (!header) throw BadFile("the file is empty");
  const std::array<std::size_t, 3> found = {balls.radii.size(), edge_lines.size(),
                                            face_lines.size()};
  for (std::size_t i = 0; i < 3; ++i)
    if (found[i] != announced[i])
      throw BadFile(std::to_string(announced[i]) + " " + kNames[i] + " are announced, but there are " +
                    std::to_string(found[i]));
  for (std::size_t i = 0; i < corners.size(); ++i)
    balls.edges.push_back(
        index_below(corners[i], found[0], edge_lines[i / 2], "a vertex of the edge"));
  for (std::size_t i = 0; i < face_corners.size(); ++i)
    balls.triangles.push_back(
        index_below(face_corners[i], found[0], face_lines[i / 3], "a vertex of the face"));
  return balls;
}

std::string write_ma(const BallFile &balls) {
  std::string out;
  for (const std::size_t count :
       {balls.radii.size(), balls.edges.size() / 2, balls.triangles.size() / 3})
    out += (out.empty() ? "" : " ") + std::to_string(count);
  out += "\n";
  for (std::size_t i = 0; i < balls.radii.size(); ++i) {
    out += "v";
    for (std::size_t a = 0; a < 4; ++a) {
      out += " ";
      append_number(out, a < 3 ? balls.centers[3 * i + a] : balls.radii[i]);
    }
    out += "\n";
  }
  const auto lists = [&](const char *name, const std::vector<int32_t> &list, std::size_t width) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      out += i % width ? " " : name;
      append_number(out, int64_t(list[i]));
      if (i % width + 1 == width) out += "\n";
    }
  };
  lists("e ", balls.edges, 2);
  lists("f ", balls.triangles, 3);
  return out;
}

} // namespace vbm::files
