#pragma once

#include <memory>
#include <optional>

#include "editor/document/scene_loader.h"
#include "editor/tools/tool_window.h"

class QProgressBar;

namespace editor {

class FigureView;

/// The window of a study tool: its figure and its form.
class StudyWindow : public ToolWindow {
  Q_OBJECT

 public:
  explicit StudyWindow(const studies::StudyTool& tool, QWidget* parent = nullptr);
  ~StudyWindow() override;

  FigureView& figure() { return *figure_; }
  const std::optional<studies::Study>& study() const { return study_; }
  bool has_picture() const override;
  bool is_busy() const override;

 protected:
  void request() override;
  std::optional<studies::Study> shown_study() const override;
  std::vector<studies::DataFile> data_files() const override;
  void changeEvent(QEvent* event) override;

 private:
  /// A study with the messages of making it.
  struct Outcome {
    std::optional<studies::Study> study;
    QString messages;
    bool has_errors = false;
  };

  bool is_loading() const;
  void request_model();
  void show_outcome(Outcome outcome);
  void show_study(studies::Study study);
  void show_busy(bool is_busy);

  std::optional<studies::Study> study_;
  std::shared_ptr<studies::StudyCache> cache_ = std::make_shared<studies::StudyCache>();
  BackgroundJob<std::shared_ptr<Outcome>> job_{this};
  SceneLoader loader_;
  QString wanted_model_;                      ///< that the state shows; empty: none
  std::shared_ptr<const LoadedScene> model_;  ///< the wanted one; null until it is loaded
  FigureView* figure_;
  QProgressBar* progress_;
  QTimer* slow_;  ///< until the progress is shown
  QAction* stop_ = nullptr;
};

}  // namespace editor
