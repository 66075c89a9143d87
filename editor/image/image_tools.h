#pragma once

#include <QList>
#include <QWidget>
#include <functional>
#include <optional>

#include "editor/image/image_figures.h"
#include "editor/image/image_pane.h"

class QAction;
class QComboBox;
class QToolBar;

namespace editor {

class ImageSelection;
class ScreenControls;

enum class Comparison { None, Wipe, SideBySide, Signed, Absolute, Relative };

/// The controls of the image view, in two rows: what can be done, and which images are shown. Their keys work
/// in the pane alone, so that they stand in nobody's way.
class ImageTools : public QWidget {
  Q_OBJECT

 public:
  explicit ImageTools(ImagePane& pane, QWidget* parent = nullptr);

  ScreenControls& controls() const { return *controls_; }
  void show_selection(const ImageSelection& selection);

  Comparison comparison() const;
  void set_comparison(Comparison comparison);
  /// Returns how the pane arranges two images, given that there is one to compare with.
  Arrangement arrangement() const;
  /// The kind of difference that is shown, if any.
  std::optional<Difference> difference() const;

  QAction* open = nullptr;
  QAction* save = nullptr;
  QAction* copy = nullptr;
  QAction* remove = nullptr;
  QAction* flip = nullptr;  ///< stays pressed
  QAction* swap = nullptr;
  QList<QAction*> of_view;  ///< they work on the pane themselves

 signals:
  void image_chosen(const QString& name);
  void reference_chosen(const QString& name);  ///< empty: none
  void comparison_changed();

 private:
  QAction* add_action(const QString& icon_name, const QString& text, const QString& help,
                      const QKeySequence& key, const std::function<void()>& work = {});
  void make_actions();
  void add_keys();
  QToolBar* make_bar();
  QToolBar* make_actions_row();
  QToolBar* make_comparison_row();

  ImagePane& pane_;
  ScreenControls* controls_;
  QComboBox* images_ = nullptr;
  QComboBox* references_ = nullptr;
  QComboBox* comparison_ = nullptr;
};

}  // namespace editor
