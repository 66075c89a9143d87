#pragma once

#include <QFrame>
#include <QTimer>
#include <functional>
#include <memory>

#include "editor/window/lesson.h"

class QLabel;
class QPushButton;

namespace editor {

/// Leads through a lesson: a card says what to do, and a frame marks the control. A step that was done is
/// followed by the next one. The user works in the window meanwhile, which nothing blocks.
class LessonGuide : public QFrame {
  Q_OBJECT

 public:
  /// The guide is drawn in front of the window, which outlives it.
  explicit LessonGuide(MainWindow& window);
  ~LessonGuide() override;

  void start(const Lesson& lesson);
  /// Ends the lesson and hides the guide.
  void end();

  /// The number of the step, from 0; the number of steps once all are done.
  int step() const { return step_; }
  bool is_running() const { return isVisibleTo(parentWidget()); }
  /// The part of the window that is marked, in its pixels; empty while none is.
  QRect marked() const;

 private:
  class Marker;

  void go_to(int step);
  void follow();
  void place(const QRect& target);

  MainWindow& window_;
  Lesson lesson_;
  int step_ = 0;
  LessonTarget target_;
  std::function<bool()> is_done_;
  QLabel* title_;
  QLabel* text_;
  // In the order of the tab key.
  QPushButton* close_;
  QPushButton* back_;
  QPushButton* next_;
  Marker* marker_;
  QTimer timer_;
};

}  // namespace editor
