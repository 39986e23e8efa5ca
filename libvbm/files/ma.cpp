// SPDX-License-Identifier: GPL-3.0-or-later
// Medial meshes as Q-MAT and the programs after it exchange them (Li et al., "Q-MAT: computing
// medial axis transform by quadratic error minimization", 2015): a line of counts, then a line for
// every vertex, edge and face. Further columns, which some of them write, are skipped; so are empty
// lines and comments (#). Lines may be in any order.
#include "files/formats.h"
#include "files/text.h"

#include <algorithm>
#include <array>

namespace vbm::files {
namespace {

/// Bytes that the shortest line of a vertex, an edge, a face takes.
constexpr uint64_t kShortest[] = {9, 5, 7};
constexpr const char *kNames[] = {"vertices", "edges", "faces"};

using Counts = std::array<uint64_t, 3>;

/// Of the first line, with `left` bytes after it.
Counts read_counts(const std::vector<std::string_view> &words, std::size_t line, uint64_t left) {
  if (words.size() < 2 || words.size() > 3)
    bad_line(line, "the first line must be the numbers of vertices, edges and faces");
  Counts counts{};
  for (std::size_t i = 0; i < words.size(); ++i)
    counts[i] = whole_number(words[i], line, "a number of elements");
  for (std::size_t i = 0; i < 3; ++i) {
    if (counts[i] > (left + 1) / kShortest[i] || counts[i] > INT32_MAX)
      bad_line(line, std::to_string(counts[i]) + " " + kNames[i] +
                         " are announced, more than the file has room for");
    left -= std::min(left, counts[i] * kShortest[i]);
  }
  return counts;
}

/// The words of a line, without comments.
void words_of(const Lines &lines, std::vector<std::string_view> &words) {
  split_words(lines.line(), words);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i].front() == '#') words.resize(i);
}

/// The edges, and the sides of faces that are not among them: readers of medial meshes expect every
/// side.
std::vector<int32_t> all_edges(const BallFile &balls) {
  const auto side = [](int32_t a, int32_t b) {
    return std::array<int32_t, 2>{std::min(a, b), std::max(a, b)};
  };
  std::vector<std::array<int32_t, 2>> given, more;
  for (std::size_t i = 0; i < balls.edges.size(); i += 2)
    given.push_back(side(balls.edges[i], balls.edges[i + 1]));
  std::sort(given.begin(), given.end());
  for (std::size_t i = 0; i < balls.triangles.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto s = side(balls.triangles[i + k], balls.triangles[i + (k + 1) % 3]);
      if (s[0] != s[1] && !std::binary_search(given.begin(), given.end(), s)) more.push_back(s);
    }
  std::sort(more.begin(), more.end());
  more.erase(std::unique(more.begin(), more.end()), more.end());
  std::vector<int32_t> edges = balls.edges;
  for (const auto &s : more) edges.insert(edges.end(), s.begin(), s.end());
  return edges;
}

} // namespace

void check_ma_head(std::string_view head, uint64_t total) {
  std::vector<std::string_view> words;
  for (Lines lines(head); lines.next();) {
    words_of(lines, words);
    if (words.empty()) continue;
    if (lines.position() < head.size() || head.size() == total)
      read_counts(words, lines.number(), total - lines.position());
    return;
  }
}

BallFile read_ma(const std::string &bytes) {
  BallFile balls;
  Counts announced{};
  std::size_t header_line = 0;
  std::vector<std::string_view> words;
  std::vector<std::size_t> edge_lines, face_lines;
  std::vector<std::string_view>
      corners; // of edges, then of faces: checked when all balls are known
  std::vector<std::string_view> face_corners;
  for (Lines lines(bytes); lines.next();) {
    words_of(lines, words);
    if (words.empty()) continue;
    const std::size_t n = lines.number();
    if (!header_line) {
      announced = read_counts(words, n, bytes.size() - lines.position());
      balls.centers.reserve(3 * announced[0]);
      balls.radii.reserve(announced[0]);
      header_line = n;
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
  if (!header_line) bad_line(1, "the file is empty");
  const std::array<std::size_t, 3> found = {balls.radii.size(), edge_lines.size(),
                                            face_lines.size()};
  for (std::size_t i = 0; i < 3; ++i)
    if (found[i] != announced[i])
      bad_line(header_line, std::to_string(announced[i]) + " " + kNames[i] +
                                " are announced, but there are " + std::to_string(found[i]));
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
  const std::vector<int32_t> edges = all_edges(balls);
  for (const std::size_t count : {balls.radii.size(), edges.size() / 2, balls.triangles.size() / 3})
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
  lists("e ", edges, 2);
  lists("f ", balls.triangles, 3);
  return out;
}

} // namespace vbm::files
