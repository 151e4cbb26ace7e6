// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/ExportPlan.h"

#include <optional>

namespace txn::app {

class Settings;

/// Plans that the artist keeps under names, without their folders. Interface thread.
class ExportPresets {
  public:
    explicit ExportPresets(Settings& settings) : m_settings(settings) {}

    QStringList names() const;
    /// With an empty folder; nothing for an unknown name. What cannot be read has its default.
    std::optional<ExportPlan> find(const QString& name) const;
    void save(const QString& name, const ExportPlan& plan);
    void remove(const QString& name);

  private:
    Settings& m_settings;
};

} // namespace txn::app
