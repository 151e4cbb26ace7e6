// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/samples/Samples.h"

// Before Qt, whose macro "emit" breaks this header.
#include <tbb/task_arena.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

using namespace txn;

namespace {

Image sample(const std::string& name, Size size, std::uint32_t seed) {
    auto result = makeSample(name, size, Seed{seed});
    return result ? std::move(*result) : Image();
}

struct Statistics {
    double mean = 0.0;
    double deviation = 0.0;
};

Statistics statisticsOf(std::span<const float> values) {
    double sum = 0.0;
    double squares = 0.0;
    for (const float v : values) {
        sum += v;
        squares += static_cast<double>(v) * v;
    }
    const auto count = static_cast<double>(values.size());
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

/// Mean absolute step between the columns left and right, wrapped around.
double step(const Image& image, int left, int right) {
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y)
        sum += std::abs(image.at(left, y, 1) - image.at(right, y, 1));
    return sum / image.height();
}

} // namespace

class TestSamples : public QObject {
    Q_OBJECT

  private slots:
    void catalogNamesAreDistinct();
    void repeats_data() { addCatalog(); }
    void repeats();
    void ignoresThreadCount_data() { addCatalog(); }
    void ignoresThreadCount();
    void looksLikePhotograph_data() { addCatalog(); }
    void looksLikePhotograph();
    void keepsLookAtOtherSizes_data() { addCatalog(); }
    void keepsLookAtOtherSizes();
    void tiles_data() { addCatalog(); }
    void tiles();
    void takesAnySize_data();
    void takesAnySize();
    void refuses_data();
    void refuses();
    void unknownNameListsCatalog();

  private:
    static void addCatalog();
};

void TestSamples::addCatalog() {
    QTest::addColumn<std::string>("name");
    for (const SampleInfo& info : sampleCatalog()) {
        const std::string name(info.name);
        QTest::newRow(name.c_str()) << name;
    }
}

void TestSamples::catalogNamesAreDistinct() {
    std::set<std::string_view> names;
    for (const SampleInfo& info : sampleCatalog()) {
        QVERIFY(!info.name.empty() && !info.description.empty());
        QVERIFY(names.insert(info.name).second);
    }
    QVERIFY(names.size() >= 5);
}

void TestSamples::repeats() {
    QFETCH(std::string, name);
    const Image image = sample(name, {128, 96}, 5);
    QVERIFY(!image.empty());
    QVERIFY(image == sample(name, {128, 96}, 5));
    QVERIFY(image != sample(name, {128, 96}, 6));
}

void TestSamples::ignoresThreadCount() {
    QFETCH(std::string, name);
    Image alone;
    tbb::task_arena single(1);
    single.execute([&] { alone = sample(name, {160, 90}, 5); });
    Image together;
    tbb::task_arena several(2);
    several.execute([&] { together = sample(name, {160, 90}, 5); });
    QVERIFY(!alone.empty());
    QVERIFY(alone == together);
}

void TestSamples::looksLikePhotograph() {
    QFETCH(std::string, name);
    const Image image = sample(name, {512, 512}, 1);
    QCOMPARE(image.size(), (Size{512, 512}));
    QCOMPARE(image.channels(), 3);
    QCOMPARE(image.transfer(), Transfer::Encoded);
    const auto samples = image.samples();
    QVERIFY(std::all_of(samples.begin(), samples.end(), [](float v) { return v >= 0 && v <= 1; }));
    // As an 8-bit file would show it: half a step from black or white is clipped too.
    const auto clipped = std::count_if(samples.begin(), samples.end(), [](float v) {
        return v < 0.5F / 255.0F || v > 254.5F / 255.0F;
    });
    QVERIFY(static_cast<double>(clipped) <= 0.005 * static_cast<double>(samples.size()));
    for (int c = 0; c < 3; ++c) {
        const Statistics statistics = statisticsOf(image.plane(c));
        QVERIFY(statistics.mean >= 0.1 && statistics.mean <= 0.9);
        QVERIFY(statistics.deviation >= 0.02 && statistics.deviation <= 0.25);
    }
}

void TestSamples::keepsLookAtOtherSizes() {
    QFETCH(std::string, name);
    const Image small = sample(name, {256, 256}, 1);
    const Image wide = sample(name, {1024, 300}, 1);
    for (int c = 0; c < 3; ++c) {
        const Statistics a = statisticsOf(small.plane(c));
        const Statistics b = statisticsOf(wide.plane(c));
        // Both deviate from the material's own by what the few broadest blobs happen to add.
        QVERIFY(std::abs(a.mean - b.mean) <= 0.04);
        QVERIFY(std::abs(a.deviation - b.deviation) <= 0.25 * b.deviation);
    }
}

void TestSamples::tiles() {
    QFETCH(std::string, name);
    const Image image = sample(name, {251, 193}, 3);
    const int last = image.width() - 1;
    double largest = 0.0;
    for (int x = 0; x < last; ++x)
        largest = std::max(largest, step(image, x, x + 1));
    // The seam is a pair of neighbouring columns like the 250 others.
    QVERIFY(step(image, last, 0) <= 1.2 * largest);
}

void TestSamples::takesAnySize_data() {
    QTest::addColumn<std::string>("name");
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    const Size sizes[] = {{16, 16}, {17, 31}, {127, 16}, {16, 509}, {211, 101}};
    for (const SampleInfo& info : sampleCatalog()) {
        for (const Size size : sizes) {
            const std::string name(info.name);
            QTest::addRow("%s %d x %d", name.c_str(), size.width, size.height)
                << name << size.width << size.height;
        }
    }
}

void TestSamples::takesAnySize() {
    QFETCH(std::string, name);
    QFETCH(int, width);
    QFETCH(int, height);
    const Image image = sample(name, {width, height}, 9);
    QCOMPARE(image.size(), (Size{width, height}));
    const auto samples = image.samples();
    QVERIFY(std::all_of(samples.begin(), samples.end(), [](float v) { return v >= 0 && v <= 1; }));
    QVERIFY(statisticsOf(image.plane(0)).deviation >= 0.01);
}

void TestSamples::refuses_data() {
    QTest::addColumn<std::string>("name");
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::newRow("unknown name") << std::string("cheese") << 64 << 64;
    QTest::newRow("no name") << std::string() << 64 << 64;
    QTest::newRow("upper case") << std::string("Wood") << 64 << 64;
    QTest::newRow("narrow") << std::string("wood") << 15 << 64;
    QTest::newRow("low") << std::string("wood") << 64 << 15;
    QTest::newRow("empty") << std::string("wood") << 0 << 0;
    QTest::newRow("negative") << std::string("wood") << -64 << 64;
    QTest::newRow("wide") << std::string("wood") << 16385 << 64;
    QTest::newRow("high") << std::string("wood") << 64 << 16385;
}

void TestSamples::refuses() {
    QFETCH(std::string, name);
    QFETCH(int, width);
    QFETCH(int, height);
    const auto result = makeSample(name, {width, height}, Seed{1});
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::InvalidArgument);
    QVERIFY(!result.error().message.empty());
}

void TestSamples::unknownNameListsCatalog() {
    const auto result = makeSample("cheese", {64, 64}, Seed{1});
    QVERIFY(!result);
    for (const SampleInfo& info : sampleCatalog())
        QVERIFY(result.error().message.find(info.name) != std::string::npos);
}

QTEST_APPLESS_MAIN(TestSamples)
#include "TestSamples.moc"
