#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/light_edits.h"

class QLabel;
class QStackedWidget;
class QToolButton;
class QTreeWidget;

namespace editor {

class ColourFields;
class NumberBox;

/// All that emits in a scene with its power, and the corner, edges and radiance of the light that is chosen.
class LightPanel : public QWidget {
  Q_OBJECT

 public:
  /// The document outlives the panel.
  explicit LightPanel(Document& document, QWidget* parent = nullptr);

  /// Chooses what emits at a place, if something does.
  void choose(grf::ScenePathView path);
  /// Adds a light over the scene that shines down, and chooses it.
  void add();

  QSize sizeHint() const override;

 signals:
  /// A light was chosen in the list.
  void chosen(const grf::ScenePath& path);

 private:
  QWidget* make_form();
  void connect_form();
  QWidget* make_buttons();
  void show_lights();
  bool concerns_lights(const Change& change) const;
  void show_chosen();
  void choose_item();
  void change(const QString& text, const grf::AreaLight& light, const QString& key);
  void change_power(double power);
  void remove();
  const LightObject* chosen_light() const;
  const Emitter* chosen_emitter() const;

  Document& document_;
  std::vector<Emitter> emitters_;
  std::optional<grf::ScenePath> path_;  // of the chosen one
  QTreeWidget* list_;
  QStackedWidget* pages_;
  QLabel* hint_ = nullptr;  ///< while no light is chosen
  QLabel* about_ = nullptr;
  QLabel* problem_;
  QToolButton* remove_ = nullptr;
  std::array<std::array<NumberBox*, 3>, 3> vectors_{};  // corner, edge 1, edge 2
  ColourFields* radiance_ = nullptr;
  NumberBox* power_ = nullptr;
};

}  // namespace editor
