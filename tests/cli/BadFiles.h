// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>
#include <QMap>

namespace txn::test {

/// A file to be written into a test's folder.
struct NamedBytes {
    QByteArray name;
    QByteArray bytes;
};

/// An RGB PNG of 8 bits; the pixels are grey unless given.
[[nodiscard]] QByteArray
pngBytes(quint32 width, quint32 height, const QByteArray& pixels = QByteArray());

/// An uncompressed EXR of floats. The samples of a channel are all its value, but for the first
/// pixel.
struct ExrLayout {
    qint32 width = 4;
    qint32 height = 4;
    QMap<QByteArray, float> channels{{"R", 0.25F}, {"G", 0.5F}, {"B", 0.75F}};
    float firstSample = 0.5F;
    QMap<QByteArray, QByteArray> attributes; ///< texts
};
[[nodiscard]] QByteArray exrBytes(const ExrLayout& layout);

/// A `.texton` text whose lines can be put wrong one by one.
struct TextonText {
    QByteArray magic = "TEXTON";
    QByteArray version = "1";
    QByteArray order = "1";
    QByteArray mean = "0.5 0.4 0.3";
    QByteArray size = "4 4";
    QByteArray inner = "0.1 0.2 -0.1";
    QByteArray border = "0 0 0";
    int samples = 16; ///< lines of coefficients, for the size 4 4
};
[[nodiscard]] QByteArray textonBytes(const TextonText& text = {});

/// The good files that others are derived from, by ending: png, jpg, tif, exr, hdr, tga, bmp, webp.
using GoodPictures = QMap<QByteArray, QByteArray>;

/// Empty, cut, overwritten, mislabelled and hostile pictures.
[[nodiscard]] QList<NamedBytes> brokenPictures(const GoodPictures& good);

/// Files called .texton that are none.
[[nodiscard]] QList<NamedBytes> brokenTextonTexts();

/// EXR files that claim to be textons and contradict themselves.
[[nodiscard]] QList<NamedBytes> brokenExrTextons();

/// Descriptions that do not fit the PNG texton they are made for, whose own one is good.
[[nodiscard]] QList<NamedBytes> brokenSidecars(const QByteArray& good);

} // namespace txn::test
