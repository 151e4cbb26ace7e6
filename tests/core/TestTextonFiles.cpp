// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/Exporter.h"
#include "core/export/TextonFile.h"
#include "core/gaussian/Exemplar.h"
#include "core/image/ImageIo.h"
#include "tests/helpers/Numbers.h"
#include "tests/helpers/Textons.h"
#include "tests/helpers/Verify.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace txn;
using namespace txn::test;
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

TextonAsset assetOf(Texton texton) {
    TextonAsset asset;
    asset.texton = std::move(texton);
    asset.process = NoiseProcess::Poisson;
    asset.meanImpacts = 31.25;
    asset.seed = {4000000000U};
    asset.exemplarName = "rust \"wall\" 12 \xc3\xa9.png";
    return asset;
}

Result<std::vector<fs::path>> save(const TextonAsset& asset, const fs::path& path) {
    const std::vector<fs::path> paths{path};
    return saveTexton(asset, paths);
}

std::string contentOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

fs::path sidecarOf(fs::path path) {
    path += ".json";
    return path;
}

Json sidecarJson(const fs::path& path) {
    return Json::parse(contentOf(sidecarOf(path)));
}

Support shapeOf(int shape, Size size) {
    if (shape == 1)
        return Support::disc(size.width);
    if (shape == 2) {
        std::vector<std::uint8_t> flags(size.area(), 1);
        flags[0] = flags[5] = 0;
        flags[size.area() - 2] = 0;
        return *Support::mask(size, flags);
    }
    return Support::rectangle(size);
}

/// Every sample of a `.texton` text: [line][channel], and the trailing comment.
struct RawTexton {
    std::string magic;
    int version = 0;
    int order = -1;
    std::vector<double> mean;
    int width = 0;
    int height = 0;
    std::vector<std::array<double, 3>> samples;
    std::string rest;
};

RawTexton parse(const std::string& text) {
    std::istringstream stream(text);
    RawTexton raw;
    raw.mean.resize(3);
    stream >> raw.magic >> raw.version >> raw.order >> raw.mean[0] >> raw.mean[1] >> raw.mean[2] >>
        raw.width >> raw.height;
    raw.samples.resize(static_cast<std::size_t>(raw.width * raw.height));
    for (auto& sample : raw.samples)
        stream >> sample[0] >> sample[1] >> sample[2];
    std::getline(stream >> std::ws, raw.rest);
    return stream ? raw : RawTexton{};
}

/// A file as the authors' own programs write it: 2 x 1 coefficients in a border of one.
const char* const kHandWritten = "TEXTON\r\n"
                                 "1\n"
                                 "1\n"
                                 "0.5 0.25 0.125\n"
                                 "4 3\n"
                                 "0 0 0\n0 0 0\n0 0 0\n0 0 0\n"
                                 "0 0 0\n1.5 -2 3e-2\n+4 5 6\n0 0 0\n"
                                 "0 0 0\n0 0 0\n0 0 0\n0 0 0\n"
                                 "A comment that may say anything, 1 2 3.\n";

} // namespace

class TestTextonFiles : public QObject {
    Q_OBJECT

  private slots:
    void init() {
        m_dir = std::make_unique<QTemporaryDir>();
        QVERIFY(m_dir->isValid());
        m_path = m_dir->path().toStdString();
    }

    void exrIsLossless_data() {
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("kernels");
        QTest::addColumn<int>("channels");
        QTest::addColumn<int>("shape");
        QTest::addColumn<bool>("linear");
        for (const int kernels : {1, 3}) {
            for (const int channels : {1, 3, 5}) {
                QTest::addRow("Q %d C %d", kernels, channels)
                    << 1 << kernels << channels << 0 << false;
                QTest::addRow("Q %d C %d disc", kernels, channels)
                    << 3 << kernels << channels << 1 << false;
                QTest::addRow("Q %d C %d mask linear", kernels, channels)
                    << 0 << kernels << channels << 2 << true;
            }
        }
        QTest::newRow("RGB and alpha alike") << 5 << 1 << 4 << 0 << false;
        QTest::newRow("many channels") << 1 << 4 << 16 << 0 << false;
        QTest::newRow("two channels") << 1 << 1 << 2 << 0 << true;
    }

