// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/RecoveryDialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace txn::app {
namespace {

constexpr int kPreviewPx = 192;

} // namespace

RecoveryDialog::RecoveryDialog(std::vector<RecoveredProject> copies, QWidget* parent)
    : QDialog(parent), m_copies(std::move(copies)), m_list(new QListWidget), m_preview(new QLabel) {
    setObjectName(QStringLiteral("recoveryDialog"));
    setWindowTitle(tr("Recover your work"));
    auto* text =
        new QLabel(tr("Texton Studio was not closed properly last time. This can come back:"));
    text->setWordWrap(true);
    m_list->setObjectName(QStringLiteral("recoveryList"));
    m_list->setAccessibleName(tr("Work that can come back"));
    m_list->setToolTip(tr("The newest is at the top."));
    const QLocale locale;
    for (const RecoveredProject& copy : m_copies)
        m_list->addItem(
            QStringLiteral("%1\n%2").arg(copy.title,
                                         locale.toString(copy.time, QLocale::ShortFormat)));
    m_preview->setFixedSize(kPreviewPx, kPreviewPx);
    m_preview->setAlignment(Qt::AlignCenter);
    auto* recover = new QPushButton(tr("Recover"));
    recover->setObjectName(QStringLiteral("recoveryRecover"));
    recover->setDefault(true);
    recover->setToolTip(tr("Opens this work again. Save it then; the original file is untouched."));
    auto* discarding = new QPushButton(tr("Delete this copy"));
    discarding->setObjectName(QStringLiteral("recoveryDiscard"));
    discarding->setToolTip(tr("Gives this work up for good."));
    auto* later = new QPushButton(tr("Later"));
    later->setObjectName(QStringLiteral("recoveryLater"));
    later->setToolTip(tr("Keeps the copies and asks again next time."));
    auto* middle = new QHBoxLayout;
    middle->addWidget(m_list, 1);
    middle->addWidget(m_preview);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(discarding);
    buttons->addStretch();
    buttons->addWidget(later);
    buttons->addWidget(recover);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    column->addWidget(text);
    column->addLayout(middle, 1);
    column->addLayout(buttons);
    resize(560, 320);
    connect(m_list, &QListWidget::currentRowChanged, this, &RecoveryDialog::showCurrent);
    connect(recover, &QPushButton::clicked, this, [this] {
        if (const RecoveredProject* copy = current())
            emit recoverRequested(*copy);
        accept();
    });
    connect(discarding, &QPushButton::clicked, this, [this] {
        const RecoveredProject* copy = current();
        if (copy == nullptr)
            return;
        discard(*copy);
        const int row = m_list->currentRow();
        m_copies.erase(m_copies.begin() + row);
        delete m_list->takeItem(row);
        if (m_copies.empty())
            reject();
    });
    connect(later, &QPushButton::clicked, this, &QDialog::reject);
    m_list->setCurrentRow(0);
}

const RecoveredProject* RecoveryDialog::current() const {
    const int row = m_list->currentRow();
    return row >= 0 && row < static_cast<int>(m_copies.size())
               ? &m_copies[static_cast<std::size_t>(row)]
               : nullptr;
}

void RecoveryDialog::showCurrent() {
    const RecoveredProject* copy = current();
    m_preview->setPixmap(copy != nullptr && !copy->thumbnail.isNull()
                             ? QPixmap::fromImage(copy->thumbnail.scaled(kPreviewPx,
                                                                         kPreviewPx,
                                                                         Qt::KeepAspectRatio,
                                                                         Qt::SmoothTransformation))
                             : QPixmap());
}

} // namespace txn::app
