// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace txn::app {

/// "What is this?" tells of every control below root what its tooltip tells, where it has no text
/// of its own. Call when all controls are there.
void explainByToolTips(QWidget& root);

} // namespace txn::app
