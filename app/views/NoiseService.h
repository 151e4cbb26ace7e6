// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/threads/Mailbox.h"
#include "app/views/NoiseFrame.h"

#include <QObject>
#include <QPointer>
#include <QString>
#include <map>
#include <memory>

namespace txn::app {

class NoiseFeed;
class NoiseWorker;

/// Draws noise on a thread and in an OpenGL context of its own, so that the interface never waits
/// for a shader, a driver or a slow renderer, and a view can be moved, docked and destroyed without
/// OpenGL noticing. Draws coarsely while requests keep coming and in full, piece by piece, when
/// they stop. Without OpenGL 3.3 the processor draws the plane. Interface thread.
class NoiseService : public QObject {
    Q_OBJECT

  public:
    explicit NoiseService(QObject* parent = nullptr);
    /// Waits for the frame being drawn.
    ~NoiseService() override;

    /// Such as "llvmpipe (LLVM 15.0.6, 256 bits)"; empty until known or without OpenGL.
    const QString& renderer() const { return m_renderer; }
    /// Why there is no OpenGL; empty where there is.
    const QString& problem() const { return m_problem; }

    /// Ends the OpenGL context as a driver's reset does; the next frame makes another one.
    void loseContext();

  signals:
    /// renderer() and problem() are known.
    void ready();

  private:
    friend class NoiseFeed;
    QString m_renderer;
    QString m_problem;
    std::map<quint64, NoiseFeed*> m_feeds;
    quint64 m_lastFeed = 0;
    Mailbox m_mailbox;
    std::unique_ptr<NoiseWorker> m_worker; ///< last: ends first
};

/// One view's wishes and what it got. Of its requests only the newest counts.
class NoiseFeed : public QObject {
    Q_OBJECT

  public:
    explicit NoiseFeed(NoiseService& service, QObject* parent = nullptr);
    ~NoiseFeed() override;

    /// Equal to the last one: nothing happens.
    void request(const NoiseRequest& request);
    /// The newest frame; its image is null before the first one.
    const NoiseFrame& frame() const { return m_frame; }
    bool isWanted() const { return m_last.texton != nullptr; }
    QSize wantedSize() const { return m_last.size; }
    /// Whether it answers the newest request, in full.
    bool isCurrent() const { return isWanted() && m_frame.complete && m_frame.request == m_last; }

  signals:
    void frameReady();
    /// Drawing failed: one line for the view.
    void failed(const QString& message);

  private:
    friend class NoiseService;
    void take(NoiseFrame frame);

    QPointer<NoiseService> m_service;
    quint64 m_id;
    NoiseRequest m_last;
    NoiseFrame m_frame;
};

} // namespace txn::app
