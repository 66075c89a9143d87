#include "editor/rendering/effects_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/controls/text.h"
#include "editor/document/document.h"
#include "editor/document/op_document.h"
#include "editor/rendering/fitted_image.h"
#include "renderer/image/image.h"

namespace editor {
namespace {

using transport::Effect;

constexpr QSize Thumbnail(9 * Grid, 6 * Grid);
/// How long scene and options must stay as they are before they are planned, milliseconds.
constexpr int SettlingTime = 150;
constexpr double DefaultSeconds = 20;
/// The pixels of a difference that may be clipped once it is brightened.
constexpr double Clipped = 0.01;

/// `12.3 %`, and a second line with the interval. Intervals of less than the last digit are one number.
QString share_text(const std::optional<ShareInterval>& share) {
  if (!share) return EffectsPage::tr("unknown");
  const auto number = [](double fraction) {
    QString text = QString::number(100 * fraction, 'f', 1);
    return text == QLatin1String("-0.0") ? QStringLiteral("0.0") : text;
  };
  QString value = EffectsPage::tr("%1 %").arg(number(share->share));
  if (number(share->low) == number(share->high)) return value;
  return value + "\n" + EffectsPage::tr("%1 to %2 %").arg(number(share->low), number(share->high));
}

/// Absolute differences of pixels, brightened until only some of them are clipped.
image::Image brightened_difference(const image::Image& full, const image::Image& without) {
  image::Image result = full;
  std::vector<float> brightest;
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) result.pixels[i][c] = std::abs(full.pixels[i][c] - without.pixels[i][c]);
    brightest.push_back(std::max({result.pixels[i].x, result.pixels[i].y, result.pixels[i].z}));
  }
  const auto rank = static_cast<std::ptrdiff_t>((1 - Clipped) * static_cast<double>(brightest.size() - 1));
  std::nth_element(brightest.begin(), brightest.begin() + rank, brightest.end());
  const float bright = brightest[static_cast<std::size_t>(rank)];
  if (bright > 0) {
    for (auto& pixel : result.pixels) pixel /= bright;
  }
  return result;
}

}  // namespace

QString title_of(Effect effect) {
  switch (effect) {
    case Effect::AreaLights:
      return EffectsPage::tr("Area lights");
    case Effect::Environment:
      return EffectsPage::tr("Environment map");
    case Effect::Background:
      return EffectsPage::tr("Background");
    case Effect::DiffuseInterreflection:
      return EffectsPage::tr("Diffuse interreflection");
    case Effect::GlossyInterreflection:
      return EffectsPage::tr("Glossy interreflection");
    case Effect::MirrorReflection:
      return EffectsPage::tr("Mirror reflection");
    case Effect::Transmission:
      return EffectsPage::tr("Transmission");
    case Effect::Anisotropy:
      return EffectsPage::tr("Anisotropy");
    case Effect::Textures:
      return EffectsPage::tr("Textures");
    case Effect::Opacity:
      return EffectsPage::tr("Opacity");
    case Effect::VertexColours:
      return EffectsPage::tr("Vertex colours");
    case Effect::InterpolatedNormals:
      return EffectsPage::tr("Interpolated normals");
    case Effect::MeasuredData:
      return EffectsPage::tr("Measured BRDFs");
    case Effect::Irradiance:
      return EffectsPage::tr("Baked irradiance");
    case Effect::DepthOfField:
      return EffectsPage::tr("Depth of field");
    case Effect::Instances:
      return EffectsPage::tr("Instances");
  }
  return {};
}

EffectsPage::EffectsPage(Document& document, std::function<FinalRenderRequest()> request,
                         const QString& program, QWidget* parent)
    : QWidget(parent),
      document_(document),
      request_(std::move(request)),
      state_(new QLabel(this)),
      measurement_(program) {
  make_buttons();
  lay_out();
  connect_document();
  connect(table_, &QTreeWidget::currentItemChanged, this, &EffectsPage::show_state);
  connect(table_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
    if (!is_filling_ && column == Name) toggle(*item);
  });
  connect(table_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item, int column) {
    if (column == Why) select_faces(table_->indexOfTopLevelItem(item));
  });
  connect(table_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item, int) {
    select_faces(table_->indexOfTopLevelItem(item));
    if (!document_.selection().empty() || !document_.selected_objects().empty()) emit scene_requested();
  });
  connect(&measurement_, &SnapshotProcess::reported, this, &EffectsPage::take_line);
  connect(&measurement_, &SnapshotProcess::finished, this, [this] { end({}); });
  connect(&measurement_, &SnapshotProcess::failed, this, &EffectsPage::end);
  show_state();
}

