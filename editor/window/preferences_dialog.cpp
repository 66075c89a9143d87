#include "editor/window/preferences_dialog.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/controls/search_terms.h"
#include "editor/window/shortcut_keys.h"

namespace editor {
namespace {

enum KeyColumn { NameOfAction, KeysOfAction };

QString key_text(const QList<QKeySequence>& keys) {
  return QKeySequence::listToString(keys, QKeySequence::NativeText);
}

QFormLayout* form_on(QWidget* page) {
  auto* form = new QFormLayout(page);
  form->setContentsMargins(2 * Grid, 2 * Grid, 2 * Grid, 2 * Grid);
  form->setVerticalSpacing(Grid);
  return form;
}

}  // namespace

PreferencesDialog::PreferencesDialog(ShortcutKeys& keys, QWidget* parent)
    : QDialog(parent), keys_(keys), preferences_(Preferences::load()) {
  setWindowTitle(tr("Preferences"));
  auto* rows = new QVBoxLayout(this);
  auto* tabs = new QTabWidget(this);
  tabs->setAccessibleName(tr("Pages of the preferences"));
  tabs->setToolTip(tr("Pages of the preferences"));
  tabs->addTab(make_general_page(), tr("&General"));
  tabs->addTab(make_work_page(), tr("&Work"));
  tabs->addTab(make_keys_page(), tr("&Keys"));
  tabs->addTab(make_farm_page(), tr("&Farm"));
  rows->addWidget(tabs, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  buttons->button(QDialogButtonBox::Close)->setToolTip(tr("Close: all changes are applied already"));
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  rows->addWidget(buttons);
  resize(70 * Grid, 70 * Grid);
}

// The list reports that it becomes empty, when the dialog and perhaps the keys are gone already.
PreferencesDialog::~PreferencesDialog() { list_->disconnect(this); }

QComboBox* PreferencesDialog::add_list(QFormLayout& form, const QString& label, const QString& name,
                                       const QString& tip,
                                       const std::vector<std::pair<QString, QString>>& choices,
                                       const QString& now,
                                       const std::function<void(const QString& choice)>& take) {
  QComboBox* list = narrow_list(name, tip, 12, this);
  for (const auto& [value, text] : choices) list->addItem(text, value);
  list->setCurrentIndex(list->findData(now));
  form.addRow(label, list);
  connect(list, &QComboBox::activated, this, [list, take] { take(list->currentData().toString()); });
  return list;
}

void PreferencesDialog::add_number(QFormLayout& form, const QString& label, const QString& name,
                                   const QString& tip, int least, int most, const QString& unit,
                                   int Preferences::*field) {
  NumberBox* box = number_box({name, tip, double(least), double(most), 1, unit}, this);
  box->set_whole(true);
  box->set_value(preferences_.*field);
  form.addRow(label, box);
  connect(box, &NumberBox::edited, this, [this, field](double number) {
    Preferences changed = preferences_;
    changed.*field = qRound(number);
    change(changed);
  });
}

QWidget* PreferencesDialog::make_general_page() {
  auto* page = new QWidget(this);
  QFormLayout* form = form_on(page);
  const auto text = [this](QString Preferences::*field) {
    return [this, field](const QString& choice) {
      Preferences changed = preferences_;
      changed.*field = choice;
      change(changed);
    };
  };
  add_list(*form, tr("&Language"), tr("Language"), tr("Language of the texts, from the next start"),
           {{"", tr("that of the system")}, {"en", "English"}, {"es", "Español"}}, preferences_.language,
           text(&Preferences::language));
  add_list(*form, tr("&Theme"), tr("Theme"), tr("Colours of windows and views"),
           {{"dark", tr("dark")}, {"light", tr("light")}},
           theme_of(palette()) == Theme::Light ? "light" : "dark", [this](const QString& theme) {
             apply(theme == "light" ? Theme::Light : Theme::Dark, *qApp);
             Preferences changed = preferences_;
             changed.theme = theme;
             change(changed);
           });
  add_list(*form, tr("&Unit of length"), tr("Unit of length"),
           tr("Unit of lengths in the Object, Lights and Cameras docks; a unit of the file is a metre"),
           {{"m", tr("metre")}, {"cm", tr("centimetre")}, {"mm", tr("millimetre")}, {"in", tr("inch")}},
           preferences_.length_unit, text(&Preferences::length_unit));
  add_list(*form, tr("U&p axis of imports"), tr("Up axis of imports"),
           tr("The axis that points up in models, unless the import dialog chose another one for the type"),
           {{"y", tr("y")}, {"z", tr("z")}}, preferences_.is_z_up ? "z" : "y", [this](const QString& axis) {
             Preferences changed = preferences_;
             changed.is_z_up = axis == "z";
             change(changed);
           });
  return page;
}

QWidget* PreferencesDialog::make_work_page() {
  auto* page = new QWidget(this);
  QFormLayout* form = form_on(page);
  add_number(*form, tr("U&ndo steps"), tr("Undo steps"),
             tr("Largest number of undo steps, which take memory; 0: no limit. While a scene has undo steps, "
                "the limit applies from the next scene on."),
             0, Preferences::MostUndoSteps, {}, &Preferences::undo_steps);
  add_number(*form, tr("Th&reads"), tr("Threads"),
             tr("Threads of previews and renders whose options leave it open; 0: one per core."), 0,
             Preferences::MostThreads, {}, &Preferences::threads);
  add_number(*form, tr("&Autosave after"), tr("Autosave after"),
             tr("Time from a change to the autosave of unsaved work."), 1, Preferences::MostAutosaveSeconds,
             "s", &Preferences::autosave_seconds);
  return page;
}

void PreferencesDialog::add_text(QFormLayout& form, const QString& label, const QString& name,
                                 const QString& tip, QString FarmAccess::*field) {
  auto* text = new QLineEdit(preferences_.farm.*field, this);
  text->setAccessibleName(name);
  text->setToolTip(tip);
  form.addRow(label, text);
  connect(text, &QLineEdit::editingFinished, this, [this, text, field] {
    Preferences changed = preferences_;
    changed.farm.*field = text->text().trimmed();
    change(changed);
  });
}

/// The access of `bpt farm render`, see renderer/FARM.md.
QWidget* PreferencesDialog::make_farm_page() {
  auto* page = new QWidget(this);
  QFormLayout* form = form_on(page);
  add_text(
      *form, tr("&Server"), tr("Server of the farm"),
      tr("URL of the render farm's server, as printed by `bpt farm serve`: nats://HOST:4222. The Render dock "
         "can then render there. Empty: no farm."),
      &FarmAccess::server);
  add_text(*form, tr("T&oken file"), tr("Token file"),
           tr("File with the secret token of the server; empty: the server asks for none."),
           &FarmAccess::token_file);
  add_text(
      *form, tr("C&A certificates"), tr("CA certificates"),
      tr("File (PEM) with the certificates of the authority that signed the server's certificate, for TLS."),
      &FarmAccess::authority_file);
  add_text(*form, tr("Own &certificate"), tr("Own certificate"),
           tr("File (PEM) with the own certificate, for servers that ask for one."),
           &FarmAccess::certificate_file);
  add_text(*form, tr("&Private key"), tr("Private key"),
           tr("File (PEM) with the key of the own certificate."), &FarmAccess::key_file);
  return page;
}

QWidget* PreferencesDialog::make_keys_page() {
  auto* page = new QWidget(this);
  auto* rows = new QVBoxLayout(page);
  auto* search = new QLineEdit(page);
  search->setPlaceholderText(tr("Search"));
  search->setAccessibleName(tr("Search actions"));
  search->setToolTip(tr("Show only actions whose name or keys have these words"));
  list_ = new QTreeWidget(page);
  list_->setAccessibleName(tr("Actions"));
  list_->setToolTip(tr("Actions and their shortcuts; changed ones are bold"));
  list_->setHeaderLabels({tr("Action"), tr("Keys")});
  list_->setRootIsDecorated(false);
  edit_ = new QKeySequenceEdit(page);
  edit_->setAccessibleName(tr("New shortcut"));
  edit_->setToolTip(tr("Press the new shortcut of the selected action"));
  default_ = new QPushButton(tr("&Default"), page);
  default_->setToolTip(tr("Restore the default shortcut of the selected action"));
  auto* clear = new QPushButton(tr("&No shortcut"), page);
  clear->setToolTip(tr("Remove the shortcut of the selected action"));
  auto* reset = new QPushButton(tr("Reset a&ll"), page);
  reset->setToolTip(tr("Restore the default shortcuts of all actions"));
  problem_ = problem_label(page);
  problem_->setWordWrap(true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(edit_, 1);
  for (QPushButton* button : {default_, clear, reset}) buttons->addWidget(button);
  rows->addWidget(search);
  rows->addWidget(list_, 1);
  rows->addLayout(buttons);
  rows->addWidget(problem_);
  show_keys();
  list_->resizeColumnToContents(NameOfAction);
  connect(search, &QLineEdit::textChanged, list_, [this](const QString& words) {
    for (int row = 0; row < list_->topLevelItemCount(); ++row) {
      QTreeWidgetItem* item = list_->topLevelItem(row);
      item->setHidden(!matches_search(item->text(NameOfAction) + ' ' + item->text(KeysOfAction), words));
    }
  });
  connect(list_, &QTreeWidget::currentItemChanged, this, &PreferencesDialog::show_entry);
  connect(edit_, &QKeySequenceEdit::editingFinished, this, [this] {
    if (!edit_->keySequence().isEmpty()) set_keys({edit_->keySequence()});
  });
  connect(default_, &QPushButton::clicked, this, [this] {
    if (entry() >= 0) set_keys(keys_.entries()[static_cast<std::size_t>(entry())].defaults);
  });
  connect(clear, &QPushButton::clicked, this, [this] { set_keys({}); });
  connect(reset, &QPushButton::clicked, this, [this] {
    keys_.reset();
    show_keys();
  });
  return page;
}

int PreferencesDialog::entry() const { return list_->indexOfTopLevelItem(list_->currentItem()); }

void PreferencesDialog::show_keys() {
  const auto& entries = keys_.entries();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    QTreeWidgetItem* item = list_->topLevelItem(static_cast<int>(i));
    if (item == nullptr) item = new QTreeWidgetItem(list_, {entries[i].name});
    const QList<QKeySequence> keys = entries[i].action->shortcuts();
    item->setText(KeysOfAction, key_text(keys));
    QFont font = list_->font();
    font.setBold(keys != entries[i].defaults);
    item->setFont(KeysOfAction, font);
  }
  show_entry();
}

void PreferencesDialog::show_entry() {
  show_or_hide(problem_, {});
  const bool has_entry = entry() >= 0;
  edit_->setEnabled(has_entry);
  if (has_entry) edit_->setKeySequence(keys_.entries()[static_cast<std::size_t>(entry())].action->shortcut());
}

/// Sets the shortcuts of the selected action, unless another action has one of them.
void PreferencesDialog::set_keys(const QList<QKeySequence>& keys) {
  if (entry() < 0) return;
  const ShortcutKeys::Entry& selected = keys_.entries()[static_cast<std::size_t>(entry())];
  for (const QKeySequence& each : keys) {
    const QAction* other = keys_.other_with(each, selected);
    if (other == nullptr) continue;
    show_entry();
    return show_or_hide(problem_,
                        tr("%1 is the shortcut of \"%2\": change that one first")
                            .arg(each.toString(QKeySequence::NativeText), other->text().remove('&')));
  }
  keys_.set(selected, keys);
  show_keys();
}

void PreferencesDialog::change(const Preferences& preferences) {
  preferences_ = preferences;
  preferences_.store();
  emit changed(preferences_);
}

}  // namespace editor
