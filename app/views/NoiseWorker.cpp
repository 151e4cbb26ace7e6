// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/NoiseWorker.h"

#include "app/threads/ThreadPriority.h"
#include "core/mesh/BuiltinMeshes.h"

#include <new>

namespace txn::app {
namespace {

using namespace std::chrono_literals;

/// What a frame may take while things move.
constexpr double kMovingMs = 15.0;
/// Without a new request for so long, things are still.
constexpr auto kStillAfter = 60ms;
constexpr QSize kRehearsalSize{16, 16};

/// As the painter; without memory it is an error like others.
Result<std::optional<NoiseFrame>> drawn(NoisePainter& painter,
                                        const NoiseRequest& request,
                                        double scale,
                                        const std::function<bool()>& stop) {
    try {
        return painter.draw(request, scale, stop);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::TooLarge,
                     "there is not enough memory to draw the noise; make the window smaller"};
    }
}

} // namespace

NoiseWorker::NoiseWorker(Callbacks callbacks)
    : m_callbacks(std::move(callbacks)), m_thread([this] { run(); }) {}

NoiseWorker::~NoiseWorker() {
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
    }
    m_wake.notify_all();
    m_thread.join();
}

void NoiseWorker::request(quint64 client, const NoiseRequest& request) {
    {
        const std::lock_guard lock(m_mutex);
        Client& entry = m_clients[client];
        entry.request = request;
        entry.number = ++m_requests;
        entry.fresh = true;
        entry.complete = false;
        entry.since = Clock::now();
    }
    m_wake.notify_all();
}

void NoiseWorker::forget(quint64 client) {
    const std::lock_guard lock(m_mutex);
    m_clients.erase(client);
}

void NoiseWorker::loseContext() {
    {
        const std::lock_guard lock(m_mutex);
        m_loseContext = true;
        for (auto& [id, client] : m_clients) {
            client.fresh = client.request.texton != nullptr;
            client.complete = false;
            client.number = ++m_requests;
        }
    }
    m_wake.notify_all();
}

std::optional<NoiseWorker::Task> NoiseWorker::next() {
    std::unique_lock lock(m_mutex);
    while (!m_ending) {
        // Those who wait for a first picture come first, taking turns.
        const auto take = [&](auto&& wanted) -> std::optional<Task> {
            auto from = m_clients.upper_bound(m_lastServed);
            for (std::size_t i = 0; i < m_clients.size(); ++i, ++from) {
                if (from == m_clients.end())
                    from = m_clients.begin();
                if (wanted(from->second)) {
                    m_lastServed = from->first;
                    return Task{from->first,
                                from->second.number,
                                from->second.request,
                                from->second.fresh};
                }
            }
            return std::nullopt;
        };
        if (auto task = take([](const Client& client) { return client.fresh; }))
            return task;
        const auto now = Clock::now();
        if (auto task = take([&](const Client& client) {
                return !client.complete && now - client.since >= kStillAfter;
            }))
            return task;
        if (!m_rehearsals.empty() && isStill(now)) {
            Task task;
            task.request = std::move(m_rehearsals.back());
            task.rehearsal = true;
            m_rehearsals.pop_back();
            return task;
        }
        const bool unfinished =
            std::any_of(m_clients.begin(), m_clients.end(), [](const auto& entry) {
                return !entry.second.complete;
            });
        if (unfinished || !m_rehearsals.empty())
            m_wake.wait_for(lock, kStillAfter / 4);
        else
            m_wake.wait(lock);
    }
    return std::nullopt;
}

bool NoiseWorker::isStill(Clock::time_point now) const {
    return std::all_of(m_clients.begin(), m_clients.end(), [now](const auto& entry) {
        return entry.second.complete && now - entry.second.since >= kStillAfter;
    });
}

void NoiseWorker::rehearse(const NoiseRequest& request) {
    const std::lock_guard lock(m_mutex);
    const auto program = [&](const View& view) {
        const auto* mesh = std::get_if<MeshView>(&view);
        return Program{view.index(),
                       mesh != nullptr ? mesh->mapping : MeshView::Mapping::Surface,
                       request.style.noise.process,
                       request.style.filter,
                       !request.maps.empty() && !request.map};
    };
    m_compiled.insert(program(request.view));
    MeshView byCoordinates;
    byCoordinates.mapping = MeshView::Mapping::TextureCoordinates;
    for (const View& view : {View(GroundView{}), View(byCoordinates), View(MeshView{})}) {
        if (!m_compiled.insert(program(view)).second)
            continue;
        NoiseRequest few = request;
        few.view = view;
        few.size = kRehearsalSize;
        if (!few.mesh)
            few.mesh = std::make_shared<const TriangleMesh>(planeMesh(2));
        m_rehearsals.push_back(std::move(few));
    }
}

bool NoiseWorker::isOutdated(const Task& task) {
    const std::lock_guard lock(m_mutex);
    const auto client = m_clients.find(task.client);
    return m_ending || m_loseContext || client == m_clients.end() ||
           client->second.number != task.number;
}

void NoiseWorker::draw(const Task& task, NoisePainter& painter) {
    if (task.rehearsal) {
        try {
            painter.rehearse(task.request);
        } catch (const std::bad_alloc&) { // nobody waits for it
        }
        return;
    }
    const double scale = task.coarse ? painter.scaleFor(task.request, kMovingMs) : 1.0;
    // A coarse frame is drawn to its end: while things move, one that is a little late is better
    // than none.
    auto frame =
        drawn(painter, task.request, scale, [&] { return !task.coarse && isOutdated(task); });
    bool complete = scale == 1.0;
    {
        const std::lock_guard lock(m_mutex);
        const auto client = m_clients.find(task.client);
        if (client == m_clients.end())
            return;
        if (client->second.number == task.number) {
            client->second.fresh = false;
            client->second.complete = complete || !frame;
        }
    }
    if (!frame) {
        m_callbacks.failed(task.client, frame.error().message);
        return;
    }
    if (*frame) {
        (*frame)->complete = complete;
        if (complete && !(*frame)->onProcessor)
            rehearse(task.request);
        m_callbacks.frame(task.client, std::move(**frame));
    }
}

void NoiseWorker::run() {
    lowerThreadPriority(ThreadPriority::Drawing);
    NoisePainter painter;
    std::string problem = painter.problem();
    m_callbacks.ready(painter.renderer(), problem);
    while (const auto task = next()) {
        const bool lose = [&] {
            const std::lock_guard lock(m_mutex);
            return std::exchange(m_loseContext, false);
        }();
        if (lose) {
            painter.loseContext();
            const std::lock_guard lock(m_mutex);
            m_compiled.clear();
        }
        draw(*task, painter);
        if (painter.problem() != problem) {
            problem = painter.problem();
            m_callbacks.ready(painter.renderer(), problem);
        }
    }
}

} // namespace txn::app