void EffectsPage::make_buttons() {
  const auto button = [this](const QString& text, const char* sign, const QString& tip, auto pressed) {
    auto* made = new QPushButton(icon(sign), text, this);
    made->setToolTip(tip);
    made->setAccessibleDescription(tip);
    made->setAutoDefault(false);
    connect(made, &QPushButton::clicked, this, pressed);
    return made;
  };
  measure_ = button(tr("Measure"), "curve",
                    tr("Render a small image with and without each effect, in the background with the lowest "
                       "priority"),
                    [this] { measure(); });
  measure_->setObjectName("measure");
  seconds_ =
      number_box({tr("Time of the measurement"),
                  tr("Processor time for all effects together; more of it makes the intervals smaller"), 0.1,
                  3600, 5, tr("s")},
                 this);
  seconds_->set_value(DefaultSeconds);
  select_ = button(tr("Select faces"), "pick", tr("Select the faces and lamps that call for the effect"),
                   [this] { select_faces(current_row()); });
  compare_ =
      button(tr("Difference to the full image"), "swap",
             tr("Compare the measured images without the effect, A, and with it, B, on the page Images"),
             [this] { compare(); });
  all_on_ = button(tr("Switch all on"), "reset", tr("Render all effects that the scene calls for"),
                   [this] { switch_all_on(); });
}

void EffectsPage::lay_out() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(Grid, Grid, Grid, Grid);
  column->setSpacing(Grid);
  auto* row = new QHBoxLayout;
  row->setSpacing(Grid / 2);
  for (QWidget* each : std::initializer_list<QWidget*>{measure_, seconds_, select_, compare_, all_on_}) {
    row->addWidget(each);
  }
  row->addStretch();
  column->addLayout(row);
  state_->setAccessibleName(tr("State of the measurement"));
  state_->setWordWrap(true);
  column->addWidget(state_);
  table_ = new QTreeWidget(this);  // after the buttons: Tab follows the order of creation
  column->addWidget(table_, 1);
  table_->setAccessibleName(tr("Effects of the scene"));
  table_->setToolTip(
      tr("Effects of the scene. Space switches the current one on or off; Return selects the faces and lamps "
         "that call for it, and shows the scene"));
  table_->setRootIsDecorated(false);
  table_->setWordWrap(true);
  table_->setAlternatingRowColors(true);
  table_->setIconSize(Thumbnail);
  table_->setTextElideMode(Qt::ElideRight);
  table_->setHeaderLabels({tr("Effect"), tr("Needed, and why"), tr("Share of the light"),
                           tr("Share of the time"), tr("Difference")});
  QTreeWidgetItem& head = *table_->headerItem();
  head.setToolTip(Light,
                  tr("The part of the image's light that is lost without the effect, with the interval "
                     "that contains it with 95 % probability; negative if the image gets brighter"));
  head.setToolTip(Time,
                  tr("The part of the render time that is saved without the effect, for as many samples, "
                     "with such an interval"));
  head.setToolTip(Difference, tr("The root mean square difference of pixels to the full image, compared with "
                                 "its mean; the picture of it is brightened"));
  QHeaderView& header = *table_->header();
  header.setStretchLastSection(false);
  header.setSectionResizeMode(QHeaderView::Interactive);
  header.setSectionResizeMode(Why, QHeaderView::Stretch);
  header.setMinimumSectionSize(12 * Grid);
  header.resizeSection(Name, 24 * Grid);
  for (const Column each : {Light, Time}) header.resizeSection(each, 17 * Grid);
  header.resizeSection(Difference, 19 * Grid);
}

void EffectsPage::connect_document() {
  settling_.setSingleShot(true);
  settling_.setInterval(SettlingTime);
  connect(&settling_, &QTimer::timeout, this, &EffectsPage::follow);
  connect(&document_, &Document::changed, this, &EffectsPage::outdate);
  connect(&document_, &Document::path_changed, this, &EffectsPage::outdate);
  connect(&document_.options(), &OpDocument::changed, this, &EffectsPage::outdate);
  connect(&document_, &Document::scene_replaced, this, [this] {
    measured_.clear();
    show_rows();
  });
}

