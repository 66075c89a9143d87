#include "editor/image/image_browser.h"

#include <QAction>
#include <QClipboard>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFutureWatcher>
#include <QGuiApplication>
#include <QLabel>
#include <QMimeData>
#include <QVBoxLayout>
#include <QtConcurrent>

#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/notice_bar.h"
#include "editor/controls/text.h"
#include "editor/image/image_texts.h"
#include "editor/image/scale_bar.h"
#include "editor/image/screen_controls.h"

namespace editor {
namespace {

/// Runs work in a thread, and delivers its result if the receiver still lives.
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

QString absolute(const QString& path) { return QDir::cleanPath(QFileInfo(path).absoluteFilePath()); }

QString title_of(const QString& letter, const ShownImage& shown) {
  return shown.image ? letter + ": " + shown.name : QString();
}

}  // namespace

ImageBrowser::ImageBrowser(QWidget* parent)
    : QWidget(parent),
      pane_(new ImagePane),  // parts of it once they are laid out: Tab leads through them in that order
      tools_(new ImageTools(*pane_)),
      scale_bar_(new ScaleBar),
      notice_(new NoticeBar),
      values_(new QLabel),
      statistics_(new QLabel) {
  setAcceptDrops(true);
  pane_->set_hint(tr("Drop an image here, open one, or render: exr, hdr, pfm, raw, png, jpg, tga or webp."));
  connect(pane_, &ImagePane::hovered, this, &ImageBrowser::show_pixel);
  connect_tools();
  lay_out();
  show_selection();
}

void ImageBrowser::connect_tools() {
  connect(&controls(), &ScreenControls::edited, this, &ImageBrowser::show_on_pane);
  connect(tools_->open, &QAction::triggered, this, &ImageBrowser::ask_for_files);
  connect(tools_->save, &QAction::triggered, this, &ImageBrowser::ask_for_name);
  connect(tools_->copy, &QAction::triggered, this, &ImageBrowser::copy);
  connect(tools_->remove, &QAction::triggered, this, [this] { remove_image(selection_.image().name); });
  connect(tools_->flip, &QAction::toggled, this, &ImageBrowser::show_on_pane);
  connect(tools_->swap, &QAction::triggered, this, [this] {
    selection_.swap();
    show_selection();
  });
  connect(tools_, &ImageTools::image_chosen, this, &ImageBrowser::select_image);
  connect(tools_, &ImageTools::reference_chosen, this, &ImageBrowser::select_reference);
  connect(tools_, &ImageTools::layer_chosen, this, &ImageBrowser::select_layer);
  connect(tools_, &ImageTools::comparison_changed, this, &ImageBrowser::show_selection);
}

void ImageBrowser::lay_out() {
  auto* column = tight_layout<QVBoxLayout>(this, 0);
  column->addWidget(tools_);
  column->addWidget(notice_);
  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  middle->addWidget(pane_, 1);
  middle->addWidget(scale_bar_);
  column->addLayout(middle, 1);
  for (QLabel* line : {values_, statistics_}) {
    line->setContentsMargins(Grid, Grid / 2, Grid, line == statistics_ ? Grid / 2 : 0);
    line->setTextInteractionFlags(Qt::TextSelectableByMouse);
    line->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    column->addWidget(line);
  }
  values_->setAccessibleName(tr("Values of the pixel"));
  values_->setToolTip(tr("Linear values of the pixel under the pointer"));
  statistics_->setAccessibleName(tr("Image statistics"));
  statistics_->setToolTip(tr("Statistics of the whole image: its range and mean, or its error against B"));
}

// Images

void ImageBrowser::put(const ImageEntry& entry, bool is_wanted) {
  selection_.put(entry, is_wanted);
  show_selection();
}

void ImageBrowser::show_image(const QString& name, SharedImage image) {
  put({name, {}, std::move(image)}, false);
}

void ImageBrowser::show_image_of(const QString& path, SharedImage image) {
  put({selection_.name_of(absolute(path)), absolute(path), std::move(image)}, false);
}

void ImageBrowser::remove_image(const QString& name) {
  selection_.remove(name);
  show_selection();
}

void ImageBrowser::select_image(const QString& name) {
  selection_.select(name);
  show_selection();
}

void ImageBrowser::select_reference(const QString& name) {
  const bool had_none = !selection_.reference().image;
  selection_.select_reference(name);
  if (had_none) wipe_unless_compared();
  show_selection();
}

void ImageBrowser::wipe_unless_compared() {
  if (selection_.reference().image && tools_->comparison() == Comparison::None) {
    set_comparison(Comparison::Wipe);
  }
}

void ImageBrowser::select_layer(const QString& name) {
  selection_.select_layer(name);
  show_selection();
}

// Files

void ImageBrowser::open_files(const QStringList& paths) {
  for (const QString& path : paths) {
    run_aside(
        this, [path = absolute(path)] { return load_image(path); },
        [this](const LoadedImage& loaded) { take_loaded(loaded, selection_.name_of(loaded.path), true); });
  }
}

void ImageBrowser::reload(const QString& path) {
  run_aside(
      this, [path = absolute(path)] { return load_image(path); },
      [this](const LoadedImage& loaded) { take_loaded(loaded, selection_.name_of(loaded.path), false); });
}

void ImageBrowser::compare(const QString& path, const QString& former_path, const QString& former_name) {
  using Pair = std::pair<LoadedImage, LoadedImage>;
  run_aside(
      this,
      [now = absolute(path), former = absolute(former_path)] {
        return Pair(load_image(now), load_image(former));
      },
      [this, former_name](const Pair& loaded) {
        const QString name = selection_.name_of(loaded.first.path);
        if (!take_loaded(loaded.second, former_name, true) || !take_loaded(loaded.first, name, true)) return;
        selection_.select(name);
        selection_.select_reference(former_name);
        wipe_unless_compared();
        show_selection();
      });
}

/// Returns false if there is no image.
bool ImageBrowser::take_loaded(const LoadedImage& loaded, const QString& name, bool is_wanted) {
  show_diagnostics(loaded.diagnostics);
  if (!loaded.image) return false;
  put({name, loaded.path, loaded.image, loaded.layers}, is_wanted);
  emit opened(loaded.path);
  return true;
}

void ImageBrowser::ask_for_files() {
  open_files(QFileDialog::getOpenFileNames(this, tr("Open images"), {}, image_read_filter()));
}

void ImageBrowser::ask_for_name() {
  if (!image_.image) return;
  const QString& own = selection_.image().path;
  const QString start = own.isEmpty() || !image_.layer.isEmpty() ? image_.name + QStringLiteral(".exr") : own;
  const QString path = QFileDialog::getSaveFileName(this, tr("Save the image"), start, image_write_filter());
  if (!path.isEmpty()) save_as(path);
}

void ImageBrowser::save_as(const QString& path) {
  if (!image_.image) return;
  const float exposure = controls().settings().exposure;
  grf::Diagnostics ignored_diagnostics;  // writing reports it again
  const image::ImageFormat* format = image::image_format_of(path.toStdString(), ignored_diagnostics);
  const bool is_linear = format == nullptr || format->is_linear;
  ScreenSettings settings;
  if (analysis_.image == image_.image) fit_range(image_, analysis_.statistics, settings);
  const auto work = [shown = image_, is_linear, settings, exposure, path] {
    const SharedImage image = is_linear ? shown.image : in_range(shown, settings);
    return save_image({{}, {}, image, shown.layer.isEmpty() ? shown.layers : nullptr}, exposure, path);
  };
  run_aside(this, work, [this](const SavedImage& result) {
    show_diagnostics(result.diagnostics);
    if (result.is_written) emit saved(result.path);
  });
}

void ImageBrowser::copy() const {
  const bool is_difference = tools_->difference() && analysis_.difference;
  const SharedImage& shown = is_difference ? analysis_.difference : image_.image;
  if (!shown) return;
  const QRect whole(0, 0, shown->width, shown->height);
  QGuiApplication::clipboard()->setImage(ScreenColours(screen_settings()).convert(*shown, whole));
}

void ImageBrowser::dragEnterEvent(QDragEnterEvent* event) {
  if (!local_files(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void ImageBrowser::dropEvent(QDropEvent* event) {
  open_files(local_files(*event->mimeData()));
  event->acceptProposedAction();
}

// Display

ScreenSettings ImageBrowser::screen_settings() const {
  ScreenSettings settings = tools_->controls().settings();
  const bool is_difference = tools_->difference() && analysis_.difference;
  if (is_difference && analysis_.kind == Difference::Signed) settings.colouring = Colouring::Signed;
  if (analysis_.image == image_.image) fit_range(image_, analysis_.statistics, settings);
  if (is_difference) {
    settings.white -= settings.black;
    settings.black = 0;
  }
  const ImageStatistics& statistics = is_difference ? analysis_.difference_statistics : analysis_.statistics;
  if (statistics.bright_luminance > 0) {
    settings.least = statistics.dark_luminance;
    settings.largest = statistics.bright_luminance;
  }
  return settings;
}

void ImageBrowser::show_selection() {
  show_layer();
  tools_->show_selection(selection_);
  show_on_pane();
  start_analysis();
}

/// Each layer keeps its own settings of the display.
void ImageBrowser::show_layer() {
  const QString layer = selection_.layer();
  if (layer != image_.layer) {
    settings_of_layers_[image_.layer] = controls().settings();
    const auto kept = settings_of_layers_.find(layer);
    controls().set_settings(kept == settings_of_layers_.end() ? default_settings(layer) : kept->second);
  }
  update_shown(selection_.image(), layer, image_);
  update_shown(selection_.reference(), layer, reference_);
}

void ImageBrowser::show_on_pane() {
  const ShownImage& first = image_;
  const ShownImage& second = reference_;
  const bool is_difference = second.image && tools_->difference() && analysis_.difference &&
                             analysis_.image->width == first.image->width;
  if (is_difference) {
    pane_->set_image(analysis_.difference, tr("A - B: %1 against %2").arg(first.name, second.name));
  } else {
    pane_->set_image(first.image, title_of("A", first));
  }
  pane_->set_reference(second.image, title_of("B", second));
  const ScreenSettings settings = screen_settings();
  pane_->set_settings(settings);
  scale_bar_->set_settings(settings);
  scale_bar_->setVisible(first.image && settings.colouring != Colouring::Natural);
  pane_->set_arrangement(second.image ? tools_->arrangement() : Arrangement::Alone);
  show_pixel(pixel_);
}

bool ImageBrowser::is_current(const ImageAnalysis& made) const {
  return made.image == image_.image && made.reference == reference_.image &&
         made.kind == tools_->difference();
}

/// Runs one analysis at a time: intermediate states of an image that keeps changing are skipped.
void ImageBrowser::start_analysis() {
  if (is_analysing_) return;
  is_analysing_ = true;
  const SharedImage first = image_.image;
  const SharedImage second = reference_.image;
  run_aside(
      this, [first, second, kind = tools_->difference()] { return analysis_of(first, second, kind); },
      [this](const ImageAnalysis& made) { take_analysis(made); });
}

void ImageBrowser::take_analysis(const ImageAnalysis& made) {
  is_analysing_ = false;
  analysis_ = made;
  show_on_pane();
  statistics_->setText(statistics_text(made, image_, reference_));
  if (!is_current(made)) start_analysis();
}

void ImageBrowser::show_pixel(const std::optional<QPoint>& pixel) {
  pixel_ = pixel;
  if (!image_.image) return values_->clear();
  values_->setText(pixel ? pixel_text(*pixel, image_, reference_.image)
                         : tr("Point at a pixel to read its values."));
}

void ImageBrowser::show_diagnostics(const grf::Diagnostics& diagnostics) {
  if (diagnostics.entries().empty()) return notice_->hide();
  notice_->show_notice(NoticeBar::Kind::Error, text_of(diagnostics));
  emit reported(diagnostics);
}

}  // namespace editor
