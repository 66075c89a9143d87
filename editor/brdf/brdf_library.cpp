#include "editor/brdf/brdf_library.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPainter>
#include <QScopedValueRollback>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/appearance/theme.h"
#include "editor/brdf/picture_tiles.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"
#include "editor/document/brdf_mime.h"
#include "grf/read.h"
#include "grf/write.h"
#include "renderer/reflectance/presets.h"

namespace editor {
namespace {

constexpr int TileSide = 8 * Grid;
constexpr int TileMargin = Grid / 2;
/// The light alone shows a white diffuse surface as white, and the sky adds to it.
constexpr double PictureStops = -1;
constexpr int PictureSamples = 32;

constexpr const char* FolderSetting = "library/folder";

grf::BrdfModel preset_of(std::string_view text) {
  grf::Diagnostics diagnostics;
  auto model = grf::read_brdf(std::string(text), "preset", diagnostics);
  Q_ASSERT(model);
  grf::BrdfModel brdf = model.value_or(grf::BrdfModel());
  brdf.location = {};
  for (grf::Argument& argument : brdf.arguments) argument.location = {};
  return brdf;
}

void add_presets(std::vector<LibraryEntry>& entries) {
  for (const reflectance::PresetTable& table : reflectance::preset_tables()) {
    for (const reflectance::Preset& preset : table.presets) {
      entries.push_back(
          {LibraryEntry::Source::Preset, text_of(table.title), text_of(preset.name), preset_of(preset.brdf)});
    }
  }
  for (const grf::ModelInfo& info : reflectance::brdf_infos()) {
    if (info.example.empty()) continue;
    entries.push_back({LibraryEntry::Source::Preset, BrdfLibrary::tr("Examples of all models"),
                       text_of(info.title), preset_of(info.example)});
  }
}

/// Cache key of thumbnails, equal for BRDFs with the same text.
QString picture_key(const LibraryEntry& entry) { return QString::fromStdString(grf::to_text(entry.brdf)); }

/// A thumbnail of a sphere with a margin, for a device pixel ratio.
QImage picture_of(const grf::BrdfModel& model, const Definitions& definitions, double ratio,
                  const StopFlag& stop) {
  SphereScene scene;
  scene.brdf = compile_brdf(model, definitions).brdf;
  scene.side = static_cast<int>((TileSide - 2 * TileMargin) * ratio);
  scene.light.normalize();
  if (!scene.brdf) return {};
  const SphereImage image = shade_on_cpu(scene, PictureSamples, stop);
  if (image.side == 0) return {};
  QImage picture(QSize(TileSide, TileSide) * ratio, QImage::Format_ARGB32_Premultiplied);
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  QImage sphere = displayed(image, PictureStops);
  sphere.setDevicePixelRatio(ratio);
  QPainter(&picture).drawImage(TileMargin, TileMargin, sphere);
  return picture;
}

/// An icon with the same colours whether selected or not; an empty tile without a thumbnail.
QIcon icon_of(QPixmap picture) {
  if (picture.isNull()) {
    picture = QPixmap(TileSide, TileSide);
    picture.fill(Qt::transparent);
  }
  QIcon icon(picture);
  icon.addPixmap(picture, QIcon::Selected);
  return icon;
}

}  // namespace

LibraryList::LibraryList(QWidget* parent) : QListWidget(parent) {
  setViewMode(QListView::IconMode);
  setIconSize({TileSide, TileSide});
  QFont small = font();
  small.setPixelSize(11);
  setFont(small);
  const int lines = 2;  // of names with several words
  setGridSize({TileSide + 2 * Grid + Grid / 4, TileSide + lines * QFontMetrics(small).height() + Grid});
  setItemDelegate(new PictureTiles(this));
  setResizeMode(QListView::Adjust);
  setMovement(QListView::Static);
  setDragEnabled(true);
  setDragDropMode(QAbstractItemView::DragOnly);
  setUniformItemSizes(true);
  setWordWrap(true);
  setTextElideMode(Qt::ElideRight);
  setEditTriggers(QAbstractItemView::EditKeyPressed);
  setAccessibleName(tr("BRDFs of the library"));
  setToolTip(tr("Double-click, press Return or drag to assign a BRDF to the selected faces"));
}

void LibraryList::set_entries(std::vector<LibraryEntry> entries) {
  entries_ = std::move(entries);
  clear();
  for (const LibraryEntry& entry : entries_) {
    auto* item = new QListWidgetItem(icon_of({}), entry.name, this);
    item->setToolTip(QString("<b>%1</b>, %2<br>%3")
                         .arg(entry.name.toHtmlEscaped(), entry.group.toHtmlEscaped(),
                              QString::fromStdString(grf::to_text(entry.brdf)).toHtmlEscaped()));
    if (entry.source == LibraryEntry::Source::Folder) item->setFlags(item->flags() | Qt::ItemIsEditable);
  }
}

const LibraryEntry* LibraryList::current_entry() const {
  const QList<QListWidgetItem*> selected = selectedItems();
  if (selected.empty()) return nullptr;
  return &entries_[static_cast<std::size_t>(row(selected.front()))];
}

QMimeData* LibraryList::mimeData(const QList<QListWidgetItem*>& items) const {
  if (items.empty()) return nullptr;
  const LibraryEntry& entry = entries_[static_cast<std::size_t>(row(items.front()))];
  return mime_of(entry.brdf, entry.source == LibraryEntry::Source::Scene ? entry.name : QString()).release();
}

QStringList LibraryList::mimeTypes() const { return {BrdfMimeType, "text/plain"}; }

bool LibraryList::shows(int row) const {
  return isVisible() && !item(row)->isHidden() && visualItemRect(item(row)).intersects(viewport()->rect());
}

void LibraryList::paintEvent(QPaintEvent* event) {
  QListWidget::paintEvent(event);
  emit painted();
}

BrdfLibrary::BrdfLibrary(QWidget* parent) : QWidget(parent) {
  build_controls();
  connect(list_, &QListWidget::itemActivated, this, [this] {
    const LibraryEntry* entry = list_->current_entry();
    if (entry == nullptr) return;
    emit chosen(entry->brdf, entry->source == LibraryEntry::Source::Scene ? entry->name : QString());
  });
  connect(list_, &QListWidget::itemSelectionChanged, this, &BrdfLibrary::show_state);
  connect(list_, &QListWidget::itemChanged, this, &BrdfLibrary::rename);
  connect(list_, &LibraryList::painted, this, [this] {
    if (!pictures_job_.is_busy()) picture_next();
  });
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, &BrdfLibrary::reload);
  const QString folder = QSettings().value(FolderSetting).toString();
  if (QFileInfo(folder).isDir()) {
    set_folder(folder);
  } else {
    reload();
  }
}

