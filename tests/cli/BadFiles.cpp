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
        files.append({name, bytes});
    };
    add("largest.png", pngBytes(kLargest, kLargest));
    add("60000.png", pngBytes(60000, 60000));
    add("negative.png", pngBytes(0xfffffff0U, 4));
    add("no-columns.png", pngBytes(0, 4));
    add("no-rows.png", pngBytes(4, 0));
    add("depth.png", pngFile(4, 4, 77, 2, QByteArray(52, '\0')));
    add("color-type.png", pngFile(4, 4, 8, 99, QByteArray(52, '\0')));
    add("no-palette.png", pngFile(4, 4, 8, 3, QByteArray(20, '\0')));
    add("one-row-less.png", pngFile(4, 4, 8, 2, QByteArray(39, '\0')));
    add("no-pixels.png",
        QByteArray("\x89PNG\r\n\x1a\n", 8) +
            chunk("IHDR" + big(quint32{4}) + big(quint32{4}) + QByteArray("\x08\x02\0\0\0", 5)) +
            chunk("IEND"));
    QByteArray chunkLength = pngBytes(4, 4);
    add("chunk-length.png", chunkLength.replace(33, 4, big(0xffffffffU)));

    add("largest.jpg", jpegOfSize(good["jpg"], 65535, 65535));
    add("60000.jpg", jpegOfSize(good["jpg"], 60000, 60000));
    add("no-columns.jpg", jpegOfSize(good["jpg"], 0, 32));
    add("no-rows.jpg", jpegOfSize(good["jpg"], 48, 0));
    add("more-rows.jpg", jpegOfSize(good["jpg"], 48, 320));
    // What a camera's card that was pulled out leaves: the end marker is there, the pixels are not.
    add("half-with-end.jpg", good["jpg"].left(good["jpg"].size() / 2) + "\xff\xd9");

    add("largest.tif", tiffBytes(kLargest, kLargest));
    add("60000.tif", tiffBytes(60000, 60000));
    add("negative.tif", tiffBytes(0xfffffffbU, 0xfffffffbU));
    add("no-columns.tif", tiffBytes(0, 3));
    add("no-rows.tif", tiffBytes(4, 0));
    add("short-strip.tif", tiffBytes(40, 3));
    QByteArray directory = tiffBytes(4, 3);
    add("directory.tif", directory.replace(4, 4, little(0x7ffffff0U)));

    add("largest.exr", exrOfWindow(0, 0, kLargest - 1, kLargest - 1));
    add("60000.exr", exrOfWindow(0, 0, 59999, 59999));
    add("inverted.exr", exrOfWindow(5, 5, 0, 0));
    add("overflow.exr", exrOfWindow(-kLargest, -kLargest, kLargest, kLargest));
    add("attribute-length.exr",
        QByteArray("\x76\x2f\x31\x01\x02\0\0\0", 8) + exrText("channels") + exrText("chlist") +
            little(kLargest));

    add("largest.hdr", hdrBytes("-Y 2147483647 +X 2147483647"));
    add("60000.hdr", hdrBytes("-Y 60000 +X 60000"));
    add("beyond.hdr", hdrBytes("-Y 99999999999999999999 +X 4"));
    add("negative.hdr", hdrBytes("-Y -5 +X 5"));
    add("zero.hdr", hdrBytes("-Y 0 +X 0"));
    add("no-size.hdr", hdrBytes("large"));
    add("header-only.hdr", "#?RADIANCE\n");

    add("largest.tga", tgaBytes(65535, 65535, 2));
    add("run-length.tga", tgaBytes(65535, 65535, 10));
    add("zero.tga", tgaBytes(0, 0, 2));
    add("short.tga", tgaBytes(5, 5, 2));

    add("largest.bmp", bmpBytes(kLargest, kLargest));
    add("60000.bmp", bmpBytes(60000, 60000));
    add("negative.bmp", bmpBytes(-5, 5));
    add("upside-down.bmp", bmpBytes(4, std::numeric_limits<qint32>::min()));
    add("zero.bmp", bmpBytes(0, 0));

    add("largest.webp", webpCanvas(1U << 24U, 1U << 24U));
    add("60000.webp", webpCanvas(60000, 60000));
    add("no-picture.webp", webpCanvas(16, 16));
    add("lossless.webp",
        webpBytes("VP8L" + little(quint32{6}) + QByteArray("\x2f\xff\xff\xff\x0f\0", 6)));
    add("lossy.webp",
        webpBytes("VP8 " + little(quint32{10}) +
                  QByteArray("\x30\x01\0\x9d\x01\x2a\xff\x3f\xff\x3f", 10)));
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
        files.append({"empty" + ending, {}});
        files.append({"one-byte" + ending, bytes.left(1)});
        files.append({"start" + ending, bytes.left(10)});
        files.append({"half" + ending, bytes.left(bytes.size() / 2)});
        // Some decoders pretend to have read these. A TGA ends in a signature that it may lack.
        if (it.key() != "tga")
            files.append({"end-lost" + ending, bytes.chopped(2)});
        files.append({"text" + ending, "This is not a picture, whatever its name says.\n"});
        const bool checked =
            it.key() == "png" || it.key() == "jpg" || it.key() == "tif" || it.key() == "exr";
        if (checked)
            files.append({"overwritten" + ending, overwritten(bytes, '\xff')});
        if (checked || it.key() == "webp" || it.key() == "hdr")
            files.append({"scrambled" + ending, scrambled(bytes)});
    }
    files.append({"texton.png", textonBytes()});
    files.append({"gif.png", QByteArray("GIF89a\x04\0\x04\0\xf0\0\0", 13) + QByteArray(64, '\0')});
    files.append(NamedBytes{"drawing.jpg", "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>"});
    files.append({"zeros.png", QByteArray(5000, '\0')});
    files.append(NamedBytes{"no-name", "neither a name nor a picture"});
    addHostileHeaders(good, files);
    return files;
}

