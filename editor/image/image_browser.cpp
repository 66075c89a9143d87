#include "editor/image/image_browser.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFutureWatcher>
#include <QGuiApplication>
#include <QLabel>
#include <QMimeData>
#include <QtConcurrent>
#include <algorithm>

#include "editor/appearance/theme.h"
#include "editor/image/image_texts.h"
#include "editor/image/scale_bar.h"
#include "editor/image/screen_controls.h"

namespace editor {
namespace {

/// Runs work on a thread, and gives its result to the receiver, if that still lives then.
template <class Work, class Take>
void run_aside(QObject* receiver, const Work& work, const Take& take) {
  using Result = std::invoke_result_t<Work>;
  auto* watcher = new QFutureWatcher<Result>(receiver);
  QObject::connect(watcher, &QFutureWatcher<Result>::finished, receiver, [watcher, take] {
    take(watcher->result());
    watcher->deleteLater();
  });
  watcher->setFuture(QtConcurrent::run(work));
}

QStringList paths_of(const QMimeData* data) {
  QStringList paths;
  for (const QUrl& url : data->urls()) {
    if (url.isLocalFile()) paths << url.toLocalFile();
  }
  return paths;
}

QString absolute(const QString& path) { return QDir::cleanPath(QFileInfo(path).absoluteFilePath()); }

}  // namespace

ImageBrowser::ImageBrowser(QWidget* parent)
    : QWidget(parent),
      pane_(new ImagePane),  // parts of it once they are laid out: Tab leads through them in that order
      controls_(new ScreenControls),
      scale_bar_(new ScaleBar) {
  setAcceptDrops(true);
  pane_->set_hint(tr("Drop an image here, open one, or render: exr, hdr, pfm, raw, png, jpg or tga."));
  make_actions();
  add_keys();
  lay_out();
  connect(controls_, &ScreenControls::edited, this, [this] { show_on_pane(); });
  connect(pane_, &ImagePane::hovered, this, &ImageBrowser::show_pixel);
  connect(pane_, &ImagePane::zoomed, this,
          [this](double zoom) { zoom_->setText(tr("%1 %").arg(100 * zoom, 0, 'g', 4)); });
  show_selection();
}

// Images

ImageEntry* ImageBrowser::find(const QString& name) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const ImageEntry& entry) { return entry.name == name; });
  return found == entries_.end() ? nullptr : &*found;
}

ImageEntry* ImageBrowser::image() { return find(image_name_); }
ImageEntry* ImageBrowser::reference() { return find(reference_name_); }

QStringList ImageBrowser::names() const {
  QStringList names;
  for (const ImageEntry& entry : entries_) names << entry.name;
  return names;
}

void ImageBrowser::put(const ImageEntry& entry, bool is_wanted) {
  ImageEntry* known = find(entry.name);
  if (known != nullptr) {
    *known = entry;
  } else {
    entries_.push_back(entry);
  }
  if (known == nullptr || is_wanted) {
    if (known == nullptr) fill_lists();
    if (reference_name_ != entry.name) image_name_ = entry.name;
  }
  show_selection();
}

void ImageBrowser::show_image(const QString& name, SharedImage image) {
  put({name, {}, std::move(image)}, false);
}

void ImageBrowser::show_image_of(const QString& path, SharedImage image) {
  put({name_of(absolute(path)), absolute(path), std::move(image)}, false);
}

/// Short, unless an image of another folder is called so.
QString ImageBrowser::name_of(const QString& path) {
  QString name = QFileInfo(path).fileName();
  const ImageEntry* same = find(name);
  return same == nullptr || same->path == path ? name : path;
}

void ImageBrowser::remove_image(const QString& name) {
  std::erase_if(entries_, [&](const ImageEntry& entry) { return entry.name == name; });
  if (reference_name_ == name) reference_name_.clear();
  if (image_name_ == name) image_name_ = entries_.empty() ? QString() : entries_.back().name;
  if (reference_name_ == image_name_) reference_name_.clear();
  fill_lists();
  show_selection();
}

void ImageBrowser::select_image(const QString& name) {
  if (find(name) == nullptr) return;
  // An image is compared with another one: the one that was shown takes the place.
  if (reference_name_ == name) reference_name_ = image_name_;
  image_name_ = name;
  show_selection();
}

