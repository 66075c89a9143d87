// The application of programs that show windows on a virtual screen.
#pragma once

#include <QApplication>
#include <iostream>
#include <memory>

#include "editor/appearance/theme.h"
#include "editor/jobs/job.h"
#include "tests/editor/own_screen.h"

namespace test {

/// Creates the editor's application, dark, on a virtual screen that is started for it and outlives it; null,
/// with a message, if the screen cannot be started. The application keeps `argc`.
inline std::unique_ptr<QApplication> application_on(OwnScreen& screen, QSize size, int& argc, char** argv) {
  if (!screen.start(size)) {
    std::cerr << "Xvfb cannot be started\n";
    return nullptr;
  }
  auto application = std::make_unique<QApplication>(argc, argv);
  QApplication::setOrganizationName("granada");
  QApplication::setApplicationName("wannabe");
  editor::leave_threads_to_painting();
  editor::apply(editor::Theme::Dark, *application);
  return application;
}

}  // namespace test
