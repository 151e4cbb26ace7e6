// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/ColorTransfer.h"
#include "core/image/ImageGeometry.h"
#include "core/image/ImageIo.h"
#include "core/image/TextLabel.h"

#include <lcms2.h>

#include <QByteArray>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>
#include <numbers>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

using namespace txn;
namespace fs = std::filesystem;

namespace {

// Bytes

QByteArray readFile(const fs::path& path) {
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writeFile(const fs::path& path, const QByteArray& bytes) {
    QFile file(QString::fromStdString(path.string()));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

QByteArray little(std::uint64_t value, int bytes) {
    QByteArray result;
    for (int i = 0; i < bytes; ++i)
        result += static_cast<char>(value >> (8 * i));
    return result;
}

QByteArray big(std::uint64_t value, int bytes) {
    QByteArray result = little(value, bytes);
    std::reverse(result.begin(), result.end());
    return result;
}

QByteArray bytesOf(float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return little(bits, 4);
}

// PNG

QByteArray pngChunk(const char* type, const QByteArray& data) {
    const QByteArray body = type + data;
    std::uint32_t crc = 0xffffffffU;
    for (const char c : body) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
    }
    return big(static_cast<std::uint64_t>(data.size()), 4) + body + big(~crc & 0xffffffffU, 4);
}

QByteArray zlib(const QByteArray& data) {
    return qCompress(data).mid(4); // behind Qt's own length
}

/// rows: each with its filter byte, as in the file.
QByteArray png(std::uint64_t width,
               std::uint64_t height,
               int depth,
               int colorType,
               const QByteArray& rows,
               const QByteArray& extraChunks = {}) {
    const QByteArray header = big(width, 4) + big(height, 4) + static_cast<char>(depth) +
                              static_cast<char>(colorType) + QByteArray(3, '\0');
    return QByteArray("\x89PNG\r\n\x1a\n", 8) + pngChunk("IHDR", header) + extraChunks +
           pngChunk("IDAT", zlib(rows)) + pngChunk("IEND", {});
}

QByteArray iccChunk(const QByteArray& profile) {
    return pngChunk("iCCP", QByteArray("p\0\0", 3) + zlib(profile));
}

// EXR, uncompressed floats

struct ExrParts {
    int x = 0;
    int y = 0;
    int width = 2;
    int height = 2;
    QByteArray channels = "BGR"; ///< one letter each, in alphabetical order
    int flags = 0;
    QByteArray attributes;
    int promisedHeight = 0; ///< 0: height
};

QByteArray exrAttribute(const char* name, const char* type, const QByteArray& value) {
    return QByteArray(name) + '\0' + type + '\0' +
           little(static_cast<std::uint64_t>(value.size()), 4) + value;
}

/// Channel c of the sample at column i and row j is 100 c + 10 j + i + 1.
QByteArray exr(const ExrParts& parts) {
    QByteArray channels;
    for (const char name : parts.channels)
        channels +=
            QByteArray(1, name) + '\0' + little(2, 4) + little(0, 4) + little(1, 4) + little(1, 4);
    channels += '\0';
    const auto corner = [](int value) { return little(static_cast<std::uint32_t>(value), 4); };
    const int height = parts.promisedHeight > 0 ? parts.promisedHeight : parts.height;
    const QByteArray window = corner(parts.x) + corner(parts.y) +
                              corner(parts.x + parts.width - 1) + corner(parts.y + height - 1);
    const QByteArray display = corner(0) + corner(0) + corner(63) + corner(63);
    QByteArray file =
        QByteArray("\x76\x2f\x31\x01", 4) + little(2U | static_cast<unsigned>(parts.flags), 4) +
        exrAttribute("channels", "chlist", channels) +
        exrAttribute("compression", "compression", QByteArray(1, '\0')) +
        exrAttribute("dataWindow", "box2i", window) +
        exrAttribute("displayWindow", "box2i", display) +
        exrAttribute("lineOrder", "lineOrder", QByteArray(1, '\0')) +
        exrAttribute("pixelAspectRatio", "float", bytesOf(1.0F)) +
        exrAttribute("screenWindowCenter", "v2f", bytesOf(0) + bytesOf(0)) +
        exrAttribute("screenWindowWidth", "float", bytesOf(1.0F)) + parts.attributes + '\0';
    const auto rowBytes = static_cast<std::uint64_t>(parts.channels.size()) *
                          static_cast<std::uint64_t>(parts.width) * 4;
    const auto firstChunk =
        static_cast<std::uint64_t>(file.size()) + 8 * static_cast<std::uint64_t>(parts.height);
    for (int row = 0; row < parts.height; ++row)
        file += little(firstChunk + static_cast<std::uint64_t>(row) * (8 + rowBytes), 8);
    for (int row = 0; row < parts.height; ++row) {
        file += corner(parts.y + row) + little(rowBytes, 4);
        for (int c = 0; c < parts.channels.size(); ++c) {
            for (int i = 0; i < parts.width; ++i)
                file += bytesOf(static_cast<float>(100 * c + 10 * row + i + 1));
        }
    }
    return file;
}

// Other types

QByteArray tga(int type, int width, int height, int bits, const QByteArray& data, int paletteSize) {
    return QByteArray(1, '\0') + static_cast<char>(paletteSize > 0) + static_cast<char>(type) +
           little(0, 2) + little(static_cast<std::uint64_t>(paletteSize), 2) +
           static_cast<char>(paletteSize > 0 ? 24 : 0) + little(0, 4) +
           little(static_cast<std::uint64_t>(width), 2) +
           little(static_cast<std::uint64_t>(height), 2) + static_cast<char>(bits) + '\x20' + data;
}

QByteArray bmp(std::int64_t width,
               std::int64_t height,
               int bits,
               int compression,
               const QByteArray& paletteAndData) {
    return "BM" + little(0, 8) + little(static_cast<std::uint64_t>(bits <= 8 ? 54 + 1024 : 54), 4) +
           little(40, 4) + little(static_cast<std::uint64_t>(width), 4) +
           little(static_cast<std::uint64_t>(height), 4) + little(1, 2) +
           little(static_cast<std::uint64_t>(bits), 2) +
           little(static_cast<std::uint64_t>(compression), 4) + QByteArray(20, '\0') +
           paletteAndData;
}

QByteArray grayPalette() {
    QByteArray palette;
    for (int i = 0; i < 256; ++i)
        palette += QByteArray(3, static_cast<char>(i)) + '\0';
    return palette;
}

QByteArray riff(const QByteArray& chunks) {
    return "RIFF" + little(static_cast<std::uint64_t>(chunks.size() + 4), 4) + "WEBP" + chunks;
}

QByteArray webpChunk(const char* type, const QByteArray& data) {
    return type + little(static_cast<std::uint64_t>(data.size()), 4) + data +
           QByteArray(data.size() % 2, '\0');
}

/// An EXIF block that says nothing but the orientation.
QByteArray exif(int orientation) {
    return QByteArray("MM\0*\0\0\0\x08", 8) + big(1, 2) + big(0x112, 2) + big(3, 2) + big(1, 4) +
           big(static_cast<std::uint64_t>(orientation), 2) + big(0, 2) + big(0, 4);
}

/// Baseline or progressive, with tables that decode zeros.
QByteArray jpegHeader(int width, int height, int frame) {
    QByteArray file = QByteArray("\xff\xd8\xff\xdb", 4) + big(67, 2) + '\0' + QByteArray(64, '\1') +
                      '\xff' + static_cast<char>(frame) + big(11, 2) + '\x08' +
                      big(static_cast<std::uint64_t>(height), 2) +
                      big(static_cast<std::uint64_t>(width), 2) + QByteArray("\1\1\x11\0", 4);
    for (const char table : {'\0', '\x10'})
        file += QByteArray("\xff\xc4", 2) + big(20, 2) + table + '\1' + QByteArray(15, '\0') + '\0';
    return file + QByteArray("\xff\xda\0\x08\1\1\0\0\x3f\0", 10) + QByteArray(20, '\0') +
           QByteArray("\xff\xd9", 2);
}

QByteArray tiff(std::uint64_t width, std::uint64_t height, int compression) {
    const std::vector<std::array<std::uint64_t, 3>> tags{
        {256, 4, width},
        {257, 4, height},
        {258, 3, 8},
        {259, 3, static_cast<std::uint64_t>(compression)},
        {262, 3, 1},
        {273, 4, 8},
        {277, 3, 1},
        {278, 4, height},
        {279, 4, 64}};
    QByteArray file =
        QByteArray("II*\0", 4) + little(72, 4) + QByteArray(64, '\0') + little(tags.size(), 2);
    for (const auto& [tag, type, value] : tags)
        file += little(tag, 2) + little(type, 2) + little(1, 4) + little(value, 4);
    return file + little(0, 4);
}

// Images

/// Smooth, so that lossy types come close, and different in every channel, row and column.
Image waves(Size size, int channels, Transfer transfer = Transfer::Encoded) {
    Image image(size, channels, 0.0F, transfer);
    for (int c = 0; c < channels; ++c) {
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x)
                image.at(x, y, c) =
                    0.5F + 0.3F * std::sin(0.07F * static_cast<float>(x + 5 * c)) +
                    0.15F * std::cos(0.09F * static_cast<float>(y) + static_cast<float>(c));
        }
    }
    return image;
}

