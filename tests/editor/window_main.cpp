// Runs tests of windows on a screen of their own, so that no test sees what another one left.
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/editor/own_application.h"

// Of LeakSanitizer, where it is linked in.
extern "C" [[gnu::weak]] void __lsan_do_leak_check();  // NOLINT: the sanitizer's name

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  test::OwnScreen screen;
  const auto application = test::application_on(screen, {1920, 1200}, argc, argv);
  if (application == nullptr) return EXIT_FAILURE;
  const int result = RUN_ALL_TESTS();
  // While the drivers of OpenGL are there: what they keep looks lost once they are unloaded with the
  // application.
  if (__lsan_do_leak_check != nullptr) __lsan_do_leak_check();
  return result;
}
