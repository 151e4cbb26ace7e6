// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/ProjectDocument.h"
#include "app/jobs/JobRunner.h"

#include <QObject>

namespace txn::app {

/// Changes to a mixture as a whole: its materials and its map. Interface thread.
class MixEditor : public QObject {
    Q_OBJECT

  public:
    MixEditor(ProjectDocument& document, JobRunner& runner, QObject* parent = nullptr);

    /// A and B change places, and the map is inverted: the noise stays as it is.
    void swapMaterials();
    void removeSecond();
    /// All of the map.
    void fill(double rho);
    /// As many equal strips as there are textons, from A on the left (0 degrees, clockwise) to B.
    void makeStrips(double degreesClockwise);
    /// From A on the left to B on the right, without steps, slowly at both ends.
    void makePassage();
    void invertMap();
    void setRepeats(bool repeats);
    /// A grey picture as the map. Takes its size, so that one of its pixels is one of the
    /// exemplar's.
    void importMap(const QString& path);
    void exportMap(const QString& path);

  signals:
    void problem(const QString& message);
    void note(const QString& message);

  private:
    void setMap(const QString& text, const Image& rho);

    ProjectDocument& m_document;
    JobRunner& m_runner;
};

} // namespace txn::app
