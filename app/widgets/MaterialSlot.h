// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>
#include <functional>
#include <utility>

class QMimeData;

namespace txn::app {

/// A place for a material: its picture with a letter, onto which another one can be dropped, and
/// which opens one when it is clicked.
class MaterialSlot : public QWidget {
    Q_OBJECT

  public:
    /// hint: what an empty one says.
    MaterialSlot(QString letter, QString hint, QWidget* parent = nullptr);

    /// What may be dropped. Nothing, unless told.
    void setAccepts(std::function<bool(const QMimeData&)> accepts) {
        m_accepts = std::move(accepts);
    }
    /// Null: empty.
    void setPicture(const QImage& picture, const QString& name);

    QSize sizeHint() const override { return {kSide, kSide}; }
    QSize minimumSizeHint() const override { return {64, 64}; }

  signals:
    void clicked();
    void dropped(const QMimeData& data);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    static constexpr int kSide = 88;

    QString m_letter;
    QString m_hint;
    QImage m_picture;
    bool m_draggedOver = false;
    std::function<bool(const QMimeData&)> m_accepts = [](const QMimeData&) { return false; };
};

} // namespace txn::app
