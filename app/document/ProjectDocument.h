// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/Project.h"

#include <QObject>
#include <QUndoStack>
#include <functional>

namespace txn::app {

/// Which control is being moved, and in which go: changes of equal gestures become one step of the
/// undo stack. The default is equal to none.
struct Gesture {
    quint64 id = 0;
    static Gesture next();
};

/// Owns the project and its undo stack; nobody else changes either. Lives on the interface thread.
class ProjectDocument : public QObject {
    Q_OBJECT

  public:
    explicit ProjectDocument(QObject* parent = nullptr);

    const Project& project() const { return m_project; }
    const ViewState& view() const { return m_view; }
    QUndoStack& undoStack() { return m_undoStack; }

    /// Applies edit to the project as one undoable step called text. A change that changes nothing
    /// is none.
    void
    change(const QString& text, const std::function<void(Project&)>& edit, Gesture gesture = {});

    /// Not undoable, and no reason to ask for saving.
    void changeView(const std::function<void(ViewState&)>& edit);

    /// Another project takes this one's place, with an empty undo stack.
    void reset(Project project, ViewState view, const QString& filePath);

    /// Where it was saved to or opened from; empty: nowhere yet.
    const QString& filePath() const { return m_filePath; }
    void setSaved(const QString& filePath);
    bool isModified() const { return !m_undoStack.isClean() || m_recovered; }
    /// What came back after a crash counts as changed until it is saved.
    void markRecovered();
    /// The file's name, or the exemplar's, or "Untitled".
    QString title() const;

  signals:
    /// By reset(), before the other signals.
    void replaced();
    void projectChanged();
    void viewChanged();
    void titleChanged();

  private:
    friend class ProjectCommand;
    void setProject(const Project& project);

    Project m_project;
    ViewState m_view;
    QUndoStack m_undoStack;
    QString m_filePath;
    bool m_recovered = false;
};

} // namespace txn::app