    void exrIsLossless() {
        QFETCH(int, order);
        QFETCH(int, kernels);
        QFETCH(int, channels);
        QFETCH(int, shape);
        QFETCH(bool, linear);
        const Size size = shape == 1 ? Size{7, 7} : Size{8, 5};
        Texton texton =
            cutTo(makeTexton({order, kernels, size, channels, 1}), shapeOf(shape, size));
        if (linear) {
            texton.transfer = Transfer::Linear;
            for (Image& kernel : texton.kernels)
                kernel.setTransfer(Transfer::Linear);
        }
        texton.mean[0] = 1.0 / 3.0; // needs all digits
        const TextonAsset asset = assetOf(std::move(texton));
        const fs::path path = m_path / "t.exr";
        const auto written = save(asset, path);
        TXN_OK(written);
        QVERIFY(*written == (std::vector<fs::path>{path, sidecarOf(path)}));
        const auto loaded = loadTexton(path);
        TXN_OK(loaded);
        QVERIFY(*loaded == asset);
        // The header alone is enough.
        fs::remove(sidecarOf(path));
        const auto alone = loadTexton(path);
        TXN_OK(alone);
        QVERIFY(*alone == asset);
    }

    void exrFrameIsZero() {
        const TextonAsset asset = assetOf(makeTexton({3, 2, {6, 4}, 3, 2}));
        const fs::path path = m_path / "t.exr";
        TXN_OK(save(asset, path));
        const auto loaded = loadImage(path);
        TXN_OK(loaded);
        const Image& image = loaded->image;
        QCOMPARE(image.size(), (Size{10, 8}));
        QCOMPARE(image.channels(), 6);
        for (int c = 0; c < image.channels(); ++c) {
            const std::string& name = loaded->channelNames[static_cast<std::size_t>(c)];
            QCOMPARE(name.size(), std::string("kernel0.R").size());
            const auto q = static_cast<std::size_t>(name[6] - '0');
            const auto channel = static_cast<int>(std::string("RGB").find(name.back()));
            QVERIFY(name.starts_with("kernel") && q < 2 && channel >= 0);
            for (int y = 0; y < 8; ++y) {
                for (int x = 0; x < 10; ++x) {
                    const bool inside = x >= 2 && y >= 2 && x < 8 && y < 6;
                    const float expected =
                        inside ? asset.texton.kernels[q].at(x - 2, y - 2, channel) : 0.0F;
                    QVERIFY(image.at(x, y, c) == expected);
                }
            }
        }
    }

    void textonTextKeepsEveryFloat_data() {
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("channels");
        QTest::addColumn<int>("shape");
        QTest::addColumn<bool>("linear");
        for (const int order : {0, 1, 3, 5}) {
            QTest::addRow("order %d", order) << order << 3 << 0 << false;
            QTest::addRow("order %d disc", order) << order << 3 << 1 << false;
        }
        QTest::newRow("mask linear") << 1 << 3 << 2 << true;
    }

    void textonTextKeepsEveryFloat() {
        QFETCH(int, order);
        QFETCH(int, channels);
        QFETCH(int, shape);
        QFETCH(bool, linear);
        const Size size = shape == 1 ? Size{7, 7} : Size{6, 4};
        Texton texton = cutTo(makeTexton({order, 1, size, channels, 3}), shapeOf(shape, size));
        // The hardest floats there are.
        texton.kernels[0].at(2, 1, 0) = std::numeric_limits<float>::denorm_min();
        texton.kernels[0].at(2, 1, 1) = -Exemplar::kLargestSample; // the largest that is used
        texton.kernels[0].at(2, 1, 2) = std::nextafter(1.0F, 2.0F);
        texton.mean = {0.1, 0.25, -3.5};
        if (linear) {
            texton.transfer = Transfer::Linear;
            texton.kernels[0].setTransfer(Transfer::Linear);
        }
        const TextonAsset asset = assetOf(std::move(texton));
        const fs::path path = m_path / "t.texton";
        TXN_OK(save(asset, path));
        // With its sidecar nothing is lost; without it the coefficients still are all there.
        const auto loaded = loadTexton(path);
        TXN_OK(loaded);
        QVERIFY(*loaded == asset);
        fs::remove(sidecarOf(path));
        const auto alone = loadTexton(path);
        TXN_OK(alone);
        QVERIFY(std::ranges::equal(alone->texton.kernels[0].samples(),
                                   asset.texton.kernels[0].samples()));
        QVERIFY(alone->texton.mean == asset.texton.mean);
        QCOMPARE(alone->texton.interpolationOrder, order);
        QCOMPARE(alone->texton.support.size(), size);
        QVERIFY(alone->process == NoiseProcess::Stratified);
    }

