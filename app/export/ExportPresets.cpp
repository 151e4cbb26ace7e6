// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/ExportPresets.h"

#include "app/settings/Settings.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace txn::app {
namespace {

const QString kKey = QStringLiteral("export-presets");

/// A plan without its folder, which is remembered apart.
QJsonObject toJson(const ExportPlan& plan) {
    return {{QStringLiteral("kind"), static_cast<int>(plan.kind)},
            {QStringLiteral("name"), plan.nameTemplate},
            {QStringLiteral("exr"), plan.textonExr},
            {QStringLiteral("png"), plan.textonPng},
            {QStringLiteral("texton"), plan.textonFile},
            {QStringLiteral("width"), plan.size.width},
            {QStringLiteral("height"), plan.size.height},
            {QStringLiteral("tile"), plan.tileable},
            {QStringLiteral("format"), static_cast<int>(plan.format)},
            {QStringLiteral("depth"), static_cast<int>(plan.depth)}};
}

ExportPlan fromJson(const QJsonObject& json) {
    ExportPlan plan;
    plan.kind = static_cast<ExportKind>(std::clamp(json.value(QLatin1String("kind")).toInt(),
                                                   0,
                                                   static_cast<int>(ExportKind::Mixture)));
    plan.nameTemplate = json.value(QLatin1String("name")).toString();
    plan.textonExr = json.value(QLatin1String("exr")).toBool(true);
    plan.textonPng = json.value(QLatin1String("png")).toBool();
    plan.textonFile = json.value(QLatin1String("texton")).toBool();
    const auto side = [&](const char* key, int standard) {
        return std::clamp(json.value(QLatin1String(key)).toInt(standard),
                          1,
                          ExportPlan::kMaxSidePx);
    };
    plan.size = {side("width", plan.size.width), side("height", plan.size.height)};
    plan.tileable = json.value(QLatin1String("tile")).toBool(true);
    for (const ExportFormat& each : kExportFormats) {
        if (static_cast<int>(each.format) == json.value(QLatin1String("format")).toInt() &&
            static_cast<int>(each.depth) == json.value(QLatin1String("depth")).toInt()) {
            plan.format = each.format;
            plan.depth = each.depth;
        }
    }
    return plan;
}

QJsonObject all(const Settings& settings) {
    return QJsonDocument::fromJson(settings.json(kKey)).object();
}

void keep(Settings& settings, const QJsonObject& presets) {
    settings.setJson(kKey, QJsonDocument(presets).toJson(QJsonDocument::Compact));
}

} // namespace

QStringList ExportPresets::names() const {
    return all(m_settings).keys();
}

std::optional<ExportPlan> ExportPresets::find(const QString& name) const {
    const QJsonObject presets = all(m_settings);
    const auto found = presets.find(name);
    return found == presets.end() ? std::nullopt : std::optional(fromJson(found->toObject()));
}

void ExportPresets::save(const QString& name, const ExportPlan& plan) {
    QJsonObject presets = all(m_settings);
    presets.insert(name, toJson(plan));
    keep(m_settings, presets);
}

void ExportPresets::remove(const QString& name) {
    QJsonObject presets = all(m_settings);
    presets.remove(name);
    keep(m_settings, presets);
}

} // namespace txn::app
