#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "editor/document/document.h"
#include "editor/rendering/cost_run.h"

class QComboBox;
class QCustomPlot;
class QHBoxLayout;
class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace editor {

class CostForm;
class NoticeBar;

/// The region that a view frames.
struct FramedRegion {
  transport::View camera;
  options::ImageSize size;     ///< of the whole view, in pixels
  transport::CropWindow crop;  ///< the region in it
};

/// The page Cost: which scheme, integrator and number of ways give the scene the smallest error in the same
/// time. It runs studies of `bpt cost`, shows them while they run, and applies the winner.
class CostPage : public QWidget {
  Q_OBJECT

 public:
  /// Returns the region that is framed; nothing if none is.
  using RegionSource = std::function<std::optional<FramedRegion>()>;

  /// The document outlives the page.
  CostPage(Document& document, RegionSource region, QWidget* parent = nullptr);
  ~CostPage() override;

  const CostStudy& study() const { return study_; }
  bool is_running() const { return run_.is_running(); }
  /// Shows a study that `bpt cost` or the page has saved, which may be continued.
  void open(const QString& path);
  /// Saves by the extension: the figure as svg, png or pdf, the table as csv, or the study as json with its
  /// reference.
  void save(const QString& path);

 signals:
  /// Emitted when two pictures are to be compared; the second one gets a name.
  void comparison_requested(const QString& path, const QString& other, const QString& other_name);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// A picture that is to be rendered.
  struct Picture {
    QString title;
    FinalRenderRequest request;
  };
  using Pairing = std::optional<SamplePair> (*)(const CostCurve& a, const CostCurve& b);

  QPushButton* button(const QString& text, const std::function<void()>& pressed);
  void describe_views();
  void lay_out();
  void connect_runs();
  QHBoxLayout* make_run_row();
  QHBoxLayout* make_picture_row();
  QHBoxLayout* make_winner_row();
  void start(const QString& continued);
  void take_end(const QString& problem);
  void show_study();
  void show_chart();
  void show_table();
  void show_winner();
  void enable_buttons();
  void fail(const QString& problem);
  void ask_to_open();
  void ask_to_save();
  void take_winner();
  FinalRenderRequest request() const;
  void render_pair(Pairing pairing);
  void render_next();

  Document& document_;
  const RegionSource region_source_;
  CostStudy study_;
  QString file_;  ///< JSON of the shown study; empty if there is none
  CostRun run_;
  FinalRender pictures_;
  std::vector<Picture> waiting_;  ///< the last one is rendered first
  QString first_picture_, first_title_;

  CostForm* form_;
  NoticeBar* notice_;
  QCustomPlot* plot_;
  QTableWidget* table_;
  QProgressBar* progress_;
  QLabel* verdict_;
  QPlainTextEdit* op_;
  QComboBox* a_;
  QComboBox* b_;
  QPushButton *start_, *continue_, *stop_, *open_, *save_, *equal_time_, *equal_error_, *take_, *copy_;
};

}  // namespace editor
