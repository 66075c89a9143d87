#pragma once

#include <QWidget>
#include <vector>

#include "editor/document/document.h"
#include "grf/catalogue.h"

class QLabel;
class QStackedWidget;

namespace editor {

class SurfaceRow;

/// What the selected faces have, and giving them something else. A BRDF that is dropped on it is theirs.
class SurfacePanel : public QWidget {
  Q_OBJECT

 public:
  /// Document and catalogue outlive the panel.
  SurfacePanel(Document& document, const grf::Catalogue& catalogue, QWidget* parent = nullptr);

  /// Gives the selected faces what a face has: all of it, or its BRDF if that was asked for last. Definitions
  /// that are not in scope of all selected faces are written out.
  void take_from(FaceId face);

  QSize sizeHint() const override;

 signals:
  /// Opens the BRDF of the selected faces in the editor of BRDFs.
  void brdf_edit_requested();
  /// The next face that is clicked is to be given to `take_from`.
  void pick_requested();
  /// Irradiance is to be computed at the vertices of the scene.
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
