// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ImageIo.h"
#include "tests/helpers/Images.h"
#include "tests/helpers/Tally.h"
#include "tests/helpers/Verify.h"

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

using namespace txn;
using namespace txn::test;

namespace {

#ifdef TXN_SANITIZED
constexpr qint64 kLongestMs = 10'000;
constexpr int kFiles = 50;
#else
constexpr qint64 kLongestMs = 2'000;
constexpr int kFiles = 500;
#endif
constexpr Size kSize{96, 64};
constexpr std::size_t kMostSamples = std::size_t{1} << 22U;

QByteArray readFile(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Files there have no size to go by.
QByteArray readProc(const QString& name) {
    QFile file(QStringLiteral("/proc/") + name);
    return file.open(QIODevice::ReadOnly | QIODevice::Unbuffered) ? file.readAll() : QByteArray();
}

bool writeFile(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

/// Grain with some even parts, so that compressors find work of both kinds.
Image picture(int channels) {
    Image image = randomImage(kSize, channels, 5);
    for (int c = 0; c < channels; ++c) {
        for (int y = 0; y < 20; ++y)
            std::ranges::fill(image.row(c, y), 0.25F);
    }
    return image;
}

/// Written by OpenImageIO itself, with what the program does not write. samples: interleaved.
QByteArray
written(const QString& path, const OIIO::ImageSpec& spec, const std::vector<float>& samples) {
    const auto output = OIIO::ImageOutput::create(path.toStdString());
    if (!output || !output->open(path.toStdString(), spec) ||
        !output->write_image(OIIO::TypeFloat, samples.data()) || !output->close())
        qFatal("%s cannot be written", qPrintable(path));
    return readFile(path);
}

std::vector<float> interleaved(const Image& image) {
    std::vector<float> samples;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int c = 0; c < image.channels(); ++c)
                samples.push_back(image.at(x, y, c));
        }
    }
    return samples;
}

QByteArray viaOiio(const QString& path,
                   OIIO::TypeDesc type,
                   int channels,
                   const std::function<void(OIIO::ImageSpec&)>& change = {}) {
    OIIO::ImageSpec spec(kSize.width, kSize.height, channels, type);
    if (change)
        change(spec);
    return written(path, spec, interleaved(picture(channels)));
}

void tiled(OIIO::ImageSpec& spec) {
    spec.tile_width = spec.tile_height = 32;
    spec.tile_depth = 1;
}

/// One harm done to a file. donor: a file of another kind.
QByteArray spoilt(QByteArray bytes, const QByteArray& donor, std::mt19937& random) {
    const auto pick = [&](qsizetype most) {
        return std::uniform_int_distribution<qsizetype>(0, std::max<qsizetype>(0, most))(random);
    };
    const auto place = [&](qsizetype within) { return pick(std::min(within, bytes.size()) - 1); };
    constexpr qsizetype kHeader = 256;
    switch (pick(6)) {
    case 0: // cut off
        bytes.truncate(pick(bytes.size() - 1));
        break;
    case 1: // bits flipped, anywhere
        for (auto i = pick(20); i >= 0; --i)
            bytes[place(bytes.size())] ^= static_cast<char>(1 << pick(7));
        break;
    case 2: // bits flipped, in the header
        for (auto i = pick(5); i >= 0; --i)
            bytes[place(kHeader)] ^= static_cast<char>(1 << pick(7));
        break;
    case 3: // the header of something else
        bytes.replace(0, pick(kHeader), donor.left(pick(kHeader)));
        break;
    case 4: { // a number as large as numbers get: bombs of size and of length
        constexpr std::array<std::uint32_t, 6> kLarge{0xffffffff,
                                                      0x7fffffff,
                                                      0x80000000,
                                                      0x0000ffff,
                                                      0x00010000,
                                                      0x00ffff00};
        std::uint32_t value = kLarge[static_cast<std::size_t>(pick(5))];
        if (pick(1) == 0) // in the other order
            value = (value >> 24U) | ((value >> 8U) & 0xff00U) | ((value << 8U) & 0xff0000U) |
                    (value << 24U);
        const auto at = place(kHeader);
        const auto length = std::min<qsizetype>(pick(1) == 0 ? 2 : 4, bytes.size() - at);
        bytes.replace(at, length, reinterpret_cast<const char*>(&value), length);
        break;
    }
    case 5: { // a part missing, or there twice
        const auto at = place(bytes.size());
        const auto part = bytes.mid(at, pick(200));
        pick(1) == 0 ? bytes.remove(at, part.size()) : bytes.insert(at, part);
        break;
    }
    default: // zeros
        const auto at = place(bytes.size());
        bytes.replace(at, 64, QByteArray(64, '\0'));
    }
    return bytes;
}

