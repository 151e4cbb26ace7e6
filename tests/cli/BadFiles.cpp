// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/BadFiles.h"

#include <QByteArrayView>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>
#include <algorithm>
#include <cstring>
#include <limits>
#include <random>

namespace txn::test {
namespace {

constexpr qint32 kLargest = std::numeric_limits<qint32>::max();

template <class Number>
QByteArray little(Number value) {
    QByteArray bytes(sizeof value, '\0');
    qToLittleEndian(value, bytes.data());
    return bytes;
}

template <class Number>
QByteArray big(Number value) {
    QByteArray bytes(sizeof value, '\0');
    qToBigEndian(value, bytes.data());
    return bytes;
}

QByteArray little(float value) {
    quint32 bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return little(bits);
}

/// The checksum of PNG chunks.
quint32 crc32(const QByteArray& bytes) {
    quint32 crc = 0xffffffffU;
    for (const char byte : bytes) {
        crc ^= static_cast<quint8>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
    }
    return ~crc;
}

QByteArray chunk(const QByteArray& typeAndData) {
    return big(static_cast<quint32>(typeAndData.size() - 4)) + typeAndData +
           big(crc32(typeAndData));
}

QByteArray
pngFile(quint32 width, quint32 height, quint8 depth, quint8 colorType, const QByteArray& rows) {
    QByteArray header = "IHDR" + big(width) + big(height);
    header += static_cast<char>(depth);
    header += static_cast<char>(colorType);
    header += QByteArray(3, '\0');
    // qCompress puts the length in front of the zlib stream.
    return QByteArray("\x89PNG\r\n\x1a\n", 8) + chunk(header) +
           chunk("IDAT" + qCompress(rows).mid(4)) + chunk("IEND");
}

QByteArray exrText(const QByteArray& text) {
    return text + '\0';
}

QByteArray exrAttribute(const QByteArray& name, const QByteArray& type, const QByteArray& value) {
    return exrText(name) + exrText(type) + little(static_cast<qint32>(value.size())) + value;
}

QByteArray exrBox(qint32 left, qint32 top, qint32 right, qint32 bottom) {
    return little(left) + little(top) + little(right) + little(bottom);
}

/// The header without its closing 0.
QByteArray exrHeader(const ExrLayout& layout, const QByteArray& box) {
    QByteArray channels;
    for (auto it = layout.channels.begin(); it != layout.channels.end(); ++it)
        channels += exrText(it.key()) + little(qint32{2}) + QByteArray(4, '\0') +
                    little(qint32{1}) + little(qint32{1});
    channels += '\0';
    QByteArray header("\x76\x2f\x31\x01\x02\0\0\0", 8);
    header += exrAttribute("channels", "chlist", channels);
    header += exrAttribute("compression", "compression", QByteArray(1, '\0'));
    header += exrAttribute("dataWindow", "box2i", box);
    header += exrAttribute("displayWindow", "box2i", box);
    header += exrAttribute("lineOrder", "lineOrder", QByteArray(1, '\0'));
    header += exrAttribute("pixelAspectRatio", "float", little(1.0F));
    header += exrAttribute("screenWindowCenter", "v2f", little(0.0F) + little(0.0F));
    header += exrAttribute("screenWindowWidth", "float", little(1.0F));
    for (auto it = layout.attributes.begin(); it != layout.attributes.end(); ++it)
        header += exrAttribute(it.key(), "string", it.value());
    return header;
}

/// An EXR that is nothing but a header with this window.
QByteArray exrOfWindow(qint32 left, qint32 top, qint32 right, qint32 bottom) {
    return exrHeader({}, exrBox(left, top, right, bottom)) + QByteArray(1, '\0') +
           QByteArray(64, '\0');
}

/// A TIFF of one uncompressed strip with 12 bytes of pixels.
QByteArray tiffBytes(quint32 width, quint32 height) {
    struct Entry {
        quint16 tag;
        quint32 value;
    };
    const QList<Entry> entries{{256, width},
                               {257, height},
                               {258, 8},
                               {259, 1},
                               {262, 1},
                               {273, 8},
                               {277, 1},
                               {278, height},
                               {279, 12}};
    QByteArray file = QByteArray("II*\0", 4) + little(quint32{20}) + QByteArray(12, '\x40') +
                      little(static_cast<quint16>(entries.size()));
    for (const Entry& entry : entries)
        file += little(entry.tag) + little(quint16{4}) + little(quint32{1}) + little(entry.value);
    return file + little(quint32{0});
}

QByteArray bmpBytes(qint32 width, qint32 height) {
    return "BM" + little(quint32{66}) + QByteArray(4, '\0') + little(quint32{54}) +
           little(quint32{40}) + little(width) + little(height) + little(quint16{1}) +
           little(quint16{24}) + QByteArray(24, '\0') + QByteArray(12, '\x40');
}

QByteArray tgaBytes(quint16 width, quint16 height, char type) {
    QByteArray file(12, '\0');
    file[2] = type;
    return file + little(width) + little(height) + QByteArray("\x18\0", 2) + QByteArray(12, '\x40');
}

QByteArray hdrBytes(const QByteArray& size) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + QByteArray(64, '\x40');
}

QByteArray webpBytes(const QByteArray& chunks) {
    return "RIFF" + little(static_cast<quint32>(chunks.size() + 4)) + "WEBP" + chunks;
}

QByteArray webpCanvas(quint32 width, quint32 height) {
    return webpBytes("VP8X" + little(quint32{10}) + QByteArray(4, '\0') +
                     little(width - 1).left(3) + little(height - 1).left(3));
}

/// Another size in the frame header.
QByteArray jpegOfSize(QByteArray good, quint16 width, quint16 height) {
    const qsizetype frame = good.indexOf(QByteArray("\xff\xc0", 2));
    return good.replace(frame + 5, 4, big(height) + big(width));
}

/// Without the file's middle.
QByteArray overwritten(QByteArray bytes, char value) {
    const qsizetype length = bytes.size() / 4;
    return bytes.replace((bytes.size() - length) / 2, length, QByteArray(length, value));
}

/// The start of the file, then chance.
QByteArray scrambled(const QByteArray& bytes) {
    std::minstd_rand random;
    QByteArray result = bytes.left(12);
    for (int i = 0; i < 4000; ++i)
        result += static_cast<char>(random() & 0xffU);
    return result;
}

void addHostileHeaders(const GoodPictures& good, QList<NamedBytes>& files) {
    const auto add = [&](const char* name, const QByteArray& bytes) {
        files.append(NamedBytes{name, bytes});
    };
    add("largest.png", pngBytes(kLargest, kLargest));
    add("60000.png", pngBytes(60000, 60000));
    add("no-columns.png", pngBytes(0, 4));
    add("color-type.png", pngFile(4, 4, 8, 99, QByteArray(52, '\0')));
    add("one-row-less.png", pngFile(4, 4, 8, 2, QByteArray(39, '\0')));
    add("no-pixels.png",
        QByteArray("\x89PNG\r\n\x1a\n", 8) +
            chunk("IHDR" + big(quint32{4}) + big(quint32{4}) + QByteArray("\x08\x02\0\0\0", 5)) +
            chunk("IEND"));
    QByteArray chunkLength = pngBytes(4, 4);
    add("chunk-length.png", chunkLength.replace(33, 4, big(0xffffffffU)));

    add("largest.jpg", jpegOfSize(good["jpg"], 65535, 65535));
    add("no-rows.jpg", jpegOfSize(good["jpg"], 48, 0));
    add("more-rows.jpg", jpegOfSize(good["jpg"], 48, 320));
    // What a camera's card that was pulled out leaves: the end marker is there, the pixels are not.
    add("half-with-end.jpg", good["jpg"].left(good["jpg"].size() / 2) + "\xff\xd9");

    add("largest.tif", tiffBytes(kLargest, kLargest));
    add("short-strip.tif", tiffBytes(400, 3));
    QByteArray directory = tiffBytes(4, 3);
    add("directory.tif", directory.replace(4, 4, little(0x7ffffff0U)));

    add("largest.exr", exrOfWindow(0, 0, kLargest - 1, kLargest - 1));
    add("inverted.exr", exrOfWindow(5, 5, 0, 0));
    add("overflow.exr", exrOfWindow(-kLargest, -kLargest, kLargest, kLargest));

    add("largest.hdr", hdrBytes("-Y 2147483647 +X 2147483647"));
    add("negative.hdr", hdrBytes("-Y -5 +X 5"));

    add("largest.tga", tgaBytes(65535, 65535, 2));
    add("run-length.tga", tgaBytes(65535, 65535, 10));

    add("largest.bmp", bmpBytes(kLargest, kLargest));
    add("upside-down.bmp", bmpBytes(4, std::numeric_limits<qint32>::min()));

    add("largest.webp", webpCanvas(1U << 24U, 1U << 24U));
    add("lossless.webp",
        webpBytes("VP8L" + little(quint32{6}) + QByteArray("\x2f\xff\xff\xff\x0f\0", 6)));
}

} // namespace

