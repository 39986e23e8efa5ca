// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/bytes.h"

#include "files/ball_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <system_error>

#ifndef _WIN32
#include <unistd.h>
#endif

namespace vbm::files {
namespace {

namespace fs = std::filesystem;

/// Names tried for the file that is written first: others' may be left from a crash.
constexpr int kNames = 100;

/// The mode of a file that may be replaced; nothing where there is none.
std::optional<fs::perms> replaceable(const fs::path &path, const fs::path &given) {
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  if (!fs::exists(status)) return {};
  if (fs::is_directory(status)) throw NoFile(EISDIR, given);
  if (!fs::is_regular_file(status))
    throw BadFile(given.filename().u8string() +
                  ": a device, pipe or socket is not replaced by a file");
#ifndef _WIN32
  if (access(path.c_str(), W_OK) != 0) throw NoFile(errno ? errno : EACCES, given);
#endif
  return status.permissions();
}

std::FILE *open(const fs::path &path, const char *mode) {
  errno = 0;
#ifdef _WIN32
  const std::wstring wide(mode, mode + std::strlen(mode));
  return _wfopen(path.c_str(), wide.c_str());
#else
  return std::fopen(path.c_str(), mode);
#endif
}

struct Close {
  void operator()(std::FILE *file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

} // namespace

NoFile::NoFile(int code, std::filesystem::path path)
    : std::runtime_error(path.u8string() + ": " + std::generic_category().message(code)),
      code(code), path(std::move(path)) {}

std::string read_bytes(const fs::path &path,
                       const std::function<void(std::string_view head, uint64_t size)> &check) {
  std::error_code failed;
  if (fs::is_directory(path, failed)) throw NoFile(EISDIR, path);
  const File file(open(path, "rb"));
  if (!file) throw NoFile(errno ? errno : EIO, path);
  std::string bytes;
  const auto size = fs::file_size(path, failed); // not known of pipes
  const bool known = !failed;
  char block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
    if (bytes.empty() && known) {
      check({block, count}, std::max<uint64_t>(size, count));
      if (size < bytes.max_size()) bytes.reserve(std::size_t(size) + 1);
    }
    bytes.append(block, count);
  }
  if (std::ferror(file.get())) throw NoFile(errno ? errno : EIO, path);
  return bytes;
}

void write_bytes(const fs::path &given, const std::string &bytes) {
  std::error_code failed;
  // What a link points to is replaced, not the link.
  const fs::path path = fs::is_symlink(given, failed) ? fs::weakly_canonical(given) : given;
  const std::optional<fs::perms> mode = replaceable(path, given);
  // A short name of its own: the target's with an addition might be too long.
  fs::path beside;
  File file;
  for (int i = 0; i < kNames && !file; ++i) {
    beside = path.parent_path() / (".vbm-" + std::to_string(i) + ".part");
    file.reset(open(beside, "wbx"));
    if (!file && errno != EEXIST) throw NoFile(errno ? errno : EIO, given);
  }
  if (!file) throw NoFile(EEXIST, beside);
  errno = 0;
  bool good = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  good = std::fflush(file.get()) == 0 && good;
  int code = errno;
  if (std::fclose(file.release()) != 0 && good) good = false, code = errno;
  if (good && mode) fs::permissions(beside, *mode, failed); // as it was, if this may be
  if (good) {
    fs::rename(beside, path, failed);
    good = !failed;
    code = failed.value();
  }
  if (!good) {
    std::error_code ignored;
    fs::remove(beside, ignored);
    throw NoFile(code ? code : EIO, given);
  }
}

} // namespace vbm::files