/// The most memory that a process has had at a time: this one, or the decoders it started.
qint64 peakBytes(const QString& process) {
    for (const QByteArray& line : readProc(process + QStringLiteral("/status")).split('\n')) {
        if (line.startsWith("VmHWM:"))
            return line.mid(6).trimmed().split(' ').front().toLongLong() * 1024;
    }
    return 0;
}
qint64 peakBytesOfDecoders() {
    qint64 most = 0;
    for (const QString& thread : QDir(QStringLiteral("/proc/self/task")).entryList(QDir::Dirs)) {
        const auto children =
            readProc(QStringLiteral("self/task/") + thread + QStringLiteral("/children"));
        for (const QByteArray& child : children.simplified().split(' '))
            most = std::max(most, peakBytes(QString::fromLatin1(child)));
    }
    return most;
}

} // namespace

/// Files that are damaged or made to do harm, and files that are odd but legal. TXN_TORTURE=long:
/// 500 of each kind instead of some.
class TestHostileImages : public QObject {
    Q_OBJECT

    Tally m_tally;
    QTemporaryDir m_folder;
    std::map<QString, QByteArray> m_sound; ///< by name, whose ending means nothing
    qint64 m_slowestMs = 0;
    int m_read = 0;
    int m_refused = 0;

    QString path(const QString& name) const { return m_folder.filePath(name); }

    QByteArray saved(const QString& name, int channels, SampleFormat format) {
        SaveOptions options;
        options.sampleFormat = format;
        if (!saveImage(picture(channels), path(name).toStdString(), options))
            qFatal("%s cannot be saved", qPrintable(name));
        return readFile(path(name));
    }

    /// What was wrong with the answer, or empty.
    QString judged(const QString& file) {
        QElapsedTimer watch;
        watch.start();
        LoadOptions options;
        options.maxSamples = kMostSamples;
        const auto loaded = loadImage(file.toStdString(), options);
        m_slowestMs = std::max(m_slowestMs, watch.elapsed());
        if (watch.elapsed() > kLongestMs)
            return QStringLiteral("took %1 ms").arg(watch.elapsed());
        ++(loaded ? m_read : m_refused);
        if (loaded) {
            const Image& image = loaded->image;
            return image.empty() || image.samples().size() > kMostSamples
                       ? QStringLiteral("an empty or too large picture")
                       : QString();
        }
        const QString message = QString::fromStdString(loaded.error().message);
        if (!message.contains(QFileInfo(file).fileName()))
            return QStringLiteral("names no file: ") + message;
        return message.contains(QLatin1Char('\n')) ? QStringLiteral("has lines: ") + message
                                                   : QString();
    }

  private slots:
    void initTestCase() {
        QVERIFY(m_folder.isValid());
        m_sound["PNG"] = saved("a.png", 3, SampleFormat::UInt8);
        m_sound["PNG, 16 bit gray"] = saved("b.png", 1, SampleFormat::UInt16);
        m_sound["JPEG"] = saved("a.jpg", 3, SampleFormat::UInt8);
        m_sound["TIFF"] = saved("a.tif", 3, SampleFormat::UInt8);
        m_sound["TIFF, tiles of floats"] = viaOiio(path("b.tif"), OIIO::TypeFloat, 4, tiled);
        m_sound["EXR"] = saved("a.exr", 3, SampleFormat::Half);
        m_sound["EXR, tiles, PIZ"] =
            viaOiio(path("b.exr"), OIIO::TypeFloat, 5, [](OIIO::ImageSpec& spec) {
                tiled(spec);
                spec.attribute("compression", "piz");
            });
        m_sound["HDR"] = saved("a.hdr", 3, SampleFormat::Float);
        m_sound["TGA"] = viaOiio(path("a.tga"), OIIO::TypeUInt8, 4, [](OIIO::ImageSpec& spec) {
            spec.attribute("compression", "rle");
        });
        m_sound["BMP"] = saved("a.bmp", 3, SampleFormat::UInt8);
        m_sound["WebP"] = saved("a.webp", 3, SampleFormat::UInt8);
        for (const auto& [name, bytes] : m_sound) {
            QVERIFY(writeFile(path("sound"), bytes));
            TXN_OK(loadImage(path("sound").toStdString()));
        }
    }