void BrdfLibrary::build_controls() {
  auto* column = tight_layout<QVBoxLayout>(this);
  auto* top = new QHBoxLayout;
  top->setSpacing(Grid / 2);
  search_ = new QLineEdit(this);
  search_->setPlaceholderText(tr("Search"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search the library"));
  search_->setToolTip(tr("Search by name, model or parameter value"));
  group_ = narrow_list(tr("Category"), tr("Category of BRDFs that is shown"), 8, this);
  top->addWidget(search_, 1);
  top->addWidget(group_, 1);
  column->addLayout(top);
  list_ = new LibraryList(this);
  column->addWidget(list_, 1);
  message_ = new ThemedLabel(&ThemeColours::faint_text, this);
  column->addWidget(message_);
  auto* bottom = new QHBoxLayout;
  bottom->setSpacing(Grid / 2);
  add_ = tool_button(
      "plus", tr("Save the BRDF to the library"), {}, [this] { add(); }, this);
  rename_ = tool_button(
      "rename", tr("Rename"), {}, [this] { list_->editItem(list_->currentItem()); }, this);
  remove_ = tool_button(
      "remove", tr("Remove"), {}, [this] { remove(); }, this);
  auto* folder = tool_button(
      "folder", tr("Choose the library's folder"), tr("Folder of the library, with one file per BRDF"),
      [this] { choose_folder(); }, this);
  for (QToolButton* button : {add_, rename_, remove_}) bottom->addWidget(button);
  bottom->addStretch(1);
  bottom->addWidget(folder);
  column->addLayout(bottom);
  connect(search_, &QLineEdit::textChanged, this, &BrdfLibrary::filter);
  connect(group_, &QComboBox::currentIndexChanged, this, &BrdfLibrary::filter);
}

void BrdfLibrary::set_definitions(Definitions definitions) {
  // What a BRDF of others looks like is not in its own text.
  if (definitions != definitions_) {
    for (const LibraryEntry& entry : list_->entries()) {
      if (!entry.brdf.terms.empty()) pictures_.remove(picture_key(entry));
    }
  }
  definitions_ = std::move(definitions);
  reload();
}

void BrdfLibrary::set_folder(const QString& path) {
  if (!watcher_.directories().empty()) watcher_.removePaths(watcher_.directories());
  folder_ = LibraryFolder(path);
  QSettings().setValue(FolderSetting, path);
  if (QFileInfo(path).isDir()) watcher_.addPath(path);
  reload();
}

void BrdfLibrary::set_current(const std::optional<grf::BrdfModel>& brdf) {
  current_ = brdf;
  show_state();
}

void BrdfLibrary::reload() {
  const QScopedValueRollback filling(is_filling_, true);
  std::vector<LibraryEntry> entries;
  for (const grf::Definition& definition : definitions_) {
    const auto* brdf = std::get_if<grf::BrdfModel>(&definition.body);
    if (brdf == nullptr) continue;
    entries.push_back(
        {LibraryEntry::Source::Scene, tr("Scene"), QString::fromStdString(definition.name), *brdf});
  }
  problems_.clear();
  for (const LibraryFile& file : folder_.files(problems_)) {
    entries.push_back({LibraryEntry::Source::Folder, tr("My library"), file.name, file.brdf});
  }
  add_presets(entries);
  list_->set_entries(std::move(entries));
  const QString shown = group_->currentText();
  const QSignalBlocker silent(group_);
  group_->clear();
  group_->addItem(tr("All"));
  for (const LibraryEntry& entry : list_->entries()) {
    if (group_->findText(entry.group) < 0) group_->addItem(entry.group);
  }
  group_->setCurrentIndex(std::max(0, group_->findText(shown)));
  pictures_job_.stop();
  waiting_.clear();
  for (std::size_t i = 0; i < list_->entries().size(); ++i) {
    const auto known = pictures_.constFind(picture_key(list_->entries()[i]));
    if (known != pictures_.constEnd()) {
      list_->item(static_cast<int>(i))->setIcon(icon_of(*known));
    } else {
      waiting_.insert(i);
    }
  }
  filter();
}

std::optional<std::size_t> BrdfLibrary::next_waiting() const {
  const auto next =
      std::ranges::find_if(waiting_, [&](std::size_t i) { return list_->shows(static_cast<int>(i)); });
  return next == waiting_.end() ? std::nullopt : std::optional(*next);
}

void BrdfLibrary::picture_next() {
  const std::optional<std::size_t> next = next_waiting();
  if (!next) return;
  const LibraryEntry& entry = list_->entries()[*next];
  pictures_job_.start([brdf = entry.brdf, definitions = definitions_, ratio = devicePixelRatioF()](
                          const StopFlag& stop) { return picture_of(brdf, definitions, ratio, stop); },
                      [this, i = *next, key = picture_key(entry)](const QImage& image) {
                        const QScopedValueRollback filling(is_filling_, true);
                        const QPixmap picture = QPixmap::fromImage(image);
                        pictures_.insert(key, picture);
                        list_->item(static_cast<int>(i))->setIcon(icon_of(picture));
                        waiting_.erase(i);
                        picture_next();
                      });
}

void BrdfLibrary::filter() {
  const QString word = search_->text().trimmed();
  int shown = 0;
  for (std::size_t i = 0; i < list_->entries().size(); ++i) {
    const LibraryEntry& entry = list_->entries()[i];
    const bool in_group = group_->currentIndex() <= 0 || entry.group == group_->currentText();
    const bool is_found = word.isEmpty() || entry.name.contains(word, Qt::CaseInsensitive) ||
                          picture_key(entry).contains(word, Qt::CaseInsensitive);
    list_->item(static_cast<int>(i))->setHidden(!in_group || !is_found);
    if (in_group && is_found) ++shown;
  }
  QString text;
  if (shown == 0) text = word.isEmpty() ? tr("No BRDFs yet.") : tr("No BRDF matches '%1'.").arg(word);
  for (const QString& problem : problems_) text += (text.isEmpty() ? "" : "\n") + problem;
  show_or_hide(message_, text);
  show_state();
}

void BrdfLibrary::show_state() {
  const LibraryEntry* entry = list_->current_entry();
  const bool is_own = entry != nullptr && entry->source == LibraryEntry::Source::Folder;
  enable(add_, tr("Save the edited BRDF to the library's folder"),
         folder_.path().isEmpty() ? tr("Choose a folder for the library first")
         : !current_              ? tr("There is no BRDF to save: select faces, or choose one")
                                  : QString());
  const QString why = entry == nullptr ? tr("Select an entry of your library first")
                                       : tr("Only entries of your library's folder can be changed");
  enable(rename_, tr("Rename the file (F2)"), is_own ? QString() : why);
  enable(remove_, tr("Move the file to the trash"), is_own ? QString() : why);
}

void BrdfLibrary::add() {
  if (!current_) return;
  const QString name = folder_.free_name(QString::fromStdString(current_->keyword));
  const QString problem = folder_.add(name, *current_);
  if (!problem.isEmpty()) return show_or_hide(message_, problem);
  set_folder(folder_.path());
  for (std::size_t i = 0; i < list_->entries().size(); ++i) {
    const LibraryEntry& entry = list_->entries()[i];
    if (entry.source != LibraryEntry::Source::Folder || entry.name != name) continue;
    list_->setCurrentRow(static_cast<int>(i));
    list_->scrollToItem(list_->item(static_cast<int>(i)));
  }
}

void BrdfLibrary::rename(QListWidgetItem* item) {
  if (is_filling_) return;
  const LibraryEntry entry = list_->entries()[static_cast<std::size_t>(list_->row(item))];
  if (entry.source != LibraryEntry::Source::Folder || item->text() == entry.name) return;
  const QString problem = folder_.rename(entry.name, item->text());
  // Queued, since this runs inside the item's own signal.
  QMetaObject::invokeMethod(
      this,
      [this, problem] {
        reload();
        if (!problem.isEmpty()) show_or_hide(message_, problem);
      },
      Qt::QueuedConnection);
}

void BrdfLibrary::remove() {
  const LibraryEntry* entry = list_->current_entry();
  if (entry == nullptr) return;
  const QString problem = folder_.remove(entry->name);
  reload();
  if (!problem.isEmpty()) show_or_hide(message_, problem);
}

void BrdfLibrary::choose_folder() {
  auto* dialog = new QFileDialog(window(), tr("Folder of the library"), folder_.path());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, &BrdfLibrary::set_folder);
  dialog->open();
}

}  // namespace editor