float largestDifference(const Image& a, const Image& b) {
    if (a.size() != b.size() || a.channels() != b.channels())
        return std::numeric_limits<float>::infinity();
    float largest = 0.0F;
    for (std::size_t i = 0; i < a.samples().size(); ++i) {
        const float difference = std::abs(a.samples()[i] - b.samples()[i]);
        if (!(difference <= largest))
            largest = difference;
    }
    return largest;
}

double deviationOf(std::span<const float> values) {
    double sum = 0.0;
    double squares = 0.0;
    for (const float v : values) {
        sum += v;
        squares += static_cast<double>(v) * v;
    }
    const auto count = static_cast<double>(values.size());
    return std::sqrt(squares / count - sum / count * (sum / count));
}

// Profiles

QByteArray serialized(cmsHPROFILE profile) {
    cmsUInt32Number length = 0;
    cmsSaveProfileToMem(profile, nullptr, &length);
    QByteArray bytes(static_cast<qsizetype>(length), '\0');
    cmsSaveProfileToMem(profile, bytes.data(), &length);
    cmsCloseProfile(profile);
    return bytes;
}

QByteArray linearRgbProfile() {
    const cmsCIExyY white{0.3127, 0.3290, 1.0};
    const cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}};
    cmsToneCurve* curve = cmsBuildGamma(nullptr, 1.0);
    cmsToneCurve* const curves[3] = {curve, curve, curve};
    const cmsHPROFILE profile = cmsCreateRGBProfile(&white, &primaries, curves);
    cmsFreeToneCurve(curve);
    return serialized(profile);
}

QByteArray linearGrayProfile() {
    cmsToneCurve* curve = cmsBuildGamma(nullptr, 1.0);
    const cmsHPROFILE profile = cmsCreateGrayProfile(cmsD50_xyY(), curve);
    cmsFreeToneCurve(curve);
    return serialized(profile);
}

// Messages

bool oneFriendlyLine(const Error& error) {
    return !error.message.empty() && error.message.find('\n') == std::string::npos &&
           error.message.find('\'') != std::string::npos && error.message.size() < 600;
}

std::string endingOf(const QString& name) {
    return name.toStdString();
}

const std::vector<std::pair<const char*, int>> kTypes{{"png", 3},
                                                      {"jpg", 3},
                                                      {"tif", 3},
                                                      {"exr", 3},
                                                      {"hdr", 3},
                                                      {"tga", 3},
                                                      {"bmp", 3},
                                                      {"webp", 3}};

} // namespace

Q_DECLARE_METATYPE(txn::ImageFormat)
Q_DECLARE_METATYPE(txn::SampleFormat)
Q_DECLARE_METATYPE(txn::ErrorCode)

class TestImageIo : public QObject {
    Q_OBJECT

  private slots:
    void init();

    void formatByEnding_data();
    void formatByEnding();
    void filesMayAppearTogether();
    void hdrClampsNegatives();
    void roundTrip_data();
    void roundTrip();
    void valuesBeyondOneSurvive_data();
    void valuesBeyondOneSurvive();
    void integersClampAndCount();
    void linearIsEncodedInIntegers();
    void halfDoesNotOverflow();
    void refusedLayouts_data();
    void refusedLayouts();
    void channelNames();
    void refusedChannelNames_data();
    void refusedChannelNames();
    void attributesSurvive_data();
    void attributesSurvive();
    void equalImagesGiveEqualFiles_data();
    void equalImagesGiveEqualFiles();

    void contentDecidesNotTheName();
    void pngPalette();
    void pngFewBits();
    void pngSixteenBits();
    void pngAlphaIsKeptApart();
    void largeConstantPng();
    void orientation_data();
    void orientation();
    void exrDataWindow_data();
    void exrDataWindow();
    void exrAlphaIsDivided();
    void exrTransferNote();
    void webpAlphaAndProfile();
    void bmpVariants();
    void tgaPalette();

    void iccProfiles_data();
    void iccProfiles();
    void iccGrayProfile();
    void exemplars();

    void unreadablePaths();
    void truncated_data();
    void truncated();
    void damagedChecksum();
    void trailingBytesAreHarmless_data();
    void trailingBytesAreHarmless();
    void hostileHeaders_data();
    void hostileHeaders();
    void sampleLimit();
    void threadsMayLoadAndSave();

    void bandsEqualWhole_data();
    void bandsEqualWhole();
    void writerRefusals();
    void abandonedWriterLeavesNothing();
    void existingFilesAndLinks();
    void unwritablePaths();
    void fullDisk_data();
    void fullDisk();

    void crops();
    void quarterTurns();
    void otherTurns_data();
    void otherTurns();
    void refusedTurns();
    void uprightUndoesOrientations();
    void transferCurve();
    void textIsDrawn();

  private:
    fs::path path(const std::string& name) const { return m_path / name; }
    int entries() const;
    Image loadPng(const QByteArray& bytes);

    std::unique_ptr<QTemporaryDir> m_dir;
    fs::path m_path;
};

void TestImageIo::init() {
    m_dir = std::make_unique<QTemporaryDir>();
    QVERIFY(m_dir->isValid());
    m_path = m_dir->path().toStdString();
}

int TestImageIo::entries() const {
    int count = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(m_path))
        ++count;
    return count;
}

/// Empty, with a warning, where it does not load.
Image TestImageIo::loadPng(const QByteArray& bytes) {
    writeFile(path("x.png"), bytes);
    auto loaded = loadImage(path("x.png"));
    if (!loaded) {
        qWarning("%s", loaded.error().message.c_str());
        return {};
    }
    return std::move(loaded->image);
}

// Writing and reading back

void TestImageIo::formatByEnding_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("format"); // -1: refused
    const auto row = [](const char* name, ImageFormat format) {
        QTest::newRow(name) << name << static_cast<int>(format);
    };
    row("a.png", ImageFormat::Png);
    row("a.b.JPG", ImageFormat::Jpeg);
    row("a.jpeg", ImageFormat::Jpeg);
    row("a.TiF", ImageFormat::Tiff);
    row("a.tiff", ImageFormat::Tiff);
    row("a.exr", ImageFormat::OpenExr);
    row("a.hdr", ImageFormat::Hdr);
    row("a.tga", ImageFormat::Tga);
    row("a.bmp", ImageFormat::Bmp);
    row("a.webp", ImageFormat::WebP);
    for (const char* name : {"a", "a.gif", "png", ".png", "a.png/b", "a.", ""})
        QTest::newRow(qPrintable(QString("refused ") + name)) << name << -1;
}

void TestImageIo::formatByEnding() {
    QFETCH(QString, name);
    QFETCH(int, format);
    const auto result = imageFormatForPath(name.toStdString());
    if (format >= 0) {
        QVERIFY(bool(result));
        QCOMPARE(static_cast<int>(*result), format);
    } else {
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::Unsupported);
        QVERIFY(result.error().message.find(".webp") != std::string::npos);
    }
}

void TestImageIo::hdrClampsNegatives() {
    Image image({16, 8}, 3, 0.5F, Transfer::Linear);
    image.at(3, 2, 0) = -0.25F;
    image.at(4, 2, 1) = std::numeric_limits<float>::quiet_NaN();
    auto writer =
        ImageWriter::open(path("x.hdr"),
                          {.size = image.size(), .channels = 3, .transfer = Transfer::Linear});
    QVERIFY(bool(writer));
    QVERIFY(bool(writer->writeRows(image)));
    QCOMPARE(writer->clippedSamples(), 2U);
    QVERIFY(bool(writer->finish()));
    const auto loaded = loadImage(path("x.hdr"));
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->image.at(3, 2, 0), 0.0F);
    QCOMPARE(loaded->image.at(4, 2, 1), 0.0F);
}

void TestImageIo::filesMayAppearTogether() {
    OutputFiles together;
    QVERIFY(bool(saveImage(waves({8, 8}, 3), path("a.exr"), {}, &together)));
    QVERIFY(bool(saveImage(waves({8, 8}, 3), path("b.png"), {}, &together)));
    QVERIFY(!loadImage(path("a.exr")));
    QVERIFY(bool(together.commit()));
    QVERIFY(bool(loadImage(path("a.exr"))));
    QVERIFY(bool(loadImage(path("b.png"))));
}

void TestImageIo::roundTrip_data() {
    QTest::addColumn<QString>("ending");
    QTest::addColumn<ImageFormat>("format");
    QTest::addColumn<int>("channels");
    QTest::addColumn<int>("samples"); // -1: the default
    QTest::addColumn<SampleFormat>("stored");
    QTest::addColumn<float>("tolerance");
    const auto row = [](const char* ending,
                        ImageFormat format,
                        int channels,
                        int samples,
                        SampleFormat stored,
                        float tolerance) {
        QTest::addRow("%s %d channels, samples %d", ending, channels, samples)
            << ending << format << channels << samples << stored << tolerance;
    };
    constexpr float kHalfOf8 = 0.5F / 255.0F + 1e-6F;
    constexpr float kHalfOf16 = 0.5F / 65535.0F + 1e-6F;
    constexpr float kHalfFloat = 0x1p-12F; // half an ulp below 1
    constexpr float kRgbe = 1.0F / 256.0F; // a shared exponent and 8 bits
    for (const int channels : {1, 3}) {
        row("png", ImageFormat::Png, channels, -1, SampleFormat::UInt8, kHalfOf8);
        row("png", ImageFormat::Png, channels, 1, SampleFormat::UInt16, kHalfOf16);
        row("tga", ImageFormat::Tga, channels, -1, SampleFormat::UInt8, kHalfOf8);
        row("bmp", ImageFormat::Bmp, channels, -1, SampleFormat::UInt8, kHalfOf8);
        // Quality 95 of a smooth image: a few levels.
        row("jpg", ImageFormat::Jpeg, channels, -1, SampleFormat::UInt8, 0.02F);
    }
    for (const int channels : {1, 2, 3, 4, 5, 12, 64}) {
        row("tif", ImageFormat::Tiff, channels, -1, SampleFormat::UInt8, kHalfOf8);
        row("tif", ImageFormat::Tiff, channels, 1, SampleFormat::UInt16, kHalfOf16);
        row("tif", ImageFormat::Tiff, channels, 3, SampleFormat::Float, 0.0F);
        row("exr", ImageFormat::OpenExr, channels, -1, SampleFormat::Half, kHalfFloat);
        row("exr", ImageFormat::OpenExr, channels, 3, SampleFormat::Float, 0.0F);
    }
    row("hdr", ImageFormat::Hdr, 3, -1, SampleFormat::Float, kRgbe);
    // Chroma at half the resolution and a narrow range.
    row("webp", ImageFormat::WebP, 3, -1, SampleFormat::UInt8, 0.03F);
}

