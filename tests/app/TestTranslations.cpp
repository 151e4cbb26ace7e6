// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

namespace {

struct Message {
    QString context;
    QString source;
    QStringList translations; ///< several where the number decides
    bool numerus = false;
    bool finished = true;
};

QList<Message> read(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QList<Message> messages;
    QString context;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.name() == QLatin1String("message")) {
            Message message;
            message.context = context;
            message.numerus = xml.attributes().value("numerus") == QLatin1String("yes");
            messages.append(message);
        } else if (xml.name() == QLatin1String("source")) {
            messages.last().source = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            messages.last().finished = !xml.attributes().hasAttribute("type");
            if (!messages.last().numerus)
                messages.last().translations.append(xml.readElementText());
        } else if (xml.name() == QLatin1String("numerusform")) {
            messages.last().translations.append(xml.readElementText());
        }
    }
    return messages;
}

/// %1, %n, {name}: what the program fills in.
QStringList placesIn(const QString& text) {
    static const QRegularExpression pattern("%n|%L?\\d|\\{[a-z]+\\}");
    QStringList places;
    for (auto matches = pattern.globalMatch(text); matches.hasNext();)
        places.append(matches.next().captured());
    places.sort();
    return places;
}

const QString kFolder = QStringLiteral(TXN_SOURCE_DIR "/translations/");

} // namespace

class TestTranslations : public QObject {
    Q_OBJECT

  private slots:
    void everythingIsTranslated_data() {
        QTest::addColumn<QString>("file");
        for (const QString& file : QDir(kFolder).entryList({"txn_*.ts"}))
            QTest::newRow(file.toUtf8()) << file;
    }
    void everythingIsTranslated() {
        QFETCH(QString, file);
        const auto messages = read(kFolder + file);
        QVERIFY(messages.size() >= (file == "txn_en.ts" ? 1 : 400));
        for (const Message& message : messages) {
            const QByteArray where = (message.context + ": " + message.source).toUtf8();
            QVERIFY2(message.finished, where);
            QVERIFY2(message.translations.size() >= (message.numerus ? 2 : 1), where);
            for (const QString& translation : message.translations) {
                QVERIFY2(!translation.trimmed().isEmpty(), where);
                QCOMPARE(placesIn(translation), placesIn(message.source));
                QVERIFY2(translation.endsWith("...") == message.source.endsWith("..."), where);
            }
        }
    }

    /// Nothing was added to the program since the translations were gathered.
    void nothingIsMissing_data() {
        QTest::addColumn<QString>("file");
        for (const char* file : {"txn_de.ts", "txn_es.ts", "txn_fr.ts"})
            QTest::newRow(file) << file;
    }
    void nothingIsMissing() {
        QFETCH(QString, file);
        QString lupdate = QStandardPaths::findExecutable("lupdate6");
        if (lupdate.isEmpty())
            lupdate = QStandardPaths::findExecutable("lupdate", {"/usr/lib/qt6/bin"});
        if (lupdate.isEmpty())
            QSKIP("there is no lupdate");
        QTemporaryDir folder;
        const QString copy = folder.filePath(file);
        QVERIFY(QFile::copy(kFolder + file, copy));
        QProcess process;
        process.setWorkingDirectory(TXN_SOURCE_DIR);
        process.start(
            lupdate,
            {"-silent", "-locations", "none", "-no-obsolete", "-I", ".", "app", "-ts", copy});
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitCode(), 0);
        QCOMPARE(process.readAllStandardError(), QByteArray());
        for (const Message& message : read(copy))
            QVERIFY2(message.finished, (message.context + ": " + message.source).toUtf8());
    }
};

QTEST_APPLESS_MAIN(TestTranslations)
#include "TestTranslations.moc"