void ImageBrowser::select_reference(const QString& name) {
  const bool had_none = reference_name_.isEmpty();
  if (!name.isEmpty() && find(name) == nullptr) return;
  if (name == image_name_ && !name.isEmpty()) return swap();
  reference_name_ = name;
  if (had_none && !name.isEmpty() && comparison_->currentIndex() == 0) {
    comparison_->setCurrentIndex(static_cast<int>(Comparison::Wipe));
  }
  show_selection();
}

void ImageBrowser::swap() {
  if (reference() == nullptr) return;
  std::swap(image_name_, reference_name_);
  show_selection();
}

void ImageBrowser::set_comparison(Comparison comparison) {
  comparison_->setCurrentIndex(static_cast<int>(comparison));
}

// Files

void ImageBrowser::open_files(const QStringList& paths) {
  for (const QString& path : paths) {
    run_aside(
        this, [path = absolute(path)] { return load_image(path); },
        [this](const LoadedImage& loaded) { take_loaded(loaded); });
  }
}

void ImageBrowser::take_loaded(const LoadedImage& loaded) {
  say(loaded.diagnostics);
  if (!loaded.image) return;
  put({name_of(loaded.path), loaded.path, loaded.image}, true);
  emit opened(loaded.path);
}

void ImageBrowser::ask_for_files() {
  open_files(QFileDialog::getOpenFileNames(this, tr("Open images"), {}, image_read_filter()));
}

void ImageBrowser::ask_for_name() {
  const ImageEntry* shown = image();
  if (shown == nullptr) return;
  const QString start = shown->path.isEmpty() ? shown->name + QStringLiteral(".exr") : shown->path;
  const QString path = QFileDialog::getSaveFileName(this, tr("Save the image"), start, image_write_filter());
  if (!path.isEmpty()) save_as(path);
}

void ImageBrowser::save_as(const QString& path) {
  const ImageEntry* shown = image();
  if (shown == nullptr) return;
  const float exposure = controls_->settings().exposure;
  run_aside(
      this, [image = shown->image, exposure, path] { return save_image(image, exposure, path); },
      [this](const SavedImage& result) {
        say(result.diagnostics);
        if (result.is_written) emit saved(result.path);
      });
}

void ImageBrowser::copy() const {
  const ImageAnalysis& made = analysis_;
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [this](const ImageEntry& entry) { return entry.name == image_name_; });
  if (found == entries_.end()) return;
  const SharedImage& shown = difference() && made.difference ? made.difference : found->image;
  const QRect whole(0, 0, shown->width, shown->height);
  QGuiApplication::clipboard()->setImage(ScreenColours(screen_settings()).convert(*shown, whole));
}

