#include "editor/panels/value_rows.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <limits>
#include <numbers>
#include <variant>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/document/light_edits.h"
#include "editor/panels/colour_fields.h"

namespace editor {
namespace {

constexpr double Largest = std::numeric_limits<float>::max();

/// Shows a value that the faces share.
void show_common(ColourFields* fields, bool is_mixed, const std::optional<grf::Colour>& value) {
  if (is_mixed) {
    fields->show_blank(mixed_text());
  } else if (value) {
    fields->show_colour(*value);
  } else {
    fields->show_blank({});
  }
}

}  // namespace

ColourRow::ColourRow(Document& document, QWidget* parent)
    : SurfaceRow(document, parent), choice_(new QComboBox(this)) {
  fields_ = new ColourFields(tr("Colour"), tr("linear RGB factor of the BRDF"), 1, this);
  field_ = fields_->field();
  choice_->setAccessibleName(tr("Name of the colour"));
  choice_->setToolTip(tr("A named colour of the scene, or RGB values only for these faces"));
  choice_->setFocusPolicy(Qt::StrongFocus);
  reset_ = tool_button(
      "reset", tr("Reset the colour"), {},
      [this] { assign(AttributeEdit<grf::ColourAttribute>::remove(), {}); }, this);
  auto* lines = tight_layout<QVBoxLayout>(this);
  lines->addWidget(choice_);
  auto* line = new QHBoxLayout;
  line->setSpacing(Grid / 4);
  line->addWidget(fields_, 1);
  line->addWidget(reset_);
  lines->addLayout(line);
  connect(choice_, &QComboBox::activated, this, &ColourRow::choose);
  connect(fields_, &ColourFields::edited, this, [this](const grf::Colour& colour) {
    assign(AttributeEdit<grf::ColourAttribute>::set(colour), "colour");
  });
  connect(fields_, &ColourFields::finished, this, [this] { document_.finish_gesture(); });
}

void ColourRow::show_summary(const SelectionSummary& summary) {
  const auto& common = summary.surface.colour;
  const QSignalBlocker blocker(choice_);
  choice_->clear();
  choice_->addItem(tr("RGB values"));
  for (const QString& name : summary.colours) choice_->addItem(icon("colour"), name, name);
  choice_->setVisible(!summary.colours.isEmpty());
  const auto* reference =
      common.value && !common.is_mixed ? std::get_if<grf::Reference>(&*common.value) : nullptr;
  if (reference != nullptr)
    choice_->setCurrentIndex(choice_->findData(QString::fromStdString(reference->name)));
  std::optional<grf::Colour> colour;
  if (reference != nullptr) {
    const auto& objects = document_.objects();
    const auto mesh = objects.mesh_at(summary.meshes.front());
    const std::size_t face = document_.selection().of_mesh(*mesh).find_first();
    colour = objects.meshes[*mesh].flat_surfaces[(*objects.meshes[*mesh].mesh->surface_of_face)[face]].colour;
  } else if (common.value) {
    colour = std::get<grf::Colour>(*common.value);
  }
  show_common(fields_, common.is_mixed, colour);
  const QString lit = why_not_reflecting(summary);
  fields_->setEnabled(lit.isEmpty());
  choice_->setEnabled(lit.isEmpty());
  enable(reset_, tr("Reset to the default colour: white"),
         common.is_mixed || common.value ? QString() : tr("The faces have no colour of their own."));
}

void ColourRow::choose(int index) {
  const QString name = choice_->itemData(index).toString();
  if (!name.isEmpty()) {
    assign(AttributeEdit<grf::ColourAttribute>::set(grf::Reference{name.toStdString(), {}}), {});
  } else if (fields_->colour()) {
    assign(AttributeEdit<grf::ColourAttribute>::set(*fields_->colour()), {});
  }
}

void ColourRow::assign(const AttributeEdit<grf::ColourAttribute>& colour, const QString& key) {
  SurfaceEdit edit;
  edit.colour = colour;
  document_.edit_surfaces(colour.value() ? tr("Set colour") : tr("Reset colour"), edit, key);
}

EmissionRow::EmissionRow(Document& document, QWidget* parent) : SurfaceRow(document, parent) {
  power_ = number_box(
      {tr("Power"), tr("Total power of the selected faces: π × area × mean of the radiance's RGB values"), 0,
       Largest, 10, tr("W")},
      this);
  field_ = power_;
  reset_ = tool_button(
      "reset", tr("Remove the emission"), {},
      [this] {
        SurfaceEdit edit;
        edit.emission = AttributeEdit<grf::Colour>::remove();
        document_.edit_surfaces(tr("Remove emission"), edit);
      },
      this);
  radiance_ =
      new ColourFields(tr("Radiance"), tr("radiance emitted by the front sides, W/(sr m²)"), Largest, this);
  auto* lines = tight_layout<QVBoxLayout>(this);
  auto* line = new QHBoxLayout;
  line->setSpacing(Grid / 4);
  line->addWidget(power_, 1);
  line->addWidget(reset_);
  lines->addLayout(line);
  radiance_->setContentsMargins(0, 0, reset_->sizeHint().width() + Grid / 4, 0);
  lines->addWidget(radiance_);
  connect(radiance_, &ColourFields::edited, this, [this](const grf::Colour& radiance) {
    SurfaceEdit edit;
    edit.emission = AttributeEdit<grf::Colour>::set(radiance);
    document_.edit_surfaces(tr("Set radiance"), edit, "radiance");
  });
  const auto take_power = [this](double power) {
    const grf::Colour colour = radiance_->colour().value_or(grf::Colour(1));
    document_.edit_surfaces(tr("Set power to %1 W").arg(power),
                            emission_of_power(document_.objects(), document_.selection(), power, colour),
                            "power");
  };
  const auto finish = [this] { document_.finish_gesture(); };
  connect_number(power_, this, take_power, finish);
  connect(radiance_, &ColourFields::finished, this, finish);
}

void EmissionRow::show_summary(const SelectionSummary& summary) {
  const auto& common = summary.surface.emission;
  show_common(radiance_, common.is_mixed, common.value);
  if (common.is_mixed) {
    power_->set_mixed();
  } else if (common.value) {
    power_->set_value(power_of(*common.value, summary.area));
  } else {
    power_->set_blank(tr("none"));
  }
  power_->setEnabled(summary.area > 0);
  enable(reset_, tr("Remove the emission: the faces emit no light"),
         common.is_mixed || common.value ? QString() : tr("The faces emit no light."));
}

VertexRow::VertexRow(Document& document, Kind kind, QWidget* parent)
    : SurfaceRow(document, parent), kind_(kind) {
  const bool is_colour = kind == Kind::Colour;
  fields_ = is_colour ? new ColourFields(tr("Vertex colour"),
                                         tr("linear RGB per vertex, which replaces the colour"), 1, this)
                      : new ColourFields(tr("Irradiance"), tr("irradiance per vertex, W/m²"), Largest, this);
  field_ = fields_->field();
  auto* line = tight_layout<QHBoxLayout>(this, Grid / 4);
  line->addWidget(fields_, 1);
  if (!is_colour) {
    bake_ = tool_button(
        "bake", tr("Bake the irradiance"), tr("Bake the irradiance at all vertices of the scene"),
        [this] { emit bake_requested(); }, this);
    line->addWidget(bake_);
  }
  clear_ = tool_button(
      "reset", is_colour ? tr("Clear the vertex colours") : tr("Clear the irradiance"), {},
      [this] { put(std::nullopt); }, this);
  line->addWidget(clear_);
  connect(fields_, &ColourFields::edited, this, [this](const grf::Colour& colour) { put(colour); });
  connect(fields_, &ColourFields::finished, this, [this] { document_.finish_gesture(); });
}

void VertexRow::show_summary(const SelectionSummary& summary) {
  const bool is_colour = kind_ == Kind::Colour;
  const auto& common = is_colour ? summary.vertices.colour : summary.vertices.irradiance;
  show_common(fields_, common.is_mixed, common.value);
  const QString none =
      is_colour ? tr("The vertices have no colours.") : tr("The vertices have no irradiance.");
  enable(clear_, is_colour ? tr("Clear the vertex colours") : tr("Clear the irradiance of the vertices"),
         common.is_mixed || common.value ? QString() : none);
}

void VertexRow::put(const std::optional<grf::Colour>& value) {
  const SelectedFaces faces = {document_.scene(), document_.objects(), document_.selection()};
  const bool is_colour = kind_ == Kind::Colour;
  grf::Scene scene = is_colour ? with_vertex_colours(faces, value) : with_irradiance(faces, value);
  const QString key = !value ? QString() : is_colour ? "vertex colours" : "irradiance";
  document_.replace(is_colour ? tr("Set vertex colours") : tr("Set irradiance"), std::move(scene), key);
}

NormalsRow::NormalsRow(Document& document, QWidget* parent)
    : SurfaceRow(document, parent), state_(new QLabel(this)) {
  constexpr double CommonCrease = 30;
  angle_ =
      number_box({tr("Crease angle"), tr("Edges stay sharp where the angle between their faces is larger"), 0,
                  180, 5, "deg"},
                 this);
  angle_->set_value(CommonCrease);
  field_ = angle_;
  auto* line = tight_layout<QHBoxLayout>(this, Grid / 4);
  line->addWidget(state_, 1);
  line->addWidget(angle_, 1);
  line->addWidget(tool_button(
      "smooth", tr("Smooth normals"),
      tr("Smooth shading: vertex normals, averaged across edges up to the crease angle"),
      [this] { apply(Change::Smooth); }, this));
  line->addWidget(tool_button(
      "flat", tr("Flat faces"), tr("Flat shading: remove the vertex normals"),
      [this] { apply(Change::Flat); }, this));
  line->addWidget(tool_button(
      "flip", tr("Flip the faces"), tr("Flip faces: reverse their orientation and their normals"),
      [this] { apply(Change::Flip); }, this));
}

void NormalsRow::show_summary(const SelectionSummary& summary) {
  state_->setText(summary.vertices.have_normals ? tr("smooth") : tr("flat"));
  state_->setToolTip(summary.vertices.have_normals ? tr("The faces have vertex normals")
                                                   : tr("The faces have no vertex normals"));
}

void NormalsRow::apply(Change change) {
  const SelectedFaces faces = {document_.scene(), document_.objects(), document_.selection()};
  if (change == Change::Smooth) {
    document_.replace(tr("Smooth normals"),
                      with_smooth_normals(faces, angle_->value() * std::numbers::pi / 180));
  } else if (change == Change::Flat) {
    document_.replace(tr("Flat faces"), with_flat_faces(faces));
  } else {
    document_.replace(tr("Flip faces"), flipped(faces));
  }
}

}  // namespace editor
