// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/NoiseService.h"

#include "app/views/NoiseWorker.h"

namespace txn::app {

NoiseService::NoiseService(QObject* parent) : QObject(parent) {
    m_worker = std::make_unique<NoiseWorker>(NoiseWorker::Callbacks{
        [this](quint64 client, NoiseFrame frame) {
            m_mailbox.post([this, client, frame = std::move(frame)]() mutable {
                if (const auto feed = m_feeds.find(client); feed != m_feeds.end())
                    feed->second->take(std::move(frame));
            });
        },
        [this](quint64 client, const std::string& message) {
            m_mailbox.post([this, client, text = QString::fromStdString(message)] {
                if (const auto feed = m_feeds.find(client); feed != m_feeds.end())
                    emit feed->second->failed(text);
            });
        },
        [this](const std::string& renderer, const std::string& problem) {
            m_mailbox.post([this,
                            name = QString::fromStdString(renderer),
                            reason = QString::fromStdString(problem)] {
                m_renderer = name;
                m_problem = reason;
                emit ready();
            });
        }});
}

NoiseService::~NoiseService() = default;

void NoiseService::loseContext() {
    m_worker->loseContext();
}

NoiseFeed::NoiseFeed(NoiseService& service, QObject* parent)
    : QObject(parent), m_service(&service), m_id(++service.m_lastFeed) {
    service.m_feeds[m_id] = this;
}

NoiseFeed::~NoiseFeed() {
    if (!m_service)
        return;
    m_service->m_feeds.erase(m_id);
    m_service->m_worker->forget(m_id);
}

void NoiseFeed::request(const NoiseRequest& request) {
    if (!m_service || request == m_last)
        return;
    m_last = request;
    if (!request.texton || request.size.isEmpty()) {
        m_service->m_worker->forget(m_id);
        if (!request.texton)
            m_frame = {};
        return;
    }
    if (std::holds_alternative<MeshView>(request.view) && !request.mesh)
        return; // it is being loaded
    m_service->m_worker->request(m_id, request);
}

void NoiseFeed::take(NoiseFrame frame) {
    if (!m_last.texton)
        return; // closed meanwhile
    m_frame = std::move(frame);
    emit frameReady();
}

} // namespace txn::app
