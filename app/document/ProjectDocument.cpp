// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/ProjectDocument.h"

#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>
#include <array>
#include <atomic>

namespace txn::app {

/// The whole project before and after: it is small, and undo then cannot forget anything.
class ProjectCommand : public QUndoCommand {
  public:
    ProjectCommand(ProjectDocument& document, const QString& text, Project after, Gesture gesture)
        : QUndoCommand(text), m_document(document), m_before(document.project()),
          m_after(std::move(after)), m_gesture(gesture) {}

    void undo() override { m_document.setProject(m_before); }
    void redo() override { m_document.setProject(m_after); }
    int id() const override { return m_gesture.id == 0 ? -1 : 1; }
    bool mergeWith(const QUndoCommand* other) override {
        const auto* next = static_cast<const ProjectCommand*>(other); // of equal id()
        if (next->m_gesture.id != m_gesture.id)
            return false;
        m_after = next->m_after;
        setObsolete(m_before == m_after);
        return true;
    }

  private:
    ProjectDocument& m_document;
    Project m_before;
    Project m_after;
    Gesture m_gesture;
};

Gesture Gesture::next() {
    static std::atomic<quint64> count{0};
    return {++count};
}

ProjectDocument::ProjectDocument(QObject* parent) : QObject(parent) {
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, &ProjectDocument::titleChanged);
}

void ProjectDocument::change(const QString& text,
                             const std::function<void(Project&)>& edit,
                             Gesture gesture) {
    Project after = m_project;
    edit(after);
    if (after == m_project)
        return;
    m_undoStack.push(new ProjectCommand(*this, text, std::move(after), gesture));
}

void ProjectDocument::changeView(const std::function<void(ViewState&)>& edit) {
    ViewState after = m_view;
    edit(after);
    if (after == m_view)
        return;
    m_view = after;
    emit viewChanged();
}

void ProjectDocument::reset(Project project, ViewState view, const QString& filePath) {
    m_undoStack.clear();
    m_filePath = filePath;
    m_recovered = false;
    m_project = std::move(project);
    m_view = view;
    emit replaced();
    emit projectChanged();
    emit viewChanged();
    emit titleChanged();
}

void ProjectDocument::setSaved(const QString& filePath) {
    m_filePath = filePath;
    m_recovered = false;
    m_undoStack.setClean();
    emit titleChanged();
}

void ProjectDocument::markRecovered() {
    m_recovered = true;
    emit titleChanged();
}

QString ProjectDocument::title() const {
    if (!m_filePath.isEmpty())
        return QFileInfo(m_filePath).fileName();
    if (m_project.source)
        return m_project.source->name();
    if (m_project.importedTexton && !m_project.importedTexton->exemplarName.empty())
        return QString::fromStdString(m_project.importedTexton->exemplarName);
    return tr("Untitled");
}

void ProjectDocument::setProject(const Project& project) {
    const std::array before{m_project.source, m_project.mix.source};
    const std::array now{project.source, project.mix.source};
    m_project = project;
    // The undo stack may keep many photos, but not their pixels.
    for (const auto& source : before) {
        if (source && !std::ranges::count(now, source))
            Source::letGo(source);
    }
    for (const auto& source : now) {
        if (source && !std::ranges::count(before, source))
            source->hold();
    }
    emit projectChanged();
    if (before.front() != now.front())
        emit titleChanged();
}

} // namespace txn::app
