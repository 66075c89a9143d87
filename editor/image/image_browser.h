#pragma once

#include <QWidget>
#include <map>
#include <optional>

#include "editor/image/image_selection.h"
#include "editor/image/image_tools.h"
#include "editor/image/shown_image.h"

class QLabel;

namespace editor {

class NoticeBar;
class ScaleBar;

/// The image view: images of files and renders, one of which is shown or compared with a reference, with
/// display settings, pixel values and statistics. Files are read and written in threads.
class ImageBrowser : public QWidget {
  Q_OBJECT

 public:
  explicit ImageBrowser(QWidget* parent = nullptr);

  /// Opens image files and shows the last one; a file that is already open is reloaded.
  void open_files(const QStringList& paths);
  /// Adds an image, or updates the one of that name. A new image is shown.
  void show_image(const QString& name, SharedImage image);
  /// Shows an unfinished image whose file is still being written: the same entry as that of `open_files`.
  void show_image_of(const QString& path, SharedImage image);
  /// Loads the file of an image that is in the list, or is about to be, without showing it.
  void reload(const QString& path);
  void remove_image(const QString& name);
  /// Saves the shown image, in the format of the file's extension.
  void save_as(const QString& path);
  /// Copies the displayed image to the clipboard.
  void copy() const;

  QStringList names() const { return selection_.names(); }
  /// Selects an image by name; an empty reference means none.
  void select_image(const QString& name);
  void select_reference(const QString& name);
  /// Selects the layer of both that is shown; empty for the images themselves.
  void select_layer(const QString& name);
  void set_comparison(Comparison comparison) { tools_->set_comparison(comparison); }
  /// Opens an image and a former state of it under another name, and compares them; with a wipe if no
  /// comparison is chosen.
  void compare(const QString& path, const QString& former_path, const QString& former_name);
  /// The path of the shown image; empty if it has none.
  QString shown_path() const { return selection_.image().path; }

  ImagePane& pane() { return *pane_; }
  ScreenControls& controls() { return tools_->controls(); }
  /// The controls and their actions, for menus.
  const ImageTools& tools() const { return *tools_; }

 signals:
  void opened(const QString& path);
  void saved(const QString& path);
  /// Emitted with the diagnostics of a file, which the browser also shows itself.
  void reported(const grf::Diagnostics& diagnostics);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void connect_tools();
  void lay_out();
  void ask_for_files();
  void ask_for_name();
  bool take_loaded(const LoadedImage& loaded, const QString& name, bool is_wanted);
  void wipe_unless_compared();
  void put(const ImageEntry& entry, bool is_wanted);
  void show_selection();
  void show_layer();
  void show_on_pane();
  void start_analysis();
  void take_analysis(const ImageAnalysis& made);
  bool is_current(const ImageAnalysis& made) const;
  ScreenSettings screen_settings() const;
  void show_pixel(const std::optional<QPoint>& pixel);
  void show_diagnostics(const grf::Diagnostics& diagnostics);

  ImageSelection selection_;
  ShownImage image_;                                      ///< A
  ShownImage reference_;                                  ///< B
  std::map<QString, ScreenSettings> settings_of_layers_;  ///< of those that were shown
  ImageAnalysis analysis_;
  bool is_analysing_ = false;
  std::optional<QPoint> pixel_;

  ImagePane* pane_;
  ImageTools* tools_;
  ScaleBar* scale_bar_;
  NoticeBar* notice_;
  QLabel* values_;
  QLabel* statistics_;
};

}  // namespace editor