QByteArray pngBytes(quint32 width, quint32 height, const QByteArray& pixels) {
    // Hostile sizes get no more pixels than these.
    const quint32 columns = std::min(width, 256U);
    const quint32 lines = std::min(height, 256U);
    const qsizetype rowBytes = static_cast<qsizetype>(columns) * 3;
    QByteArray rows;
    for (quint32 y = 0; y < lines; ++y) {
        const auto at = static_cast<qsizetype>(y) * rowBytes;
        rows += '\0' + (pixels.isEmpty() ? QByteArray(rowBytes, '\x40') : pixels.mid(at, rowBytes));
    }
    return pngFile(width, height, 8, 2, rows);
}

QByteArray exrBytes(const ExrLayout& layout) {
    QByteArray file =
        exrHeader(layout, exrBox(0, 0, layout.width - 1, layout.height - 1)) + QByteArray(1, '\0');
    const qsizetype rowBytes = layout.channels.size() * layout.width * 4;
    const qsizetype first = file.size() + 8 * static_cast<qsizetype>(layout.height);
    for (qint32 y = 0; y < layout.height; ++y)
        file += little(static_cast<quint64>(first + y * (rowBytes + 8)));
    for (qint32 y = 0; y < layout.height; ++y) {
        file += little(y) + little(static_cast<qint32>(rowBytes));
        for (const float value : layout.channels) {
            for (qint32 x = 0; x < layout.width; ++x)
                file += little(x == 0 && y == 0 ? layout.firstSample : value);
        }
    }
    return file;
}

