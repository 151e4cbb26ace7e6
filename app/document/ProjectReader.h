// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/Project.h"

#include <QCborArray>
#include <QCborMap>

namespace txn::app {

/// Takes values out of a map of a file that nobody vouches for. What is missing gives the default;
/// what is there and out of its range or of another type is remembered: isGood() turns false.
class CborReader {
  public:
    explicit CborReader(const QCborMap& map) : m_map(map) {}

    bool isGood() const { return m_good; }
    bool has(const char* key) const { return m_map.contains(QLatin1String(key)); }
    qint64 integer(const char* key, qint64 low, qint64 high, qint64 standard);
    double number(const char* key, double low, double high, double standard);
    bool flag(const char* key, bool standard);
    QString text(const char* key) const { return m_map.value(QLatin1String(key)).toString(); }
    QByteArray bytes(const char* key) const {
        return m_map.value(QLatin1String(key)).toByteArray();
    }
    CborReader map(const char* key) const {
        return CborReader(m_map.value(QLatin1String(key)).toMap());
    }
    QCborArray array(const char* key) const { return m_map.value(QLatin1String(key)).toArray(); }
    void fail() { m_good = false; }

  private:
    QCborMap m_map;
    bool m_good = true;
};

// Each gives false where something is out of its range.
[[nodiscard]] bool readEdit(CborReader reader, ExemplarEdit& edit);
[[nodiscard]] bool readGaussian(CborReader reader, GaussianSettings& gaussian);
[[nodiscard]] bool readSettings(CborReader reader, TextonSettings& texton);
[[nodiscard]] bool readNoise(CborReader reader, NoiseSettings& noise);
/// All but the exemplar and its edit.
[[nodiscard]] bool readMixSettings(CborReader& reader, MixSettings& mix);
[[nodiscard]] bool readView(CborReader reader, ViewState& view);
[[nodiscard]] Result<TextonAsset> readTextonAsset(CborReader reader);

} // namespace txn::app
