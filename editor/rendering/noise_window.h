#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "editor/rendering/noise_results.h"
#include "editor/rendering/snapshot_process.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace editor {

class Document;

/// A window that shows which lamps, bounces and BRDFs the noise of the final image comes from, and what
/// changes of settings do to it, measured by `bpt noise` in the background. A click selects the lamp or the
/// faces; a change that was tried can be applied.
class NoiseWindow : public QWidget {
  Q_OBJECT

 public:
  /// `request` returns the final render of the document as it is. The document outlives the window.
  NoiseWindow(Document& document, std::function<FinalRenderRequest()> request, const QString& program,
              QWidget* parent = nullptr);

  /// Measures the noise of the document as it is now.
  void measure();
  /// Measures what each change does.
  void try_all();
  bool is_running() const { return run_.is_running(); }
  const std::optional<NoiseResult>& result() const { return result_; }

 private:
  enum class Running { Nothing, Shares, Trials };

  void lay_out();
  QTreeWidget* make_shares();
  QTreeWidget* make_changes();
  QWidget* make_buttons();
  void start(Running what, const QStringList& arguments);
  void read(const QByteArray& line);
  void end(const QString& problem);
  void outdate();
  void show_shares();
  void add_group(const QString& title, const std::vector<NoiseShareRow>& rows);
  void show_changes();
  void show_change(QTreeWidgetItem& item, const NoiseTrial& change) const;
  void show_state();
  void select_current();
  std::optional<std::size_t> current_change() const;
  void try_current();
  void apply();

  Document& document_;
  const std::function<FinalRenderRequest()> request_;
  SnapshotProcess run_;
  Running running_ = Running::Nothing;
  bool is_outdated_ = false;
  QString problem_;
  QString applied_;  ///< what was applied since the measurement
  std::optional<NoiseResult> result_;
  std::vector<const NoiseShareRow*> rows_;  ///< by the items' numbers

  QLabel* state_;
  QLabel* advice_;
  QProgressBar* progress_;
  QTreeWidget* shares_;
  QTreeWidget* changes_;
  QPushButton* measure_button_;
  QPushButton* stop_button_;
  QPushButton* try_button_;
  QPushButton* try_all_button_;
  QPushButton* apply_button_;
};

}  // namespace editor