/// A measurement of what is not any more is worth nothing.
void EffectsPage::outdate() {
  is_plan_outdated_ = true;
  are_shares_outdated_ = true;
  measurement_.stop();
  problem_.clear();
  settling_.start();
  show_rows();
}

void EffectsPage::follow() {
  if (!is_plan_outdated_ || !isVisible()) return;
  is_plan_outdated_ = false;
  planning_.start([request = request_(), objects = document_.shared_objects()](
                      const StopFlag&) { return effect_plan(request, *objects); },
                  [this](EffectPlan plan) {
                    plan_ = std::move(plan);
                    show_rows();
                  });
}

void EffectsPage::show_rows() {
  is_filling_ = true;
  while (table_->topLevelItemCount() > static_cast<int>(plan_.rows.size()))
    delete table_->takeTopLevelItem(0);
  while (table_->topLevelItemCount() < static_cast<int>(plan_.rows.size())) {
    table_->addTopLevelItem(new QTreeWidgetItem);
  }
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    show_row(*table_->topLevelItem(i), plan_.rows[static_cast<std::size_t>(i)]);
  }
  if (table_->currentItem() == nullptr) table_->setCurrentItem(table_->topLevelItem(0));
  is_filling_ = false;
  show_state();
}

void EffectsPage::show_row(QTreeWidgetItem& item, const EffectRow& row) {
  const auto& info = transport::EffectInfos[static_cast<std::size_t>(row.effect)];
  item.setText(Name, title_of(row.effect));
  item.setCheckState(Name, row.is_on ? Qt::Checked : Qt::Unchecked);
  item.setToolTip(Name, tr("If it is switched off: %1").arg(text_of(info.without)));
  item.setText(Why, (row.is_needed ? tr("Needed: %1") : tr("Not needed: %1")).arg(row.why));
  const bool has_places = !row.faces.empty() || !row.lights.empty();
  item.setToolTip(Why, has_places ? row.why + ". " + tr("Click to select these faces and lamps") : row.why);
  item.setSizeHint(Name, {0, row.is_needed ? Thumbnail.height() + Grid / 2 : 3 * Grid + Grid / 2});
  show_shares(item, row.effect);
  const ThemeColours colours = colours_of(theme_of(palette()));
  for (int column = 0; column < ColumnCount; ++column) {
    const bool is_faint = !row.is_needed || (column >= Light && are_shares_outdated_);
    item.setForeground(column, is_faint ? colours.faint_text : colours.text);
  }
  if (row.is_needed && has_places) item.setForeground(Why, palette().link());
}

void EffectsPage::show_shares(QTreeWidgetItem& item, Effect effect) {
  const auto found = measured_.find(effect);
  const bool is_known = found != measured_.end();
  const auto difference = is_known ? found->second.shares.difference : std::nullopt;
  item.setText(Light, is_known ? share_text(found->second.shares.light) : QString());
  item.setText(Time, is_known ? share_text(found->second.shares.time) : QString());
  item.setText(Difference, difference ? tr("%1 %").arg(100 * *difference, 0, 'f', 1) : QString());
  item.setIcon(Difference, is_known ? QIcon(QPixmap::fromImage(found->second.picture)) : QIcon());
}

void EffectsPage::show_state() {
  const int row = current_row();
  const EffectRow* current = row >= 0 ? &plan_.rows[static_cast<std::size_t>(row)] : nullptr;
  const bool has_places = current != nullptr && (!current->faces.empty() || !current->lights.empty());
  select_->setEnabled(has_places);
  compare_->setEnabled(current != nullptr && measured_.contains(current->effect));
  const auto is_off = [](const EffectRow& each) { return !each.is_on; };
  all_on_->setEnabled(std::any_of(plan_.rows.begin(), plan_.rows.end(), is_off));
  measure_->setText(is_measuring() ? tr("Stop measuring") : tr("Measure"));
  measure_->setIcon(icon(is_measuring() ? "stop" : "curve"));
  measure_->setEnabled(is_measuring() || !plan_.rows.empty());
  if (!plan_.problem.isEmpty()) return state_->setText(plan_.problem);
  if (!problem_.isEmpty()) return state_->setText(tr("Cannot measure: %1").arg(problem_));
  if (is_measuring()) {
    return state_->setText(tr("Measuring: %1 of %2 effects").arg(measured_.size()).arg(to_measure_));
  }
  if (measured_.empty()) return state_->setText(tr("Measure what each effect costs and contributes."));
  state_->setText(
      are_shares_outdated_
          ? tr("The scene or its options have changed since the effects were measured.")
          : tr("Measured on a small image: what is lost without the effect, with intervals of 95 % "
               "probability."));
}

