#pragma once

#include <QDialog>
#include <QTimer>
#include <optional>
#include <stop_token>
#include <vector>

#include "converters/risks/risk.h"
#include "editor/jobs/background_job.h"
#include "grf/catalogue.h"
#include "renderer/job/non_finite.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace editor {

class Document;
class MeshActions;

/// A dialog, not modal, that lists what can make the image of the scene wrong or noisy, ranked. It follows
/// edits; an entry selects what it is about, and can repair it as one undo step. A search renders the scene
/// for samples that are not finite.
class RiskDialog : public QDialog {
  Q_OBJECT

 public:
  /// The document and the actions outlive it.
  RiskDialog(Document& document, MeshActions& meshes, grf::Catalogue catalogue, QWidget* parent);
  ~RiskDialog() override;

  const std::vector<convert::Risk>& risks() const { return risks_; }
  /// Whether the list is of the scene as it is.
  bool is_up_to_date() const { return !pause_.isActive() && !check_.is_busy(); }

 signals:
  /// Emitted with the path of the object of an entry, after it was selected.
  void chosen(const grf::ScenePath& path);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct Search {
    std::optional<job::NonFiniteSearch> found;
    QString problem;
  };

  void add_buttons();
  void check_soon();
  void check();
  void show_risks(std::vector<convert::Risk> risks);
  const convert::Risk* current() const;
  void choose();
  void repair();
  void search_non_finite();
  void show_search(const Search& search);

  Document& document_;
  MeshActions& meshes_;
  const grf::Catalogue catalogue_;
  std::vector<convert::Risk> risks_;
  QLabel* summary_;
  QTreeWidget* list_;
  QLabel* advice_;  ///< what to do about the selected risk
  QLabel* finding_;
  QPushButton* repair_ = nullptr;
  QPushButton* search_ = nullptr;
  QTimer pause_;
  BackgroundJob<std::vector<convert::Risk>> check_{this};
  std::stop_source search_stop_;
  BackgroundJob<Search> search_job_{this};
};

}  // namespace editor
