#include "editor/brdf/brdf_editor.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QToolButton>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/controls/scaled_slider.h"
#include "editor/controls/tab_order.h"
#include "editor/document/brdf_mime.h"

namespace editor {
namespace {

constexpr int UnfoldedWidth = 110 * Grid;

/// The hint of views that cannot show an invalid BRDF.
QString hint_of(const std::vector<QString>& errors) {
  if (errors.empty()) return {};
  return BrdfEditor::tr("Cannot show this BRDF:") + '\n' +
         QStringList(errors.begin(), errors.end()).join('\n');
}

/// A slider and a number box for one parameter of a view.
template <class Take>
void add_number(QHBoxLayout& row, const QString& name, const QString& help, const QString& unit,
                double minimum, double maximum, double value, const Take& take) {
  auto* label = new QLabel(name);
  auto* slider = new ScaledSlider;
  slider->set_range(minimum, maximum, SliderScale::Linear);
  slider->set_number(value);
  slider->setAccessibleName(name);
  slider->setToolTip(help);
  auto* box = new NumberBox;
  box->set_range(minimum, maximum);
  box->set_unit(unit);
  box->set_value(value);
  box->set_help(help);
  box->setAccessibleName(name);
  box->setFixedWidth(8 * Grid);
  label->setBuddy(box);
  row.addWidget(label);
  row.addWidget(slider, 1);
  row.addWidget(box);
  const auto from_slider = [box, take](double number) {
    box->set_value(number);
    take(number);
  };
  const auto from_box = [slider, take](double number) {
    slider->set_number(number);
    take(number);
  };
  QObject::connect(slider, &ScaledSlider::changing, box, from_slider);
  QObject::connect(box, &NumberBox::changing, slider, from_box);
  QObject::connect(box, &NumberBox::edited, slider, from_box);
}

}  // namespace

BrdfEditor::BrdfEditor(QWidget* parent) : QWidget(parent) {
  setAcceptDrops(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(Grid, Grid, Grid, Grid);
  column->setSpacing(Grid);
  bar_ = new QWidget(this);
  tight_layout<QHBoxLayout>(bar_);
  buttons_ = new QButtonGroup(this);
  column->addWidget(bar_);
  splitter_ = new QSplitter(Qt::Vertical, this);
  splitter_->setChildrenCollapsible(false);
  splitter_->setHandleWidth(Grid);
  column->addWidget(splitter_, 1);
  auto* holder = new QWidget(splitter_);
  auto* grid = tight_layout<QGridLayout>(holder, Grid);
  plots_ = new BrdfPlots;
  library_ = new BrdfLibrary;
  add_view(View::Sphere, "sphere", tr("Sphere"), tr("The BRDF on a sphere"), sphere_with_exposure());
  add_view(View::Lobe, "lobe", tr("Lobe"), tr("The lobe in three dimensions"), lobe_with_choices());
  add_view(View::Plots, "curve", tr("Plots"), tr("Plots in the plane of incidence, and albedo"), plots_);
  add_view(View::Library, "library", tr("Library"), tr("Presets, BRDFs of the scene, and your own library"),
           library_);
  // Only now, so that the tab order visits the buttons of all views before the contents of one.
  for (std::size_t i = 0; i < views_.size(); ++i)
    grid->addWidget(views_[i], static_cast<int>(i / 2), static_cast<int>(i % 2));
  auto* scroll = new QScrollArea(splitter_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  form_ = new BrdfForm;
  scroll->setWidget(form_);
  connect(buttons_, &QButtonGroup::idClicked, this, [this](int id) { set_view(static_cast<View>(id)); });
  connect(form_, &BrdfForm::changing, this, [this](const auto& models) {
    show_brdf();
    emit changing(models);
  });
  connect(form_, &BrdfForm::edited, this, [this](const auto& models) {
    show_brdf();
    emit edited(models);
  });
  connect(library_, &BrdfLibrary::chosen, this, [this](const grf::BrdfModel& brdf, const QString& name) {
    if (!name.isEmpty()) return emit definition_chosen(name);
    replace(brdf);
  });
  arrange();
}

void BrdfEditor::add_view(View view, const char* icon_name, const QString& name, const QString& tip,
                          QWidget* contents) {
  auto* button = new QToolButton(bar_);
  button->setIcon(icon(icon_name));
  button->setText(name);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setCheckable(true);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setToolTip(tip);
  button->setAccessibleName(name);
  buttons_->addButton(button, static_cast<int>(view));
  bar_->layout()->addWidget(button);
  views_[static_cast<std::size_t>(view)] = contents;
}

QWidget* BrdfEditor::sphere_with_exposure() {
  auto* holder = new QWidget;
  auto* column = tight_layout<QVBoxLayout>(holder);
  sphere_ = new LiveSphere;
  column->addWidget(sphere_, 1);
  auto* row = new QHBoxLayout;
  add_number(*row, tr("Exposure"), tr("Exposure of the sphere in stops"), "", -5, 5, 0,
             [this](double stops) { sphere_->set_exposure(stops); });
  column->addLayout(row);
  column->addWidget(light_choice());
  return holder;
}

QWidget* BrdfEditor::light_choice() {
  auto* holder = new QWidget;
  auto* row = tight_layout<QHBoxLayout>(holder);
  light_ = narrow_list(tr("Light of the sphere"), {}, 8, holder);
  light_->addItems({tr("Studio and a lamp"), tr("Environment")});
  row->addWidget(new QLabel(tr("Light")));
  row->addWidget(light_, 1);
  connect(light_, &QComboBox::currentIndexChanged, this, &BrdfEditor::light_sphere);
  set_environment(std::nullopt);
  return holder;
}

void BrdfEditor::set_environment(const std::optional<studies::Environment>& environment) {
  environment_ = environment;
  light_->setEnabled(environment.has_value());
  light_->setToolTip(environment
                         ? tr("What lights the sphere: a studio and a lamp that the pointer moves, or the "
                              "environment map of the scene, seen along -z")
                         : tr("The environment map of the scene can light the sphere; the scene has none"));
  light_sphere();
}

/// The choice is kept while the scene has no map.
void BrdfEditor::light_sphere() {
  sphere_->set_environment(light_->currentIndex() == 1 ? environment_ : std::nullopt);
}

QWidget* BrdfEditor::lobe_with_choices() {
  auto* holder = new QWidget;
  auto* column = tight_layout<QVBoxLayout>(holder);
  lobe_ = new LobeView;
  column->addWidget(lobe_, 1);
  auto* row = new QHBoxLayout;
  add_number(*row, tr("View"), tr("View angle from the normal, in degrees"), "deg", 0, 89, lobe_->view(),
             [this](double degrees) { lobe_->set_view(degrees); });
  auto* cosine = new QCheckBox("cos");
  cosine->setChecked(true);
  cosine->setToolTip(tr("Multiply by the cosine of the light direction"));
  cosine->setAccessibleName(tr("Times cosine"));
  auto* logarithmic = new QCheckBox(tr("Log"));
  logarithmic->setToolTip(tr("Logarithmic radius over five decades"));
  logarithmic->setAccessibleName(tr("Logarithmic radius"));
  row->addWidget(cosine);
  row->addWidget(logarithmic);
  connect(cosine, &QCheckBox::toggled, lobe_, &LobeView::set_with_cosine);
  connect(logarithmic, &QCheckBox::toggled, lobe_, &LobeView::set_logarithmic);
  column->addLayout(row);
  return holder;
}

void BrdfEditor::set_view(View view) {
  view_ = view;
  arrange();
}

void BrdfEditor::arrange() {
  buttons_->button(static_cast<int>(view_))->setChecked(true);
  bar_->setVisible(!is_unfolded_);
  for (std::size_t i = 0; i < views_.size(); ++i) {
    views_[i]->setVisible(is_unfolded_ || i == static_cast<std::size_t>(view_));
  }
  splitter_->setOrientation(is_unfolded_ ? Qt::Horizontal : Qt::Vertical);
  // The form is beside the views on the left, or under them.
  QWidget* form = form_->parentWidget()->parentWidget();
  splitter_->insertWidget(is_unfolded_ ? 0 : 1, form);
  lead_tab_through({is_unfolded_ ? bar_ : splitter_->widget(0), form});
  form->setMinimumWidth(is_unfolded_ ? 40 * Grid : 0);
  form->setMaximumWidth(is_unfolded_ ? 50 * Grid : QWIDGETSIZE_MAX);
  // In a dock both have about half of the height; a taller form is scrolled.
  splitter_->setStretchFactor(splitter_->indexOf(form), is_unfolded_ ? 0 : 1);
  splitter_->setStretchFactor(1 - splitter_->indexOf(form), 1);
  splitter_->setSizes(is_unfolded_ ? QList<int>{40 * Grid, 100 * Grid} : QList<int>{55 * Grid, 40 * Grid});
}

void BrdfEditor::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool is_wide = width() >= UnfoldedWidth;
  if (is_wide == is_unfolded_) return;
  is_unfolded_ = is_wide;
  arrange();
}

void BrdfEditor::set_models(const std::vector<grf::BrdfModel>& models) {
  form_->set_models(models);
  show_brdf();
}

void BrdfEditor::set_definitions(const Definitions& definitions) {
  definitions_ = definitions;
  form_->set_definitions(definitions);
  library_->set_definitions(definitions);
  show_brdf();
}

void BrdfEditor::show_brdf() {
  making_.stop();
  const auto show = [this](const SharedBrdf& brdf, const QString& hint) {
    sphere_->set_brdf(brdf, hint);
    lobe_->set_brdf(brdf, hint);
    plots_->set_brdf(brdf, hint);
  };
  if (models().empty()) {
    library_->set_current(std::nullopt);
    return show(nullptr, tr("Select faces to see their BRDF."));
  }
  const auto show_made = [show](const CompiledBrdf& made) { show(made.brdf, hint_of(made.errors)); };
  const grf::BrdfModel& model = models().front();
  library_->set_current(model);
  if (!form_->errors().empty()) return show(nullptr, hint_of(form_->errors()));
  if (!reads_data(model, definitions_)) return show_made(compile_brdf(model, definitions_));
  making_.start(
      [model, definitions = definitions_](const StopFlag&) { return compile_brdf(model, definitions); },
      show_made);
}

void BrdfEditor::replace(const grf::BrdfModel& brdf) {
  if (models().empty()) return;
  const std::vector<grf::BrdfModel> replaced(models().size(), brdf);
  set_models(replaced);
  if (form_->errors().empty()) emit edited(replaced);
}

void BrdfEditor::dragEnterEvent(QDragEnterEvent* event) {
  if (!models().empty() && event->mimeData()->hasFormat(BrdfMimeType)) event->acceptProposedAction();
}

void BrdfEditor::dropEvent(QDropEvent* event) {
  grf::Diagnostics ignored_diagnostics;
  const auto brdf = brdf_of(*event->mimeData(), reflectance::brdf_infos(), ignored_diagnostics);
  if (!brdf) return;
  event->acceptProposedAction();
  replace(*brdf);
}

}  // namespace editor
