// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

namespace txn::app {

/// A square picture with a caption below, as large as there is room for.
class PlotPicture : public QWidget {
    Q_OBJECT

  public:
    explicit PlotPicture(const QString& caption, QWidget* parent = nullptr);

    void setImage(const QImage& image);
    const QImage& image() const { return m_image; }
    QSize sizeHint() const override { return {160, 176}; }
    QSize minimumSizeHint() const override { return {64, 80}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString m_caption;
    QImage m_image;
};

} // namespace txn::app