void TestImageIo::roundTrip() {
    QFETCH(QString, ending);
    QFETCH(ImageFormat, format);
    QFETCH(int, channels);
    QFETCH(int, samples);
    QFETCH(SampleFormat, stored);
    QFETCH(float, tolerance);
    const Image image = waves({61, 83}, channels);
    SaveOptions options;
    if (samples >= 0)
        options.sampleFormat = static_cast<SampleFormat>(samples);
    const fs::path file = path("image." + endingOf(ending));
    const auto saved = saveImage(image, file, options);
    QVERIFY2(bool(saved), saved.error().message.c_str());
    const auto loaded = loadImage(file);
    QVERIFY2(bool(loaded), loaded ? "" : loaded.error().message.c_str());
    QCOMPARE(loaded->format, format);
    QCOMPARE(loaded->sampleFormat, stored);
    QCOMPARE(loaded->image.size(), image.size());
    QCOMPARE(loaded->image.channels(), channels);
    QVERIFY(!loaded->alpha);
    QVERIFY(!loaded->iccConverted);
    QCOMPARE(loaded->image.transfer(), Transfer::Encoded);
    QCOMPARE(loaded->channelNames.size(), static_cast<std::size_t>(channels));
    const float difference = largestDifference(loaded->image, image);
    QVERIFY2(difference <= tolerance, qPrintable(QString::number(difference)));
    QCOMPARE(entries(), 1);
}

void TestImageIo::valuesBeyondOneSurvive_data() {
    QTest::addColumn<QString>("ending");
    QTest::addColumn<bool>("linear");
    for (const char* ending : {"exr", "tif", "hdr"}) {
        for (const bool linear : {false, true})
            QTest::addRow("%s %s", ending, linear ? "linear" : "encoded") << ending << linear;
    }
}

void TestImageIo::valuesBeyondOneSurvive() {
    QFETCH(QString, ending);
    QFETCH(bool, linear);
    Image image({16, 16}, 3, 0.25F, linear ? Transfer::Linear : Transfer::Encoded);
    const bool negatives = ending != "hdr"; // which cannot hold them
    for (int c = 0; c < 3; ++c) {
        image.at(0, 0, c) = 40.0F;
        image.at(1, 0, c) = negatives ? -3.0F : 3.0F;
    }
    if (negatives)
        image.at(2, 0, 1) = std::numeric_limits<float>::quiet_NaN();
    SaveOptions options;
    options.sampleFormat = SampleFormat::Float;
    const fs::path file = path("x." + endingOf(ending));
    auto writer =
        ImageWriter::open(file,
                          {.size = image.size(), .channels = 3, .transfer = image.transfer()},
                          options);
    QVERIFY(bool(writer));
    QCOMPARE(writer->clips(), !negatives);
    QVERIFY(bool(writer->writeRows(image)));
    QCOMPARE(writer->clippedSamples(), 0U);
    QVERIFY(bool(writer->finish()));
    auto loaded = loadImage(file);
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->image.transfer(), image.transfer());
    if (negatives) {
        QVERIFY(std::isnan(loaded->image.at(2, 0, 1)));
        loaded->image.at(2, 0, 1) = image.at(2, 0, 1) = 0.0F;
    }
    QCOMPARE(largestDifference(loaded->image, image), 0.0F);
}

void TestImageIo::integersClampAndCount() {
    Image image({4, 2}, 1);
    const float values[8] = {-0.25F,
                             1.5F,
                             0.0F,
                             1.0F,
                             std::nanf(""),
                             0.5F,
                             std::numeric_limits<float>::infinity(),
                             -std::numeric_limits<float>::infinity()};
    std::copy(std::begin(values), std::end(values), image.samples().begin());
    auto writer = ImageWriter::open(path("x.png"), {.size = image.size(), .channels = 1});
    QVERIFY(bool(writer));
    QVERIFY(writer->clips());
    QVERIFY(bool(writer->writeRows(image)));
    QCOMPARE(writer->clippedSamples(), 5U);
    QVERIFY(bool(writer->finish()));
    QCOMPARE(writer->clippedSamples(), 5U);
    const auto loaded = loadImage(path("x.png"));
    QVERIFY(bool(loaded));
    const float expected[8] = {0.0F, 1.0F, 0.0F, 1.0F, 0.0F, 128.0F / 255.0F, 1.0F, 0.0F};
    for (std::size_t i = 0; i < 8; ++i)
        QCOMPARE(loaded->image.samples()[i], expected[i]);
}

void TestImageIo::linearIsEncodedInIntegers() {
    const Image image = waves({31, 17}, 3, Transfer::Linear);
    SaveOptions options;
    options.sampleFormat = SampleFormat::UInt16;
    QVERIFY(bool(saveImage(image, path("x.png"), options)));
    const auto loaded = loadImage(path("x.png"));
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->image.transfer(), Transfer::Encoded);
    QVERIFY(largestDifference(loaded->image, toEncoded(image)) <= 0.5F / 65535.0F + 1e-6F);
}

void TestImageIo::halfDoesNotOverflow() {
    Image image({8, 8}, 3, 1e6F);
    image.at(0, 0, 0) = -1e6F;
    QVERIFY(bool(saveImage(image, path("x.exr"))));
    const auto loaded = loadImage(path("x.exr"));
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->image.at(0, 0, 0), -65504.0F);
    QCOMPARE(loaded->image.at(1, 0, 0), 65504.0F);
}

void TestImageIo::refusedLayouts_data() {
    QTest::addColumn<QString>("ending");
    QTest::addColumn<int>("channels");
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("samples");
    QTest::addColumn<QString>("says");
    QTest::newRow("PNG 2") << "png" << 2 << 8 << -1 << "use EXR or TIFF for 2";
    QTest::newRow("PNG 4") << "png" << 4 << 8 << -1 << "use EXR or TIFF for 4";
    QTest::newRow("PNG float") << "png" << 3 << 8 << 3 << "use EXR or TIFF for float";
    QTest::newRow("PNG half") << "png" << 3 << 8 << 2 << "use EXR for half";
    QTest::newRow("JPEG 5") << "jpg" << 5 << 8 << -1 << "use EXR or TIFF for 5";
    QTest::newRow("JPEG 16") << "jpg" << 3 << 8 << 1 << "use PNG or TIFF for 16-bit";
    QTest::newRow("JPEG wide") << "jpg" << 1 << 65501 << -1 << "65500";
    QTest::newRow("HDR 1") << "hdr" << 1 << 8 << -1 << "use PNG, EXR or TIFF for 1";
    QTest::newRow("HDR 8") << "hdr" << 3 << 8 << 0 << "use PNG or TIFF for 8-bit";
    QTest::newRow("TGA 4") << "tga" << 4 << 8 << -1 << "use EXR or TIFF for 4";
    QTest::newRow("TGA wide") << "tga" << 1 << 65536 << -1 << "65535";
    QTest::newRow("BMP 4") << "bmp" << 4 << 8 << -1 << "use EXR or TIFF for 4";
    QTest::newRow("WebP 1") << "webp" << 1 << 8 << -1 << "use PNG, EXR or TIFF for 1";
    QTest::newRow("WebP wide") << "webp" << 3 << 16384 << -1 << "16383";
    QTest::newRow("TIFF half") << "tif" << 3 << 8 << 2 << "use EXR for half";
    QTest::newRow("EXR 65") << "exr" << 65 << 8 << -1 << "64";
    QTest::newRow("EXR 8") << "exr" << 3 << 8 << 0 << "use PNG or TIFF for 8-bit";
    QTest::newRow("unknown ending") << "gif" << 3 << 8 << -1 << ".png";
}

void TestImageIo::refusedLayouts() {
    QFETCH(QString, ending);
    QFETCH(int, channels);
    QFETCH(int, width);
    QFETCH(int, samples);
    QFETCH(QString, says);
    SaveOptions options;
    if (samples >= 0)
        options.sampleFormat = static_cast<SampleFormat>(samples);
    const auto saved =
        saveImage(Image({width, 1}, channels), path("x." + endingOf(ending)), options);
    QVERIFY(!saved);
    QCOMPARE(saved.error().code, ErrorCode::Unsupported);
    QVERIFY(oneFriendlyLine(saved.error()));
    QVERIFY2(QString::fromStdString(saved.error().message).contains(says),
             saved.error().message.c_str());
    QCOMPARE(entries(), 0);
}