    void damagedFilesCostAMessage_data() {
        QTest::addColumn<QString>("kind");
        for (const auto& [name, bytes] : m_sound)
            QTest::newRow(qPrintable(name)) << name;
    }
    void damagedFilesCostAMessage() {
        QFETCH(QString, kind);
        std::mt19937 random(static_cast<unsigned>(qHash(kind, 1)));
        std::uniform_int_distribution<std::size_t> any(0, m_sound.size() - 1);
        const QString file = path("spoilt.png");
        for (int i = 0; i < kFiles; ++i) {
            const QByteArray& donor =
                std::next(m_sound.begin(), static_cast<long>(any(random)))->second;
            QVERIFY(writeFile(file, spoilt(m_sound[kind], donor, random)));
            const QString problem = judged(file);
            m_tally.count("damaged and hostile pictures: " + kind, problem);
            if (!problem.isEmpty())
                QFile::copy(file, QStringLiteral("hostile-%1-%2").arg(kind).arg(i)); // to look at
        }
        QCOMPARE(m_tally.bad(), 0);
    }

    void memoryStaysInItsBounds() {
        // Half a gigabyte for decoders, and the samples of the budget once decoded, once converted.
        [[maybe_unused]] constexpr qint64 kMost =
            (qint64{512} << 20) + 20 * static_cast<qint64>(kMostSamples);
        const qint64 own = peakBytes(QStringLiteral("self"));
        const qint64 decoders = peakBytesOfDecoders();
        // Harm of both kinds was done: some leaves a picture, some does not.
        QVERIFY(m_read > 100 && m_refused > 100);
        qInfo("%d files read, %d refused, slowest answer %lld ms, memory at most %.0f MB here, "
              "%.0f MB in a decoder",
              m_read,
              m_refused,
              m_slowestMs,
              static_cast<double>(own) / 1e6,
              static_cast<double>(decoders) / 1e6);
        QVERIFY(own > 0 && decoders > 0);
#ifndef TXN_SANITIZED
        QVERIFY(own <= kMost);
        QVERIFY(decoders <= kMost + (qint64{128} << 20)); // the program itself
#endif
    }

