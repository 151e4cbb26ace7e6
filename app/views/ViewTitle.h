// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/Project.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace txn::app {

/// The artist's word for it.
[[nodiscard]] QString nameOf(Picture picture);

/// The line above a view: what it shows, whether that is stale, and what is told about it.
class ViewTitle : public QWidget {
    Q_OBJECT

  public:
    static constexpr int kHeight = 24;

    explicit ViewTitle(int place, QWidget* parent = nullptr);

    /// What is seen; second: right of the border of a wipe.
    void showPictures(Picture first, std::optional<Picture> second);
    void showGaussian(GaussianMethod method);
    void setStale(bool stale);
    void setInfo(const QString& info);

  signals:
    // By the user.
    void pictureChosen(Picture picture);
    void secondChosen(Picture picture);
    void gaussianMethodChosen(GaussianMethod method);
    void gaussianSeedWanted();
    void doubleClicked();

  protected:
    void mouseDoubleClickEvent(QMouseEvent* event) override;

  private:
    QComboBox* makeChooser(const QString& name, const QString& label);

    QComboBox* m_first;
    QComboBox* m_second;
    QComboBox* m_method;
    QToolButton* m_dice;
    QLabel* m_stale;
    QLabel* m_info;
};

} // namespace txn::app
