#pragma once

#include <QFileSystemWatcher>
#include <QHash>
#include <QListWidget>
#include <QPixmap>
#include <QWidget>
#include <optional>
#include <set>

#include "editor/brdf/compiled_brdf.h"
#include "editor/brdf/library_folder.h"
#include "editor/brdf/sphere_shading.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace editor {

/// A BRDF of the library, with its group.
struct LibraryEntry {
  enum class Source { Preset, Scene, Folder };
  Source source = Source::Preset;
  QString group;
  QString name;
  grf::BrdfModel brdf;
};

/// The list of a library: entries are dragged from it as GRF text, see document/brdf_mime.h.
class LibraryList : public QListWidget {
  Q_OBJECT

 public:
  explicit LibraryList(QWidget* parent = nullptr);

  void set_entries(std::vector<LibraryEntry> entries);
  const std::vector<LibraryEntry>& entries() const { return entries_; }
  /// The selected entry, or null.
  const LibraryEntry* current_entry() const;

  QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override;
  QStringList mimeTypes() const override;

  bool shows(int row) const;

 signals:
  /// Emitted when other entries may have come in sight.
  void painted();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<LibraryEntry> entries_;
};

/// A searchable library of presets, the definitions of the scene and a folder on disk, shown as spheres with
/// names that can be assigned and dragged. BRDFs of the folder can be added, renamed and removed.
class BrdfLibrary : public QWidget {
  Q_OBJECT

 public:
  explicit BrdfLibrary(QWidget* parent = nullptr);

  void set_definitions(Definitions definitions);
  /// Sets the folder, which is watched for external changes and remembered for the next library.
  void set_folder(const QString& path);
  /// Sets the BRDF that the Save button adds; without one the button is disabled.
  void set_current(const std::optional<grf::BrdfModel>& brdf);

  LibraryList& list() { return *list_; }
  /// Whether an entry in sight has no picture yet; pictures of others are made when they come in sight.
  bool is_busy() const { return pictures_job_.is_busy() || next_waiting().has_value(); }

 signals:
  /// Emitted on double click or Return. The name is that of the definition, for entries of the scene.
  void chosen(const grf::BrdfModel& brdf, const QString& definition_name);

 private:
  void build_controls();
  void reload();
  void filter();
  void show_state();
  void add();
  void rename(QListWidgetItem* item);
  void remove();
  void choose_folder();
  std::optional<std::size_t> next_waiting() const;
  void picture_next();

  Definitions definitions_;
  LibraryFolder folder_;
  std::optional<grf::BrdfModel> current_;
  std::vector<QString> problems_;
  bool is_filling_ = false;

  QLineEdit* search_ = nullptr;
  QComboBox* group_ = nullptr;
  LibraryList* list_ = nullptr;
  QLabel* message_ = nullptr;
  QToolButton* add_ = nullptr;
  QToolButton* rename_ = nullptr;
  QToolButton* remove_ = nullptr;
  QFileSystemWatcher watcher_;
  QHash<QString, QPixmap> pictures_;  // by GRF text
  std::set<std::size_t> waiting_;     // entries without a picture
  BackgroundJob<QImage> pictures_job_{this};
};

}  // namespace editor
