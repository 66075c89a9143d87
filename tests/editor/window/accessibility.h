// Checks of windows: every visible control has a name and a tool tip, and Tab reaches it.
#pragma once

#include <set>
#include <string>

#include <gtest/gtest.h>

class QWidget;

namespace editor {

/// Checks that Tab reaches everything visible, dock after dock, and Shift+Tab the reverse.
void expect_tab_leads_to_all(QWidget& start);

/// Settings are empty at first.
class Accessibility : public testing::Test {
 protected:
  Accessibility();

  /// Checks that visible controls have names and tool tips, and are reached by Tab.
  void check_controls(QWidget& window);
  /// Checks each tab of the window.
  void check_tabs(QWidget& window);

 private:
  std::set<std::string> seen_;
};

}  // namespace editor
