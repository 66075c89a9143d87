// The user's preferences, which are kept in the settings.
#pragma once

#include <QString>
#include <QStringList>

namespace editor {

/// How to reach a render farm of `bpt`, see renderer/FARM.md.
struct FarmAccess {
  QString server = {};          ///< URL, as nats://host:4222; empty: there is no farm
  QString token_file = {};      ///< path; empty: none
  QString authority_file = {};  ///< certificates (PEM) of who signed the server's certificate; empty: no TLS
  QString certificate_file = {};  ///< own certificate (PEM) for servers that ask for one; empty: none
  QString key_file = {};          ///< private key (PEM) of the own certificate

  bool operator==(const FarmAccess&) const = default;
};

/// The choices of Edit > Preferences that no scene stores. Shortcuts are in ShortcutKeys.
struct Preferences {
  QString language;           ///< `en` or `es`; empty: that of the system
  QString theme = "dark";     ///< or `light`
  QString length_unit = "m";  ///< in which lengths are shown: m, cm, mm or in; files are in metres
  bool is_z_up = false;       ///< whether models are imported with z up unless their type has its own option
  int undo_steps = 0;         ///< largest number of undo steps; 0: no limit
  int threads = 0;            ///< of previews and renders whose options leave it open; 0: one per core
  int autosave_seconds = 3;   ///< time from a change to its autosave
  FarmAccess farm = {};
  bool shows_welcome = true;  ///< whether a session without a file starts with the page Welcome

  bool operator==(const Preferences&) const = default;

  /// Reads the settings; what is missing or invalid there has its default.
  static Preferences load();
  /// Writes the settings.
  void store() const;

  static constexpr int MostUndoSteps = 100'000;
  static constexpr int MostThreads = 1024;
  static constexpr int MostAutosaveSeconds = 3600;
};

}  // namespace editor