void EffectsPage::measure() {
  if (is_measuring()) {
    measurement_.stop();
    return show_state();
  }
  measured_.clear();
  problem_.clear();
  are_shares_outdated_ = false;
  const auto is_measured = [](const EffectRow& row) {
    return row.is_needed && row.effect != Effect::Instances;
  };
  to_measure_ = static_cast<int>(std::count_if(plan_.rows.begin(), plan_.rows.end(), is_measured));
  measurement_.start(request_(), QStringLiteral("plan"),
                     {"--measure", "--measure-seconds", QString::number(seconds_->value()), "--json",
                      "--progress", "json", "--measure-images", measurement_.folder()});
  show_rows();
}

void EffectsPage::take_line(const QByteArray& line) {
  const auto shares = effect_shares_of(line);
  if (!shares) return;
  for (const transport::EffectInfo& info : transport::EffectInfos) {
    if (text_of(info.name) == shares->name) measured_[info.effect] = {*shares, picture_of(info.effect)};
  }
  show_rows();
}

void EffectsPage::end(const QString& problem) {
  problem_ = problem;
  show_state();
}

QString EffectsPage::image_of(Effect effect, const QString& kind) const {
  return measurement_.folder() + "/" + text_of(name_of(effect)) + "_" + kind + ".exr";
}

QImage EffectsPage::picture_of(Effect effect) const {
  grf::Diagnostics diagnostics;
  const auto full = image::read_image(image_of(effect, "full").toStdString(), diagnostics);
  const auto without = image::read_image(image_of(effect, "without").toStdString(), diagnostics);
  if (!full || !without || full->pixels.size() != without->pixels.size()) return {};
  const qreal ratio = devicePixelRatioF();
  QImage picture = fitted(brightened_difference(*full, *without), Thumbnail * ratio);
  picture.setDevicePixelRatio(ratio);
  return picture;
}

const EffectShares* EffectsPage::shares_of(Effect effect) const {
  const auto found = measured_.find(effect);
  return found == measured_.end() ? nullptr : &found->second.shares;
}

void EffectsPage::toggle(QTreeWidgetItem& item) {
  const EffectRow& row = plan_.rows[static_cast<std::size_t>(table_->indexOfTopLevelItem(&item))];
  const bool is_on = item.checkState(Name) == Qt::Checked;
  options::RenderOptions now = document_.options().valid_options();
  switch_effect(now, row.effect, is_on);
  document_.options().set_options(
      (is_on ? tr("Switch on: %1") : tr("Switch off: %1")).arg(title_of(row.effect)), now);
}

void EffectsPage::switch_all_on() {
  options::RenderOptions now = document_.options().valid_options();
  now.only = options::RenderOptions().only;
  now.without.clear();
  document_.options().set_options(tr("Switch all effects on"), now);
}

void EffectsPage::select_faces(int row) {
  if (row < 0) return;
  const EffectRow& chosen = plan_.rows[static_cast<std::size_t>(row)];
  if (chosen.faces.empty() && chosen.lights.empty()) {
    return emit status_message(tr("No face or lamp calls for it: %1").arg(chosen.why));
  }
  if (!chosen.faces.fits(document_.objects())) return;
  document_.select(chosen.faces);
  document_.select_objects(chosen.lights);
  emit status_message(tr("Selected because they call for it: faces: %1, area lights: %2 (%3)")
                          .arg(chosen.faces.count())
                          .arg(chosen.lights.size())
                          .arg(title_of(chosen.effect)));
}

void EffectsPage::compare() {
  const Effect effect = plan_.rows[static_cast<std::size_t>(current_row())].effect;
  emit comparison_requested(image_of(effect, "without"), image_of(effect, "full"),
                            tr("%1: full image").arg(title_of(effect)));
}

int EffectsPage::current_row() const { return table_->indexOfTopLevelItem(table_->currentItem()); }

void EffectsPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  follow();
}

void EffectsPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) show_rows();
}

}  // namespace editor
