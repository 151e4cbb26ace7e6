// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/views/NoiseFrame.h"
#include "app/views/NoisePainter.h"

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <tuple>
#include <vector>

namespace txn::app {

/// The thread behind a NoiseService. Its functions may be called from any thread; its callbacks
/// come on its own.
class NoiseWorker {
  public:
    struct Callbacks {
        std::function<void(quint64 client, NoiseFrame)> frame;
        std::function<void(quint64 client, std::string message)> failed;
        /// The renderer's name, and why there is none or what it cannot do. First of all, and
        /// again when that changes.
        std::function<void(std::string renderer, std::string problem)> ready;
    };

    explicit NoiseWorker(Callbacks callbacks);
    NoiseWorker(const NoiseWorker&) = delete;
    NoiseWorker& operator=(const NoiseWorker&) = delete;
    ~NoiseWorker();

    /// Takes the place of the client's last request.
    void request(quint64 client, const NoiseRequest& request);
    void forget(quint64 client);
    void loseContext();

  private:
    using Clock = std::chrono::steady_clock;
    struct Client {
        NoiseRequest request;
        quint64 number = 0; ///< of the request
        bool fresh = false; ///< nothing of it has been drawn yet
        bool complete = true;
        Clock::time_point since; ///< when the request came
    };
    struct Task {
        quint64 client = 0;
        quint64 number = 0;
        NoiseRequest request;
        bool coarse = false;
        bool rehearsal = false; ///< nobody waits for the picture
    };
    /// What shaders are compiled for.
    using Program = std::tuple<std::size_t, MeshView::Mapping, NoiseProcess, Filter, bool>;

    void run();
    /// Waits for something to draw; nothing when the program ends.
    std::optional<Task> next();
    void draw(const Task& task, NoisePainter& painter);
    bool isOutdated(const Task& task);
    bool isStill(Clock::time_point now) const;
    /// Shaders of the views that may be asked for next are compiled while nothing else is to be
    /// done, by drawing a few pixels of each.
    void rehearse(const NoiseRequest& request);

    Callbacks m_callbacks;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::map<quint64, Client> m_clients;
    quint64 m_requests = 0;
    quint64 m_lastServed = 0;
    std::set<Program> m_compiled;
    std::vector<NoiseRequest> m_rehearsals;
    bool m_loseContext = false;
    bool m_ending = false;
    std::thread m_thread; ///< last: starts when all else is there
};

} // namespace txn::app