void TestImageIo::channelNames() {
    const auto namesOf = [&](int channels, const std::vector<std::string>& given) {
        SaveOptions options;
        options.channelNames = given;
        const auto saved = saveImage(waves({8, 8}, channels), path("x.exr"), options);
        if (!saved)
            return std::vector<std::string>{saved.error().message};
        const auto loaded = loadImage(path("x.exr"));
        return loaded ? loaded->channelNames : std::vector<std::string>{loaded.error().message};
    };
    using Names = std::vector<std::string>;
    QCOMPARE(namesOf(1, {}), Names({"Y"}));
    QCOMPARE(namesOf(2, {}), Names({"0", "1"}));
    QCOMPARE(namesOf(3, {}), Names({"R", "G", "B"}));
    QCOMPARE(namesOf(4, {}), Names({"0", "1", "2", "3"}));
    const Names many = namesOf(11, {});
    QCOMPARE(many.front(), std::string("00"));
    QCOMPARE(many.back(), std::string("10"));
    QCOMPARE(namesOf(3, {"height", "normal.X", "normal.Y"}),
             Names({"height", "normal.X", "normal.Y"}));
}

void TestImageIo::refusedChannelNames_data() {
    QTest::addColumn<QStringList>("names");
    QTest::newRow("too few") << QStringList{"R", "G"};
    QTest::newRow("twice") << QStringList{"R", "G", "R"};
    QTest::newRow("empty") << QStringList{"R", "G", ""};
    QTest::newRow("alpha") << QStringList{"R", "G", "layer.A"};
    QTest::newRow("Alpha") << QStringList{"R", "G", "Alpha"};
}

void TestImageIo::refusedChannelNames() {
    QFETCH(QStringList, names);
    SaveOptions options;
    for (const QString& name : names)
        options.channelNames.push_back(name.toStdString());
    const auto saved = saveImage(Image({4, 4}, 3), path("x.exr"), options);
    QVERIFY(!saved);
    QCOMPARE(saved.error().code, ErrorCode::InvalidArgument);
    QVERIFY(oneFriendlyLine(saved.error()));
    QCOMPARE(entries(), 0);
}

void TestImageIo::attributesSurvive_data() {
    QTest::addColumn<QString>("ending");
    for (const char* ending : {"exr", "tif", "png"})
        QTest::newRow(ending) << ending;
}

void TestImageIo::attributesSurvive() {
    QFETCH(QString, ending);
    SaveOptions options;
    options.attributes["texton:seed"] = "42";
    options.attributes["texton:note"] = "two\nlines, a \\ and a = sign";
    options.attributes["bare"] = "x";
    const fs::path file = path("x." + endingOf(ending));
    QVERIFY(bool(saveImage(waves({9, 9}, 3), file, options)));
    auto loaded = loadImage(file);
    QVERIFY(bool(loaded));
    loaded->attributes.erase("texton:transfer");
    const ImageAttributes expected{{"texton:seed", "42"},
                                   {"texton:note", options.attributes["texton:note"]},
                                   {"texton:bare", "x"}};
    QCOMPARE(loaded->attributes, expected);
}

void TestImageIo::equalImagesGiveEqualFiles_data() {
    QTest::addColumn<QString>("ending");
    for (const auto& [ending, channels] : kTypes)
        QTest::newRow(ending) << ending;
}

void TestImageIo::equalImagesGiveEqualFiles() {
    QFETCH(QString, ending);
    const Image image = waves({37, 70}, 3);
    QVERIFY(bool(saveImage(image, path("a." + endingOf(ending)))));
    const QByteArray bytes = readFile(path("a." + endingOf(ending)));
    // A date would be in one of these forms.
    const auto today = QDateTime::currentDateTime();
    QVERIFY(!bytes.contains(today.toString("yyyy:MM:dd").toLatin1()));
    QVERIFY(!bytes.contains(today.toString("yyyy-MM-dd").toLatin1()));
    QVERIFY(bool(saveImage(image, path("b." + endingOf(ending)))));
    QCOMPARE(readFile(path("b." + endingOf(ending))), bytes);
}

// Reading what others write

void TestImageIo::contentDecidesNotTheName() {
    const Image image = waves({20, 20}, 3);
    for (const auto& [ending, channels] : kTypes) {
        if (std::string_view(ending) == "tga")
            continue; // by its footer, below
        QVERIFY(bool(saveImage(image, path(std::string("x.") + ending))));
        fs::rename(path(std::string("x.") + ending), path("wrong.bin"));
        const auto loaded = loadImage(path("wrong.bin"));
        QVERIFY2(bool(loaded), ending);
        QCOMPARE(loaded->format, *imageFormatForPath(std::string("x.") + ending));
    }
    QVERIFY(bool(saveImage(image, path("x.tga"))));
    fs::rename(path("x.tga"), path("wrong.png"));
    const auto loaded = loadImage(path("wrong.png"));
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->format, ImageFormat::Tga);
}

void TestImageIo::pngPalette() {
    // Twelve greys, as RGB entries: three channels, since a palette holds colors.
    QByteArray palette;
    for (int i = 0; i < 12; ++i)
        palette += QByteArray(3, static_cast<char>(20 * i));
    QByteArray rows;
    for (int y = 0; y < 2; ++y) {
        rows += '\0';
        for (int x = 0; x < 12; x += 2)
            rows += static_cast<char>(16 * x + x + 1); // 4 bits each
    }
    const Image image = loadPng(png(12, 2, 4, 3, rows, pngChunk("PLTE", palette)));
    QCOMPARE(image.size(), (Size{12, 2}));
    QCOMPARE(image.channels(), 3);
    for (int x = 0; x < 12; ++x) {
        for (int c = 0; c < 3; ++c)
            QCOMPARE(image.at(x, 1, c), static_cast<float>(20 * x) / 255.0F);
    }
}

void TestImageIo::pngFewBits() {
    const Image image = loadPng(png(8, 1, 1, 0, QByteArray("\0\xa5", 2)));
    QCOMPARE(image.channels(), 1);
    for (int x = 0; x < 8; ++x)
        QCOMPARE(image.at(x, 0, 0), ((0xa5 >> (7 - x)) & 1) != 0 ? 1.0F : 0.0F);
}

void TestImageIo::pngSixteenBits() {
    QByteArray row(1, '\0');
    for (int x = 0; x < 300; ++x)
        row += big(static_cast<std::uint64_t>(30000 + x), 2);
    writeFile(path("x.png"), png(300, 1, 16, 0, row));
    const auto loaded = loadImage(path("x.png"));
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->sampleFormat, SampleFormat::UInt16);
    for (int x = 0; x < 300; ++x)
        QVERIFY(std::abs(loaded->image.at(x, 0, 0) - static_cast<float>(30000 + x) / 65535.0F) <=
                1e-7F);
}

void TestImageIo::pngAlphaIsKeptApart() {
    const auto check = [&](const QByteArray& bytes, int channels, bool names) {
        writeFile(path("x.png"), bytes);
        const auto loaded = loadImage(path("x.png"));
        QVERIFY(bool(loaded));
        QCOMPARE(loaded->image.channels(), channels);
        QVERIFY(loaded->alpha.has_value());
        QCOMPARE(loaded->alpha->channels(), 1);
        // The color of a transparent pixel is what the file says.
        QCOMPARE(loaded->image.at(0, 0, 0), 200.0F / 255.0F);
        QCOMPARE(loaded->image.at(1, 0, 0), 100.0F / 255.0F);
        QCOMPARE(loaded->alpha->at(0, 0, 0), 0.0F);
        QCOMPARE(loaded->alpha->at(1, 0, 0), names ? 51.0F / 255.0F : 1.0F);
        QCOMPARE(loaded->channelNames.size(), static_cast<std::size_t>(channels));
    };
    check(png(2, 1, 8, 4, QByteArray("\0\xc8\0\x64\x33", 5)), 1, true);
    check(png(2, 1, 8, 6, QByteArray("\0\xc8\1\2\0\x64\5\6\x33", 9)), 3, true);
    // Gray 200 is declared transparent.
    check(png(2, 1, 8, 0, QByteArray("\0\xc8\x64", 3), pngChunk("tRNS", big(200, 2))), 1, false);
}

void TestImageIo::largeConstantPng() {
    // Compresses a thousand times: no check of sizes may refuse it.
    QVERIFY(bool(saveImage(Image({4096, 4096}, 1, 0.5F), path("x.png"))));
    QVERIFY(fs::file_size(path("x.png")) < 40000);
    const auto loaded = loadImage(path("x.png"));
    QVERIFY2(bool(loaded), loaded ? "" : loaded.error().message.c_str());
    QCOMPARE(loaded->image.at(4095, 4095, 0), 128.0F / 255.0F);
}

void TestImageIo::orientation_data() {
    QTest::addColumn<QString>("ending");
    QTest::addColumn<int>("value");
    for (const char* ending : {"tif", "jpg", "png", "webp"}) {
        for (int value = 1; value <= 8; ++value)
            QTest::addRow("%s %d", ending, value) << ending << value;
    }
}

