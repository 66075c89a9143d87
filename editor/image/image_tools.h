#pragma once

#include <QList>
#include <QWidget>
#include <functional>
#include <optional>

#include "editor/image/image_pane.h"
#include "editor/image/image_statistics.h"

class QAction;
class QComboBox;
class QToolBar;

namespace editor {

class ImageSelection;
class ScreenControls;

enum class Comparison { None, Wipe, SideBySide, Signed, Absolute, Relative };

/// The controls of the image view, in two rows: actions, and the choice of images. Their shortcuts work only
/// in the pane, so that they do not clash with others.
class ImageTools : public QWidget {
  Q_OBJECT

 public:
  explicit ImageTools(ImagePane& pane, QWidget* parent = nullptr);

  ScreenControls& controls() const { return *controls_; }
  void show_selection(const ImageSelection& selection);

  Comparison comparison() const;
  void set_comparison(Comparison comparison);
  /// Returns how the pane arranges two images, if there is a reference.
  Arrangement arrangement() const;
  /// The kind of difference that is shown, if any.
  std::optional<Difference> difference() const;

  QAction* open = nullptr;
  QAction* save = nullptr;
  QAction* copy = nullptr;
  QAction* remove = nullptr;
  QAction* flip = nullptr;  ///< checkable
  QAction* swap = nullptr;
  QAction* next_layer = nullptr;
  QAction* previous_layer = nullptr;
  QList<QAction*> of_view;  ///< act on the pane directly

 signals:
  void image_chosen(const QString& name);
  void reference_chosen(const QString& name);  ///< empty for none
  void comparison_changed();
  void layer_chosen(const QString& name);  ///< empty for the image itself

 private:
  QAction* add_action(const QString& icon_name, const QString& text, const QString& help,
                      const QKeySequence& key, const std::function<void()>& work = {});
  void make_actions();
  void add_keys();
  void step_layer(int step);
  void show_layers(const ImageSelection& selection);
  QToolBar* make_bar();
  QToolBar* make_actions_row();
  QToolBar* make_comparison_row();

  ImagePane& pane_;
  ScreenControls* controls_;
  QComboBox* images_ = nullptr;
  QComboBox* references_ = nullptr;
  QComboBox* comparison_ = nullptr;
  QComboBox* layers_ = nullptr;
};

}  // namespace editor
