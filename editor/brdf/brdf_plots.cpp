#include "editor/brdf/brdf_plots.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSaveFile>
#include <QSvgGenerator>
#include <QToolButton>

#include <qcustomplot.h>

#include "editor/appearance/theme.h"
#include "editor/charts/chart_painter.h"
#include "editor/controls/expression.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"
#include "grf/keywords.h"

namespace editor {
namespace {

constexpr int RoughSamples = 256;
constexpr int FineSamples = 4096;

QComboBox* list_of(const QStringList& items, const QString& name, const QString& tip, QWidget* parent) {
  QComboBox* list = narrow_list(name, tip, 6, parent);
  list->addItems(items);
  return list;
}

/// Parses angles in degrees; nothing if one is invalid.
std::optional<std::vector<double>> read_views(const QString& text) {
  std::vector<double> views;
  for (const QString& word : text.split(QRegularExpression("[,;\\s]+"), Qt::SkipEmptyParts)) {
    const Typed typed = value_of(word, units_like("deg"));
    if (!typed.value || *typed.value < 0 || *typed.value >= 90) return std::nullopt;
    views.push_back(*typed.value);
  }
  if (views.empty()) return std::nullopt;
  return views;
}

}  // namespace

BrdfPlots::BrdfPlots(QWidget* parent) : QWidget(parent) {
  auto* column = tight_layout<QVBoxLayout>(this);
  auto* kinds = new QHBoxLayout;
  build_kinds(*kinds);
  column->addLayout(kinds);
  lobe_controls_ = new QWidget(this);
  auto* controls = tight_layout<QVBoxLayout>(lobe_controls_);
  auto* choices = new QHBoxLayout;
  build_choices(*choices);
  controls->addLayout(choices);
  auto* views = new QHBoxLayout;
  build_views(*views);
  controls->addLayout(views);
  column->addWidget(lobe_controls_);
  plot_ = new QCustomPlot(this);
  plot_->setMinimumSize(25 * Grid, 22 * Grid);
  plot_->setAccessibleName(tr("Plot of the BRDF"));
  plot_->setToolTip(tr("Plot of the BRDF; the button with the arrow exports it"));
  plot_->plotLayout()->addElement(1, 0, new QCPLayoutGrid);
  auto* below = static_cast<QCPLayoutGrid*>(plot_->plotLayout()->element(1, 0));
  below->addElement(0, 0, plot_->legend);
  below->setMargins({0, 0, 0, Grid / 2});
  plot_->plotLayout()->setRowStretchFactor(1, 0.001);
  column->addWidget(plot_, 1);
  words_ = new ThemedLabel(&ThemeColours::faint_text, this);
  column->addWidget(words_);
  set_kind(Kind::Polar);
}

void BrdfPlots::build_kinds(QHBoxLayout& row) {
  row.setSpacing(Grid / 2);
  kinds_ = new QButtonGroup(this);
  const auto add = [&](Kind kind, const QString& text, const QString& tip) {
    auto* button = new QToolButton(this);
    button->setText(text);
    button->setToolTip(tip);
    button->setAccessibleName(tr("%1 plot").arg(text));
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    kinds_->addButton(button, static_cast<int>(kind));
    row.addWidget(button);
  };
  add(Kind::Polar, tr("Polar"),
      tr("Polar plot of the lobe in the plane of incidence; the radius is the value in 1/sr"));
  add(Kind::Cartesian, tr("Angle"),
      tr("Cartesian plot of the value in 1/sr against the light's angle in degrees"));
  add(Kind::Albedo, tr("Albedo"),
      tr("Directional albedo: the fraction of light reflected, against the view angle in degrees"));
  connect(kinds_, &QButtonGroup::idClicked, this, [this](int id) { set_kind(static_cast<Kind>(id)); });
  row.addWidget(tool_button(
      "export", tr("Save the plot"), tr("Save the plot as SVG, PNG or PDF, or its values as CSV"),
      [this] { choose_export(); }, this));
}

void BrdfPlots::build_choices(QHBoxLayout& row) {
  row.setSpacing(Grid / 2);
  quantity_ =
      list_of({"f", "f cos"}, tr("Plotted quantity"),
              tr("The BRDF f itself, or f times the cosine of the light's angle: both in 1/sr"), this);
  channel_ = list_of({tr("Luminance"), tr("Red"), tr("Green"), tr("Blue")}, tr("Channel"),
                     tr("The channel of the value, or its luminance"), this);
  logarithmic_ = new QCheckBox(tr("Log"), this);
  logarithmic_->setToolTip(tr("Logarithmic scale, in decades below the peak"));
  logarithmic_->setAccessibleName(tr("Logarithmic scale"));
  row.addWidget(quantity_, 1);
  row.addWidget(channel_, 2);
  row.addWidget(logarithmic_);
  connect(quantity_, &QComboBox::currentIndexChanged, this, &BrdfPlots::draw);
  connect(channel_, &QComboBox::currentIndexChanged, this, &BrdfPlots::draw);
  connect(logarithmic_, &QCheckBox::toggled, this, &BrdfPlots::draw);
}

void BrdfPlots::build_views(QHBoxLayout& row) {
  row.setSpacing(Grid / 2);
  auto* label = new QLabel(tr("Views"), this);
  view_line_ = new QLineEdit("0, 30, 60, 80", this);
  view_line_->setAccessibleName(tr("View angles"));
  view_line_->setToolTip(tr("View angles from the normal in degrees, 0 to below 90, separated by commas"));
  label->setBuddy(view_line_);
  connect(view_line_, &QLineEdit::editingFinished, this, &BrdfPlots::take_views);
  scheme_ = list_of({tr("No pdf")}, tr("Sampling scheme"),
                    tr("Sampling scheme whose pdf in 1/sr is drawn, dashed"), this);
  for (const grf::ModelInfo& info : reflectance::scheme_infos()) {
    const QString keyword = text_of(info.keyword);
    scheme_->addItem(keyword, keyword);
  }
  connect(scheme_, &QComboBox::currentIndexChanged, this, [this] {
    curves_are_old_ = true;
    compute();
  });
  row.addWidget(label);
  row.addWidget(view_line_, 1);
  row.addWidget(scheme_, 1);
}

void BrdfPlots::set_brdf(SharedBrdf brdf, const QString& hint) {
  brdf_ = std::move(brdf);
  hint_ = hint;
  curves_are_old_ = albedo_is_old_ = true;
  compute();
}

void BrdfPlots::set_scheme(const std::optional<grf::PdfModel>& scheme) {
  own_scheme_ = scheme;
  const QSignalBlocker silent(scheme_);
  scheme_->setCurrentIndex(
      scheme ? scheme_->findText(QString::fromStdString(scheme->keyword), Qt::MatchFixedString) : 0);
  curves_are_old_ = true;
  compute();
}

void BrdfPlots::set_kind(Kind kind) {
  kind_ = kind;
  kinds_->button(static_cast<int>(kind))->setChecked(true);
  lobe_controls_->setVisible(kind != Kind::Albedo);
  compute();
  draw();
}

void BrdfPlots::take_views() {
  const auto views = read_views(view_line_->text());
  QPalette look = palette();
  if (!views) look.setColor(QPalette::Text, colours_of(theme_of(palette())).error);
  view_line_->setPalette(look);
  if (!views) return show_words(tr("Enter view angles from 0 to below 90 degrees, such as 0, 30, 60."), true);
  if (*views == views_) return draw();
  views_ = *views;
  curves_are_old_ = true;
  compute();
}

void BrdfPlots::compute() {
  if (!brdf_) {
    curves_job_.stop();
    albedo_job_.stop();
    curves_ = {};
    albedo_ = {};
    return draw();
  }
  // Hidden plots are updated when they are shown.
  if (!isVisible()) return;
  if (kind_ == Kind::Albedo) {
    if (albedo_is_old_) compute_albedo(RoughSamples);
    return;
  }
  if (!curves_are_old_) return;
  curves_are_old_ = false;
  std::optional<grf::PdfModel> scheme;
  if (scheme_->currentIndex() > 0) {
    scheme.emplace();
    scheme->keyword = scheme_->currentText().toStdString();
    if (own_scheme_ && grf::same_keyword(own_scheme_->keyword, scheme->keyword)) scheme = own_scheme_;
  }
  curves_job_.start([brdf = brdf_, views = views_,
                     scheme](const StopFlag& stop) { return lobe_curves(*brdf, views, scheme, stop); },
                    [this](LobeCurves curves) {
                      curves_ = std::move(curves);
                      draw();
                      emit updated();
                    });
}

void BrdfPlots::compute_albedo(int samples) {
  albedo_is_old_ = false;
  albedo_job_.start(
      [brdf = brdf_, samples](const StopFlag& stop) {
        const reflectance::Reflector reflector(*brdf, reflectance::OwnScheme());
        return plot::albedo_curve(reflector, samples, [&stop] { return stop.is_set(); });
      },
      [this, samples](plot::AlbedoCurve curve) {
        albedo_ = std::move(curve);
        if (samples < FineSamples) compute_albedo(FineSamples);
        draw();
        emit updated();
      });
}

plot::LobeStyle BrdfPlots::style() const {
  return {static_cast<plot::Channel>(channel_->currentIndex()), quantity_->currentIndex() == 1,
          logarithmic_->isChecked()};
}

void BrdfPlots::draw() {
  const bool is_albedo = kind_ == Kind::Albedo;
  const bool is_empty = is_albedo ? albedo_.degrees.empty() : curves_.curves.empty();
  plot_->setVisible(!is_empty);
  lobe_controls_->setVisible(!is_albedo && !is_empty);
  layout()->activate();  // a polar plot depends on the aspect ratio of its widget
  if (is_empty) {
    words_->setAlignment(Qt::AlignCenter);
    show_words(brdf_ ? QString() : hint_, false);
    return;
  }
  words_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  if (is_albedo) {
    editor::draw(*plot_, plot::albedo_chart(albedo_));
    const EnergyNote words = energy_note(*brdf_, albedo_.largest);
    show_words(words.text, words.is_warning);
  } else {
    draw_lobes();
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void BrdfPlots::draw_lobes() {
  if (kind_ == Kind::Polar) {
    editor::draw(*plot_, polar_lobe_chart(curves_.curves, style()));
  } else {
    plot::Chart chart = lobe_chart(curves_.curves, style());
    add_specular_lines(chart, curves_.curves, style().channel);
    editor::draw(*plot_, chart);
  }
  const bool has_specular_part = std::ranges::any_of(curves_.curves, [](const plot::LobeCurve& curve) {
    return !reflectance::is_black(curve.specular_weight);
  });
  QStringList words;
  if (!curves_.scheme_error.isEmpty()) words << tr("No pdf: %1.").arg(curves_.scheme_error);
  if (has_specular_part)
    words << tr(
        "Straight lines: the specular (delta) part; its length is the fraction of light that it reflects.");
  show_words(words.join('\n'), !curves_.scheme_error.isEmpty());
}

void BrdfPlots::show_words(const QString& text, bool is_warning) {
  words_->set_colour(is_warning ? &ThemeColours::warning : &ThemeColours::faint_text);
  show_or_hide(words_, text);
}

QString BrdfPlots::export_to(const QString& path) {
  const auto has_ending = [&](const char* ending) { return path.endsWith(ending, Qt::CaseInsensitive); };
  const int width = std::max(plot_->width(), 80 * Grid);
  const int height = std::max(plot_->height(), 60 * Grid);
  bool is_written = false;
  if (has_ending(".csv")) {
    QSaveFile file(path);
    const QString text = kind_ == Kind::Albedo ? albedo_csv(albedo_) : curves_csv(curves_);
    is_written = file.open(QIODevice::WriteOnly) && file.write(text.toUtf8()) >= 0 && file.commit();
  } else if (has_ending(".svg")) {
    QSvgGenerator generator;
    generator.setFileName(path);
    generator.setSize({width, height});
    generator.setViewBox(QRect(0, 0, width, height));
    QCPPainter painter;
    is_written = painter.begin(&generator);
    if (is_written) {
      painter.setMode(QCPPainter::pmVectorized);
      plot_->toPainter(&painter, width, height);
      painter.end();
    }
  } else if (has_ending(".pdf")) {
    is_written = plot_->savePdf(path, width, height);
  } else if (has_ending(".png")) {
    is_written = plot_->savePng(path, width, height, 2);
  } else {
    return tr("Cannot save the plot: the file name must end in .svg, .png, .pdf or .csv.");
  }
  return is_written ? QString() : tr("Cannot write '%1'.").arg(path);
}

void BrdfPlots::choose_export() {
  auto* dialog = new QFileDialog(window(), tr("Save the plot"), "brdf.svg",
                                 tr("SVG (*.svg);;PNG (*.png);;PDF (*.pdf);;Values as CSV (*.csv)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    const QString message = export_to(path);
    if (!message.isEmpty()) show_words(message, true);
  });
  dialog->open();
}

void BrdfPlots::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) draw();
  QWidget::changeEvent(event);
}

void BrdfPlots::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  draw();
}

void BrdfPlots::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  compute();
}

}  // namespace editor