void TestImageIo::orientation() {
    QFETCH(QString, ending);
    QFETCH(int, value);
    // One bright corner in each channel shows where the picture went.
    Image image({48, 32}, 3, 0.1F);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            image.at(x, y, 0) = 0.9F;
            image.at(47 - x, y, 1) = 0.9F;
        }
    }
    const fs::path file = path("x." + endingOf(ending));
    QVERIFY(bool(saveImage(image, file)));
    QByteArray bytes = readFile(file);
    if (ending == "tif") {
        // The last one: the writer leaves an early draft of the directory in the file.
        const auto at = bytes.lastIndexOf(little(0x112, 2) + little(3, 2) + little(1, 4));
        QVERIFY(at > 0);
        bytes[at + 8] = static_cast<char>(value);
    } else if (ending == "jpg") {
        const QByteArray block = QByteArray("Exif\0\0", 6) + exif(value);
        const auto at = bytes.indexOf(QByteArray("Exif\0\0", 6)); // the writer's own block
        if (at > 0) {
            const auto length = static_cast<std::uint8_t>(bytes[at - 2]) * 256 +
                                static_cast<std::uint8_t>(bytes[at - 1]);
            bytes.remove(at - 4, length + 2);
        }
        bytes.insert(2,
                     QByteArray("\xff\xe1", 2) +
                         big(static_cast<std::uint64_t>(block.size() + 2), 2) + block);
    } else if (ending == "png") {
        bytes.insert(8 + 25, pngChunk("eXIf", exif(value)));
    } else {
        bytes =
            riff(webpChunk("VP8X", QByteArray("\x08\0\0\0", 4) + little(47, 3) + little(31, 3)) +
                 bytes.mid(12) + webpChunk("EXIF", exif(value)));
    }
    writeFile(file, bytes);
    const auto loaded = loadImage(file);
    QVERIFY2(bool(loaded), loaded ? "" : loaded.error().message.c_str());
    const Image expected = upright(image, value);
    // The lossy ones smear the corners' edges.
    double sum = 0.0;
    QCOMPARE(loaded->image.size(), expected.size());
    for (std::size_t i = 0; i < expected.samples().size(); ++i)
        sum += std::abs(loaded->image.samples()[i] - expected.samples()[i]);
    QVERIFY(sum / static_cast<double>(expected.samples().size()) <= 0.03);

    // Where EXIF puts the red (first) corner of the stored image.
    constexpr std::array<std::array<int, 2>, 8> kRed{
        {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    const auto corner = kRed[static_cast<std::size_t>(value - 1)];
    QVERIFY(loaded->image.at(corner[0] * (expected.width() - 1),
                             corner[1] * (expected.height() - 1),
                             0) > 0.7F);
    QCOMPARE(expected.width(), value >= 5 ? 32 : 48);
}

void TestImageIo::exrDataWindow_data() {
    QTest::addColumn<int>("x");
    QTest::addColumn<int>("y");
    QTest::newRow("origin") << 0 << 0;
    QTest::newRow("inside") << 10 << 20;
    QTest::newRow("negative") << -1000 << -7;
    QTest::newRow("outside") << 500 << 100000;
}

void TestImageIo::exrDataWindow() {
    QFETCH(int, x);
    QFETCH(int, y);
    ExrParts parts;
    parts.x = x;
    parts.y = y;
    parts.width = 5;
    parts.height = 3;
    writeFile(path("x.exr"), exr(parts));
    const auto loaded = loadImage(path("x.exr"));
    QVERIFY2(bool(loaded), loaded ? "" : loaded.error().message.c_str());
    QCOMPARE(loaded->image.size(), (Size{5, 3}));
    QCOMPARE(loaded->channelNames, (std::vector<std::string>{"R", "G", "B"}));
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 5; ++i) {
            for (int c = 0; c < 3; ++c)
                QCOMPARE(loaded->image.at(i, j, c),
                         static_cast<float>(100 * (2 - c) + 10 * j + i + 1));
        }
    }
}

void TestImageIo::exrAlphaIsDivided() {
    ExrParts parts;
    parts.channels = "ABGR";
    writeFile(path("x.exr"), exr(parts));
    const auto loaded = loadImage(path("x.exr"));
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->image.channels(), 3);
    QVERIFY(loaded->alpha.has_value());
    QCOMPARE(loaded->alpha->at(1, 1, 0), 12.0F);
    QCOMPARE(loaded->image.at(1, 1, 0), 312.0F / 12.0F);
}

void TestImageIo::exrTransferNote() {
    ExrParts parts;
    writeFile(path("x.exr"), exr(parts));
    auto loaded = loadImage(path("x.exr"));
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->image.transfer(), Transfer::Linear);
    QCOMPARE(loaded->sampleFormat, SampleFormat::Float);
    parts.attributes = exrAttribute("texton:transfer", "string", "encoded");
    writeFile(path("x.exr"), exr(parts));
    loaded = loadImage(path("x.exr"));
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->image.transfer(), Transfer::Encoded);
}

void TestImageIo::webpAlphaAndProfile() {
    QVERIFY(bool(saveImage(Image({16, 16}, 3, 0.5F), path("x.webp"))));
    const QByteArray coded = readFile(path("x.webp")).mid(12);
    const QByteArray size = little(15, 3) + little(15, 3);
    writeFile(path("x.webp"),
              riff(webpChunk("VP8X", QByteArray("\x20\0\0\0", 4) + size) +
                   webpChunk("ICCP", linearRgbProfile()) + coded));
    auto loaded = loadImage(path("x.webp"));
    QVERIFY2(bool(loaded), loaded ? "" : loaded.error().message.c_str());
    QVERIFY(loaded->iccConverted);
    QVERIFY(std::abs(loaded->image.at(8, 8, 1) - encodedFromLinear(0.5F)) <= 0.01F);

    // Uncompressed transparency: 128 everywhere.
    writeFile(path("x.webp"),
              riff(webpChunk("VP8X", QByteArray("\x10\0\0\0", 4) + size) +
                   webpChunk("ALPH", QByteArray(1, '\0') + QByteArray(256, '\x80')) + coded));
    loaded = loadImage(path("x.webp"));
    QVERIFY2(bool(loaded), loaded ? "" : loaded.error().message.c_str());
    QVERIFY(loaded->alpha.has_value());
    QCOMPARE(loaded->alpha->at(3, 3, 0), 128.0F / 255.0F);
    QVERIFY(std::abs(loaded->image.at(8, 8, 1) - 0.5F) <= 0.02F);
}

void TestImageIo::bmpVariants() {
    // Run lengths with a grey palette: OpenImageIO would write past its rows if asked for one
    // channel.
    writeFile(path("x.bmp"),
              bmp(50, 2, 8, 1, grayPalette() + QByteArray("\x32\x07\0\0\x32\x09\0\1", 8)));
    auto loaded = loadImage(path("x.bmp"));
    QVERIFY2(bool(loaded), loaded ? "" : loaded.error().message.c_str());
    QCOMPARE(loaded->image.size(), (Size{50, 2}));
    QCOMPARE(loaded->image.at(49, 0, 0), 9.0F / 255.0F);
    QCOMPARE(loaded->image.at(0, 1, 2), 7.0F / 255.0F);
    // The fourth byte of this kind is padding.
    writeFile(path("x.bmp"), bmp(1, 2, 32, 0, QByteArray("\1\2\3\0\4\5\6\x80", 8)));
    loaded = loadImage(path("x.bmp"));
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->image.channels(), 3);
    QVERIFY(!loaded->alpha);
    QCOMPARE(loaded->image.at(0, 0, 0), 6.0F / 255.0F);
    // Rows from the top down.
    writeFile(path("x.bmp"), bmp(1, -2, 24, 0, QByteArray("\1\2\3\0\4\5\6\0", 8)));
    loaded = loadImage(path("x.bmp"));
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->image.at(0, 0, 0), 3.0F / 255.0F);
}

void TestImageIo::tgaPalette() {
    const QByteArray palette("\1\2\3\4\5\6", 6);
    writeFile(path("x.tga"), tga(9, 5, 5, 8, palette + QByteArray("\x98\1", 2), 2));
    const auto loaded = loadImage(path("x.tga"));
    QVERIFY2(bool(loaded), loaded ? "" : loaded.error().message.c_str());
    QCOMPARE(loaded->image.at(4, 4, 0), 6.0F / 255.0F);
    for (const QByteArray& data : {tga(9, 5, 5, 8, palette + QByteArray("\x98\2", 2), 2),
                                   tga(1, 5, 5, 8, palette + QByteArray(25, '\x7f'), 2)}) {
        writeFile(path("x.tga"), data);
        const auto refused = loadImage(path("x.tga"));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::Unreadable);
    }
}

// Profiles

void TestImageIo::iccProfiles_data() {
    QTest::addColumn<QByteArray>("profile");
    QTest::addColumn<bool>("converted");
    QTest::newRow("linear") << linearRgbProfile() << true;
    QTest::newRow("sRGB") << serialized(cmsCreate_sRGBProfile()) << false;
    QTest::newRow("grey for color") << linearGrayProfile() << false;
    QTest::newRow("broken") << linearRgbProfile().left(200) << false;
    QTest::newRow("garbage") << QByteArray(300, '\x5a') << false;
}

void TestImageIo::iccProfiles() {
    QFETCH(QByteArray, profile);
    QFETCH(bool, converted);
    QByteArray rows;
    for (int y = 0; y < 16; ++y) {
        rows += '\0';
        for (int x = 0; x < 16; ++x)
            rows += QByteArray(1, static_cast<char>(16 * y + x)) + static_cast<char>(16 * x + y) +
                    static_cast<char>(15 * x + y);
    }
    const Image plain = loadPng(png(16, 16, 8, 2, rows));
    writeFile(path("x.png"), png(16, 16, 8, 2, rows, iccChunk(profile)));
    const auto loaded = loadImage(path("x.png"));
    QVERIFY2(bool(loaded), loaded ? "" : loaded.error().message.c_str());
    QCOMPARE(loaded->iccConverted, converted);
    Image expected = plain;
    if (converted) {
        expected.setTransfer(Transfer::Linear);
        expected = toEncoded(expected);
        // The profile stores its primaries with 16 bits; dark values are steep.
        QVERIFY(largestDifference(loaded->image, expected) <= 2e-3F);
    } else {
        QCOMPARE(loaded->image, expected);
    }
}

