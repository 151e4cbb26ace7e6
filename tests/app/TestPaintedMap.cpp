// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/PaintedMap.h"
#include "core/mixing/MapBrush.h"
#include "core/mixing/TextonField.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Verify.h"

#include <QElapsedTimer>
#include <QLoggingCategory>
#include <QtTest>

#include <limits>

using namespace txn;
using namespace txn::app;
using namespace txn::test;

namespace {

Image roughMap(Size size, std::uint64_t seed) {
    TestRandom random(seed);
    Image rho(size, 1);
    for (float& v : rho.samples())
        v = static_cast<float>(std::clamp(random.uniform(-0.2, 1.2), 0.0, 1.0));
    return rho;
}

/// Uniform tiles, soft ones and rough ones.
Image mixedMap(Size size, std::uint64_t seed) {
    Image rho(size, 1);
    linearGradient(rho, {10, 10}, {70, 40}, 1.0F, 0.0F, Ease::Smooth);
    const Image rough = roughMap(size, seed);
    for (int y = 0; y < size.height; ++y) {
        for (int x = size.width - 40; x >= 0 && x < size.width; ++x)
            rho.at(x, y, 0) = rough.at(x, y, 0);
    }
    return rho;
}

constexpr auto kSizes = {
    Size{1, 1}, {64, 64}, {65, 63}, {1, 300}, {300, 1}, {128, 192}, {333, 190}};

bool isMap(const Image& rho) {
    return std::ranges::all_of(rho.samples(), [](float v) { return v >= 0.0F && v <= 1.0F; });
}

/// A stroke of an artist: a few hundred texels in one of the ways there are.
std::vector<Rect> stroke(Image& map, double radius, TestRandom& random) {
    Brush brush;
    brush.radius = radius;
    brush.hardness = random.uniform();
    brush.strength = random.uniform(0.2, 1.0);
    brush.mode = static_cast<BrushMode>(random.below(3));
    brush.target = static_cast<float>(random.uniform());
    BrushStroke strokes(map, brush, {}, random.below(2) == 1);
    std::vector<Rect> dirty;
    double x = random.uniform(0.0, map.width());
    double y = random.uniform(0.0, map.height());
    for (int i = 0; i < 10; ++i) {
        for (const Rect& r : strokes.moveTo(x, y, random.uniform(0.5, 1.0), map))
            dirty.push_back(r);
        x += random.uniform(-30.0, 40.0);
        y += random.uniform(-40.0, 30.0);
    }
    return dirty;
}

} // namespace

