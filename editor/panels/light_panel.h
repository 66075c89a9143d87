#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/lamp.h"
#include "editor/document/light_edits.h"

class QLabel;
class QStackedWidget;
class QToolButton;
class QTreeWidget;

namespace editor {

class LampForm;
class NumberBox;

/// Lists all emitters of a scene with their power, and edits the selected light: as a lamp, or corner and
/// edges of an area light that is no rectangle.
class LightPanel : public QWidget {
  Q_OBJECT

 public:
  /// The document outlives the panel.
  explicit LightPanel(Document& document, QWidget* parent = nullptr);

  /// Selects the emitter at a path, if there is one.
  void choose(grf::ScenePathView path);
  /// Adds a lamp above the scene, facing down, and selects it.
  void add(LampShape shape = LampShape::Rectangle);
  /// The selected lamp, if one is.
  std::optional<Lamp> lamp() const;
  /// Changes the selected lamp. Steps with the same key are merged until Document::finish_gesture.
  void change_lamp(const Lamp& lamp, const QString& title, const QString& key = {});

  QSize sizeHint() const override;

 signals:
  /// Emitted when a light is selected in the list.
  void chosen(const grf::ScenePath& path);
  /// See LampForm.
  void aim_requested();
  void highlight_requested();

 private:
  QWidget* make_form();
  QWidget* make_corner();
  QWidget* make_buttons();
  void show_lights();
  bool concerns_lights(const Change& change) const;
  void show_chosen();
  void choose_item();
  void change(const QString& text, const grf::AreaLight& light, const QString& key);
  void report(const grf::Diagnostics& diagnostics);
  void remove();
  const LightObject* chosen_light() const;
  const Emitter* chosen_emitter() const;

  Document& document_;
  std::vector<Emitter> emitters_;
  std::optional<grf::ScenePath> path_;  // of the chosen one
  QTreeWidget* list_;
  QStackedWidget* pages_;
  QLabel* hint_ = nullptr;  ///< shown while no light is selected
  QLabel* about_ = nullptr;
  QLabel* problem_;
  QToolButton* remove_ = nullptr;
  std::array<std::array<NumberBox*, 3>, 3> vectors_{};  // corner, edge 1, edge 2
  QWidget* corner_ = nullptr;                           ///< the form of these
  LampForm* form_ = nullptr;
};

}  // namespace editor
