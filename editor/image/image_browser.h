#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "editor/image/image_entry.h"
#include "editor/image/image_pane.h"

class QAction;
class QComboBox;
class QLabel;
class QToolBar;
class QToolButton;

namespace editor {

class ScaleBar;
class ScreenControls;

enum class Comparison { None, Wipe, SideBySide, Signed, Absolute, Relative };

/// Images of files and renders, one of which is shown, alone or against another one: the view, what it shows
/// and how, the values under the pointer, and figures. Files are read and written on threads.
class ImageBrowser : public QWidget {
  Q_OBJECT

 public:
  explicit ImageBrowser(QWidget* parent = nullptr);

  /// Adds images of files and shows the last one; a file that is open already is read again.
  void open_files(const QStringList& paths);
  /// Adds an image, or a new state of the one of that name. A new one is shown.
  void show_image(const QString& name, SharedImage image);
  /// As it is while its file is still being made: the same entry as that of `open_files`.
  void show_image_of(const QString& path, SharedImage image);
  void remove_image(const QString& name);
  /// Writes the image that is shown, in the format that the name means.
  void save_as(const QString& path);
  /// Puts what the view shows of the whole image on the clipboard.
  void copy() const;

  QStringList names() const;
  /// Selects by name; an empty reference is none.
  void select_image(const QString& name);
  void select_reference(const QString& name);
  void set_comparison(Comparison comparison);

  ImagePane& pane() { return *pane_; }
  ScreenControls& controls() { return *controls_; }
  /// The last one that was made; it belongs to what is shown once `analysed` came after the last change.
  const ImageAnalysis& analysis() const { return analysis_; }

  /// For menus. Their shortcuts work in the view alone, so that they stand in nobody's way.
  QAction* open_action() const { return open_; }
  QAction* save_action() const { return save_; }
  QAction* copy_action() const { return copy_; }
  const std::vector<QAction*>& view_actions() const { return view_actions_; }
  const std::vector<QAction*>& comparison_actions() const { return comparison_actions_; }

 signals:
  void opened(const QString& path);
  void saved(const QString& path);
  /// What is wrong with a file; the browser itself shows it too.
  void reported(const grf::Diagnostics& diagnostics);
  void analysed();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void make_actions();
  QAction* add_action(const QString& icon_name, const QString& text, const QString& help,
                      const QKeySequence& key);
  void add_keys();
  void lay_out();
  QToolBar* make_tools();
  QWidget* make_comparison_row();
  void ask_for_files();
  void ask_for_name();
  void take_loaded(const LoadedImage& loaded);
  void put(const ImageEntry& entry, bool is_wanted);
  QString name_of(const QString& path);
  ImageEntry* find(const QString& name);
  ImageEntry* image();
  ImageEntry* reference();
  void fill_lists();
  void show_selection();
  void show_on_pane();
  void start_analysis();
  void take_analysis(const ImageAnalysis& made);
  bool is_current(const ImageAnalysis& made);
  std::optional<Difference> difference() const;
  ScreenSettings screen_settings() const;
  void swap();
  void show_pixel(const std::optional<QPoint>& pixel);
  void say(const QString& problem);
  void say(const grf::Diagnostics& diagnostics);
  void colour_message();

  std::vector<ImageEntry> entries_;
  QString image_name_;
  QString reference_name_;
  ImageAnalysis analysis_;
  bool is_analysing_ = false;
  std::optional<QPoint> pixel_;

  ImagePane* pane_;
  ScreenControls* controls_;
  ScaleBar* scale_bar_;
  QComboBox* image_list_ = nullptr;
  QComboBox* reference_list_ = nullptr;
  QComboBox* comparison_ = nullptr;
  QLabel* zoom_ = nullptr;
  QLabel* values_ = nullptr;
  QLabel* figures_ = nullptr;
  QWidget* message_row_ = nullptr;
  QLabel* message_ = nullptr;
  QAction* open_ = nullptr;
  QAction* save_ = nullptr;
  QAction* copy_ = nullptr;
  QAction* flip_ = nullptr;
  QAction* swap_ = nullptr;
  QAction* remove_ = nullptr;
  std::vector<QAction*> view_actions_;
  std::vector<QAction*> comparison_actions_;
};

}  // namespace editor