void ImageBrowser::dragEnterEvent(QDragEnterEvent* event) {
  if (!paths_of(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void ImageBrowser::dropEvent(QDropEvent* event) {
  open_files(paths_of(event->mimeData()));
  event->acceptProposedAction();
}

// What is shown

std::optional<Difference> ImageBrowser::difference() const {
  switch (static_cast<Comparison>(comparison_->currentIndex())) {
    case Comparison::Signed:
      return Difference::Signed;
    case Comparison::Absolute:
      return Difference::Absolute;
    case Comparison::Relative:
      return Difference::Relative;
    default:
      return std::nullopt;
  }
}

ScreenSettings ImageBrowser::screen_settings() const {
  ScreenSettings settings = controls_->settings();
  const bool is_difference = difference() && analysis_.difference;
  if (is_difference && analysis_.kind == Difference::Signed) settings.colouring = Colouring::Signed;
  const ImageFigures& figures = is_difference ? analysis_.difference_figures : analysis_.figures;
  if (figures.bright_luminance > 0) {
    settings.least = figures.dark_luminance;
    settings.largest = figures.bright_luminance;
  }
  return settings;
}

void ImageBrowser::show_selection() {
  const bool has_image = image() != nullptr;
  const bool has_reference = reference() != nullptr;
  image_list_->setCurrentIndex(image_list_->findText(image_name_));
  reference_list_->setCurrentIndex(std::max(0, reference_list_->findData(reference_name_)));
  for (QAction* action : {save_, copy_, remove_}) action->setEnabled(has_image);
  for (QAction* action : {flip_, swap_}) action->setEnabled(has_reference);
  comparison_->setEnabled(has_reference);
  comparison_->setToolTip(has_reference
                              ? tr("How A and B are shown: in turn, on both sides of a line that can be "
                                   "dragged, side by side, or their difference.")
                              : tr("Choose an image as B first: there is nothing to compare with."));
  image_list_->setEnabled(has_image);
  reference_list_->setEnabled(entries_.size() > 1);
  reference_list_->setToolTip(entries_.size() > 1 ? tr("The reference that A is compared with.")
                                                  : tr("Open a second image to compare with."));
  show_on_pane();
  start_analysis();
}

void ImageBrowser::show_on_pane() {
  const ImageEntry* first = image();
  const ImageEntry* second = reference();
  const auto comparison = static_cast<Comparison>(comparison_->currentIndex());
  const bool is_difference = second != nullptr && difference() && analysis_.difference &&
                             analysis_.image->width == first->image->width;
  if (is_difference) {
    pane_->set_image(analysis_.difference, tr("A - B: %1 against %2").arg(first->name, second->name));
  } else {
    pane_->set_image(first != nullptr ? first->image : nullptr,
                     first != nullptr ? "A: " + first->name : QString());
  }
  pane_->set_reference(second != nullptr ? second->image : nullptr,
                       second != nullptr ? "B: " + second->name : QString());
  const ScreenSettings settings = screen_settings();
  pane_->set_settings(settings);
  scale_bar_->set_settings(settings);
  scale_bar_->setVisible(first != nullptr && settings.colouring != Colouring::Natural);
  Arrangement arrangement = Arrangement::Alone;
  if (second != nullptr && comparison == Comparison::Wipe) arrangement = Arrangement::Wipe;
  if (second != nullptr && comparison == Comparison::SideBySide) arrangement = Arrangement::SideBySide;
  if (second != nullptr && flip_->isChecked()) arrangement = Arrangement::Reference;
  pane_->set_arrangement(arrangement);
  show_pixel(pixel_);
}

bool ImageBrowser::is_current(const ImageAnalysis& made) {
  const ImageEntry* first = image();
  const ImageEntry* second = reference();
  return made.image == (first != nullptr ? first->image : nullptr) &&
         made.reference == (second != nullptr ? second->image : nullptr) && made.kind == difference();
}

/// One at a time: of an image that changes all the while, the states between are left out.
void ImageBrowser::start_analysis() {
  if (is_analysing_) return;
  is_analysing_ = true;
  const SharedImage first = image() != nullptr ? image()->image : nullptr;
  const SharedImage second = reference() != nullptr ? reference()->image : nullptr;
  run_aside(
      this, [first, second, kind = difference()] { return analysis_of(first, second, kind); },
      [this](const ImageAnalysis& made) { take_analysis(made); });
}

void ImageBrowser::take_analysis(const ImageAnalysis& made) {
  is_analysing_ = false;
  analysis_ = made;
  show_on_pane();
  figures_->setText(figures_text(made));
  if (is_current(made)) {
    emit analysed();
  } else {
    start_analysis();
  }
}

void ImageBrowser::show_pixel(const std::optional<QPoint>& pixel) {
  pixel_ = pixel;
  const ImageEntry* first = image();
  const ImageEntry* second = reference();
  if (first == nullptr) return values_->clear();
  if (!pixel) return values_->setText(tr("Point at a pixel to read its values."));
  values_->setText(pixel_text(*pixel, first->image, second != nullptr ? second->image : nullptr));
}

void ImageBrowser::say(const grf::Diagnostics& diagnostics) {
  if (diagnostics.entries().empty()) return say(QString());
  say(QString::fromStdString(diagnostics.to_text()).trimmed());
  emit reported(diagnostics);
}

void ImageBrowser::say(const QString& problem) {
  message_->setText(problem);
  message_row_->setVisible(!problem.isEmpty());
}

void ImageBrowser::colour_message() {
  QPalette coloured = message_->palette();
  coloured.setColor(QPalette::WindowText, colours_of(theme_of(palette())).error);
  message_->setPalette(coloured);
}

void ImageBrowser::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && message_ != nullptr) colour_message();
  QWidget::changeEvent(event);
}

}  // namespace editor
