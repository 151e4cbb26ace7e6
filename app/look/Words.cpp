// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/look/Words.h"

#include <QCoreApplication>
#include <QLocale>

namespace txn::app {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Words)
};

QString inShort(ErrorCode code) {
    switch (code) {
    case ErrorCode::InvalidArgument:
        return Words::tr("A value is out of its range; please choose another one.");
    case ErrorCode::NotFound:
        return Words::tr("The file is not there; please choose another one.");
    case ErrorCode::Unreadable:
        return Words::tr("The file cannot be read; please open another copy of it.");
    case ErrorCode::Unwritable:
        return Words::tr("The file cannot be written; please choose another place.");
    case ErrorCode::TooLarge:
    case ErrorCode::OverBudget:
        return Words::tr("This is too large; please choose a smaller picture, part or size.");
    case ErrorCode::Unsupported:
        return Words::tr("This cannot be done with such a file; please choose another kind.");
    case ErrorCode::SizeMismatch:
        return Words::tr(
            "These do not fit together; please choose another picture, support or part.");
    case ErrorCode::Degenerate:
        return Words::tr("The picture is all one color, or has values that are no numbers; please "
                         "choose another one.");
    case ErrorCode::Cancelled:
        break;
    }
    return Words::tr("Cancelled.");
}

} // namespace

QString inWords(const Error& error) {
    QString details = QString::fromStdString(error.message);
    if (QLocale().language() == QLocale::English) {
        if (!details.isEmpty())
            details[0] = details[0].toUpper();
        return details;
    }
    return QStringLiteral("%1 (%2)").arg(inShort(error.code), details);
}

} // namespace txn::app
