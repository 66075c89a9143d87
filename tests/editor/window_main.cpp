// Runs tests of windows on a screen of their own, so that no test sees what another one left.
#include <QApplication>
#include <cstdlib>
#include <iostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/appearance/theme.h"
#include "tests/editor/own_screen.h"

// Of LeakSanitizer, where it is linked in.
extern "C" [[gnu::weak]] void __lsan_do_leak_check();  // NOLINT: the sanitizer's name

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  test::OwnScreen screen;
  if (!screen.start({1920, 1200})) {
    std::cerr << "Xvfb cannot be started\n";
    return EXIT_FAILURE;
  }
  QApplication application(argc, argv);
  QApplication::setOrganizationName("granada");
  QApplication::setApplicationName("wannabe");
  editor::apply(editor::Theme::Dark, application);
  const int result = RUN_ALL_TESTS();
  // While the drivers of OpenGL are there: what they keep looks lost once they are unloaded with the
  // application.
  if (__lsan_do_leak_check != nullptr) __lsan_do_leak_check();
  return result;
}
