// A lesson leads through a task in the window, control by control.
#pragma once

#include <QRect>
#include <QString>
#include <functional>
#include <vector>

class QWidget;

namespace editor {

class MainWindow;

/// A control, or a part of it, that a lesson points at.
struct LessonTarget {
  QWidget* widget = nullptr;
  QRect part = {};  ///< in the widget's pixels; empty: all of it
};

/// A step of a lesson: what to do, where, and what shows that it was done.
struct LessonStep {
  QString text;
  /// Returns the control of the step. It shows the dock that the control is in.
  std::function<LessonTarget(MainWindow& window)> target;
  /// Called when the step begins. What it returns tells whether the step was done since then.
  std::function<std::function<bool()>(MainWindow& window)> begin;
};

struct Lesson {
  QString title;
  QString about;
  bool needs_scene = false;  ///< whether it begins with a sample if the scene is empty
  std::vector<LessonStep> steps;
};

/// Returns the lessons of the page Welcome, each a few steps long, in the order in which to take them.
std::vector<Lesson> lessons();

}  // namespace editor