void TestImageIo::iccGrayProfile() {
    QByteArray row(1, '\0');
    for (int x = 0; x < 256; ++x)
        row += static_cast<char>(x);
    const Image plain = loadPng(png(256, 1, 8, 0, row));
    writeFile(path("x.png"), png(256, 1, 8, 0, row, iccChunk(linearGrayProfile())));
    const auto loaded = loadImage(path("x.png"));
    QVERIFY(bool(loaded));
    QVERIFY(loaded->iccConverted);
    QCOMPARE(loaded->image.channels(), 1);
    Image expected = plain;
    expected.setTransfer(Transfer::Linear);
    QVERIFY(largestDifference(loaded->image, toEncoded(expected)) <= 2e-3F);
}

void TestImageIo::exemplars() {
    const fs::path folder = fs::path(TXN_SOURCE_DIR) / ".." / "shared" / "exemplars";
    if (!fs::is_directory(folder))
        QSKIP("the shared exemplars are not here");
    const auto veneer = loadImage(folder / "veneer_normal_rgb16_512.png");
    QVERIFY(bool(veneer));
    QCOMPARE(veneer->sampleFormat, SampleFormat::UInt16);
    // A reader that drops to 8 bits loses these small signals; as listed in the folder's README.
    constexpr std::array kDeviations{423.0, 268.0, 109.0};
    for (int c = 0; c < 3; ++c)
        QVERIFY(std::abs(deviationOf(veneer->image.plane(c)) * 65535.0 -
                         kDeviations[static_cast<std::size_t>(c)]) <= 1.0);
    const auto rust = loadImage(folder / "rust_768x384.png");
    QVERIFY(bool(rust));
    QVERIFY(!rust->iccConverted); // its profile is sRGB
    const auto lawn = loadImage(folder / "lawn_hdr_384x288.exr");
    QVERIFY(bool(lawn));
    QCOMPARE(lawn->image.transfer(), Transfer::Linear);
    const auto granite = loadImage(folder / "granite_palette_128.png");
    QVERIFY(bool(granite));
    QCOMPARE(granite->image.channels(), 3);
}

// Bad files

void TestImageIo::unreadablePaths() {
    const auto codeOf = [](const fs::path& file) {
        const auto loaded = loadImage(file);
        return loaded || !oneFriendlyLine(loaded.error()) ? ErrorCode::Cancelled
                                                          : loaded.error().code;
    };
    QCOMPARE(codeOf(path("none.png")), ErrorCode::NotFound);
    QCOMPARE(codeOf(path("none/none.png")), ErrorCode::NotFound);
    QCOMPARE(codeOf(m_path), ErrorCode::Unreadable);
    QCOMPARE(::mkfifo(path("pipe.png").c_str(), 0600), 0);
    QCOMPARE(codeOf(path("pipe.png")), ErrorCode::Unreadable); // and does not wait
    QCOMPARE(codeOf("/dev/zero"), ErrorCode::Unreadable);
    writeFile(path("empty.png"), {});
    QCOMPARE(codeOf(path("empty.png")), ErrorCode::Unreadable);
    for (const char* name : {"text.png", "text.tga", "text.txt", "line\nbreak.png"}) {
        writeFile(path(name), "Only some words, of no image at all.");
        QCOMPARE(codeOf(path(name)), ErrorCode::Unreadable);
    }
    writeFile(path("short.png"), "x");
    QCOMPARE(codeOf(path("short.png")), ErrorCode::Unreadable);
    fs::create_symlink("nowhere", path("dangling.png"));
    QCOMPARE(codeOf(path("dangling.png")), ErrorCode::NotFound);
    if (::geteuid() != 0) {
        QVERIFY(bool(saveImage(waves({4, 4}, 3), path("secret.png"))));
        QCOMPARE(::chmod(path("secret.png").c_str(), 0), 0);
        QCOMPARE(codeOf(path("secret.png")), ErrorCode::Unreadable);
    }
}

void TestImageIo::truncated_data() {
    QTest::addColumn<QString>("ending");
    QTest::addColumn<int>("channels");
    QTest::addColumn<int>("samples");
    for (const auto& [ending, channels] : kTypes)
        QTest::newRow(ending) << ending << channels << -1;
    QTest::newRow("16-bit TIFF") << "tif" << 1 << 1;
    QTest::newRow("float TIFF") << "tif" << 5 << 3;
    QTest::newRow("16-bit PNG") << "png" << 1 << 1;
    QTest::newRow("float EXR") << "exr" << 5 << 3;
}

void TestImageIo::truncated() {
    QFETCH(QString, ending);
    QFETCH(int, channels);
    QFETCH(int, samples);
    SaveOptions options;
    if (samples >= 0)
        options.sampleFormat = static_cast<SampleFormat>(samples);
    options.attributes["texton:seed"] = "1";
    const fs::path file = path("x." + endingOf(ending));
    Image image = waves({97, 64}, channels);
    std::uint32_t noise = 1; // so that most of the file is data
    for (float& v : image.samples()) {
        noise = noise * 1664525U + 1013904223U;
        v = 0.9F * v + 0.1F * static_cast<float>(noise >> 8U) * 0x1p-24F;
    }
    QVERIFY(bool(saveImage(image, file, options)));
    const QByteArray whole = readFile(file);
    // What follows the pixels of a TGA is optional.
    const qsizetype needed = ending == "tga" ? 18 + 97 * 64 * channels : whole.size();
    std::vector<qsizetype>
        lengths{1, 2, 4, 11, 17, 30, 60, 100, needed - 1, needed - 2, needed - 9};
    for (const double part : {0.1, 0.25, 0.5, 0.75, 0.9, 0.99})
        lengths.push_back(static_cast<qsizetype>(static_cast<double>(needed) * part));
    for (const qsizetype length : lengths) {
        writeFile(file, whole.left(length));
        const auto loaded = loadImage(file);
        QVERIFY2(!loaded, qPrintable(QString("%1 of %2 bytes").arg(length).arg(whole.size())));
        QCOMPARE(loaded.error().code, ErrorCode::Unreadable);
        QVERIFY2(oneFriendlyLine(loaded.error()), loaded.error().message.c_str());
    }
    writeFile(file, whole);
    QVERIFY(bool(loadImage(file)));
}

void TestImageIo::damagedChecksum() {
    QVERIFY(bool(saveImage(waves({64, 64}, 3), path("x.png"))));
    QByteArray bytes = readFile(path("x.png"));
    const auto middle = bytes.size() / 2;
    bytes[middle] = static_cast<char>(bytes[middle] ^ 0x55);
    writeFile(path("x.png"), bytes);
    const auto loaded = loadImage(path("x.png"));
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, ErrorCode::Unreadable);
}

void TestImageIo::trailingBytesAreHarmless_data() {
    equalImagesGiveEqualFiles_data();
}

void TestImageIo::trailingBytesAreHarmless() {
    QFETCH(QString, ending);
    const fs::path file = path("x." + endingOf(ending));
    QVERIFY(bool(saveImage(waves({40, 30}, 3), file)));
    const auto before = loadImage(file);
    QVERIFY(bool(before));
    writeFile(file, readFile(file) + QByteArray(1000, '\0'));
    const auto loaded = loadImage(file);
    QVERIFY2(bool(loaded), loaded ? "" : loaded.error().message.c_str());
    QCOMPARE(loaded->image, before->image);
}

