#pragma once

#include <QScrollArea>
#include <QStringList>
#include <vector>

#include "editor/window/lesson.h"
#include "editor/window/sample_scenes.h"

class QCheckBox;
class QVBoxLayout;

namespace editor {

/// The first page of a session: recent files, sample scenes with their pictures, and lessons.
class WelcomePage : public QScrollArea {
  Q_OBJECT

 public:
  WelcomePage(const std::vector<SampleScene>& samples, const std::vector<Lesson>& lessons,
              QWidget* parent = nullptr);

  /// Lists files; those that do not exist are disabled.
  void show_recent(const QStringList& files);
  void set_shown_at_start(bool is_shown);

 signals:
  void new_requested();
  void open_requested();
  void file_chosen(const QString& file);
  /// Emitted with the number of a lesson, from 0.
  void lesson_chosen(int lesson);
  void shown_at_start_changed(bool is_shown);

 private:
  QWidget* make_start();
  QWidget* make_lessons(const std::vector<Lesson>& lessons);
  QWidget* make_samples(const std::vector<SampleScene>& samples);

  QVBoxLayout* recent_ = nullptr;
  QCheckBox* at_start_ = nullptr;
};

}  // namespace editor
