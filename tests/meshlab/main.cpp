// SPDX-License-Identifier: GPL-3.0-or-later
// An application, as plugins expect one, in the locale of the environment, as MeshLab's is.
#include <gtest/gtest.h>

#include <QApplication>

#include <clocale>

int main(int argc, char **argv) {
  ::testing::InitGoogleTest(&argc, argv);
  QApplication application(argc, argv);
  if (const char *locale = std::getenv("VBM_TEST_LOCALE")) {
    if (!std::setlocale(LC_ALL, locale)) {
      std::printf("the locale %s is not there\n", locale);
      return 1;
    }
    QLocale::setDefault(QLocale(QString(locale)));
  }
  return RUN_ALL_TESTS();
}
