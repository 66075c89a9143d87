// Sets up windows for pictures of the editor.
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

/// Throws if a picture cannot be made.
void expect(bool holds, const QString& what);

/// A window of a given size with the default layout, and operations on it for a picture. Its files are in a
/// folder that programs take for the user's home, so that no picture shows real paths.
class Stage {
 public:
  explicit Stage(QSize size = {1600, 1000});
  ~Stage();

  editor::MainWindow& window() { return *window_; }
  QPixmap picture() { return window_->grab(); }
  /// Creates a file in the home folder, and returns its path.
  QString add(const char* name, const QByteArray& bytes) const;

  void open(const QString& file);
  void act(const QString& name);
  /// Opens a sample with the render camera, in the display mode BRDF.
  void open_as_rendered(const QString& file);
  void draw_as(editor::DisplayMode mode);
  /// Orbits away from the render camera, so that it is visible.
  void orbit(double to_the_right, double upwards, double nearer);
  /// Clicks at a position of the view, in fractions of its size, and grows the selection by rings.
  void select_patch(QPointF place, int rings);
  /// Opens the spheres of all models, with faces of one selected.
  void show_models();
  void show_brdf(editor::BrdfEditor::View view);
  /// Shows a dock, in front of others that are tabbed with it.
  QDockWidget& dock(const QString& name);
  void hide_docks(const QStringList& names);
  void hide_all_docks();
  /// Opens a scene with a misspelt name, and goes to the location of its message.
  void show_mistake();
  /// Runs a preview until it is done.
  void preview(QSize size, int samples);
  /// Renders the image file with `bpt`.
  void render(QSize size, int samples);

  /// Waits until the view is drawn in full and no work is running.
  void settle();

 private:
  void take_settings(QSize size, int samples);

  test::TemporaryFolder folder_;
  std::unique_ptr<editor::MainWindow> window_;
};

}  // namespace screenshots