QByteArray textonBytes(const TextonText& text) {
    QByteArray file = text.magic + "\n" + text.version + "\n" + text.order + "\n" + text.mean +
                      "\n" + text.size + "\n";
    for (int i = 0; i < text.samples; ++i) {
        const bool isInner = i % 4 % 3 != 0 && i / 4 % 3 != 0;
        file += (isInner ? text.inner : text.border) + "\n";
    }
    return file;
}

QList<NamedBytes> brokenPictures(const GoodPictures& good) {
    QList<NamedBytes> files;
    for (auto it = good.begin(); it != good.end(); ++it) {
        const QByteArray ending = "." + it.key();
        const QByteArray& bytes = it.value();
        files.append(NamedBytes{"half" + ending, bytes.left(bytes.size() / 2)});
        // Some decoders pretend to have read these. A TGA ends in a signature that it may lack.
        if (it.key() != "tga")
            files.append(NamedBytes{"end-lost" + ending, bytes.chopped(2)});
        const bool hasChecksums = it.key() == "png" || it.key() == "tif" || it.key() == "exr";
        if (hasChecksums || it.key() == "jpg")
            files.append(NamedBytes{"overwritten" + ending, overwritten(bytes, '\xff')});
    }
    files.append(NamedBytes{"empty.png", {}});
    files.append(NamedBytes{"empty.tga", {}});
    files.append(NamedBytes{"one-byte.bmp", "B"});
    for (const char* ending : {"jpg", "tif", "exr", "webp"})
        files.append(NamedBytes{QByteArray("start.") + ending, good[ending].left(10)});
    for (const char* ending : {"jpg", "tif", "exr", "hdr", "webp"})
        files.append(NamedBytes{QByteArray("scrambled.") + ending, scrambled(good[ending])});
    for (const char* ending : {"png", "tga"})
        files.append(
            {QByteArray("text.") + ending, "This is no picture, whatever its name says.\n"});
    files.append(NamedBytes{"texton.png", textonBytes()});
    files.append(
        NamedBytes{"gif.png", QByteArray("GIF89a\x04\0\x04\0\xf0\0\0", 13) + QByteArray(64, '\0')});
    files.append(NamedBytes{"drawing.jpg",
                            "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>"});
    files.append(NamedBytes{"zeros.png", QByteArray(5000, '\0')});
    files.append(NamedBytes{"no-name", "neither a name nor a picture"});
    addHostileHeaders(good, files);
    return files;
}

QList<NamedBytes> brokenTextonTexts() {
    QList<NamedBytes> files;
    const auto add = [&](const char* name, const TextonText& text) {
        files.append(NamedBytes{QByteArray(name) + ".texton", textonBytes(text)});
    };
    files.append(NamedBytes{"empty.texton", {}});
    files.append(NamedBytes{"magic-only.texton", "TEXTON"});
    files.append(NamedBytes{"scrambled.texton", scrambled("TEXTON\n1\n1\n")});
    files.append(NamedBytes{"png.texton", pngBytes(4, 4)});
    add("version-2", {.version = "2"});
    add("mean-huge", {.mean = "0 1e999 0"});
    add("mean-beyond-float", {.mean = "0 1e300 0"});
    add("size-negative", {.size = "-4 4"});
    add("size-border-only", {.size = "2 2"});
    add("size-larger", {.size = "40 40"});
    add("size-largest", {.size = "2147483647 2147483647"});
    add("coefficient-nan", {.inner = "nan 0 0"});
    add("border", {.border = "0 0.5 0"});
    add("one-line-less", {.samples = 15});
    return files;
}

