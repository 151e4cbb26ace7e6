// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/ViewTitle.h"

#include "app/look/Theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QToolButton>
#include <array>

namespace txn::app {
namespace {

constexpr std::array kMethods{GaussianMethod::Adsn, GaussianMethod::RandomPhase};
constexpr QSize kIconSize{14, 14};

} // namespace

QString nameOf(Picture picture) {
    switch (picture) {
    case Picture::Exemplar:
        return ViewTitle::tr("Exemplar");
    case Picture::Gaussian:
        return ViewTitle::tr("Gaussian version");
    case Picture::Texton:
        return ViewTitle::tr("Texton");
    case Picture::Noise:
        break;
    }
    return ViewTitle::tr("Noise");
}

ViewTitle::ViewTitle(int place, QWidget* parent)
    : QWidget(parent),
      m_first(makeChooser(QStringLiteral("viewPicture%1").arg(place), tr("Picture in this view"))),
      m_second(makeChooser(QStringLiteral("viewSecond%1").arg(place),
                           tr("Picture right of the border"))),
      m_method(new QComboBox), m_dice(new QToolButton), m_stale(new QLabel), m_info(new QLabel) {
    setObjectName(QStringLiteral("viewTitle"));
    m_first->setToolTip(tr("What this view shows."));
    m_second->setToolTip(tr("What is shown right of the border that you can drag."));
    connect(m_first, &QComboBox::activated, this, [this](int index) {
        emit pictureChosen(kPictures[static_cast<std::size_t>(index)]);
    });
    connect(m_second, &QComboBox::activated, this, [this](int index) {
        emit secondChosen(kPictures[static_cast<std::size_t>(index)]);
    });

    m_method->setObjectName(QStringLiteral("viewMethod%1").arg(place));
    m_method->setAccessibleName(tr("Method of the Gaussian version"));
    m_method->setToolTip(tr("ADSN: random phases and strengths, what texton noise comes to. RPN: "
                            "random phases only, keeps the exact spectrum of the photo."));
    m_method->addItems({tr("ADSN"), tr("RPN")});
    m_method->setFrame(false);
    m_method->setFocusPolicy(Qt::TabFocus);
    connect(m_method, &QComboBox::activated, this, [this](int index) {
        emit gaussianMethodChosen(kMethods[static_cast<std::size_t>(index)]);
    });
    m_dice->setObjectName(QStringLiteral("viewDice%1").arg(place));
    m_dice->setIcon(themeIcon(QStringLiteral("dice")));
    m_dice->setIconSize(kIconSize);
    m_dice->setAccessibleName(tr("Another Gaussian version"));
    m_dice->setToolTip(tr("Roll the dice for another Gaussian version."));
    m_dice->setFocusPolicy(Qt::TabFocus);
    connect(m_dice, &QToolButton::clicked, this, &ViewTitle::gaussianSeedWanted);

    m_stale->setText(QStringLiteral("\u25cf"));
    m_stale->setProperty("role", QStringLiteral("stale"));
    m_stale->setObjectName(QStringLiteral("viewStale%1").arg(place));
    m_stale->setToolTip(tr("This is still an older result; the new one is being computed."));
    m_stale->setAccessibleName(tr("Older result"));
    m_info->setObjectName(QStringLiteral("viewInfo%1").arg(place));
    m_info->setProperty("role", QStringLiteral("secondary"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 0, 8, 0);
    row->setSpacing(4);
    row->addWidget(m_first);
    row->addWidget(m_stale);
    row->addWidget(m_method);
    row->addWidget(m_dice);
    row->addStretch();
    row->addWidget(m_info);
    row->addWidget(m_second);
}

QComboBox* ViewTitle::makeChooser(const QString& name, const QString& label) {
    auto* chooser = new QComboBox(this);
    chooser->setObjectName(name);
    chooser->setAccessibleName(label);
    chooser->setFrame(false);
    chooser->setFocusPolicy(Qt::TabFocus);
    for (const Picture each : kPictures)
        chooser->addItem(nameOf(each));
    return chooser;
}

void ViewTitle::showPictures(Picture first, std::optional<Picture> second) {
    m_first->setCurrentIndex(static_cast<int>(first));
    m_second->setVisible(second.has_value());
    if (second)
        m_second->setCurrentIndex(static_cast<int>(*second));
    const bool gaussian = first == Picture::Gaussian || second == Picture::Gaussian;
    m_method->setVisible(gaussian);
    m_dice->setVisible(gaussian);
}

void ViewTitle::showGaussian(GaussianMethod method) {
    for (std::size_t i = 0; i < kMethods.size(); ++i) {
        if (kMethods[i] == method)
            m_method->setCurrentIndex(static_cast<int>(i));
    }
}

void ViewTitle::setStale(bool stale) {
    m_stale->setVisible(stale);
}

void ViewTitle::setInfo(const QString& info) {
    m_info->setText(info);
}

void ViewTitle::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        emit doubleClicked();
}

} // namespace txn::app