QList<NamedBytes> brokenTextonTexts() {
    QList<NamedBytes> files;
    const auto add = [&](const char* name, const TextonText& text) {
        files.append({QByteArray(name) + ".texton", textonBytes(text)});
    };
    files.append(NamedBytes{"empty.texton", {}});
    files.append(NamedBytes{"magic-only.texton", "TEXTON"});
    files.append({"scrambled.texton", scrambled("TEXTON\n1\n1\n")});
    files.append({"png.texton", pngBytes(4, 4)});
    add("other-magic", {.magic = "texton"});
    add("version-2", {.version = "2"});
    add("version-0", {.version = "0"});
    add("no-version", {.version = "one"});
    add("order-2", {.order = "2"});
    add("order-negative", {.order = "-1"});
    add("order-7", {.order = "7"});
    add("order-large", {.order = "99999999999"});
    add("order-fraction", {.order = "1.5"});
    add("mean-nan", {.mean = "nan 0 0"});
    add("mean-infinite", {.mean = "0 -inf 0"});
    add("mean-huge", {.mean = "0 1e999 0"});
    add("mean-beyond-float", {.mean = "0 1e300 0"});
    add("mean-text", {.mean = "red green blue"});
    add("size-zero", {.size = "0 0"});
    add("size-negative", {.size = "-4 4"});
    add("size-border-only", {.size = "2 2"});
    add("size-larger", {.size = "40 40"});
    add("size-huge", {.size = "16384 16384"});
    add("size-largest", {.size = "2147483647 2147483647"});
    add("size-beyond", {.size = "99999999999 4"});
    add("coefficient-nan", {.inner = "nan 0 0"});
    add("coefficient-infinite", {.inner = "0 inf 0"});
    add("coefficient-huge", {.inner = "0 0 1e39"});
    add("coefficient-text", {.inner = "0 0 zero"});
    add("coefficient-comma", {.inner = "0,1 0,2 0,3"});
    add("one-channel", {.inner = "0.1"});
    add("border", {.border = "0 0.5 0"});
    add("border-nan", {.border = "0 0 nan"});
    add("one-line-less", {.samples = 15});
    add("no-coefficients", {.samples = 0});
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
        files.append({QByteArray("texton-") + name + ".exr", exrBytes(layout)});
    };
    add("version-2", "texton:version", "2");
    add("no-channels", "texton:channels", nullptr);
    add("more-channels", "texton:channels", "16");
    add("mean-for-two", "texton:mean", "[0.5,0.5]");
    add("two-kernels", "texton:kernels", "2");
    add("order-2", "texton:interpolation_order", "2");
    add("order-5", "texton:interpolation_order", "5");
    add("wide", "texton:support_width", "3");
    add("largest", "texton:support_width", "2147483647");
    add("not-json", "texton:scale", "[1.0,");
    add("nested", "texton:scale", QByteArray(10000, '[').constData());
    add("scale-huge", "texton:scale", "[1e300,1,1]");

    ExrLayout other;
    other.attributes = description;
    other.channels = {{"X", 0.1F}, {"Y", 0.1F}, {"Z", 0.1F}};
    files.append({"texton-other-channels.exr", exrBytes(other)});
    ExrLayout nan;
    nan.attributes = description;
    for (float& value : nan.channels)
        value = std::numeric_limits<float>::quiet_NaN();
    files.append({"texton-nan.exr", exrBytes(nan)});
    files.append({"texton-none.exr", exrBytes({})});
    return files;
}

