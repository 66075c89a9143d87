#pragma once

#include <QMainWindow>
#include <functional>
#include <optional>
#include <vector>

#include "editor/jobs/background_job.h"
#include "renderer/studies/study.h"

class QAction;
class QLabel;
class QMenu;
class QTimer;

namespace editor {

class NoticeBar;
class StudyForm;

/// What the windows of tools with a state have in common: the form, undo, the state as text, which can be
/// copied, saved and opened, and exports, which follow from the state alone, so that
/// `wannabe --tool NAME --state FILE -o FIGURE` makes them again.
class ToolWindow : public QMainWindow {
  Q_OBJECT

 public:
  ~ToolWindow() override;

  const studies::ToolState& state() const { return state_; }
  /// Replaces the state, as one undo step unless it is the same gesture as before.
  void set_state(const studies::ToolState& state);
  /// Opens a state, or files that the tool shows. Reports what is wrong with them in the window.
  void open(const QStringList& files);
  /// Replaces the text of a state, as from the clipboard or a file; false after an error, which is shown.
  bool read(const QString& text, const QString& path);
  /// Sets the first BRDF of the tool, if it takes one, and the BRDFs that the terms of a sum refer to.
  void set_brdf(const grf::BrdfModel& brdf, const std::vector<grf::Definition>& definitions = {});
  /// Sets whether there is a scene with faces that the BRDF can be applied to: see `applied`.
  void set_apply_target(bool has_target);

  // The functions below write files in a thread: see `written`.

  /// Saves the state as text.
  void save_state(const QString& path);
  /// Exports the figure as .svg, .png or .pdf, on white.
  void export_figure(const QString& path);
  /// Exports the data of the study in one of its formats, by the extension.
  void export_data(const QString& path);
  /// Exports a picture for each of so many steps of the animation, numbered before the extension.
  void export_animation(const QString& path, int count);

  NoticeBar& notice() { return *notice_; }
  StudyForm& form() { return *form_; }
  /// Whether there is a picture of the state, if only a first one that is refined, or a message.
  virtual bool has_picture() const = 0;
  /// Whether what is shown is older than the state.
  virtual bool is_busy() const = 0;

 signals:
  void updated();                                             ///< what is shown follows the state
  void written(const QString& path, const QString& message);  ///< with an error message, empty on success
  void applied(const grf::BrdfModel& brdf);  ///< the user applies the BRDF to the selected faces

 protected:
  explicit ToolWindow(const studies::StudyTool& tool, QWidget* parent);
  /// Lays the window out, with the form beside the widget that shows the state, and makes its menus. The
  /// first state is shown from the event loop, so that it is not the initial one if files are opened until
  /// then.
  void begin(QWidget* canvas);

  /// Has the picture follow the state.
  void follow();
  /// Called with each new state, which is to be shown.
  virtual void request() = 0;
  /// Whether a state was shown yet.
  bool has_followed() const { return has_followed_; }
  /// The study that is shown, if it follows from the state: to make it once more may take long.
  virtual std::optional<studies::Study> shown_study() const { return std::nullopt; }
  /// The formats in which its data can be exported.
  virtual std::vector<studies::DataFile> data_files() const = 0;
  /// Whether the next step of an animation can follow.
  virtual bool is_frame_shown() const { return !is_busy(); }
  /// Sets the time between the steps of a played animation, in milliseconds, and their number.
  void set_animation(int interval, int steps);

  const studies::StudyTool& tool() const { return tool_; }
  QMenu& view_menu() { return *view_menu_; }
  QAction& export_data_action() { return *export_data_; }
  QLabel& pointed() { return *pointed_; }  ///< what is under the pointer, in the status line
  /// Shows a state that was edited here, as an undo step if it is done.
  void show_edited(const studies::ToolState& state, bool is_done);
  /// Turns the figure by the drag of so many pixels, if the tool has settings for that.
  void turn(const QPointF& by, bool is_done);
  /// The value of a setting that is a number.
  double setting(std::string_view name) const;
  /// Sets one of a state, within its range.
  void set_setting(std::string_view name, double value, studies::ToolState& state) const;
  void report(const QString& message);

  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void lay_out(QWidget* canvas);
  void make_status_line();
  void make_file_menu();
  void make_edit_menu();
  void make_view_menu();
  void edit(const studies::ToolState& state, bool is_done);
  void remember();
  void go_to(std::size_t step);
  void show_step();
  void ask_for_files();
  void ask_to_save_state();
  void ask_to_export_data();
  void ask_to_export(const QString& title, const QString& name, const QString& filter,
                     const std::function<void(const QString&)>& write);
  void write(const QString& path, const std::function<void(grf::Diagnostics&, const StopFlag&)>& work);

  studies::StudyTool tool_;
  studies::ToolState state_;
  std::vector<studies::ToolState> steps_;  ///< of undo; the current one is at `step_`
  std::size_t step_ = 0;
  bool has_followed_ = false;
  BackgroundJob<QString> writing_{this};

  NoticeBar* notice_;
  StudyForm* form_;
  QLabel* pointed_;
  QTimer* playing_;  ///< the steps of an animation
  int played_steps_;
  QMenu* view_menu_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  QAction* apply_ = nullptr;
  QAction* export_data_ = nullptr;
};

}  // namespace editor
