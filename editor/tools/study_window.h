#pragma once

#include <QMainWindow>
#include <memory>
#include <optional>
#include <vector>

#include "editor/jobs/background_job.h"
#include "renderer/studies/study.h"

class QAction;
class QLabel;
class QProgressBar;
class QTimer;

namespace editor {

class FigureView;
class NoticeBar;
class StudyForm;

/// The window of a study tool: its figure and its form. The figure follows from the state alone, which can be
/// copied, saved and opened as text, so that `wannabe --tool NAME --state FILE -o FIGURE` makes it again.
class StudyWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit StudyWindow(const studies::StudyTool& tool, QWidget* parent = nullptr);
  ~StudyWindow() override;

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

  FigureView& figure() { return *figure_; }
  NoticeBar& notice() { return *notice_; }
  StudyForm& form() { return *form_; }
  const std::optional<studies::Study>& study() const { return study_; }
  /// Whether there is a picture of the state, if only a first one of a study that is refined, or a message.
  bool has_picture() const;
  /// Whether the figure is older than the state.
  bool is_busy() const;

 signals:
  void updated();                                             ///< the figure shows the state
  void written(const QString& path, const QString& message);  ///< with an error message, empty on success
  void applied(const grf::BrdfModel& brdf);  ///< the user applies the BRDF to the selected faces

 protected:
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  /// A study with the messages of making it.
  struct Outcome {
    std::optional<studies::Study> study;
    QString messages;
    bool has_errors = false;
  };

  void lay_out();
  void make_status_line();
  void make_file_menu();
  void make_edit_menu();
  void make_view_menu();
  void edit(const studies::ToolState& state, bool is_done);
  void remember();
  void go_to(std::size_t step);
  void request();
  void show_outcome(Outcome outcome);
  void show_study(studies::Study study);
  void show_busy(bool is_busy);
  void turn(const QPointF& by, bool is_done);
  void show_step();
  void ask_for_files();
  void ask_to_save_state();
  void ask_to_export_data();
  void ask_to_export(const QString& title, const QString& name, const QString& filter,
                     const std::function<void(const QString&)>& write);
  void write(const QString& path, const std::function<void(grf::Diagnostics&, const StopFlag&)>& work);
  double setting(std::string_view name) const;
  void report(const QString& message);

  studies::StudyTool tool_;
  studies::ToolState state_;
  std::vector<studies::ToolState> steps_;  ///< of undo; the current one is at `step_`
  std::size_t step_ = 0;
  std::optional<studies::Study> study_;
  std::shared_ptr<studies::StudyCache> cache_ = std::make_shared<studies::StudyCache>();
  BackgroundJob<std::shared_ptr<Outcome>> job_{this};
  BackgroundJob<QString> writing_{this};

  NoticeBar* notice_;
  FigureView* figure_;
  StudyForm* form_;
  QLabel* pointed_;
  QProgressBar* progress_;
  QTimer* slow_;     ///< until the progress is shown
  QTimer* playing_;  ///< the steps of an animation
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  QAction* apply_ = nullptr;
  QAction* export_data_ = nullptr;
  QAction* stop_ = nullptr;
};

}  // namespace editor
