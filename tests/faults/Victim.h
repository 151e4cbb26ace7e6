// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <memory>
#include <optional>

namespace txn::test {

/// Writes files by the application's own code.
class Victim {
  public:
    virtual ~Victim() = default;
    /// Variant 1 or 2 of the files; the message if that fails.
    virtual std::optional<QString> write(int variant) = 0;
    /// Whether the document counts as changed if, and only if, it was not saved the last time.
    virtual bool isTold() const { return true; }
};

/// What victims write.
inline const QStringList kVictimKinds{QStringLiteral("project"),
                                      QStringLiteral("autosave"),
                                      QStringLiteral("texton"),
                                      QStringLiteral("maps"),
                                      QStringLiteral("noise"),
                                      QStringLiteral("view"),
                                      QStringLiteral("engine"),
                                      QStringLiteral("mixture")};

/// How a victim ends, and so does the command line.
inline constexpr int kDone = 0;
inline constexpr int kRefused = 1; ///< having said why
inline constexpr int kUntold = 9;  ///< the document does not know

std::unique_ptr<Victim> makeVictim(const QString& kind, const QString& folder);

/// As a program of its own, PROGRAM --victim KIND FOLDER VARIANT: writes that, or with 0 both by
/// turns until it is killed, having said so. Ends without tidying up.
[[noreturn]] void runVictim(int& argc, char** argv);

} // namespace txn::test
