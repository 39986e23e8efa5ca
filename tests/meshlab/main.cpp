// SPDX-License-Identifier: GPL-3.0-or-later
// An application, as plugins expect one, in the locale of the environment, as MeshLab's is. With
// --script and a filter's name it prints that filter as a step of a MeshLab script, and tests
// nothing.
#include "host.h"

#include <gtest/gtest.h>

#include <QApplication>

#include <clocale>
#include <cstdio>
#include <string>

int main(int argc, char **argv) {
  ::testing::InitGoogleTest(&argc, argv);
  QApplication application(argc, argv);
  if (argc == 3 && std::string(argv[1]) == "--script") {
    MeshDocument document;
    std::puts(host::script(argv[2], document).c_str());
    return 0;
  }
  if (const char *locale = std::getenv("VBM_TEST_LOCALE")) {
    if (!std::setlocale(LC_ALL, locale)) {
      std::printf("the locale %s is not there\n", locale);
      return 1;
    }
    QLocale::setDefault(QLocale(QString(locale)));
  }
  return RUN_ALL_TESTS();
}