void TestImageIo::hostileHeaders_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    const auto row = [](const std::string& tag, const char* ending, const QByteArray& bytes) {
        QTest::newRow(tag.c_str()) << QString("x.") + ending << bytes;
    };
    const std::vector<std::pair<std::string, std::array<std::int64_t, 2>>> sizes{
        {"60000 x 60000", {60000, 60000}},
        {"16000 x 16000", {16000, 16000}},
        {"largest", {0x7fffffff, 0x7fffffff}},
        {"wide", {0x7fffffff, 1}},
        {"tall", {1, 0x7fffffff}},
        {"unsigned", {0xffffffff, 0xffffffff}},
        {"nothing", {0, 0}}};
    const QByteArray few(100, '\0');
    for (const auto& [tag, size] : sizes) {
        const auto w = static_cast<std::uint64_t>(size[0]);
        const auto h = static_cast<std::uint64_t>(size[1]);
        const int w16 = static_cast<int>(w & 0xffffU);
        const int h16 = static_cast<int>(h & 0xffffU);
        row("PNG " + tag, "png", png(w, h, 8, 2, few));
        row("BMP " + tag, "bmp", bmp(size[0], size[1], 24, 0, few));
        row("BMP 1 bit " + tag, "bmp", bmp(size[0], size[1], 1, 0, few));
        row("TGA " + tag, "tga", tga(2, w16, h16, 24, few, 0));
        row("TGA runs " + tag, "tga", tga(10, w16, h16, 24, few, 0));
        row("JPEG " + tag, "jpg", jpegHeader(w16, h16, 0xc0));
        row("JPEG progressive " + tag, "jpg", jpegHeader(w16, h16, 0xc2));
        for (const int compression : {1, 5, 8, 32773})
            row("TIFF " + std::to_string(compression) + " " + tag, "tif", tiff(w, h, compression));
        row("HDR " + tag,
            "hdr",
            "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + QByteArray::number(size[1]) + " +X " +
                QByteArray::number(size[0]) + "\n" + few);
        row("WebP canvas " + tag,
            "webp",
            riff(webpChunk("VP8X", QByteArray(4, '\0') + little(w - 1, 3) + little(h - 1, 3)) +
                 webpChunk("VP8L", QByteArray("\x2f", 1) + few)));
        ExrParts parts;
        parts.width = static_cast<int>(std::min<std::uint64_t>(w, 0x3fffffff));
        parts.height = 0;
        parts.promisedHeight = static_cast<int>(std::min<std::uint64_t>(h, 0x3fffffff));
        row("EXR " + tag, "exr", exr(parts));
        parts.flags = 0x200;
        parts.attributes = exrAttribute("tiles", "tiledesc", little(64, 4) + little(64, 4) + '\0');
        row("EXR tiles " + tag, "exr", exr(parts));
    }
    row("BMP largest negative", "bmp", bmp(5, INT32_MIN, 24, 0, few));
    row("BMP negative width", "bmp", bmp(-5, 5, 24, 0, few));
    row("BMP runs without palette", "bmp", bmp(5, 5, 24, 1, few));
    row("HDR sizes of many digits",
        "hdr",
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 99999999999999999999 +X 99999999999999999999\n");
    row("HDR without end", "hdr", "#?RADIANCE\n" + QByteArray(100000, 'x'));
    ExrParts parts;
    parts.attributes = QByteArray("long\0string\0", 12) + little(0x7fffffff, 4);
    row("EXR attribute", "exr", exr(parts));
    parts.flags = 0x800;
    parts.attributes = exrAttribute("type", "string", "deepscanline") +
                       exrAttribute("version", "int", little(1, 4)) +
                       exrAttribute("chunkCount", "int", little(2, 4)) +
                       exrAttribute("maxSamplesPerPixel", "int", little(1, 4));
    row("EXR deep", "exr", exr(parts));
    row("JPEG short EXIF",
        "jpg",
        QByteArray("\xff\xd8\xff\xe1\0\x08"
                   "Exif\0\0",
                   12) +
            jpegHeader(8, 8, 0xc0).mid(2));
    row("JPEG short profile",
        "jpg",
        QByteArray("\xff\xd8\xff\xe2\0\x0e"
                   "ICC_PROFILE\0",
                   16) +
            jpegHeader(8, 8, 0xc0).mid(2));
    row("WebP short EXIF",
        "webp",
        riff(webpChunk("VP8X", QByteArray("\x08\0\0\0", 4) + little(7, 3) + little(7, 3)) +
             webpChunk("EXIF", "abc")));
}

void TestImageIo::hostileHeaders() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    const fs::path file = path(name.toStdString());
    writeFile(file, bytes);
    const auto peakKiB = [] {
        rusage usage{};
        ::getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss;
    };
    const long before = peakKiB();
    QElapsedTimer timer;
    timer.start();
    const auto loaded = loadImage(file);
    QVERIFY(!loaded);
    QVERIFY(loaded.error().code == ErrorCode::OverBudget ||
            loaded.error().code == ErrorCode::Unreadable);
    QVERIFY2(oneFriendlyLine(loaded.error()), loaded.error().message.c_str());
    // Generous for a busy machine: a gigabyte of zeros alone takes longer and would show below.
    QVERIFY(timer.elapsed() < 2000);
    QVERIFY(peakKiB() - before < 200 * 1024);
}

void TestImageIo::sampleLimit() {
    for (const auto& [ending, channels] : kTypes) {
        const fs::path file = path(std::string("x.") + ending);
        QVERIFY(bool(saveImage(waves({20, 10}, channels), file)));
        QVERIFY(bool(loadImage(file, {.maxSamples = 600})));
        const auto refused = loadImage(file, {.maxSamples = 599});
        QVERIFY2(!refused, ending);
        QCOMPARE(refused.error().code, ErrorCode::OverBudget);
        QVERIFY(refused.error().message.find("20 x 10") != std::string::npos);
        QVERIFY(refused.error().message.find("599") != std::string::npos);
    }
}

void TestImageIo::threadsMayLoadAndSave() {
    const Image image = waves({50, 40}, 3);
    std::array<int, 4> good{};
    {
        std::vector<std::jthread> threads;
        for (std::size_t t = 0; t < good.size(); ++t) {
            threads.emplace_back([&, t] {
                for (const char* ending : {"png", "exr", "tif", "bmp", "jpg"}) {
                    const fs::path file = path(std::to_string(t) + "." + ending);
                    if (saveImage(image, file) && loadImage(file))
                        ++good[t];
                }
            });
        }
    }
    for (const int count : good)
        QCOMPARE(count, 5);
}

// Writing in bands

void TestImageIo::bandsEqualWhole_data() {
    equalImagesGiveEqualFiles_data();
}

void TestImageIo::bandsEqualWhole() {
    QFETCH(QString, ending);
    const Image image = waves({30, 301}, 3);
    QVERIFY(bool(saveImage(image, path("whole." + endingOf(ending)))));
    const QByteArray whole = readFile(path("whole." + endingOf(ending)));
    for (const int rows : {1, 7, 64, 300}) {
        const fs::path file = path("bands." + endingOf(ending));
        auto writer = ImageWriter::open(file, {.size = image.size(), .channels = 3});
        QVERIFY(bool(writer));
        for (int y = 0; y < image.height(); y += rows) {
            const auto band = crop(image, {0, y, {30, std::min(rows, image.height() - y)}});
            QVERIFY(bool(band));
            QVERIFY(bool(writer->writeRows(*band)));
        }
        QVERIFY(!fs::exists(file) || rows > 1);
        QVERIFY(bool(writer->finish()));
        QCOMPARE(readFile(file), whole);
    }
}

void TestImageIo::writerRefusals() {
    const auto codeOf = [](const Result<void>& result) {
        return result ? ErrorCode::Cancelled : result.error().code;
    };
    auto writer = ImageWriter::open(path("x.png"), {.size = {8, 8}, .channels = 3});
    QVERIFY(bool(writer));
    QCOMPARE(codeOf(writer->writeRows(Image({7, 2}, 3))), ErrorCode::InvalidArgument);
    QCOMPARE(codeOf(writer->writeRows(Image({8, 2}, 1))), ErrorCode::InvalidArgument);
    QCOMPARE(codeOf(writer->writeRows(Image({8, 9}, 3))), ErrorCode::InvalidArgument);
    QVERIFY(bool(writer->writeRows(Image({8, 7}, 3))));
    QCOMPARE(codeOf(writer->finish()), ErrorCode::InvalidArgument); // a row is missing
    QVERIFY(!fs::exists(path("x.png")));
    QVERIFY(bool(writer->writeRows(Image({8, 1}, 3))));
    QVERIFY(bool(writer->finish()));
    QVERIFY(bool(loadImage(path("x.png"))));
    const auto empty = ImageWriter::open(path("y.png"), {.size = {0, 8}, .channels = 3});
    QVERIFY(!empty);
    QCOMPARE(empty.error().code, ErrorCode::InvalidArgument);
}

void TestImageIo::abandonedWriterLeavesNothing() {
    for (const auto& [ending, channels] : kTypes) {
        const fs::path file = path(std::string("x.") + ending);
        auto writer = ImageWriter::open(file, {.size = {40, 100}, .channels = channels});
        QVERIFY(bool(writer));
        QVERIFY(bool(writer->writeRows(waves({40, 70}, channels))));
        ImageWriter moved = *std::move(writer);
    }
    QCOMPARE(entries(), 0);
}

void TestImageIo::existingFilesAndLinks() {
    QVERIFY(bool(saveImage(Image({4, 4}, 3, 0.0F), path("x.png"))));
    fs::create_symlink("x.png", path("link.png"));
    QVERIFY(bool(saveImage(Image({4, 4}, 3, 1.0F), path("link.png"))));
    QVERIFY(fs::is_symlink(path("link.png")));
    const auto loaded = loadImage(path("x.png"));
    QVERIFY(bool(loaded));
    QCOMPARE(loaded->image.at(0, 0, 0), 1.0F);
    // A name that a decoder or a formatter might take for something else.
    const fs::path strange = path("a %04d?x=1 \xc3\xa9.exr");
    QVERIFY(bool(saveImage(Image({4, 4}, 3), strange)));
    QVERIFY(bool(loadImage(strange)));
}

void TestImageIo::unwritablePaths() {
    fs::create_directory(path("folder.png"));
    for (const fs::path& target :
         {path("none/x.png"), path("folder.png"), fs::path("/dev/null.png/x.png")}) {
        const auto saved = saveImage(Image({4, 4}, 3), target);
        QVERIFY(!saved);
        QCOMPARE(saved.error().code, ErrorCode::Unwritable);
        QVERIFY(oneFriendlyLine(saved.error()));
    }
    QCOMPARE(entries(), 1);
}

void TestImageIo::fullDisk_data() {
    equalImagesGiveEqualFiles_data();
}