class TestPaintedMap : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        // Qt says of every damaged tile that it is.
        QLoggingCategory::setFilterRules("default.warning=false");
    }

    void theDefaultIsAllA() {
        const PaintedMap map;
        QCOMPARE(map.size(), (Size{1024, 1024}));
        QVERIFY(map.image() == Image({1024, 1024}, 1));
        QVERIFY(map == PaintedMap::fromImage(Image({1024, 1024}, 1)));
        QVERIFY(map.bytes() < 8192);
        QVERIFY(map.toBytes().size() <= 1024);
    }

    void valuesComeBackToHalfAStep() {
        for (const Size size : kSizes) {
            for (const Image& rho : {roughMap(size, 1), mixedMap(size, 2), Image(size, 1, 0.3F)}) {
                const PaintedMap map = PaintedMap::fromImage(rho);
                QCOMPARE(map.size(), size);
                const Image back = map.image();
                TXN_AT_MOST(largestDifference(back.samples(), rho.samples()), 0.5 / 65535.0 + 1e-7);
                QVERIFY(isMap(back));
                const PaintedMap again = PaintedMap::fromImage(back);
                QVERIFY(again == map);
                QVERIFY(again.image() == back);
            }
        }
        Image all({256, 256}, 1); // every value that there is
        for (std::size_t i = 0; i < all.samples().size(); ++i)
            all.samples()[i] = static_cast<float>(static_cast<double>(i) / 65535.0);
        QVERIFY(PaintedMap::fromImage(all).image() == all);
    }

    void whatIsNoMapBecomesOne() {
        Image rho({70, 3}, 1, 0.5F);
        const auto infinity = std::numeric_limits<float>::infinity();
        rho.at(0, 0, 0) = std::numeric_limits<float>::quiet_NaN();
        rho.at(1, 0, 0) = -infinity;
        rho.at(2, 0, 0) = infinity;
        rho.at(3, 0, 0) = -0.1F;
        rho.at(4, 0, 0) = 1.1F;
        const Image back = PaintedMap::fromImage(rho).image();
        QVERIFY(isMap(back));
        const auto row = back.row(0, 0);
        QVERIFY(row[0] == 0.0F && row[1] == 0.0F && row[2] == 1.0F && row[3] == 0.0F &&
                row[4] == 1.0F);
    }

    void textonsStayWhichTheyAre() {
        for (int textons = 2; textons <= TextonField::kMaxTextons; ++textons) {
            Image rho({textons, 1}, 1);
            for (int r = 0; r < textons; ++r)
                rho.at(r, 0, 0) = static_cast<float>(static_cast<double>(r) / (textons - 1));
            MixingMap map;
            map.rho = PaintedMap::fromImage(rho).image();
            map.placement = {0.0, 0.0, 1.0 * textons, 1.0};
            // 0.5 is as far from both its neighbours as can be.
            TXN_AT_MOST(largestDifference(map.rho.samples(), rho.samples()), 0.5 / 65535.0 + 6e-8);
            const TextonField field(map, textons, {8, 8});
            for (int r = 0; r < textons; ++r) {
                for (const std::uint32_t choice : {0U, 511U, 1023U})
                    QCOMPARE(field.textonAt(r + 0.5, 0.5, choice), r);
            }
        }
    }

    void aStrokeLeavesAllOtherTilesShared() {
        Image rho = mixedMap({333, 190}, 3);
        const PaintedMap before = PaintedMap::fromImage(rho);
        Brush brush;
        brush.radius = 20.0;
        brush.target = 0.3F;
        BrushStroke corner(before.image(), brush, {}, false);
        rho = before.image();
        const auto dirty = corner.moveTo(0.0, 0.0, 1.0, rho);
        const PaintedMap after = before.with(rho, dirty);
        QVERIFY(after != before);
        QVERIFY(after == PaintedMap::fromImage(rho));
        for (int y = 0; y < 190; ++y) {
            for (int x = 0; x < 333; ++x)
                QCOMPARE(after.sharesTile(before, x, y), x >= 64 || y >= 64);
        }
        QVERIFY(PaintedMap::bytes(std::array{before, after}) <
                before.bytes() + after.bytes() - before.bytes() / 2);
        QCOMPARE(PaintedMap::bytes(std::array{before, before}), before.bytes());
    }

    void onlyDirtyTilesAreLookedAt() {
        Image rho = mixedMap({200, 200}, 4);
        const PaintedMap before = PaintedMap::fromImage(rho);
        const auto value = static_cast<float>(16384 / 65535.0);
        fillMap(rho, value);
        const Image was = before.image();
        for (const Rect& none : {Rect{},
                                 {64, 64, {0, 0}},
                                 {-70, 0, {70, 64}},
                                 {0, 200, {64, 9}},
                                 {1LL << 40, 0, {9, 9}},
                                 {10, 10, {-5, 5}}})
            QVERIFY(before.with(rho, none) == before);
        const PaintedMap one = before.with(rho, Rect{64, 127, {64, 1}});
        const PaintedMap more =
            before.with(rho, std::array<Rect, 2>{{{-5, -5, {6, 6}}, {199, 100, {1, 100}}}});
        const Image is = one.image();
        for (int y = 0; y < 200; y += 8) {
            for (int x = 0; x < 200; x += 8) {
                const int column = x / 64;
                const int row = y / 64;
                const bool inOne = column == 1 && row == 1;
                const bool inMore = (column == 0 && row == 0) || (column == 3 && row >= 1);
                QCOMPARE(one.sharesTile(before, x, y), !inOne);
                QCOMPARE(more.sharesTile(before, x, y), !inMore);
                QCOMPARE(is.at(x, y, 0), inOne ? value : was.at(x, y, 0));
            }
        }
        // What was looked at and is alike stays shared, whatever it is made of.
        const PaintedMap same = before.with(before.image(), Rect{0, 0, {200, 200}});
        const PaintedMap whole = before.with(rho, Rect{0, 0, {200, 200}});
        for (int at = 0; at < 200; at += 8)
            QVERIFY(same.sharesTile(before, at, at) && !whole.sharesTile(before, at, at));
        QVERIFY(whole == PaintedMap::fromImage(rho));
    }

    void equalityIsOfSizesAndTexels() {
        const Image rho = mixedMap({130, 70}, 5);
        const PaintedMap map = PaintedMap::fromImage(rho);
        const PaintedMap copy = map;
        QVERIFY(copy == map);
        QVERIFY(PaintedMap::fromImage(rho) == map);
        QVERIFY(PaintedMap::fromImage(mixedMap({130, 71}, 5)) != map);
        QVERIFY(PaintedMap::fromImage(Image({64, 1}, 1)) !=
                PaintedMap::fromImage(Image({1, 64}, 1)));
        for (const auto& [x, y] : {std::pair{0, 0}, {64, 0}, {129, 69}, {100, 65}}) {
            Image other = rho;
            other.at(x, y, 0) += other.at(x, y, 0) > 0.5F ? -1.0F / 65535.0F : 1.0F / 65535.0F;
            QVERIFY(PaintedMap::fromImage(other) != map);
            QVERIFY(map.with(other, {x, y, {1, 1}}) != map);
            QVERIFY(map.with(other, {x, y, {1, 1}}).with(rho, {x, y, {1, 1}}) == map);
        }
        QVERIFY(PaintedMap::fromImage(Image({9, 9}, 1, 0.5F)) !=
                PaintedMap::fromImage(Image({9, 9}, 1, 0.6F)));
    }

    void tilesOfAnotherCompressorAreEqual() {
        // The same tile, as a compressor that tries harder and one that does not try make it.
        const PaintedMap map = PaintedMap::fromImage(mixedMap({64, 64}, 6));
        const QByteArray bytes = map.toBytes();
        const QByteArray raw = qUncompress(bytes.mid(2));
        QCOMPARE(raw.size(), 2 * 64 * 64);
        for (const int level : {0, 9}) {
            const QByteArray tile = qCompress(raw, level);
            QByteArray other;
            other.append(static_cast<char>(tile.size() & 0xff));
            other.append(static_cast<char>(tile.size() >> 8));
            other.append(tile);
            QVERIFY(other != bytes);
            const auto read = PaintedMap::fromBytes(other, {64, 64});
            TXN_OK(read);
            QVERIFY(*read == map && map == *read);
        }
        // And a uniform one, told texel by texel.
        QByteArray zeros = qCompress(QByteArray(2 * 64 * 64, '\0'), 9);
        zeros.prepend('\0').prepend(static_cast<char>(zeros.size() - 1));
        const auto read = PaintedMap::fromBytes(zeros, {64, 64});
        TXN_OK(read);
        const PaintedMap uniform = PaintedMap::fromImage(Image({64, 64}, 1));
        QVERIFY(*read == uniform && uniform == *read);
    }

    void bytesComeBack() {
        for (const Size size : kSizes) {
            for (const Image& rho : {roughMap(size, 7), mixedMap(size, 8), Image(size, 1, 0.3F)}) {
                const PaintedMap map = PaintedMap::fromImage(rho);
                const auto read = PaintedMap::fromBytes(map.toBytes(), size);
                TXN_OK(read);
                QVERIFY(*read == map);
                QVERIFY(read->image() == map.image());
                QCOMPARE(read->toBytes(), map.toBytes());
            }
        }
    }

    void bytesOfAnotherSizeAreRefused() {
        const QByteArray bytes = PaintedMap::fromImage(mixedMap({333, 190}, 9)).toBytes();
        for (const Size size : {Size{0, 0},
                                {-1, 5},
                                {333, 0},
                                {333, 189},
                                {332, 190},
                                {190, 333},
                                {333, 500},
                                {8193, 190},
                                {1 << 30, 1 << 30}})
            TXN_FAILS_WITH(PaintedMap::fromBytes(bytes, size), ErrorCode::Unreadable);
        TXN_FAILS_WITH(PaintedMap::fromBytes({}, {333, 190}), ErrorCode::Unreadable);
        TXN_FAILS_WITH(PaintedMap::fromBytes({}, {0, 0}), ErrorCode::Unreadable);
        TXN_OK(PaintedMap::fromBytes(QByteArray(128 * 4, '\0'), {8192, 1}));
        TXN_FAILS_WITH(PaintedMap::fromBytes(QByteArray(129 * 4, '\0'), {8193, 1}),
                       ErrorCode::Unreadable);
        TXN_FAILS_WITH(PaintedMap::fromBytes(QByteArray(129 * 4, '\0'), {1, 8193}),
                       ErrorCode::Unreadable);
        TXN_FAILS_WITH(PaintedMap::fromBytes(bytes + '\0', {333, 190}), ErrorCode::Unreadable);
        for (qsizetype length = 0; length < bytes.size(); length += 1 + length / 40)
            TXN_FAILS_WITH(PaintedMap::fromBytes(bytes.first(length), {333, 190}),
                           ErrorCode::Unreadable);
    }

    void bombsAreRefused() {
        const auto tileOf = [](const QByteArray& packed) {
            QByteArray bytes;
            bytes.append(static_cast<char>(packed.size() & 0xff));
            bytes.append(static_cast<char>(packed.size() >> 8));
            return bytes + packed;
        };
        const auto withLength = [](QByteArray packed, quint32 length) {
            qToBigEndian(length, packed.data());
            return packed;
        };
        const QByteArray honest = qCompress(QByteArray(8192, 'x'), 9);
        TXN_OK(PaintedMap::fromBytes(tileOf(honest), {64, 64}));
        // Lengths that would be taken from memory before anything is looked at.
        for (const quint32 length : {0U, 1U, 8191U, 8193U, 0x7fffffffU, 0xffffffffU})
            TXN_FAILS_WITH(PaintedMap::fromBytes(tileOf(withLength(honest, length)), {64, 64}),
                           ErrorCode::Unreadable);
        // More or less than the length says.
        for (const int inside : {0, 1, 8191, 8193, 100000, 8000000, 60000000})
            TXN_FAILS_WITH(PaintedMap::fromBytes(
                               tileOf(withLength(qCompress(QByteArray(inside, 'x'), 9), 8192)),
                               {64, 64}),
                           ErrorCode::Unreadable);
        for (const int length : {1, 2, 3, 4, 5})
            TXN_FAILS_WITH(PaintedMap::fromBytes(tileOf(honest.first(length)), {64, 64}),
                           ErrorCode::Unreadable);
    }

    void damagedBytesAreRefusedOrAMap() {
        const Size size{200, 130};
        const QByteArray bytes = PaintedMap::fromImage(mixedMap(size, 10)).toBytes();
        TestRandom random(11);
        int refused = 0;
        for (int run = 0; run < 2000; ++run) {
            QByteArray other = bytes;
            for (int change = random.below(4); change >= 0; --change) {
                const auto at =
                    static_cast<qsizetype>(random.below(static_cast<int>(other.size())));
                const auto byte = static_cast<char>(random.below(256));
                switch (random.below(4)) {
                case 0:
                    other[at] = byte;
                    break;
                case 1:
                    other.insert(at, byte);
                    break;
                case 2:
                    other.remove(at, 1 + random.below(30));
                    break;
                default:
                    other[at] = static_cast<char>(other[at] ^ (1 << random.below(8)));
                    break;
                }
            }
            const auto read = PaintedMap::fromBytes(other, size);
            if (!read) {
                TXN_FAILS_WITH(read, ErrorCode::Unreadable);
                ++refused;
                continue;
            }
            QCOMPARE(read->size(), size);
            QVERIFY(isMap(read->image()));
            const auto again = PaintedMap::fromBytes(read->toBytes(), size);
            TXN_OK(again);
            QVERIFY(*again == *read);
        }
        qInfo("%d of 2000 refused", refused);
        QVERIFY(refused > 1800);
    }

    void aThousandStrokesAreSmall() {
        TestRandom random(12);
        Image rho({1024, 1024}, 1);
        std::vector<PaintedMap> undo{PaintedMap()};
        double milliseconds = 0.0;
        double longest = 0.0;
        for (int i = 0; i < 1000; ++i) {
            const auto dirty = stroke(rho, 40.0, random);
            QElapsedTimer timer;
            timer.start();
            undo.push_back(undo.back().with(rho, dirty));
            const auto taken = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
            milliseconds += taken;
            longest = std::max(longest, taken);
            if (i % 50 == 0)
                QVERIFY(undo.back().image() == PaintedMap::fromImage(rho).image());
        }
        QVERIFY(undo.back() == PaintedMap::fromImage(rho));
        QElapsedTimer timer;
        timer.start();
        const Image last = undo.back().image();
        const auto decompressing = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
        TXN_AT_MOST(largestDifference(last.samples(), rho.samples()), 0.5 / 65535.0 + 1e-7);
        const auto bytes = PaintedMap::bytes(undo);
        qInfo("1000 strokes: %.1f MB; the last map alone %.2f MB; a stroke %.2f ms, at most %.2f; "
              "image() %.2f ms",
              static_cast<double>(bytes) * 1e-6,
              static_cast<double>(undo.back().bytes()) * 1e-6,
              milliseconds / 1000.0,
              longest,
              decompressing);
        QVERIFY(bytes < 64'000'000);
    }
};

QTEST_APPLESS_MAIN(TestPaintedMap)
#include "TestPaintedMap.moc"
