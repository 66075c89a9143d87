#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <optional>

#include "editor/window/lesson.h"

class QAction;

namespace editor {

class LessonGuide;
class MainWindow;
class Pages;
class WelcomePage;

/// The page Welcome and the lessons that start there.
class WelcomeController : public QObject {
  Q_OBJECT

 public:
  /// Window and pages outlive the controller. Without a folder of samples the page offers none.
  WelcomeController(MainWindow& window, Pages& pages, const QString& samples);

  /// Shows the page, which is created on first use.
  void show_page();
  QAction* action() const { return action_; }
  /// Starts a lesson by its number, after it has opened a sample if the lesson needs a scene and there is
  /// none.
  void start_lesson(int lesson);
  /// The guide of the lessons, if one was started.
  LessonGuide* guide() const { return guide_; }

 private:
  void begin_lesson();
  void close_page();

  MainWindow& window_;
  Pages& pages_;
  const QString samples_;
  QAction* action_;
  QPointer<WelcomePage> page_;
  LessonGuide* guide_ = nullptr;
  std::optional<Lesson> next_;  ///< begins once its scene is there
};

}  // namespace editor
