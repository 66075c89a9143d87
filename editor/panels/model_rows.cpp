#include "editor/panels/model_rows.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QToolButton>
#include <variant>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/brdf/parameter_rows.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/tab_order.h"
#include "editor/document/definitions.h"
#include "grf/keywords.h"
#include "grf/write.h"

namespace editor {
namespace {

/// The kinds of list entries.
enum class Choice { None, Inline, Named, Model };

constexpr int KindRole = Qt::UserRole;
constexpr int NameRole = Qt::UserRole + 1;

void add_choice(QComboBox* list, Choice choice, const QString& text, const QString& name, const QString& help,
                const QIcon& icon = {}) {
  list->addItem(icon, text);
  const int index = list->count() - 1;
  list->setItemData(index, static_cast<int>(choice), KindRole);
  list->setItemData(index, name, NameRole);
  list->setItemData(index, help, Qt::ToolTipRole);
}

void select_choice(QComboBox* list, Choice choice, const QString& name) {
  for (int i = 0; i < list->count(); ++i) {
    const QVariant kind = list->itemData(i, KindRole);
    const bool is_it = kind.isValid() && kind.toInt() == static_cast<int>(choice);
    if (is_it && list->itemData(i, NameRole).toString() == name) return list->setCurrentIndex(i);
  }
  list->setCurrentIndex(-1);
}

void add_models(QComboBox* list, const std::vector<grf::ModelInfo>& models) {
  list->insertSeparator(list->count());
  for (const grf::ModelInfo& info : models) {
    // The others need more than a click: names, or a file.
    if (info.argument_kind != grf::ModelInfo::ArgumentKind::Parameters) continue;
    const auto text = [](std::string_view words) {
      return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
    };
    add_choice(list, Choice::Model, QComboBox::tr("new %1").arg(text(info.keyword)), text(info.keyword),
               QString("%1\n%2").arg(text(info.title), text(info.description)), icon("add"));
  }
}

QComboBox* choice_list(const QString& name, QWidget* parent) {
  QComboBox* list = narrow_list(name, {}, 6, parent);
  list->setMaxVisibleItems(24);
  list->setFocusPolicy(Qt::StrongFocus);
  list->setIconSize({2 * Grid, 2 * Grid});
  return list;
}

}  // namespace

BrdfRow::BrdfRow(Document& document, const grf::Catalogue& catalogue, QWidget* parent)
    : SurfaceRow(document, parent), catalogue_(catalogue), choice_(choice_list(tr("BRDF"), this)) {
  field_ = choice_;
  auto* layout = tight_layout<QHBoxLayout>(this, Grid / 4);
  layout->addWidget(choice_, 1);
  edit_ = tool_button(
      "edit", tr("Edit the BRDF"), {}, [this] { emit edit_requested(); }, this);
  define_ = tool_button(
      "define", tr("Define the BRDF"), {}, [this] { define_common(); }, this);
  pick_ = tool_button(
      "pick", tr("Pick the BRDF from a face"),
      tr("Pick: assign the BRDF of the face that you click in the view"), [this] { emit pick_requested(); },
      this);
  reset_ = tool_button(
      "reset", tr("Reset the BRDF"), {},
      [this] { assign(tr("Reset BRDF"), AttributeEdit<grf::BrdfAttribute>::remove()); }, this);
  for (QToolButton* button : {edit_, define_, pick_, reset_}) layout->addWidget(button);
  connect(choice_, &QComboBox::activated, this, &BrdfRow::choose);
}

void BrdfRow::show_summary(const SelectionSummary& summary) {
  common_ = summary.surface.brdf;
  fill(summary);
  const QString lit = why_not_reflecting(summary);
  enable(choice_, tr("The BRDF of the faces: a named definition of the scene, or a new one"), lit);
  const bool has_one = !common_.is_mixed && common_.value.has_value();
  const bool is_named = has_one && std::holds_alternative<grf::Reference>(*common_.value);
  const QString none = common_.is_mixed ? tr("The faces have several BRDFs.") : tr("The faces have no BRDF.");
  enable(edit_, tr("Edit the BRDF: its lobe and its parameters"), has_one ? QString() : none);
  enable(define_, tr("Define: name the BRDF, so that other faces can share it"),
         is_named  ? tr("The BRDF is a named definition already.")
         : has_one ? QString()
                   : none);
  pick_->setEnabled(lit.isEmpty());
  enable(reset_, tr("Reset to the default BRDF: diffuse with kd = 0.5"),
         has_one || common_.is_mixed ? QString() : none);
}

void BrdfRow::fill(const SelectionSummary& summary) {
  const QSignalBlocker blocker(choice_);
  choice_->clear();
  add_choice(choice_, Choice::None, tr("none"), {}, tr("Diffuse with kd = 0.5"));
  const grf::BrdfModel* model = nullptr;
  if (common_.value && !common_.is_mixed) model = std::get_if<grf::BrdfModel>(&*common_.value);
  if (model != nullptr) {
    const QString text = QString::fromStdString(grf::to_text(*model));
    const bool is_known = grf::find_model(catalogue_.brdfs, model->keyword) != nullptr;
    add_choice(choice_, Choice::Inline, text, {}, tr("Inline, only on these faces: %1").arg(text),
               icon(is_known ? "brdf" : "error"));
  }
  for (const QString& name : summary.brdfs) {
    add_choice(choice_, Choice::Named, name, name, tr("The BRDF '%1' of the scene").arg(name), icon("brdf"));
  }
  add_models(choice_, catalogue_.brdfs);
  choice_->setPlaceholderText(mixed_text());
  if (common_.is_mixed) {
    choice_->setCurrentIndex(-1);
  } else if (model != nullptr) {
    select_choice(choice_, Choice::Inline, {});
  } else if (common_.value) {
    const std::string& name = std::get<grf::Reference>(*common_.value).name;
    select_choice(choice_, Choice::Named, QString::fromStdString(name));
  } else {
    select_choice(choice_, Choice::None, {});
  }
}

void BrdfRow::choose(int index) {
  const auto choice = static_cast<Choice>(choice_->itemData(index, KindRole).toInt());
  const QString name = choice_->itemData(index, NameRole).toString();
  if (choice == Choice::None) {
    assign(tr("Reset BRDF"), AttributeEdit<grf::BrdfAttribute>::remove());
  } else if (choice == Choice::Named) {
    assign(tr("Assign %1").arg(name),
           AttributeEdit<grf::BrdfAttribute>::set(grf::Reference{name.toStdString(), {}}));
  } else if (choice == Choice::Model) {
    grf::BrdfModel model;
    model.keyword = name.toStdString();
    assign(tr("Assign %1").arg(name), AttributeEdit<grf::BrdfAttribute>::set(model));
  }
}

void BrdfRow::assign(const QString& text, const AttributeEdit<grf::BrdfAttribute>& brdf) {
  SurfaceEdit edit;
  edit.brdf = brdf;
  document_.edit_surfaces(text, edit);
}

void BrdfRow::define_common() {
  const auto& model = std::get<grf::BrdfModel>(*common_.value);
  grf::Diagnostics diagnostics;
  auto defined = define(document_.scene(), "my_" + grf::lower_case(model.keyword), model, diagnostics);
  if (!defined) return emit problem_found(QString::fromStdString(diagnostics.entries().front().message));
  // The order of meshes is unchanged, so the selection is valid in the new scene too.
  SurfaceEdit edit;
  edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(grf::Reference{defined->name, {}});
  const SceneObjects objects = objects_of(defined->scene, document_.path().toStdString());
  for (PlacedMesh& placed : edited(objects, document_.selection(), edit)) {
    *grf::find_mesh(defined->scene, placed.path) = std::move(placed.mesh);
  }
  document_.replace(tr("Define %1").arg(QString::fromStdString(defined->name)), std::move(defined->scene));
}

PdfRow::PdfRow(Document& document, const grf::Catalogue& catalogue, QWidget* parent)
    : SurfaceRow(document, parent),
      catalogue_(catalogue),
      choice_(choice_list(tr("Sampling scheme"), this)),
      parameters_(new ParameterRows(this)),
      problem_(problem_label(this)) {
  field_ = choice_;
  auto* layout = tight_layout<QVBoxLayout>(this);
  auto* line = new QHBoxLayout;
  line->setSpacing(Grid / 4);
  line->addWidget(choice_, 1);
  reset_ = tool_button(
      "reset", tr("Reset the sampling scheme"), {},
      [this] { assign(tr("Reset PDF"), AttributeEdit<grf::PdfAttribute>::remove()); }, this);
  line->addWidget(reset_);
  layout->addLayout(line);
  layout->addWidget(parameters_);
  layout->addWidget(problem_);
  connect(choice_, &QComboBox::activated, this, &PdfRow::choose);
  connect(parameters_, &ParameterRows::edited, this, &PdfRow::edit_parameters);
}

void PdfRow::show_summary(const SelectionSummary& summary) {
  show_or_hide(problem_, {});
  fill(summary);
  const QString lit = why_not_reflecting(summary);
  enable(choice_, tr("How reflected directions are sampled; by default, with the BRDF's own scheme"), lit);
  const auto& common = summary.surface.pdf;
  const grf::PdfModel* model = nullptr;
  if (common.value && !common.is_mixed) model = std::get_if<grf::PdfModel>(&*common.value);
  model_ = model == nullptr ? std::nullopt : std::optional(*model);
  show_parameters();
  enable(reset_, tr("Reset to the default sampling scheme of each BRDF"),
         common.is_mixed || common.value ? QString() : tr("The faces have no sampling scheme of their own."));
}

void PdfRow::fill(const SelectionSummary& summary) {
  const QSignalBlocker blocker(choice_);
  const auto& common = summary.surface.pdf;
  choice_->clear();
  add_choice(choice_, Choice::None, tr("BRDF default"), {},
             tr("Each BRDF is sampled with its default scheme"));
  for (const QString& name : summary.pdfs) {
    add_choice(choice_, Choice::Named, name, name, tr("The scheme '%1' of the scene").arg(name), icon("pdf"));
  }
  add_models(choice_, catalogue_.pdfs);
  choice_->setPlaceholderText(mixed_text());
  if (common.is_mixed) {
    choice_->setCurrentIndex(-1);
  } else if (!common.value) {
    select_choice(choice_, Choice::None, {});
  } else if (const auto* reference = std::get_if<grf::Reference>(&*common.value)) {
    select_choice(choice_, Choice::Named, QString::fromStdString(reference->name));
  } else {
    select_model(std::get<grf::PdfModel>(*common.value));
  }
}

void PdfRow::select_model(const grf::PdfModel& model) {
  grf::Diagnostics diagnostics;
  if (!grf::check(model, catalogue_.pdfs, "PDF", diagnostics)) {
    show_or_hide(problem_, QString::fromStdString(diagnostics.entries().front().message));
  }
  const grf::ModelInfo* info = grf::find_model(catalogue_.pdfs, model.keyword);
  if (info == nullptr) {
    const QString keyword = QString::fromStdString(model.keyword);
    add_choice(choice_, Choice::Inline, tr("%1 (unknown)").arg(keyword), {},
               tr("Unknown sampling scheme '%1'").arg(keyword), icon("error"));
    return select_choice(choice_, Choice::Inline, {});
  }
  const QString keyword = QString::fromStdString(std::string(info->keyword));
  select_choice(choice_, Choice::Model, keyword);
  choice_->setItemText(choice_->currentIndex(), keyword);
  choice_->setItemIcon(choice_->currentIndex(), icon("pdf"));
}

void PdfRow::choose(int index) {
  const auto choice = static_cast<Choice>(choice_->itemData(index, KindRole).toInt());
  const QString name = choice_->itemData(index, NameRole).toString();
  if (choice == Choice::None) {
    assign(tr("Reset PDF"), AttributeEdit<grf::PdfAttribute>::remove());
  } else if (choice == Choice::Named) {
    assign(tr("Assign scheme %1").arg(name),
           AttributeEdit<grf::PdfAttribute>::set(grf::Reference{name.toStdString(), {}}));
  } else if (choice == Choice::Model) {
    grf::PdfModel model;
    model.keyword = name.toStdString();
    assign(tr("Assign scheme %1").arg(name), AttributeEdit<grf::PdfAttribute>::set(model));
  }
}

void PdfRow::assign(const QString& text, const AttributeEdit<grf::PdfAttribute>& pdf) {
  SurfaceEdit edit;
  edit.pdf = pdf;
  document_.edit_surfaces(text, edit);
}

void PdfRow::show_parameters() {
  const grf::ModelInfo* info = model_ ? grf::find_model(catalogue_.pdfs, model_->keyword) : nullptr;
  parameters_->show_models(info, {model_ ? &*model_ : nullptr});
  parameters_->setVisible(info != nullptr && !info->parameters.empty());
  lead_tab_through({choice_, reset_, parameters_});
}

void PdfRow::edit_parameters(const std::function<void(grf::Model&)>& edit, bool is_done) {
  edit(*model_);
  grf::Diagnostics diagnostics;
  if (!grf::check(*model_, catalogue_.pdfs, "PDF", diagnostics)) {
    show_parameters();
    return show_or_hide(problem_, QString::fromStdString(diagnostics.entries().front().message));
  }
  SurfaceEdit parameters;
  parameters.pdf = AttributeEdit<grf::PdfAttribute>::set(*model_);
  document_.edit_surfaces(tr("Edit parameters of %1").arg(QString::fromStdString(model_->keyword)),
                          parameters, QStringLiteral("parameters of the sampling scheme"));
  if (is_done) document_.finish_gesture();
}

}  // namespace editor
