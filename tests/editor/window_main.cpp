// Runs tests of windows on a separate virtual screen, isolated from other tests. The environment may ask for
// the light theme (GRANADA_THEME=light), or a display of 200 % (QT_SCALE_FACTOR=2).
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/editor/own_application.h"

// From LeakSanitizer, if it is linked.
extern "C" [[gnu::weak]] void __lsan_do_leak_check();  // NOLINT: the sanitizer's name

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  test::OwnScreen screen;
  const int scale = qMax(1, qRound(qEnvironmentVariable("QT_SCALE_FACTOR").toDouble()));
  const auto application = test::application_on(screen, QSize(1920, 1200) * scale, argc, argv);
  if (application == nullptr) return EXIT_FAILURE;
  if (qEnvironmentVariable("GRANADA_THEME") == "light") editor::apply(editor::Theme::Light, *application);
  const int result = RUN_ALL_TESTS();
  // Checks before the OpenGL drivers are unloaded with the application, since their allocations would look
  // leaked.
  if (__lsan_do_leak_check != nullptr) __lsan_do_leak_check();
  return result;
}