    void textonTextHasTheAuthorsLayout() {
        for (const int order : {0, 1, 3, 5}) {
            const Texton texton = makeTexton({order, 1, {5, 4}, 3, 4});
            const auto text = toTextonFile(assetOf(texton));
            TXN_OK(text);
            const RawTexton raw = parse(*text);
            QCOMPARE(raw.magic, std::string("TEXTON"));
            QCOMPARE(raw.version, 1);
            QCOMPARE(raw.order, order);
            QCOMPARE(raw.width, 7); // a frame of one, whatever the order
            QCOMPARE(raw.height, 6);
            QVERIFY(!raw.rest.empty());
            for (std::size_t c = 0; c < 3; ++c)
                TXN_AT_MOST(std::abs(raw.mean[c] - texton.mean[c]), 1e-9);
            for (int line = 0; line < raw.height; ++line) {
                for (int column = 0; column < raw.width; ++column) {
                    const auto& sample =
                        raw.samples[static_cast<std::size_t>(line * raw.width + column)];
                    const int x = column - 1;
                    const int y = raw.height - 1 - line - 1; // bottom row first
                    const bool inside = x >= 0 && y >= 0 && x < 5 && y < 4;
                    for (int c = 0; c < 3; ++c)
                        QVERIFY(static_cast<float>(sample[static_cast<std::size_t>(c)]) ==
                                (inside ? texton.kernels[0].at(x, y, c) : 0.0F));
                }
            }
        }
    }

    void greyIsWrittenThreeTimes() {
        const Texton grey = makeTexton({1, 1, {5, 4}, 1, 5});
        const auto text = toTextonFile(assetOf(grey));
        TXN_OK(text);
        const RawTexton raw = parse(*text);
        QCOMPARE(raw.samples.size(), std::size_t{42});
        for (const auto& sample : raw.samples)
            QVERIFY(sample[0] == sample[1] && sample[1] == sample[2]);
        QVERIFY(raw.mean[0] == raw.mean[1] && raw.mean[1] == raw.mean[2]);
        const auto loaded = fromTextonFile(*text);
        TXN_OK(loaded);
        QCOMPARE(loaded->texton.channels(), 3);
        QVERIFY(std::ranges::equal(loaded->texton.kernels[0].plane(1), grey.kernels[0].plane(0)));
    }

    void namesDoNotBreakTheText() {
        TextonAsset asset = assetOf(makeTexton({}));
        asset.exemplarName = "two\nlines\r\tof \x01 name";
        const auto text = toTextonFile(asset);
        TXN_OK(text);
        QCOMPARE(std::ranges::count(*text, '\n'), 5 + 11 * 9 + 1);
        TXN_OK(fromTextonFile(*text));
    }

    void namesDoNotTurnTextAround() {
        TextonAsset asset = assetOf(makeTexton({}));
        for (const char* control :
             {"\u202e", "\u2066", "\u200f", "\u061c", "\u2028", "\u0085", "\x7f"}) {
            asset.exemplarName = std::string("st\u00f6ne \U0001f9f1") + control + "*/ \"gpj\"";
            const auto text = toTextonFile(asset);
            TXN_OK(text);
            QVERIFY(text->find(control) == std::string::npos);
            QVERIFY(text->find("st\u00f6ne \U0001f9f1 */") != std::string::npos);
            // In JSON it stays what it is, but escaped.
            const fs::path path = m_path / "turned.exr";
            TXN_OK(save(asset, path));
            std::ifstream stream(path.string() + ".json", std::ios::binary);
            const std::string json{std::istreambuf_iterator<char>(stream), {}};
            QVERIFY(json.find(control) == std::string::npos);
            const auto again = loadTexton(path);
            TXN_OK(again);
            QCOMPARE(again->exemplarName, asset.exemplarName);
        }
    }

