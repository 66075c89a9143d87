#include "editor/panels/opacity_row.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>

#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"

namespace editor {
namespace {

using Kind = grf::Opacity::Kind;

/// The value with which a kind of opacity begins.
grf::Opacity initial(Kind kind) { return {kind, kind == Kind::Mask ? 0.5F : 1.0F}; }

}  // namespace

OpacityRow::OpacityRow(Document& document, QWidget* parent)
    : SurfaceRow(document, parent), choice_(new QComboBox(this)) {
  // In the order of grf::Opacity::Kind.
  choice_->addItems({tr("Uniform"), tr("Cut out by alpha"), tr("Blended by alpha")});
  choice_->setAccessibleName(tr("Kind of opacity"));
  choice_->setFocusPolicy(Qt::StrongFocus);
  value_ =
      number_box({tr("Opacity"),
                  tr("Fraction of light that meets the faces. Cut out by alpha: the alpha of the texture "
                     "below which they are absent. Blended by alpha: a factor of that alpha"),
                  0,
                  1,
                  0.05,
                  {}},
                 this);
  reset_ = tool_button(
      "reset", tr("Reset the opacity"), {}, [this] { assign(AttributeEdit<grf::Opacity>::remove(), {}); },
      this);
  field_ = value_;
  auto* line = tight_layout<QHBoxLayout>(this, Grid / 4);
  line->addWidget(choice_, 1);
  line->addWidget(value_, 1);
  line->addWidget(reset_);
  connect(choice_, &QComboBox::activated, this, &OpacityRow::choose);
  const auto take = [this](double value) {
    assign(AttributeEdit<grf::Opacity>::set({shown_.kind, static_cast<float>(value)}), "opacity");
  };
  connect_number(value_, this, take, [this] { document_.finish_gesture(); });
}

void OpacityRow::show_summary(const SelectionSummary& summary) {
  const auto& common = summary.surface.opacity;
  const QSignalBlocker blocker(choice_);
  shown_ = common.is_mixed ? grf::Opacity() : common.value.value_or(grf::Opacity());
  choice_->setCurrentIndex(common.is_mixed ? -1 : static_cast<int>(shown_.kind));
  if (common.is_mixed) {
    value_->set_mixed();
  } else {
    value_->set_value(static_cast<double>(shown_.value));
  }
  // A mesh light has no attribute but its radiance.
  const QString lit = why_not_reflecting(summary);
  enable(choice_,
         tr("Uniform, or by the alpha of the texture: faces that are absent below a cutoff, or that let part "
            "of the light pass"),
         lit);
  value_->setEnabled(lit.isEmpty());
  enable(reset_, tr("Reset to the default: opaque"),
         common.is_mixed || common.value ? QString() : tr("The faces are opaque."));
}

void OpacityRow::choose(int index) {
  const auto kind = static_cast<Kind>(index);
  if (kind != shown_.kind) assign(AttributeEdit<grf::Opacity>::set(initial(kind)), {});
}

void OpacityRow::assign(const AttributeEdit<grf::Opacity>& opacity, const QString& key) {
  SurfaceEdit edit;
  edit.opacity = opacity;
  document_.edit_surfaces(opacity.value() ? tr("Set opacity") : tr("Reset opacity"), edit, key);
}

}  // namespace editor