    void oddSizesAreRead_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::newRow("1 x 1") << 1 << 1;
        QTest::newRow("1 x 4096") << 1 << 4096;
        QTest::newRow("4096 x 1") << 4096 << 1;
        QTest::newRow("primes") << 127 << 61;
    }
    void oddSizesAreRead() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Image image = randomImage({width, height}, 3, 9);
        for (const char* ending : {"png", "jpg", "tif", "exr", "hdr", "tga", "bmp", "webp"}) {
            const QString file = path(QStringLiteral("odd.") + ending);
            TXN_OK(saveImage(image, file.toStdString()));
            const auto loaded = loadImage(file.toStdString());
            TXN_OK(loaded);
            QVERIFY(loaded->image.size() == image.size());
        }
    }

    void oddValuesArriveAsTheyAre() {
        using Limits = std::numeric_limits<float>;
        Image image({4, 2}, 1);
        const std::array values{Limits::quiet_NaN(),
                                Limits::infinity(),
                                -Limits::infinity(),
                                Limits::denorm_min(),
                                -1e-40F,
                                -3.5F,
                                Limits::max(),
                                -0.0F};
        std::ranges::copy(values, image.samples().begin());
        for (const char* ending : {"exr", "tif"}) {
            const QString file = path(QStringLiteral("values.") + ending);
            SaveOptions options;
            options.sampleFormat = SampleFormat::Float;
            TXN_OK(saveImage(image, file.toStdString(), options));
            const auto loaded = loadImage(file.toStdString());
            TXN_OK(loaded);
            for (std::size_t i = 0; i < values.size(); ++i) {
                const float sample = loaded->image.samples()[i];
                if (std::isnan(values[i]))
                    QVERIFY(std::isnan(sample));
                else
                    QVERIFY(std::bit_cast<std::uint32_t>(sample) ==
                            std::bit_cast<std::uint32_t>(values[i]));
            }
        }
    }

    void manyChannelsAreRead() {
        for (const int channels : {1, 2, 3, 5, 16, 33, 64}) {
            const QString file = path("channels.exr");
            viaOiio(file, OIIO::TypeHalf, channels, [](OIIO::ImageSpec& spec) {
                for (std::size_t c = 0; c < spec.channelnames.size(); ++c)
                    spec.channelnames[c] = "map" + std::to_string(c);
                spec.alpha_channel = -1;
            });
            const auto loaded = loadImage(file.toStdString());
            TXN_OK(loaded);
            QCOMPARE(loaded->image.channels(), channels);
        }
    }

    /// Read as a picture, or refused with a reason; never anything else.
    void rareKindsAreReadOrRefused() {
        viaOiio(path("cmyk.tif"), OIIO::TypeUInt8, 4, [](OIIO::ImageSpec& spec) {
            spec.channelnames = {"C", "M", "Y", "K"};
            spec.alpha_channel = -1;
            spec.attribute("tiff:PhotometricInterpretation", 5);
            spec.attribute("tiff:ColorSpace", "CMYK");
            spec.attribute("oiio:ColorSpace", "CMYK");
        });
        viaOiio(path("onebit.tif"), OIIO::TypeUInt8, 1, [](OIIO::ImageSpec& spec) {
            spec.attribute("oiio:BitsPerSample", 1);
        });
        viaOiio(path("zip.tif"), OIIO::TypeUInt16, 3, [](OIIO::ImageSpec& spec) {
            tiled(spec);
            spec.attribute("compression", "zip");
        });
        writeParts(path("parts.exr"));
        writeDeep(path("deep.exr"));
        for (const char* name : {"cmyk.tif", "onebit.tif", "zip.tif", "parts.exr", "deep.exr"})
            m_tally.count("rare kinds of pictures", judged(path(name)));
        QCOMPARE(m_tally.bad(), 0);
        // These are common enough to be read.
        for (const char* name : {"onebit.tif", "zip.tif", "parts.exr"})
            TXN_OK(loadImage(path(name).toStdString()));
    }

    void clearPixelsKeepNoFalseColor() {
        OIIO::ImageSpec spec(2, 1, 4, OIIO::TypeFloat);
        spec.alpha_channel = 3;
        written(path("clear.exr"), spec, {0.0F, 0.0F, 0.0F, 0.0F, 0.2F, 0.1F, 0.3F, 0.5F});
        const auto loaded = loadImage(path("clear.exr").toStdString());
        TXN_OK(loaded);
        QVERIFY(loaded->alpha);
        for (int c = 0; c < 3; ++c)
            QCOMPARE(loaded->image.at(0, 0, c), 0.0F);
        QVERIFY(std::abs(loaded->image.at(1, 0, 0) - 0.4F) <= 1e-6F);
    }

    void unlistedKindsAreRefused() {
        const std::map<QString, QByteArray> files{
            {"a.gif",
             QByteArray("GIF89a\1\0\1\0\x80\0\0\0\0\0\xff\xff\xff,\0\0\0\0\1\0\1\0\0\2\2D\1\0;",
                        35)},
            {"a.ppm", "P6\n1 1\n255\nabc"},
            {"a.svg", "<svg xmlns='http://www.w3.org/2000/svg'/>"},
            {"a.psd", QByteArray("8BPS\0\1\0\0\0\0\0\0\0\3\0\0\0\1\0\0\0\1\0\x8\0\3", 26)},
            {"a.png", "#!/bin/sh\necho harm\n"},
            {"a.tif", QByteArray("\0\0\0\0", 4)},
            {"empty.png", ""}};
        for (const auto& [name, bytes] : files) {
            QVERIFY(writeFile(path(name), bytes));
            TXN_FAILS_WITH(loadImage(path(name).toStdString()), ErrorCode::Unreadable);
            QCOMPARE(judged(path(name)), QString());
        }
    }

  private:
    static void writeParts(const QString& path) {
        std::vector<OIIO::ImageSpec> specs(2, OIIO::ImageSpec(8, 8, 3, OIIO::TypeHalf));
        specs[0].attribute("oiio:subimagename", "one");
        specs[1].attribute("oiio:subimagename", "two");
        const std::vector<float> samples(8 * 8 * 3, 0.5F);
        const auto output = OIIO::ImageOutput::create(path.toStdString());
        QVERIFY(output && output->open(path.toStdString(), 2, specs.data()));
        QVERIFY(output->write_image(OIIO::TypeFloat, samples.data()));
        QVERIFY(output->open(path.toStdString(), specs[1], OIIO::ImageOutput::AppendSubimage));
        QVERIFY(output->write_image(OIIO::TypeFloat, samples.data()) && output->close());
    }
    static void writeDeep(const QString& path) {
        OIIO::ImageSpec spec(4, 4, 5, OIIO::TypeFloat);
        spec.channelnames = {"R", "G", "B", "A", "Z"};
        spec.alpha_channel = 3;
        spec.z_channel = 4;
        spec.deep = true;
        OIIO::DeepData deep(spec);
        for (int p = 0; p < 16; ++p)
            deep.set_samples(p, p % 3);
        const auto output = OIIO::ImageOutput::create(path.toStdString());
        QVERIFY(output && output->open(path.toStdString(), spec));
        QVERIFY(output->write_deep_image(deep) && output->close());
    }
};

QTEST_APPLESS_MAIN(TestHostileImages)
#include "TestHostileImages.moc"