    void handWrittenTextIsRead() {
        const auto asset = fromTextonFile(kHandWritten);
        TXN_OK(asset);
        const Texton& texton = asset->texton;
        QCOMPARE(texton.interpolationOrder, 1);
        QVERIFY(texton.mean == (std::vector<double>{0.5, 0.25, 0.125}));
        QCOMPARE(texton.support.size(), (Size{2, 1}));
        QCOMPARE(texton.kernels[0].at(0, 0, 0), 1.5F);
        QCOMPARE(texton.kernels[0].at(0, 0, 1), -2.0F);
        QCOMPARE(texton.kernels[0].at(0, 0, 2), 0.03F);
        QCOMPARE(texton.kernels[0].at(1, 0, 0), 4.0F);
        QCOMPARE(texton.kernels[0].at(1, 0, 2), 6.0F);
        QVERIFY(asset->process == NoiseProcess::Stratified);
        // The comment may be missing.
        const std::string text = kHandWritten;
        TXN_OK(fromTextonFile(text.substr(0, text.find("A comment"))));
    }

    void brokenTextsAreErrors_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::newRow("empty") << QByteArray(kHandWritten) << QByteArray();
        QTest::newRow("other magic") << QByteArray("TEXTON") << QByteArray("TEXTOM");
        QTest::newRow("longer magic") << QByteArray("TEXTON\r") << QByteArray("TEXTONS\r");
        QTest::newRow("version 2") << QByteArray("\n1\n1\n") << QByteArray("\n2\n1\n");
        QTest::newRow("version 1.5") << QByteArray("\n1\n1\n") << QByteArray("\n1.5\n1\n");
        QTest::newRow("order 2") << QByteArray("\n1\n1\n") << QByteArray("\n1\n2\n");
        QTest::newRow("order -1") << QByteArray("\n1\n1\n") << QByteArray("\n1\n-1\n");
        QTest::newRow("order word") << QByteArray("\n1\n1\n") << QByteArray("\n1\none\n");
        QTest::newRow("mean nan") << QByteArray("0.25") << QByteArray("nan");
        QTest::newRow("mean infinite") << QByteArray("0.25") << QByteArray("inf");
        QTest::newRow("mean beyond double") << QByteArray("0.25") << QByteArray("1e999");
        QTest::newRow("mean word") << QByteArray("0.25") << QByteArray("0.25x");
        QTest::newRow("mean comma") << QByteArray("0.25") << QByteArray("0,25");
        QTest::newRow("width 2") << QByteArray("4 3\n") << QByteArray("2 3\n");
        QTest::newRow("height 0") << QByteArray("4 3\n") << QByteArray("4 0\n");
        QTest::newRow("width negative") << QByteArray("4 3\n") << QByteArray("-4 3\n");
        QTest::newRow("width huge") << QByteArray("4 3\n") << QByteArray("16000 16000\n");
        QTest::newRow("width beyond int") << QByteArray("4 3\n") << QByteArray("4294967300 3\n");
        QTest::newRow("width fraction") << QByteArray("4 3\n") << QByteArray("4.5 3\n");
        QTest::newRow("one row too many") << QByteArray("4 3\n") << QByteArray("4 4\n");
        QTest::newRow("sample nan") << QByteArray("1.5 ") << QByteArray("nan ");
        QTest::newRow("sample infinite") << QByteArray("1.5 ") << QByteArray("-inf ");
        QTest::newRow("sample beyond float") << QByteArray("1.5 ") << QByteArray("1e39 ");
        QTest::newRow("sample word") << QByteArray("1.5 ") << QByteArray("x ");
        QTest::newRow("sample sign twice") << QByteArray("+4") << QByteArray("+-4");
        QTest::newRow("sample sign alone") << QByteArray("+4") << QByteArray("+");
        QTest::newRow("border not zero")
            << QByteArray("4 3\n0 0 0\n") << QByteArray("4 3\n0 0.1 0\n");
        QTest::newRow("sample missing") << QByteArray("1.5 -2 ") << QByteArray("1.5 ");
    }

    void brokenTextsAreErrors() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        std::string text = kHandWritten;
        const auto at = text.find(from.toStdString());
        QVERIFY(at != std::string::npos);
        text.replace(at, static_cast<std::size_t>(from.size()), to.toStdString());
        TXN_FAILS_WITH(fromTextonFile(text), ErrorCode::Unreadable);
        // As a file: the message names it.
        const fs::path path = m_path / "broken.texton";
        write(path, text);
        const auto loaded = loadTexton(path);
        TXN_FAILS_WITH(loaded, ErrorCode::Unreadable);
        QVERIFY(loaded.error().message.find("broken.texton") != std::string::npos);
    }

    void textsCutAnywhereAreErrors() {
        const std::string text = kHandWritten;
        const auto end = text.find("A comment") - 1; // just behind the last zero
        for (std::size_t length = 0; length < end; ++length)
            QVERIFY(!fromTextonFile(std::string_view(text).substr(0, length)));
        TXN_OK(fromTextonFile(std::string_view(text).substr(0, end)));
    }

    void pngIsWithinHalfACode_data() {
        QTest::addColumn<int>("order");
        QTest::addColumn<int>("kernels");
        QTest::addColumn<int>("channels");
        QTest::addColumn<int>("shape");
        QTest::addColumn<bool>("linear");
        for (const int kernels : {1, 3}) {
            for (const int channels : {1, 3}) {
                for (const int order : {0, 1, 5})
                    QTest::addRow("Q %d C %d order %d", kernels, channels, order)
                        << order << kernels << channels << 0 << false;
                QTest::addRow("Q %d C %d disc linear", kernels, channels)
                    << 1 << kernels << channels << 1 << true;
            }
        }
    }

    void pngIsWithinHalfACode() {
        QFETCH(int, order);
        QFETCH(int, kernels);
        QFETCH(int, channels);
        QFETCH(int, shape);
        QFETCH(bool, linear);
        const Size size = shape == 1 ? Size{9, 9} : Size{12, 7};
        Texton texton =
            cutTo(makeTexton({order, kernels, size, channels, 6}), shapeOf(shape, size));
        if (linear) {
            texton.transfer = Transfer::Linear;
            for (Image& kernel : texton.kernels)
                kernel.setTransfer(Transfer::Linear);
        }
        const TextonAsset asset = assetOf(texton);
        const fs::path path = m_path / "t.png";
        TXN_OK(save(asset, path));
        const auto loaded = loadTexton(path);
        TXN_OK(loaded);

        // All but the samples comes back exactly.
        TextonAsset other = *loaded;
        QCOMPARE(other.texton.kernelCount(), kernels);
        const std::vector<Image> decoded = other.texton.kernels;
        other.texton.kernels = texton.kernels;
        QVERIFY(other == asset);

        const Json json = sidecarJson(path);
        for (int c = 0; c < channels; ++c) {
            const double scale = json.at("scale").at(static_cast<std::size_t>(c));
            // A code too wide would pass the next check: it must not be wider than the values need.
            double largest = 0.0;
            for (int q = 0; q < kernels; ++q) {
                const auto i = static_cast<std::size_t>(q);
                QVERIFY(decoded[i].transfer() == texton.transfer);
                for (const float v : texton.kernels[i].plane(c))
                    largest = std::max(largest, static_cast<double>(std::abs(v)));
                TXN_AT_MOST(largestDifference(decoded[i].plane(c), texton.kernels[i].plane(c)),
                            scale / 65535.0 / 2.0 * 1.01);
            }
            TXN_AT_MOST(scale, 2.001 * largest);
        }

        // The picture itself: kernels one below the other, the frame at the code of exactly 0.
        const auto picture = loadImage(path);
        TXN_OK(picture);
        QVERIFY(picture->sampleFormat == SampleFormat::UInt16);
        const int frame = texton.frame();
        const Size footprint = texton.footprint();
        QCOMPARE(picture->image.size(), (Size{footprint.width, footprint.height * kernels}));
        QCOMPARE(picture->image.channels(), channels);
        for (int c = 0; c < channels; ++c) {
            const auto i = static_cast<std::size_t>(c);
            const double scale = json.at("scale").at(i);
            const double bias = json.at("bias").at(i);
            for (int y = 0; y < picture->image.height(); ++y) {
                const int row = y % footprint.height - frame;
                for (int x = 0; x < footprint.width; ++x) {
                    if (row < 0 || row >= size.height || x < frame || x >= frame + size.width) {
                        const double code =
                            std::round(static_cast<double>(picture->image.at(x, y, c)) * 65535.0);
                        TXN_AT_MOST(std::abs(code / 65535.0 * scale + bias), 1e-12 * scale);
                    }
                }
            }
        }
        // Outside a disc, too.
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                if (!texton.support.contains(x, y))
                    QVERIFY(decoded[0].at(x, y, 0) == 0.0F);
            }
        }
    }

    void flatChannelsSurvivePng() {
        Texton texton = makeTexton({1, 1, {6, 5}, 3, 7});
        for (float& v : texton.kernels[0].plane(1))
            v = 0.0F;
        for (float& v : texton.kernels[0].plane(2))
            v = std::abs(v); // one sign only
        TXN_OK(save(assetOf(texton), m_path / "t.png"));
        const auto loaded = loadTexton(m_path / "t.png");
        TXN_OK(loaded);
        for (const float v : loaded->texton.kernels[0].plane(1))
            QVERIFY(v == 0.0F);
        TXN_AT_MOST(
            test::relativeError(loaded->texton.kernels[0].plane(2), texton.kernels[0].plane(2)),
            1e-4);
    }

    void sidecarSaysEverything() {
        Texton texton = cutTo(makeTexton({3, 2, {7, 7}, 1, 8}), Support::disc(7));
        const TextonAsset asset = assetOf(texton);
        TXN_OK(save(asset, m_path / "t.exr"));
        const Json json = sidecarJson(m_path / "t.exr");
        QCOMPARE(json.at("format").get<std::string>(), std::string("texton"));
        QCOMPARE(json.at("version").get<int>(), 1);
        QCOMPARE(json.at("channels").get<int>(), 1);
        QCOMPARE(json.at("kernels").get<int>(), 2);
        QCOMPARE(json.at("interpolation_order").get<int>(), 3);
        QCOMPARE(json.at("frame").get<int>(), 2);
        QCOMPARE(json.at("support_width").get<int>(), 7);
        QCOMPARE(json.at("support_height").get<int>(), 7);
        QCOMPARE(json.at("support_shape").get<std::string>(), std::string("disc"));
        QVERIFY(json.at("mean") == Json(texton.mean));
        QVERIFY(json.at("scale") == Json({1.0}));
        QVERIFY(json.at("bias") == Json({0.0}));
        QCOMPARE(json.at("color_space").get<std::string>(), std::string("encoded"));
        QCOMPARE(json.at("mni").get<double>(), 31.25);
        QCOMPARE(json.at("process").get<std::string>(), std::string("poisson"));
        QCOMPARE(json.at("seed").get<std::uint32_t>(), 4000000000U);
        QCOMPARE(json.at("exemplar").get<std::string>(), asset.exemplarName);
        QVERIFY(json.at("program").get<std::string>().find("Texton Studio") == 0);
    }

    void brokenSidecarsAreErrors_data() {
        QTest::addColumn<QByteArray>("key");
        QTest::addColumn<QByteArray>("value"); // empty: the key is taken away
        for (const char* key : {"format",
                                "version",
                                "channels",
                                "kernels",
                                "interpolation_order",
                                "frame",
                                "support_width",
                                "support_height",
                                "support_shape",
                                "mean",
                                "scale",
                                "bias",
                                "color_space",
                                "mni",
                                "process",
                                "seed",
                                "exemplar"}) {
            QTest::addRow("%s missing", key) << QByteArray(key) << QByteArray();
            QTest::addRow("%s null", key) << QByteArray(key) << QByteArray("null");
            QTest::addRow("%s list", key) << QByteArray(key) << QByteArray("[[1]]");
        }
        const auto bad = [](const char* key, const char* value) {
            QTest::addRow("%s %s", key, value) << QByteArray(key) << QByteArray(value);
        };
        bad("format", "\"gltf\"");
        bad("version", "2");
        bad("channels", "0");
        bad("channels", "1");
        bad("channels", "1e9");
        bad("channels", "3.5");
        bad("kernels", "2");
        bad("kernels", "-1");
        bad("interpolation_order", "2");
        bad("interpolation_order", "3");
        bad("frame", "2");
        bad("support_width", "5");
        bad("support_width", "99999999");
        bad("support_height", "-4");
        bad("support_shape", "\"disc\""); // of a 6 x 5 support
        bad("support_shape", "\"star\"");
        bad("mean", "[0.5, 0.5]");
        bad("mean", "[0.5, 0.5, \"x\"]");
        bad("mean", "[0.5, 0.5, 1e999]");
        bad("scale", "[1, 1, 1, 1]");
        bad("scale", "[1e300, 1e300, 1e300]");
        bad("color_space", "\"xyz\"");
        bad("mni", "0");
        bad("mni", "1e9");
        bad("process", "\"gauss\"");
        bad("seed", "-1");
        bad("seed", "4294967296");
    }

    void brokenSidecarsAreErrors() {
        QFETCH(QByteArray, key);
        QFETCH(QByteArray, value);
        const fs::path path = m_path / "t.png";
        // Saved once: waiting for the disk takes longer than all the rest.
        static const auto good = [&] {
            const bool saved = bool(save(assetOf(makeTexton({1, 1, {6, 5}, 3, 9})), path));
            return saved ? std::pair(contentOf(path), contentOf(sidecarOf(path)))
                         : std::pair<std::string, std::string>();
        }();
        write(path, good.first);
        write(sidecarOf(path), good.second);
        TXN_OK(loadTexton(path));
        // Text in place of the parsed value: some of these values are not valid JSON.
        Json json = sidecarJson(path);
        QVERIFY(json.contains(key.toStdString()));
        json.erase(key.toStdString());
        std::string text = json.dump();
        if (!value.isEmpty())
            text.replace(0, 1, "{\"" + key.toStdString() + "\": " + value.toStdString() + ", ");
        write(sidecarOf(path), text);
        const auto loaded = loadTexton(path);
        QVERIFY2(!loaded, "it should have failed");
        QVERIFY(loaded.error().code == ErrorCode::Unreadable ||
                loaded.error().code == ErrorCode::Unsupported);
        QVERIFY(loaded.error().message.find("t.png") != std::string::npos);
        QVERIFY(loaded.error().message.find('\n') == std::string::npos);
    }

    void unusableSidecars() {
        const fs::path png = m_path / "t.png";
        TXN_OK(save(assetOf(makeTexton({1, 1, {6, 5}, 3, 9})), png));
        for (const char* text : {"", "{", "[]", "7", "{}", "\xff\xfe{}"}) {
            write(sidecarOf(png), text);
            TXN_FAILS_WITH(loadTexton(png), ErrorCode::Unreadable);
        }
        fs::remove(sidecarOf(png));
        TXN_FAILS_WITH(loadTexton(png), ErrorCode::Unreadable); // a picture like any other
        const auto picture = loadTextonOrImage(png);
        TXN_OK(picture);
        QVERIFY(std::holds_alternative<LoadedImage>(*picture));
        TXN_FAILS_WITH(loadTexton(m_path / "missing.texton"), ErrorCode::NotFound);
        TXN_FAILS_WITH(loadTexton(m_path / "missing.png"), ErrorCode::NotFound);
        TXN_FAILS_WITH(loadTexton(m_path), ErrorCode::Unreadable);

        // Beside a `.texton`, which says all by itself, a foreign sidecar is not an error.
        const fs::path text = m_path / "t.texton";
        const TextonAsset asset = assetOf(makeTexton({1, 1, {6, 5}, 3, 9}));
        TXN_OK(save(asset, text));
        write(sidecarOf(text), "{}");
        const auto loaded = loadTexton(text);
        TXN_OK(loaded);
        QVERIFY(loaded->texton == asset.texton);
        QVERIFY(loaded->process == NoiseProcess::Stratified);
    }

    void whatAFormatCannotHoldIsAnError() {
        const auto two = assetOf(makeTexton({1, 2, {6, 5}, 3, 10}));
        const auto five = assetOf(makeTexton({1, 1, {6, 5}, 5, 10}));
        const auto one = assetOf(makeTexton({1, 1, {6, 5}, 3, 10}));
        TXN_FAILS_WITH(save(two, m_path / "t.texton"), ErrorCode::Unsupported);
        TXN_FAILS_WITH(save(five, m_path / "t.texton"), ErrorCode::Unsupported);
        TXN_FAILS_WITH(save(five, m_path / "t.png"), ErrorCode::Unsupported);
        for (const char* name : {"t.jpg", "t", "t.texton.bak", "t.tif"})
            TXN_FAILS_WITH(save(one, m_path / name), ErrorCode::Unsupported);
        TXN_FAILS_WITH(save(one, m_path / "none" / "t.exr"), ErrorCode::Unwritable);
        QCOMPARE(entries(), 0);
        TXN_OK(save(one, m_path / "T.EXR")); // endings in any case
        TXN_OK(loadTexton(m_path / "T.EXR"));
    }

    void allFilesAppearOrNone() {
        const auto two = assetOf(makeTexton({1, 2, {6, 5}, 3, 11}));
        write(m_path / "a.exr", "old");
        const std::vector<fs::path> mixed{m_path / "a.exr", m_path / "b.png", m_path / "c.texton"};
        TXN_FAILS_WITH(saveTexton(two, mixed), ErrorCode::Unsupported); // the last one
        QCOMPARE(entries(), 1);
        QCOMPARE(contentOf(m_path / "a.exr"), std::string("old"));

        const auto one = assetOf(makeTexton({1, 1, {6, 5}, 3, 11}));
        const auto written = saveTexton(one, mixed);
        TXN_OK(written);
        QCOMPARE(written->size(), std::size_t{6});
        QCOMPARE(entries(), 6);
        for (const fs::path& path : *written)
            QVERIFY(fs::is_regular_file(path));
        QVERIFY(*loadTexton(mixed[0]) == one);
        QVERIFY(*loadTexton(mixed[2]) == one);

        const std::vector<fs::path> twice{m_path / "d.exr", m_path / "d.exr"};
        TXN_FAILS_WITH(saveTexton(one, twice), ErrorCode::InvalidArgument);
        QCOMPARE(entries(), 6);
    }

    void textonsAreToldFromPictures() {
        const auto asset = assetOf(makeTexton({1, 1, {6, 5}, 3, 12}));
        // By content, not by name.
        TXN_OK(save(asset, m_path / "t.texton"));
        fs::rename(m_path / "t.texton", m_path / "renamed.txt");
        const auto loaded = loadTextonOrImage(m_path / "renamed.txt");
        TXN_OK(loaded);
        QVERIFY(std::holds_alternative<TextonAsset>(*loaded));
        // A plain EXR picture is none.
        TXN_OK(saveImage(asset.texton.kernels[0], m_path / "plain.exr"));
        const auto picture = loadTextonOrImage(m_path / "plain.exr");
        TXN_OK(picture);
        QVERIFY(std::holds_alternative<LoadedImage>(*picture));
        TXN_FAILS_WITH(loadTexton(m_path / "plain.exr"), ErrorCode::Unreadable);
    }

    void equalTextonsGiveEqualBytes() {
        const auto asset = assetOf(makeTexton({3, 1, {16, 12}, 3, 13}));
        for (const char* ending : {".texton", ".png"}) {
            TXN_OK(save(asset, m_path / (std::string("a") + ending)));
            TXN_OK(save(asset, m_path / (std::string("b") + ending)));
            const auto content = contentOf(m_path / (std::string("a") + ending));
            QVERIFY(!content.empty());
            QVERIFY(content == contentOf(m_path / (std::string("b") + ending)));
        }
    }

  private:
    int entries() const {
        return static_cast<int>(
            std::distance(fs::directory_iterator(m_path), fs::directory_iterator()));
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    fs::path m_path;
};

QTEST_APPLESS_MAIN(TestTextonFiles)
#include "TestTextonFiles.moc"