void TestImageIo::fullDisk() {
    QFETCH(QString, ending);
    Image noise({200, 200}, 3);
    std::uint32_t state = 1;
    for (float& v : noise.samples()) {
        state = state * 1664525U + 1013904223U;
        v = static_cast<float>(state >> 8U) * 0x1p-24F;
    }
    const fs::path file = path("x." + endingOf(ending));
    QVERIFY(bool(saveImage(noise, file)));
    const QByteArray before = readFile(file);

    // A limit on the size of files stands for the end of the disk.
    const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &old), 0);
    std::vector<Error> errors;
    // Early, in the middle, and at the very end, which only the last flush meets.
    for (const qsizetype limit : {qsizetype{10}, before.size() / 2, before.size() - 1}) {
        const rlimit small{static_cast<rlim_t>(limit), old.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
        const auto saved = saveImage(noise, file);
        ::setrlimit(RLIMIT_FSIZE, &old);
        if (!saved)
            errors.push_back(saved.error());
    }
    std::signal(SIGXFSZ, ignored);

    QCOMPARE(errors.size(), 3U);
    for (const Error& error : errors) {
        QCOMPARE(error.code, ErrorCode::Unwritable);
        QVERIFY2(oneFriendlyLine(error) && error.message.find("arge") != std::string::npos,
                 error.message.c_str()); // "File too large"
    }
    QCOMPARE(entries(), 1);
    QCOMPARE(readFile(file), before);
}

// Geometry, transfer, text

void TestImageIo::crops() {
    const Image image = waves({20, 10}, 2, Transfer::Linear);
    const auto part = crop(image, {3, 4, {5, 6}});
    QVERIFY(bool(part));
    QCOMPARE(part->size(), (Size{5, 6}));
    QCOMPARE(part->transfer(), Transfer::Linear);
    QCOMPARE(part->at(4, 5, 1), image.at(7, 9, 1));
    const auto whole = crop(image, {0, 0, {20, 10}});
    QVERIFY(bool(whole));
    QCOMPARE(*whole, image);
    for (const Rect& rect : {Rect{-1, 0, {5, 5}},
                             Rect{16, 0, {5, 5}},
                             Rect{0, 6, {5, 5}},
                             Rect{0, 0, {0, 5}},
                             Rect{0, 0, {21, 5}},
                             Rect{INT64_MAX, INT64_MAX, {5, 5}},
                             Rect{INT64_MIN, 0, {5, 5}}}) {
        const auto refused = crop(image, rect);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::InvalidArgument);
        QVERIFY(refused.error().message.find("20 x 10") != std::string::npos);
    }
}

void TestImageIo::quarterTurns() {
    const Image image = waves({7, 5}, 3);
    const auto left = rotated(image, 90.0);
    QVERIFY(bool(left));
    QCOMPARE(left->size(), (Size{5, 7}));
    QCOMPARE(left->at(0, 0, 1), image.at(6, 0, 1)); // the right end of the top row is on top
    QCOMPARE(left->at(0, 6, 1), image.at(0, 0, 1));
    const auto right = rotated(image, -450.0);
    QVERIFY(bool(right));
    const auto back = rotated(*left, -90.0);
    QVERIFY(bool(back));
    QCOMPARE(*back, image);
    const auto half = rotated(image, 180.0);
    QVERIFY(bool(half));
    QCOMPARE(half->at(0, 0, 2), image.at(6, 4, 2));
    QCOMPARE(*rotated(*half, -180.0), image);
    QCOMPARE(*rotated(*right, 90.0), image);
    QCOMPARE(*rotated(image, 720.0), image);
}

void TestImageIo::otherTurns_data() {
    QTest::addColumn<double>("degrees");
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    for (const double degrees :
         {0.001, 1.0, 10.0, 30.0, 45.0, 60.0, 89.0, 100.0, 170.0, -20.0, 300.0}) {
        QTest::addRow("square %g", degrees) << degrees << 200 << 200;
        QTest::addRow("wide %g", degrees) << degrees << 300 << 120;
        QTest::addRow("tall %g", degrees) << degrees << 90 << 250;
    }
}

void TestImageIo::otherTurns() {
    QFETCH(double, degrees);
    QFETCH(int, width);
    QFETCH(int, height);
    const double angle = degrees * std::numbers::pi / 180.0;
    // A plane wave with a period of 20 samples, about the center.
    const auto wave = [](double x, double y) { return 0.5 + 0.4 * std::sin(0.25 * x + 0.18 * y); };
    Image image({width, height}, 2, 0.25F);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            image.at(x, y, 0) =
                static_cast<float>(wave(x + 0.5 - 0.5 * width, y + 0.5 - 0.5 * height));
    }
    const auto turned = rotated(image, degrees);
    QVERIFY(bool(turned));
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    double worst = 0.0;
    for (int y = 0; y < turned->height(); ++y) {
        for (int x = 0; x < turned->width(); ++x) {
            QVERIFY(std::abs(turned->at(x, y, 1) - 0.25F) <= 1e-5F); // no dark rim
            const double dx = x + 0.5 - 0.5 * turned->width();
            const double dy = y + 0.5 - 0.5 * turned->height();
            const double fromX = dx * c - dy * s;
            const double fromY = dx * s + dy * c;
            // Near the border the filter sees repeated samples.
            if (std::abs(fromX) < 0.5 * width - 4 && std::abs(fromY) < 0.5 * height - 4)
                worst = std::max(worst, std::abs(turned->at(x, y, 0) - wave(fromX, fromY)));
            QVERIFY(std::abs(fromX) <= 0.5 * width && std::abs(fromY) <= 0.5 * height);
        }
    }
    QVERIFY2(worst <= 5e-3, qPrintable(QString::number(worst)));
    // The largest rectangle is at least as large as one of the same shape: its side is the short
    // one over (cos + long / short sin).
    const double longSide = std::max(width, height);
    const double shortSide = std::min(width, height);
    const double scale = shortSide / (shortSide * std::abs(c) + longSide * std::abs(s));
    QVERIFY((turned->width() + 1.0) * (turned->height() + 1.0) >= scale * scale * width * height);
}

void TestImageIo::refusedTurns() {
    const Image image = waves({10, 1}, 1);
    for (const double degrees : {45.0, std::nan(""), HUGE_VAL}) {
        const auto result = rotated(image, degrees);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::InvalidArgument);
    }
    QVERIFY(bool(rotated(image, 1e-12)));
}

void TestImageIo::uprightUndoesOrientations() {
    const Image image = waves({6, 4}, 2);
    // Each orientation is undone by itself, but for the two quarter turns.
    for (int value = 0; value <= 9; ++value) {
        const int inverse = value == 6 ? 8 : value == 8 ? 6 : value;
        QCOMPARE(upright(upright(image, value), inverse), image);
    }
}

void TestImageIo::transferCurve() {
    QCOMPARE(linearFromEncoded(0.0F), 0.0F);
    QVERIFY(std::abs(linearFromEncoded(1.0F) - 1.0F) <= 1e-6F);
    QVERIFY(std::abs(linearFromEncoded(0.5F) - 0.21404114F) <= 1e-6F);
    QVERIFY(std::abs(linearFromEncoded(0.02F) - 0.02F / 12.92F) <= 1e-8F);
    QVERIFY(std::isnan(linearFromEncoded(std::nanf(""))));
    QVERIFY(std::isnan(encodedFromLinear(std::nanf(""))));
    for (int i = -3000; i <= 3000; ++i) {
        const float value = static_cast<float>(i) / 1000.0F;
        const float tolerance = 1e-6F * std::max(1.0F, std::abs(value));
        QVERIFY(std::abs(encodedFromLinear(linearFromEncoded(value)) - value) <= tolerance);
        QVERIFY(std::abs(linearFromEncoded(encodedFromLinear(value)) - value) <= tolerance);
        QCOMPARE(linearFromEncoded(-value), -linearFromEncoded(value));
    }
    const Image image = waves({64, 64}, 3);
    const Image linear = toLinear(image);
    QCOMPARE(linear.transfer(), Transfer::Linear);
    QCOMPARE(linear.at(5, 6, 1), linearFromEncoded(image.at(5, 6, 1)));
    QCOMPARE(toLinear(linear), linear);
    QVERIFY(largestDifference(toEncoded(linear), image) <= 1e-6F);
    QCOMPARE(toEncoded(linear).transfer(), Transfer::Encoded);
}

void TestImageIo::textIsDrawn() {
    Image image({120, 40}, 2, 0.25F);
    const auto drawn = drawText(image, 10, 30, 20, "Texton", 1.0F);
    if (!drawn && drawn.error().code == ErrorCode::Unsupported)
        QSKIP("the font DejaVu Sans is not here");
    QVERIFY2(bool(drawn), drawn.error().message.c_str());
    const auto width = textWidthPx("Texton", 20);
    QVERIFY(bool(width));
    QVERIFY(*width > 40 && *width < 100);
    int inked = 0;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 120; ++x) {
            const float value = image.at(x, y, 0);
            QCOMPARE(image.at(x, y, 1), value);
            QVERIFY(value >= 0.25F && value <= 1.0F);
            if (value > 0.25F) {
                ++inked;
                QVERIFY(x >= 9 && x <= 11 + *width && y >= 10 && y <= 31);
            }
        }
    }
    QVERIFY(inked > 150);
    // What does not fit is cut off.
    QVERIFY(bool(drawText(image, -30, 45, 40, "outside", 0.0F)));
    QVERIFY(bool(drawText(image, 5000, -5000, 40, "outside", 0.0F)));
    QVERIFY(bool(drawText(image, 0, 10, 10, "", 0.0F)));
    QVERIFY(!drawText(image, 0, 10, 0, "x", 0.0F));
    QCOMPARE(*textWidthPx("", 20), 0);
}

QTEST_GUILESS_MAIN(TestImageIo)
#include "TestImageIo.moc"