QList<NamedBytes> brokenSidecars(const QByteArray& good) {
    const QJsonObject description = QJsonDocument::fromJson(good).object();
    QList<NamedBytes> files;
    const auto add = [&](const QByteArray& name, const QByteArray& text) {
        files.append({"sidecar-" + name + ".png", text});
    };
    for (const QString& key : description.keys()) {
        // The only entry that is for people.
        if (key == "program")
            continue;
        QJsonObject without = description;
        without.remove(key);
        add("without-" + key.toUtf8(), QJsonDocument(without).toJson());
        QJsonObject other = description;
        other[key] = QJsonObject{{"a", 1}};
        add("object-" + key.toUtf8(), QJsonDocument(other).toJson());
    }
    // As text: numbers that QJsonDocument cannot hold.
    const auto with = [&](const char* name, const char* key, const QByteArray& value) {
        QJsonObject marked = description;
        marked[key] = "MARK";
        add(name, QJsonDocument(marked).toJson().replace("\"MARK\"", value));
    };
    with("version-2", "version", "2");
    with("channels-text", "channels", "\"3\"");
    with("channels-half", "channels", "2.5");
    with("channels-1", "channels", "1");
    with("channels-0", "channels", "0");
    with("kernels-2", "kernels", "2");
    with("kernels-huge", "kernels", "1000000");
    with("order-2", "interpolation_order", "2");
    with("frame", "frame", "7");
    with("wider", "support_width", "9");
    with("negative", "support_width", "-8");
    with("largest", "support_width", "2147483647");
    with("beyond-64-bit", "support_width", "99999999999999999999999");
    with("unsigned", "support_width", "18446744073709551615");
    with("huge-width", "support_width", "1e300");
    with("shape", "support_shape", "\"star\"");
    with("mean-two", "mean", "[0.5,0.5]");
    with("mean-texts", "mean", "[\"a\",\"b\",\"c\"]");
    with("mean-beyond-float", "mean", "[1e300,0,0]");
    with("mean-infinite", "mean", "[1e999,0,0]");
    with("mean-nan", "mean", "[NaN,0,0]");
    with("scale-huge", "scale", "[1e300,1,1]");
    with("bias-huge", "bias", "[1,1e300,1]");
    with("color-space", "color_space", "\"violet\"");
    with("mni-0", "mni", "0");
    with("mni-huge", "mni", "1e9");
    with("process", "process", "\"magic\"");
    with("seed-negative", "seed", "-1");
    with("seed-huge", "seed", "4294967296");
    with("format", "format", "\"picture\"");
    add("empty", {});
    add("text", "not JSON at all");
    add("half", good.left(good.size() / 2));
    add("array", "[1,2,3]");
    add("string", "\"texton\"");
    add("null", "null");
    add("not-utf8", "{\"format\":\"\xff\xfe\"}");
    add("nested", QByteArray(10000, '['));
    add("nested-closed", QByteArray(10000, '[') + QByteArray(10000, ']'));
    add("nested-objects", QByteArray("{\"a\":").repeated(10000));
    add("large", QByteArray(3 << 20, ' '));
    return files;
}

} // namespace txn::test
