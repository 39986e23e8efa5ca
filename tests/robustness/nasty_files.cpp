// SPDX-License-Identifier: GPL-3.0-or-later
#include "nasty_files.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace fs = std::filesystem;

namespace {

std::string write_files() {
  const char *shared = std::getenv("VBM_SHARED");
  const fs::path script =
      fs::path(shared ? shared : VBM_SOURCE_DIR "/../shared") / "nasty/make_nasty.py";
  if (!fs::exists(script)) return "";
  const fs::path folder = fs::path(VBM_BINARY_DIR) / "nasty";
  if (fs::exists(folder / "INDEX.tsv")) return folder;
  // Under another name first: somebody else may be doing the same.
  const fs::path fresh = folder.string() + "." + std::to_string(getpid());
  const std::string command =
      "'" VBM_PYTHON3 "' '" + script.string() + "' '" + fresh.string() + "' >/dev/null";
  if (std::system(command.c_str()) != 0) return "";
  std::error_code taken;
  fs::rename(fresh, folder, taken);
  if (taken) fs::remove_all(fresh);
  return folder;
}

} // namespace

const std::string &nasty_folder() {
  static const std::string folder = write_files();
  return folder;
}

std::vector<std::string> nasty_index(const std::string &prefix) {
  std::vector<std::string> files;
  std::ifstream index(nasty_folder() + "/INDEX.tsv");
  for (std::string line; std::getline(index, line);)
    if (line.rfind(prefix, 0) == 0) files.push_back(line.substr(0, line.find('\t')));
  return files;
}