QList<NamedBytes> brokenExrTextons() {
    const QMap<QByteArray, QByteArray> description{{"texton:format", "\"texton\""},
                                                   {"texton:version", "1"},
                                                   {"texton:exemplar", "\"wood.png\""},
                                                   {"texton:channels", "3"},
                                                   {"texton:kernels", "1"},
                                                   {"texton:interpolation_order", "1"},
                                                   {"texton:frame", "1"},
                                                   {"texton:support_width", "2"},
                                                   {"texton:support_height", "2"},
                                                   {"texton:support_shape", "\"rectangle\""},
                                                   {"texton:mean", "[0.5,0.5,0.5]"},
                                                   {"texton:scale", "[1.0,1.0,1.0]"},
                                                   {"texton:bias", "[0.0,0.0,0.0]"},
                                                   {"texton:color_space", "\"encoded\""},
                                                   {"texton:mni", "12.0"},
                                                   {"texton:process", "\"stratified\""},
                                                   {"texton:seed", "1"}};
    QList<NamedBytes> files;
    const auto add = [&](const char* name, const char* key, const char* value) {
        ExrLayout layout;
        layout.attributes = description;
        if (value != nullptr)
            layout.attributes[key] = value;
        else
            layout.attributes.remove(key);
        files.append(NamedBytes{QByteArray("texton-") + name + ".exr", exrBytes(layout)});
    };
    add("version-2", "texton:version", "2");
    add("more-channels", "texton:channels", "16");
    add("two-kernels", "texton:kernels", "2");
    add("wide", "texton:support_width", "3");
    add("nested", "texton:scale", QByteArray(10000, '[').constData());
    add("scale-huge", "texton:scale", "[1e300,1,1]");

    ExrLayout other;
    other.attributes = description;
    other.channels = {{"X", 0.1F}, {"Y", 0.1F}, {"Z", 0.1F}};
    files.append(NamedBytes{"texton-other-channels.exr", exrBytes(other)});
    ExrLayout nan;
    nan.attributes = description;
    for (float& value : nan.channels)
        value = std::numeric_limits<float>::quiet_NaN();
    files.append(NamedBytes{"texton-nan.exr", exrBytes(nan)});
    files.append(NamedBytes{"texton-none.exr", exrBytes({})});
    return files;
}

QList<NamedBytes> brokenSidecars(const QByteArray& good) {
    const QJsonObject description = QJsonDocument::fromJson(good).object();
    QList<NamedBytes> files;
    const auto add = [&](const QByteArray& name, const QByteArray& text) {
        files.append(NamedBytes{"sidecar-" + name + ".png", text});
    };
    for (const char* key : {"format", "mean"}) {
        QJsonObject without = description;
        without.remove(key);
        add(QByteArray("without-") + key, QJsonDocument(without).toJson());
        QJsonObject other = description;
        other[key] = QJsonObject{{"a", 1}};
        add(QByteArray("object-") + key, QJsonDocument(other).toJson());
    }
    // As text: numbers that QJsonDocument cannot hold.
    const auto with = [&](const char* name, const char* key, const QByteArray& value) {
        QJsonObject marked = description;
        marked[key] = "MARK";
        add(name, QJsonDocument(marked).toJson().replace("\"MARK\"", value));
    };
    with("version-2", "version", "2");
    with("channels-1", "channels", "1");
    with("kernels-2", "kernels", "2");
    with("order-2", "interpolation_order", "2");
    with("largest", "support_width", "2147483647");
    with("shape", "support_shape", "\"star\"");
    with("mean-beyond-float", "mean", "[1e300,0,0]");
    with("mean-nan", "mean", "[NaN,0,0]");
    with("scale-huge", "scale", "[1e300,1,1]");
    with("mni-0", "mni", "0");
    with("seed-huge", "seed", "4294967296");
    add("empty", {});
    add("half", good.left(good.size() / 2));
    add("array", "[1,2,3]");
    add("not-utf8", "{\"format\":\"\xff\xfe\"}");
    add("nested", QByteArray(10000, '['));
    add("nested-closed", QByteArray(10000, '[') + QByteArray(10000, ']'));
    add("nested-objects", QByteArray("{\"a\":").repeated(10000));
    add("large", QByteArray(3 << 20, ' '));
    return files;
}

} // namespace txn::test
