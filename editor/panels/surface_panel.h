#pragma once

#include <QWidget>
#include <vector>

#include "editor/document/document.h"
#include "grf/catalogue.h"

class QLabel;
class QStackedWidget;

namespace editor {

class SurfaceRow;

/// Shows and edits the surface of the selected faces. A BRDF that is dropped on it is assigned to them.
class SurfacePanel : public QWidget {
  Q_OBJECT

 public:
  /// Document and catalogue outlive the panel.
  SurfacePanel(Document& document, const grf::Catalogue& catalogue, QWidget* parent = nullptr);

  /// Copies the whole surface of a face to the selected faces, or only its BRDF if that was requested last.
  /// Definitions that are not in scope of all selected faces are written out.
  void take_from(FaceId face);

  QSize sizeHint() const override;

 signals:
  /// Requests the BRDF editor for the selected faces.
  void brdf_edit_requested();
  /// Requests that the next clicked face is passed to `take_from`.
  void pick_requested();
  /// Requests baking of irradiance at the vertices of the scene.
  void bake_requested();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* make_rows();
  QWidget* make_header();
  void show_selection();
  void report(const QString& problem);

  enum class Picks { All, Brdf };

  Document& document_;
  const grf::Catalogue& catalogue_;
  Picks picks_ = Picks::All;
  QStackedWidget* pages_;
  QLabel* count_ = nullptr;
  QLabel* area_ = nullptr;
  QLabel* problem_ = nullptr;
  std::vector<SurfaceRow*> rows_;
};

}  // namespace editor
