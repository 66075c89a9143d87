#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>
#include <map>

#include "editor/jobs/background_job.h"
#include "editor/rendering/effect_plan.h"
#include "editor/rendering/render_report.h"
#include "editor/rendering/snapshot_process.h"

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace editor {

class Document;
class NumberBox;

/// The page Effects: which effects the scene calls for and why, what each costs and contributes, and switches
/// for them. It follows edits while it is visible.
class EffectsPage : public QWidget {
  Q_OBJECT

 public:
  enum Column { Name, Why, Light, Time, Difference, ColumnCount };

  /// Document outlives the page. `request` returns a final render of the document as it is now.
  EffectsPage(Document& document, std::function<FinalRenderRequest()> request,
              const QString& program = bundled_program("bpt"), QWidget* parent = nullptr);

  QTreeWidget& table() { return *table_; }
  bool is_measuring() const { return measurement_.is_running(); }
  /// The measured shares of an effect; null while there are none.
  const EffectShares* shares_of(transport::Effect effect) const;

 signals:
  void status_message(const QString& message);
  /// Emitted when the faces that call for an effect are to be seen, which are selected.
  void scene_requested();
  /// Emitted with the files of an image without an effect and of the full one, and the title of the latter.
  void comparison_requested(const QString& without, const QString& full, const QString& full_name);

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void lay_out();
  void make_buttons();
  void connect_document();
  void outdate();
  void follow();
  void show_rows();
  void show_row(QTreeWidgetItem& item, const EffectRow& row);
  void show_shares(QTreeWidgetItem& item, transport::Effect effect);
  void show_state();
  void measure();
  void take_line(const QByteArray& line);
  void end(const QString& problem);
  void toggle(QTreeWidgetItem& item);
  void switch_all_on();
  void select_faces(int row);
  void compare();
  int current_row() const;
  QString image_of(transport::Effect effect, const QString& kind) const;
  QImage picture_of(transport::Effect effect) const;

  /// A measured effect has shares of the light and the time, and a picture.
  struct Measured {
    EffectShares shares;
    QImage picture;  ///< the difference to the full image
  };

  Document& document_;
  const std::function<FinalRenderRequest()> request_;
  EffectPlan plan_;
  std::map<transport::Effect, Measured> measured_;
  bool is_plan_outdated_ = true;
  bool are_shares_outdated_ = false;
  bool is_filling_ = false;  ///< the changes of items are not the user's
  int to_measure_ = 0;       ///< effects of the running measurement
  QString problem_;          ///< of the last measurement

  QTreeWidget* table_ = nullptr;
  QLabel* state_;
  QPushButton* measure_;
  NumberBox* seconds_;
  QPushButton* select_;
  QPushButton* compare_;
  QPushButton* all_on_;
  QTimer settling_;  ///< runs while edits may follow
  BackgroundJob<EffectPlan> planning_{this};
  SnapshotProcess measurement_;
};

/// The name of an effect in the editor's language.
QString title_of(transport::Effect effect);

}  // namespace editor
