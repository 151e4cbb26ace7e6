// SPDX-License-Identifier: GPL-3.0-or-later
// soak SECONDS PICTURE: works in the real window for so long, over and over the same: computes,
// paints, bakes, takes back. Draws the memory that the program has and the time of a frame after
// each round, and fails where either grows; the time as against that of a fixed computation at the
// same moments, since machines have their moods. See docs/RELIABILITY.md.
#include "app/panels/ExportDialog.h"
#include "app/threads/ThreadPriority.h"
#include "tests/app/Studio.h"

#include <QChartView>
#include <QCheckBox>
#include <QFile>
#include <QLineEdit>
#include <QLineSeries>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QSpinBox>
#include <QValueAxis>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <functional>
#include <thread>
#include <unistd.h>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

constexpr double kGrowthMb = 20.0; ///< that memory may show
constexpr double kSlower = 1.25;   ///< that a frame may become

struct Round {
    double minutes = 0.0;
    double memoryMb = 0.0;
    double frameMs = 0.0;
    double fixedMs = 0.0;

    double frameAgainstFixed() const { return frameMs / fixedMs; }
};

/// Of the same computation every time, on all cores, at the priority at which frames are drawn.
double fixedMs() {
    constexpr int kTerms = 1'500'000;
    QElapsedTimer clock;
    clock.start();
    std::vector<std::thread> threads;
    std::atomic<double> sink{0.0};
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i) {
        threads.emplace_back([&sink] {
            lowerThreadPriority(ThreadPriority::Drawing);
            double sum = 0.0;
            for (int k = 0; k < kTerms; ++k)
                sum += std::sin(k);
            sink = sum;
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    return static_cast<double>(clock.nsecsElapsed()) / 1e6;
}

/// Resident, of this process.
double memoryMb() {
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly))
        return NAN;
    const double pages = file.readAll().split(' ').value(1).toDouble();
    return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

class Worker {
  public:
    bool open() {
        if (!m_studio.openSample("rust"))
            return false;
        m_studio.window().files().openSecondSample("sand");
        // So that a round takes seconds.
        m_studio.document().change("Small", [](Project& p) {
            p.texton.support = {32, 32};
            p.texton.kernels = 1;
            p.mix.textons = 3;
        });
        if (!settle())
            return false;
        m_studio.document().changeView([](ViewState& view) {
            view.layout = ViewLayout::Single;
            view.shown = {Picture::Noise, Picture::Exemplar, Picture::Gaussian, Picture::Texton};
        });
        m_studio.window().views().setZoom(1.0);
        return settle();
    }

    /// Computes, paints, bakes and takes it all back; false if something does not work or end.
    bool work() {
        const int before = m_studio.document().undoStack().index();
        const quint32 seed = ++m_seed;
        m_studio.document().change("Seed", [seed](Project& p) { p.texton.seed = {seed}; });
        if (!settle())
            return false;
        const std::array tools{"mix.brush", "mix.smooth", "mix.erase"};
        for (const char* tool : tools) {
            m_studio.trigger(tool);
            paint();
        }
        if (m_studio.document().undoStack().index() != before + 1 + static_cast<int>(tools.size()))
            return false;              // a stroke did not arrive
        m_studio.trigger("mix.brush"); // off: drags move the view again
        if (!settle() || !bake())
            return false;
        while (m_studio.document().undoStack().index() > before)
            m_studio.document().undoStack().undo();
        return settle();
    }

    /// The quickest of several frames, each at some new place, and what the fixed computation takes
    /// at its quickest meanwhile.
    bool measure(Round& round) {
        round.frameMs = INFINITY;
        round.fixedMs = INFINITY;
        for (int i = 0; i < 9; ++i) {
            round.fixedMs = std::min(round.fixedMs, fixedMs());
            m_studio.document().changeView([i](ViewState& view) { view.centerX = 37.0 * i; });
            if (!settle())
                return false;
            round.frameMs = std::min(round.frameMs, noiseView().noiseFrame().milliseconds);
        }
        return true;
    }

  private:
    PictureView& noiseView() { return *m_studio.window().views().views().front(); }

    bool settle() {
        return waitFor([&] {
            const auto mix = m_studio->pipeline().mix();
            return m_studio.isSettled() && mix && mix->finished &&
                   !m_studio->pipeline().isMixStale();
        });
    }

    void paint() {
        PictureView& view = noiseView();
        const QPointF middle(view.rect().center());
        QTest::mousePress(&view, Qt::LeftButton, {}, middle.toPoint());
        for (int i = 0; i < 60; ++i)
            QTest::mouseMove(
                &view,
                (middle + 200.0 * QPointF(std::sin(0.11 * i), std::cos(0.07 * i))).toPoint());
        QTest::mouseRelease(&view, Qt::LeftButton, {}, middle.toPoint());
    }

    bool bake() {
        m_studio.trigger("file.export");
        auto* dialog = m_studio.find<ExportDialog>("exportDialog");
        dialog->findChild<QListWidget*>("exportKinds")->setCurrentRow(1);
        dialog->findChild<QLineEdit*>("exportFolder")->setText(m_folder.path());
        // A tile would have to be as large as the map.
        dialog->findChild<QCheckBox*>("exportTileable")->setChecked(false);
        dialog->findChild<QSpinBox*>("exportWidth")->setValue(1024);
        dialog->findChild<QSpinBox*>("exportHeight")->setValue(1024);
        dialog->findChild<QPushButton*>("exportStart")->click();
        const bool ended = waitFor([&] {
            return m_studio->runner().isIdle() &&
                   !QDir(m_folder.path()).entryList(QDir::Files).isEmpty();
        });
        dialog->close();
        for (const QFileInfo& file : QDir(m_folder.path()).entryInfoList(QDir::Files))
            QFile::remove(file.filePath());
        return ended;
    }

    QTemporaryDir m_folder;
    Studio m_studio{QStringLiteral("en"), ThemeChoice::Dark, {1100, 700}};
    quint32 m_seed = 100;
};

/// Of the rounds from one share of all to another.
double median(const std::vector<Round>& rounds, auto value, double from, double to) {
    std::vector<double> values;
    const auto count = static_cast<double>(rounds.size());
    for (auto i = static_cast<std::size_t>(from * count); i < static_cast<std::size_t>(to * count);
         ++i)
        values.push_back(std::invoke(value, rounds[i]));
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

QImage drawn(const std::vector<Round>& rounds, auto value, const QString& title) {
    auto* line = new QLineSeries;
    double highest = 0.0;
    for (const Round& each : rounds) {
        line->append(each.minutes, std::invoke(value, each));
        highest = std::max(highest, std::invoke(value, each));
    }
    QChart chart;
    chart.addSeries(line);
    chart.legend()->hide();
    chart.setTitle(title);
    auto* minutes = new QValueAxis;
    minutes->setRange(0.0, std::max(1.0, std::ceil(rounds.back().minutes - 0.2)));
    minutes->setTickCount(static_cast<int>(minutes->max()) + 1);
    minutes->setLabelFormat(QStringLiteral("%d"));
    minutes->setTitleText(QStringLiteral("minutes"));
    auto* axis = new QValueAxis;
    axis->setRange(0.0, 1.25 * highest);
    axis->applyNiceNumbers();
    axis->setLabelFormat(QStringLiteral("%d"));
    chart.addAxis(minutes, Qt::AlignBottom);
    chart.addAxis(axis, Qt::AlignLeft);
    line->attachAxis(minutes);
    line->attachAxis(axis);

    QGraphicsScene scene;
    chart.resize(900, 280);
    scene.addItem(&chart);
    QImage image(900, 280, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    scene.render(&painter, image.rect(), chart.geometry());
    scene.removeItem(&chart);
    return image;
}

bool draw(const std::vector<Round>& rounds, const QString& file) {
    const QImage memory = drawn(rounds, &Round::memoryMb, QStringLiteral("memory, MB"));
    const QImage frame = drawn(rounds, &Round::frameMs, QStringLiteral("time of a frame, ms"));
    const QImage fixed =
        drawn(rounds, &Round::fixedMs, QStringLiteral("time of a fixed computation, ms"));
    QImage all(memory.width(), 3 * memory.height(), QImage::Format_RGB32);
    QPainter painter(&all);
    painter.drawImage(0, 0, memory);
    painter.drawImage(0, memory.height(), frame);
    painter.drawImage(0, 2 * memory.height(), fixed);
    painter.end();
    return all.save(file);
}

} // namespace

int main(int argc, char** argv) {
    const QApplication application(argc, argv);
    const double seconds = argc == 3 ? QByteArray(argv[1]).toDouble() : 0.0;
    if (seconds <= 0.0) {
        std::fputs("usage: soak SECONDS PICTURE\n", stderr);
        return 2;
    }
    Worker worker;
    bool good = worker.open();
    std::vector<Round> rounds;
    QElapsedTimer clock;
    clock.start();
    while (good && static_cast<double>(clock.elapsed()) < 1000.0 * seconds) {
        Round round;
        good = worker.work() && worker.measure(round);
        round.minutes = static_cast<double>(clock.elapsed()) / 60000.0;
        round.memoryMb = memoryMb();
        rounds.push_back(round);
        std::fprintf(stderr,
                     "%.2f min: %.1f MB, frames of %.1f ms, %.2f times the fixed computation\n",
                     round.minutes,
                     round.memoryMb,
                     round.frameMs,
                     round.frameAgainstFixed());
    }
    constexpr std::size_t kFewest = 10;
    if (!good) {
        std::fputs("something did not work or not finish in time\n", stderr);
        return 1;
    }
    if (rounds.size() < kFewest) {
        std::fprintf(stderr, "only %zu rounds; please take more seconds\n", rounds.size());
        return 1;
    }
    if (!draw(rounds, QString::fromLocal8Bit(argv[2]))) {
        std::fprintf(stderr, "cannot write %s\n", argv[2]);
        return 1;
    }
    // The first fifth is warming up: caches and pools fill.
    const double grown =
        median(rounds, &Round::memoryMb, 0.8, 1.0) - median(rounds, &Round::memoryMb, 0.2, 0.4);
    const double slower = median(rounds, &Round::frameAgainstFixed, 0.8, 1.0) /
                          median(rounds, &Round::frameAgainstFixed, 0.2, 0.4);
    std::fprintf(stderr, "grown by %.1f MB, frames take %.2f times as long\n", grown, slower);
    const bool flat = grown <= kGrowthMb && slower <= kSlower;
    std::printf("{\"name\": \"rounds of %.0f minutes of work\", \"runs\": %zu, \"bad\": %d}\n",
                seconds / 60.0,
                rounds.size(),
                flat ? 0 : 1);
    return flat ? 0 : 1;
}
