// What pictures of the editor are taken of.
#pragma once

#include <QPixmap>
#include <QString>
#include <memory>

#include "editor/brdf/brdf_editor.h"
#include "editor/view/scene_view.h"
#include "editor/window/main_window.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

class QDockWidget;

namespace screenshots {

const QString Samples = GRANADA_SOURCE_DIR "/samples/";
constexpr int Minute = 60'000;  // in milliseconds

/// A picture that is not made is a failure of the whole.
void expect(bool holds, const QString& what);

/// A window of a size with the layout of its first start, and what is done to it for a picture. Its files are
/// in a folder that programs take for the user's own, so that no picture shows where they really are.
class Stage {
 public:
  explicit Stage(QSize size = {1600, 1000});
  ~Stage();

  editor::MainWindow& window() { return *window_; }
  QPixmap picture() { return window_->grab(); }
  /// Makes a file in the user's folder, and gives its path.
  QString add(const char* name, const QByteArray& bytes) const;

  void open(const QString& file);
  void act(const QString& name);
  /// A sample as its render sees it, with its BRDFs.
  void open_as_rendered(const QString& file);
  void draw_as(editor::DisplayMode mode);
  /// Away from where the camera of renders is, so that it is seen.
  void orbit(double to_the_right, double upwards, double nearer);
  /// A click at a place of the view, in parts of its size, and rings of neighbours around the face.
  void select_patch(QPointF place, int rings);
  /// Spheres of all models, with faces of one selected.
  void show_models();
  void show_brdf(editor::BrdfEditor::View view);
  /// Shows a dock, over others at its place.
  QDockWidget& dock(const QString& name);
  void hide_docks(const QStringList& names);
  /// A scene with a mistake in a name, and where the message of it leads to.
  void show_mistake();
  /// A preview until it is done.
  void preview(QSize size, int samples);
  /// The image of a file by `bpt`.
  void render(QSize size, int samples);

  /// Until the view is drawn in full and no work is under way.
  void settle();

 private:
  void take_settings(QSize size, int samples);

  test::TemporaryFolder folder_;
  std::unique_ptr<editor::MainWindow> window_;
};

}  // namespace screenshots
