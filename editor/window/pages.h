#pragma once

#include <QString>
#include <QTabWidget>

#include "grf/scene.h"
#include "grf/source_location.h"

namespace editor {

class SceneComparison;
class SourceView;

/// The pages in the middle of the window: the scene, and others that are created on first use and can be
/// closed.
class Pages : public QTabWidget {
  Q_OBJECT

 public:
  explicit Pages(QWidget* parent = nullptr);

  /// Adds the first page, which cannot be closed.
  void add_scene(QWidget* page);
  /// Goes to a page, which is added if necessary.
  void show_page(QWidget& page, const QString& title, const QString& tip);
  void show_source(const grf::SourceLocation& location);
  /// Shows the differences between a scene and its file.
  void show_differences(const grf::Scene& scene, const QString& path);

 private:
  SceneComparison* comparison_ = nullptr;
  SourceView* source_ = nullptr;
};

}  // namespace editor
