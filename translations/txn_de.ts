<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Help</name>
    <message>
        <source>Show this help.</source>
        <translation>Diese Hilfe zeigen.</translation>
    </message>
    <message>
        <source>Show the version.</source>
        <translation>Die Version zeigen.</translation>
    </message>
    <message>
        <source>Language of the window, such as en or fr.</source>
        <translation>Sprache des Fensters, etwa en oder de.</translation>
    </message>
    <message>
        <source>LANGUAGE</source>
        <translation>SPRACHE</translation>
    </message>
    <message>
        <source>Makes endless material from a photo. FILES may be photos, textons or a project.</source>
        <translation>Macht aus einem Foto endloses Material. DATEIEN können Fotos, Textons oder ein Projekt sein.</translation>
    </message>
    <message>
        <source>What to open.</source>
        <translation>Was geöffnet werden soll.</translation>
    </message>
    <message>
        <source>texton-studio: %1 See texton-studio --help.</source>
        <translation>texton-studio: %1 Siehe texton-studio --help.</translation>
    </message>
    <message>
        <source>With --version: those of all libraries, too.</source>
        <translation>Mit --version: auch die aller Bibliotheken.</translation>
    </message>
</context>
<context>
    <name>Warnings</name>
    <message>
        <source>%1 has changed since the project was saved.</source>
        <translation>%1 hat sich geändert, seit das Projekt gesichert wurde.</translation>
    </message>
    <message>
        <source>%1 is missing; a sphere takes its place.</source>
        <translation>%1 fehlt; eine Kugel tritt an seine Stelle.</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>A value is out of its range; please choose another one.</source>
        <translation>Ein Wert liegt außerhalb seines Bereichs; bitte einen anderen wählen.</translation>
    </message>
    <message>
        <source>The file is not there; please choose another one.</source>
        <translation>Die Datei gibt es nicht; bitte eine andere wählen.</translation>
    </message>
    <message>
        <source>The file cannot be read; please open another copy of it.</source>
        <translation>Die Datei ist nicht lesbar; bitte eine andere Kopie davon öffnen.</translation>
    </message>
    <message>
        <source>The file cannot be written; please choose another place.</source>
        <translation>Die Datei kann nicht geschrieben werden; bitte einen anderen Ort wählen.</translation>
    </message>
    <message>
        <source>This is too large; please choose a smaller picture, part or size.</source>
        <translation>Das ist zu groß; bitte ein kleineres Bild, Stück oder Maß wählen.</translation>
    </message>
    <message>
        <source>This cannot be done with such a file; please choose another kind.</source>
        <translation>Das geht mit einer solchen Datei nicht; bitte eine andere Art wählen.</translation>
    </message>
    <message>
        <source>These do not fit together; please choose another picture, support or part.</source>
        <translation>Das passt nicht zusammen; bitte ein anderes Bild, einen anderen Träger oder Ausschnitt wählen.</translation>
    </message>
    <message>
        <source>The picture is all one color, or has values that are no numbers; please choose another one.</source>
        <translation>Das Bild hat nur eine Farbe oder Werte, die keine Zahlen sind; bitte ein anderes wählen.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
</context>
<context>
    <name>txn::app::ActionRegistry</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>txn::app::Autosave</name>
    <message>
        <source>Keeping a copy</source>
        <translation>Eine Kopie wird aufgehoben</translation>
    </message>
    <message>
        <source>No copy of your work can be kept (%1). Please save it.</source>
        <translation>Von der Arbeit kann keine Kopie aufgehoben werden (%1). Bitte sichern.</translation>
    </message>
</context>
<context>
    <name>txn::app::BeforeAfter</name>
    <message>
        <source>Hold the mouse button or the space bar to see it as it was before.</source>
        <translation>Maustaste oder Leertaste halten, um es wie vorher zu sehen.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After (hold for before)</source>
        <translation>Nachher (halten: vorher)</translation>
    </message>
</context>
<context>
    <name>txn::app::CommandPalette</name>
    <message>
        <source>Type what you want to do</source>
        <translation>Schreiben, was zu tun ist</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Befehle suchen</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
</context>
<context>
    <name>txn::app::ErrorPlot</name>
    <message>
        <source>Error against iterations</source>
        <translation>Fehler gegen Schritte</translation>
    </message>
</context>
<context>
    <name>txn::app::ExemplarPanel</name>
    <message>
        <source>8 bit</source>
        <translation>8 Bit</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>16 bit float</source>
        <translation>16 Bit Gleitkomma</translation>
    </message>
    <message>
        <source>32 bit float</source>
        <translation>32 Bit Gleitkomma</translation>
    </message>
    <message>
        <source>gray</source>
        <translation>grau</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>%1 channels</source>
        <translation>%1 Kanäle</translation>
    </message>
    <message>
        <source>Colors will clip</source>
        <translation>Farben werden abgeschnitten</translation>
    </message>
    <message>
        <source>%1 % of the noise&apos;s values are darker than black or lighter than white. Lower the contrast of the noise, or export EXR.</source>
        <translation>%1 % der Werte des Rauschens sind dunkler als Schwarz oder heller als Weiß. Den Kontrast des Rauschens senken oder EXR exportieren.</translation>
    </message>
    <message>
        <source>Suits, but highlights or shadows even out</source>
        <translation>Geeignet, aber Lichter oder Schatten gleichen sich aus</translation>
    </message>
    <message>
        <source>Its values lean to one side; those of the noise are spread evenly around the mean.</source>
        <translation>Die Werte neigen zu einer Seite; die des Rauschens liegen gleichmäßig um den Mittelwert.</translation>
    </message>
    <message>
        <source>Suits texton noise</source>
        <translation>Für Texton-Rauschen geeignet</translation>
    </message>
    <message>
        <source>It is all grain and no shapes, and its colors fit.</source>
        <translation>Es ist ganz Korn ohne Formen, und die Farben passen.</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>Drag over the part of the photo that looks the same all over.</source>
        <translation>Über den Teil des Fotos ziehen, der überall gleich aussieht.</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Draw a line along the grain; it becomes level or upright.</source>
        <translation>Eine Linie entlang der Maserung ziehen; sie wird waagrecht oder senkrecht.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the photo as it was opened.</source>
        <translation>Zurück zum Foto, wie es geöffnet wurde.</translation>
    </message>
    <message>
        <source>Reset the exemplar</source>
        <translation>Vorlage zurücksetzen</translation>
    </message>
    <message>
        <source>The photo and its crop</source>
        <translation>Das Foto und sein Ausschnitt</translation>
    </message>
    <message>
        <source>Drag to use only a part of the photo. Arrow keys move it, with Shift they resize it.</source>
        <translation>Ziehen, um nur einen Teil des Fotos zu verwenden. Pfeiltasten verschieben ihn, mit Umschalt ändern sie die Größe.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Turns the photo, counterclockwise. Or draw a line with Straighten.</source>
        <translation>Dreht das Foto gegen den Uhrzeigersinn. Oder mit Ausrichten eine Linie ziehen.</translation>
    </message>
    <message>
        <source>Work in</source>
        <translation>Rechnen in</translation>
    </message>
    <message>
        <source>sRGB values</source>
        <translation>sRGB-Werten</translation>
    </message>
    <message>
        <source>Linear light</source>
        <translation>linearem Licht</translation>
    </message>
    <message>
        <source>sRGB values keep dark grain; linear light suits renderers. Try sRGB first.</source>
        <translation>sRGB-Werte erhalten dunkles Korn; lineares Licht passt zu Renderern. Am besten erst sRGB versuchen.</translation>
    </message>
    <message>
        <source>Even out the lighting</source>
        <translation>Beleuchtung ausgleichen</translation>
    </message>
    <message>
        <source>Takes away shade that is smoother than the radius, such as a dark corner.</source>
        <translation>Entfernt Schatten, die weicher sind als der Radius, etwa eine dunkle Ecke.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>Only what is smoother than this goes away. Small values also take large grain.</source>
        <translation>Nur was weicher ist als dies, verschwindet. Kleine Werte nehmen auch grobes Korn weg.</translation>
    </message>
    <message>
        <source>Lighting radius</source>
        <translation>Radius der Beleuchtung</translation>
    </message>
    <message>
        <source>Lighting before and after</source>
        <translation>Beleuchtung vorher und nachher</translation>
    </message>
    <message>
        <source>Remove the seam</source>
        <translation>Naht entfernen</translation>
    </message>
    <message>
        <source>Takes away the jump from one border of the photo to the other (the periodic component). Switch it off for pictures that tile already.</source>
        <translation>Entfernt den Sprung von einem Rand des Fotos zum anderen (die periodische Komponente). Für Bilder, die schon kacheln, ausschalten.</translation>
    </message>
    <message>
        <source>Seam before and after</source>
        <translation>Naht vorher und nachher</translation>
    </message>
    <message>
        <source>A texton from a file needs no exemplar.</source>
        <translation>Ein Texton aus einer Datei braucht keine Vorlage.</translation>
    </message>
    <message>
        <source>Open a photo of a material, or drop one here.</source>
        <translation>Ein Foto eines Materials öffnen oder hierher ziehen.</translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation>%1 x %2 px</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>sRGB</source>
        <translation>sRGB</translation>
    </message>
    <message>
        <source>color profile converted</source>
        <translation>Farbprofil umgerechnet</translation>
    </message>
    <message>
        <source>transparency left out</source>
        <translation>Transparenz weggelassen</translation>
    </message>
    <message>
        <source>Skewness %1, excess kurtosis %2, clipped values %3 %, sub-bands %4 standard deviations from those of its Gaussian versions.</source>
        <translation>Schiefe %1, Exzess %2, abgeschnittene Werte %3 %, Teilbänder %4 Standardabweichungen von denen seiner Gauß-Versionen.</translation>
    </message>
    <message>
        <source>Has shapes that a Gaussian texture cannot keep</source>
        <translation>Hat Formen, die eine Gaußsche Textur nicht halten kann</translation>
    </message>
    <message>
        <source>Edges, patches and single features even out into grain. Compare with the Gaussian version, or crop a part that is all grain.</source>
        <translation>Kanten, Flecken und einzelne Merkmale werden zu Korn. Mit der Gauß-Version vergleichen oder einen Ausschnitt wählen, der ganz Korn ist.</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Normals, green down</source>
        <translation>Normalen, Grün nach unten</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>Metalness</source>
        <translation>Metall</translation>
    </message>
    <message>
        <source>Occlusion, roughness, metalness</source>
        <translation>Verdeckung, Rauheit, Metall</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The maps of this material, told by the words in their names. Their noise comes from the same impacts, so that they stay in register.</source>
        <translation>Die Karten dieses Materials, an Wörtern in ihren Namen erkannt. Ihr Rauschen kommt von denselben Impulsen, so bleiben sie deckungsgleich.</translation>
    </message>
    <message>
        <source>Green points the other way</source>
        <translation>Grün zeigt andersherum</translation>
    </message>
    <message>
        <source>For normal maps made for another program: switch it on if bumps look like dents.</source>
        <translation>Für Normalenkarten aus einem anderen Programm: einschalten, wenn Buckel wie Dellen aussehen.</translation>
    </message>
    <message>
        <source>Green of the normals</source>
        <translation>Grün der Normalen</translation>
    </message>
</context>
<context>
    <name>txn::app::ExportDialog</name>
    <message>
        <source>PNG, 8 bit</source>
        <translation>PNG, 8 Bit</translation>
    </message>
    <message>
        <source>PNG, 16 bit</source>
        <translation>PNG, 16 Bit</translation>
    </message>
    <message>
        <source>EXR, 16 bit float</source>
        <translation>EXR, 16 Bit Gleitkomma</translation>
    </message>
    <message>
        <source>EXR, 32 bit float</source>
        <translation>EXR, 32 Bit Gleitkomma</translation>
    </message>
    <message>
        <source>TIFF, 8 bit</source>
        <translation>TIFF, 8 Bit</translation>
    </message>
    <message>
        <source>TIFF, 16 bit</source>
        <translation>TIFF, 16 Bit</translation>
    </message>
    <message>
        <source>TIFF, 32 bit float</source>
        <translation>TIFF, 32 Bit Gleitkomma</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>EXR, exact</source>
        <translation>EXR, genau</translation>
    </message>
    <message>
        <source>Every value as it is, with all parameters inside. The best choice.</source>
        <translation>Jeder Wert, wie er ist, mit allen Angaben darin. Die beste Wahl.</translation>
    </message>
    <message>
        <source>For programs that cannot read EXR. The JSON file tells how values are coded.</source>
        <translation>Für Programme, die kein EXR lesen. Die JSON-Datei sagt, wie Werte kodiert sind.</translation>
    </message>
    <message>
        <source>.texton, as text</source>
        <translation>.texton, als Text</translation>
    </message>
    <message>
        <source>The format of the papers&apos; authors, for their programs.</source>
        <translation>Das Format der Autoren der Arbeiten, für ihre Programme.</translation>
    </message>
    <message>
        <source>Common sizes; any other can be typed below.</source>
        <translation>Übliche Größen; jede andere lässt sich darunter eingeben.</translation>
    </message>
    <message>
        <source>%1 x %1</source>
        <translation>%1 x %1</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Tiles without a seam</source>
        <translation>Kachelt ohne Naht</translation>
    </message>
    <message>
        <source>The picture repeats without a seam. Off, it is a piece of the endless plane.</source>
        <translation>Das Bild wiederholt sich ohne Naht. Sonst ist es ein Stück der endlosen Ebene.</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Von links</translation>
    </message>
    <message>
        <source>From the top</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Where on the endless plane the piece is cut out.</source>
        <translation>Wo auf der endlosen Ebene das Stück ausgeschnitten wird.</translation>
    </message>
    <message>
        <source>EXR keeps values beyond black and white; PNG and TIFF with 8 or 16 bits clip them.</source>
        <translation>EXR behält Werte jenseits von Schwarz und Weiß; PNG und TIFF mit 8 oder 16 Bit schneiden sie ab.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What to export</source>
        <translation>Was exportiert wird</translation>
    </message>
    <message>
        <source>Texton</source>
        <translation>Texton</translation>
    </message>
    <message>
        <source>Noise texture</source>
        <translation>Rauschtextur</translation>
    </message>
    <message>
        <source>Current view</source>
        <translation>Jetzige Ansicht</translation>
    </message>
    <message>
        <source>For engines</source>
        <translation>Für Engines</translation>
    </message>
    <message>
        <source>The noise as it is on screen, as a PNG picture.</source>
        <translation>Das Rauschen, wie es zu sehen ist, als PNG-Bild.</translation>
    </message>
    <message>
        <source>Everything to draw endless material in your own program: the texton, one self-contained shader (GLSL 330, free to use under CC0), its parameters, and a small example program.</source>
        <translation>Alles, um endloses Material im eigenen Programm zu zeichnen: das Texton, ein Shader ohne Weiteres (GLSL 330, frei nach CC0), seine Werte und ein kleines Beispielprogramm.</translation>
    </message>
    <message>
        <source>Choices that you saved under a name.</source>
        <translation>Eigene Auswahlen, unter einem Namen aufgehoben.</translation>
    </message>
    <message>
        <source>Save as preset...</source>
        <translation>Als Vorgabe sichern...</translation>
    </message>
    <message>
        <source>Words in braces are filled in: {name} {support} {mni} {seed} {size}.</source>
        <translation>Wörter in Klammern werden ersetzt: {name} {support} {mni} {seed} {size}.</translation>
    </message>
    <message>
        <source>Where the files go.</source>
        <translation>Wohin die Dateien kommen.</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>%1  (replaces a file)</source>
        <translation>%1  (ersetzt eine Datei)</translation>
    </message>
    <message>
        <source>There is no texton yet.</source>
        <translation>Es gibt noch kein Texton.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>Noch %n s</numerusform>
            <numerusform>Noch %n s</numerusform>
        </translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Als Vorgabe sichern</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Name der Vorgabe</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Einen Ordner wählen</translation>
    </message>
    <message>
        <source>Replace files?</source>
        <translation>Dateien ersetzen?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) of these names exist already.</source>
        <translation>
            <numerusform>%n Datei dieses Namens gibt es schon.</numerusform>
            <numerusform>%n Dateien dieser Namen gibt es schon.</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Exportieren</translation>
    </message>
    <message numerus="yes">
        <source>Wrote %n file(s).</source>
        <translation>
            <numerusform>%n Datei geschrieben.</numerusform>
            <numerusform>%n Dateien geschrieben.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 % of the values were clipped; EXR keeps them.</source>
        <translation>%1 % der Werte wurden abgeschnitten; EXR behält sie.</translation>
    </message>
    <message>
        <source>Pixels of the picture. Large ones are written piece by piece.</source>
        <translation>Pixel des Bildes. Große werden stückweise geschrieben.</translation>
    </message>
    <message>
        <source>What to write.</source>
        <translation>Was geschrieben wird.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Forgets the chosen preset.</source>
        <translation>Vergisst die gewählte Vorgabe.</translation>
    </message>
    <message>
        <source>Remembers these choices under a name.</source>
        <translation>Merkt sich diese Auswahl unter einem Namen.</translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation>Einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>Shows where the files are.</source>
        <translation>Zeigt, wo die Dateien sind.</translation>
    </message>
    <message>
        <source>Writes the files that are listed.</source>
        <translation>Schreibt die aufgeführten Dateien.</translation>
    </message>
    <message>
        <source>Stops the work, or else closes this window.</source>
        <translation>Hält die Arbeit an oder schließt sonst dieses Fenster.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Delete the preset?</source>
        <translation>Vorgabe löschen?</translation>
    </message>
    <message>
        <source>The preset %1 will be gone.</source>
        <translation>Die Vorgabe %1 geht verloren.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Mixture</source>
        <translation>Mischung</translation>
    </message>
    <message>
        <source>All textons from A to B in a folder of their own: one EXR with a layer for each, the same as single files, a description, and the map as a gray picture. A noise texture of the mixture begins at the corner of the map; to tile, the map has to repeat.</source>
        <translation>Alle Textons von A bis B in einem eigenen Ordner: ein EXR mit einer Ebene für jedes, dieselben als einzelne Dateien, eine Beschreibung und die Karte als graues Bild. Eine Rauschtextur der Mischung beginnt an der Ecke der Karte; zum Kacheln muss die Karte sich wiederholen.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>There is no mixture yet. Open a second material first.</source>
        <translation>Es gibt noch keine Mischung. Erst ein zweites Material öffnen.</translation>
    </message>
    <message>
        <source>The mixture is not ready. The Mix panel tells why.</source>
        <translation>Die Mischung ist nicht fertig. Das Feld Mischen sagt, warum.</translation>
    </message>
    <message>
        <source>To tile, switch on Mix &gt; Repeat the map, and choose a multiple of %1 x %2 px.</source>
        <translation>Zum Kacheln Mischen &gt; Karte wiederholen einschalten und ein Vielfaches von %1 x %2 px wählen.</translation>
    </message>
</context>
<context>
    <name>txn::app::FileController</name>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Making the sample</source>
        <translation>Das Beispiel wird gemacht</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Open a photo, texton or project</source>
        <translation>Ein Foto, Texton oder Projekt öffnen</translation>
    </message>
    <message>
        <source>All that can be opened (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp *.texton *.txnproj);;Photos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;Textons (*.texton *.exr *.png);;Projects (*.txnproj);;All files (*)</source>
        <translation>Alles, was sich öffnen lässt (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp *.texton *.txnproj);;Fotos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;Textons (*.texton *.exr *.png);;Projekte (*.txnproj);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Pasting a picture</source>
        <translation>Ein Bild wird eingefügt</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Eingefügtes Bild</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Das Projekt sichern</translation>
    </message>
    <message>
        <source>Texton Studio projects (*.txnproj)</source>
        <translation>Texton-Studio-Projekte (*.txnproj)</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gesichert</translation>
    </message>
    <message>
        <source>Save before closing?</source>
        <translation>Vor dem Schließen sichern?</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 hat Änderungen, die nicht gesichert sind.</translation>
    </message>
    <message>
        <source>Saving keeps the photo, all settings and the view in one project file.</source>
        <translation>Gesichert werden das Foto, alle Einstellungen und die Ansicht in einer Projektdatei.</translation>
    </message>
    <message>
        <source>Still saving. Please try again in a moment.</source>
        <translation>Es wird noch gesichert. Bitte gleich noch einmal versuchen.</translation>
    </message>
    <message>
        <source>Opening the maps of a material</source>
        <translation>Die Karten eines Materials werden geöffnet</translation>
    </message>
    <message>
        <source>Open %1 as B</source>
        <translation>%1 als B öffnen</translation>
    </message>
    <message>
        <source>Open the second material</source>
        <translation>Das zweite Material öffnen</translation>
    </message>
    <message>
        <source>Photos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;All files (*)</source>
        <translation>Fotos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a photo first, then a second one to mix it with.</source>
        <translation>Erst ein Foto öffnen, dann ein zweites, um beide zu mischen.</translation>
    </message>
    <message>
        <source>Open a very large picture?</source>
        <translation>Ein sehr großes Bild öffnen?</translation>
    </message>
    <message>
        <source>Opening it may take long and much memory. Open only files that you trust this way.</source>
        <translation>Das Öffnen kann lange dauern und viel Speicher brauchen. Nur Dateien so öffnen, denen man traut.</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Trotzdem öffnen</translation>
    </message>
    <message>
        <source>Files outside the project&apos;s folder</source>
        <translation>Dateien außerhalb des Projektordners</translation>
    </message>
    <message>
        <source>%1 wants to open files outside its own folder. Do that only if you know where it comes from.</source>
        <translation>%1 möchte Dateien außerhalb des eigenen Ordners öffnen. Nur zulassen, wenn klar ist, woher das Projekt kommt.</translation>
    </message>
    <message>
        <source>%1 is open in another Texton Studio. Please choose another name.</source>
        <translation>%1 ist in einem anderen Texton Studio geöffnet. Bitte einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>%1 is open in another Texton Studio. This is a copy of it; please save it under another name.</source>
        <translation>%1 ist in einem anderen Texton Studio geöffnet. Das hier ist eine Kopie; bitte unter einem anderen Namen sichern.</translation>
    </message>
</context>
<context>
    <name>txn::app::HistogramPanel</name>
    <message>
        <source>How often each value occurs. Where the noise reaches beyond 0 or 1, its colors are clipped.</source>
        <translation>Wie oft jeder Wert vorkommt. Wo das Rauschen über 0 oder 1 hinausgeht, werden Farben abgeschnitten.</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation>Gauß-Version</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Gray</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Channel %1</source>
        <translation>Kanal %1</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
</context>
<context>
    <name>txn::app::JobRunner</name>
    <message>
        <source>there is not enough memory; try a smaller picture or size</source>
        <translation>der Speicher reicht nicht; ein kleineres Bild oder Maß versuchen</translation>
    </message>
</context>
<context>
    <name>txn::app::JobsPanel</name>
    <message>
        <source>Work in progress</source>
        <translation>Laufende Arbeit</translation>
    </message>
    <message>
        <source>What is being computed right now.</source>
        <translation>Was gerade berechnet wird.</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Arbeit</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops this work.</source>
        <translation>Hält diese Arbeit an.</translation>
    </message>
</context>
<context>
    <name>txn::app::JobsStatus</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>How far the work is. The Jobs panel lists all of it.</source>
        <translation>Wie weit die Arbeit ist. Das Feld Aufgaben führt alle auf.</translation>
    </message>
</context>
<context>
    <name>txn::app::KeyMapOverlay</name>
    <message>
        <source>All keys</source>
        <translation>Alle Tasten</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Zoom at the mouse</source>
        <translation>An der Maus zoomen</translation>
    </message>
    <message>
        <source>Middle drag, Space drag</source>
        <translation>Mitte ziehen, Leertaste ziehen</translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation>Das Bild verschieben</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Links ziehen</translation>
    </message>
    <message>
        <source>Look around the ground or mesh</source>
        <translation>Um Boden oder Netz herumsehen</translation>
    </message>
    <message>
        <source>Hold `</source>
        <translation>` halten</translation>
    </message>
    <message>
        <source>See the exemplar instead</source>
        <translation>Stattdessen die Vorlage sehen</translation>
    </message>
    <message>
        <source>Hold X</source>
        <translation>X halten</translation>
    </message>
    <message>
        <source>See the difference, eightfold</source>
        <translation>Den Unterschied sehen, achtfach</translation>
    </message>
    <message>
        <source>Shift drag</source>
        <translation>Umschalt ziehen</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>In a view</source>
        <translation>In einer Ansicht</translation>
    </message>
    <message>
        <source>Double-click the title</source>
        <translation>Doppelklick auf den Titel</translation>
    </message>
    <message>
        <source>This view only</source>
        <translation>Nur diese Ansicht</translation>
    </message>
    <message>
        <source>On a slider</source>
        <translation>Auf einem Regler</translation>
    </message>
    <message>
        <source>Fine steps</source>
        <translation>Feine Schritte</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Any key closes this.</source>
        <translation>Jede Taste schließt dies.</translation>
    </message>
</context>
<context>
    <name>txn::app::MainWindow</name>
    <message>
        <source>Recovering %1</source>
        <translation>%1 wird zurückgeholt</translation>
    </message>
    <message>
        <source>That did not work: %1</source>
        <translation>Das ging nicht: %1</translation>
    </message>
    <message>
        <source>The noise is drawn without the graphics card, from above only: %1</source>
        <translation>Das Rauschen wird ohne Grafikkarte gezeichnet, nur von oben: %1</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Texton</source>
        <translation>Texton</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Every change you made. Click one to go back to it.</source>
        <translation>Jede Änderung. Ein Klick führt zu ihr zurück.</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>What draws the noise.</source>
        <translation>Was das Rauschen zeichnet.</translation>
    </message>
    <message>
        <source>x %1  y %2</source>
        <translation>x %1  y %2</translation>
    </message>
    <message>
        <source>sRGB %1</source>
        <translation>sRGB %1</translation>
    </message>
    <message>
        <source>linear %1</source>
        <translation>linear %1</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Holz</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>Stein</translation>
    </message>
    <message>
        <source>Sand</source>
        <translation>Sand</translation>
    </message>
    <message>
        <source>Rust</source>
        <translation>Rost</translation>
    </message>
    <message>
        <source>Brushed metal</source>
        <translation>Gebürstetes Metall</translation>
    </message>
    <message>
        <source>Cloth</source>
        <translation>Stoff</translation>
    </message>
    <message>
        <source>Leather</source>
        <translation>Leder</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Close everything and start afresh.</source>
        <translation>Alles schließen und von vorn beginnen.</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>Ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Open a photo, a texton or a project.</source>
        <translation>Ein Foto, ein Texton oder ein Projekt öffnen.</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>Projekt &amp;sichern</translation>
    </message>
    <message>
        <source>Keep the photo and all settings in one file.</source>
        <translation>Das Foto und alle Einstellungen in einer Datei aufheben.</translation>
    </message>
    <message>
        <source>Save project &amp;as...</source>
        <translation>Projekt sichern &amp;unter...</translation>
    </message>
    <message>
        <source>Save under another name.</source>
        <translation>Unter einem anderen Namen sichern.</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportieren...</translation>
    </message>
    <message>
        <source>Write textons, textures and shaders for other programs.</source>
        <translation>Textons, Texturen und Shader für andere Programme schreiben.</translation>
    </message>
    <message>
        <source>Save picture of &amp;the noise...</source>
        <translation>&amp;Bild des Rauschens sichern...</translation>
    </message>
    <message>
        <source>Save what the noise view shows.</source>
        <translation>Sichern, was die Ansicht des Rauschens zeigt.</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Been&amp;den</translation>
    </message>
    <message>
        <source>Close the program.</source>
        <translation>Das Programm schließen.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take the last change back.</source>
        <translation>Die letzte Änderung zurücknehmen.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Make the change again.</source>
        <translation>Die Änderung wieder machen.</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Open the picture or file in the clipboard.</source>
        <translation>Das Bild oder die Datei in der Zwischenablage öffnen.</translation>
    </message>
    <message>
        <source>There is no picture in the clipboard.</source>
        <translation>In der Zwischenablage ist kein Bild.</translation>
    </message>
    <message>
        <source>&amp;Shortcuts...</source>
        <translation>&amp;Tastenkürzel...</translation>
    </message>
    <message>
        <source>Choose your own keys.</source>
        <translation>Eigene Tasten wählen.</translation>
    </message>
    <message>
        <source>&amp;Single view</source>
        <translation>&amp;Eine Ansicht</translation>
    </message>
    <message>
        <source>One picture fills the middle.</source>
        <translation>Ein Bild füllt die Mitte.</translation>
    </message>
    <message>
        <source>Side &amp;by side</source>
        <translation>&amp;Nebeneinander</translation>
    </message>
    <message>
        <source>Two pictures next to each other.</source>
        <translation>Zwei Bilder nebeneinander.</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>&amp;Vier Ansichten</translation>
    </message>
    <message>
        <source>Exemplar, Gaussian version, texton and noise at once.</source>
        <translation>Vorlage, Gauß-Version, Texton und Rauschen zugleich.</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Wischen</translation>
    </message>
    <message>
        <source>Two pictures in one place, with a border to drag.</source>
        <translation>Zwei Bilder an einer Stelle, mit einer Grenze zum Ziehen.</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>Ein&amp;passen</translation>
    </message>
    <message>
        <source>Show the whole exemplar.</source>
        <translation>Die ganze Vorlage zeigen.</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100 %</translation>
    </message>
    <message>
        <source>One pixel of the picture is one of the screen.</source>
        <translation>Ein Pixel des Bildes ist eines des Bildschirms.</translation>
    </message>
    <message>
        <source>&amp;200 %</source>
        <translation>&amp;200 %</translation>
    </message>
    <message>
        <source>Twice as large.</source>
        <translation>Doppelt so groß.</translation>
    </message>
    <message>
        <source>Show the &amp;Gaussian version</source>
        <translation>&amp;Gauß-Version zeigen</translation>
    </message>
    <message>
        <source>In the view under the mouse.</source>
        <translation>In der Ansicht unter der Maus.</translation>
    </message>
    <message>
        <source>&amp;Tile the exemplar</source>
        <translation>Vor&amp;lage kacheln</translation>
    </message>
    <message>
        <source>Repeat the photo, to see the repetition that the noise does away with.</source>
        <translation>Das Foto wiederholen, um die Wiederholung zu sehen, die das Rauschen vermeidet.</translation>
    </message>
    <message>
        <source>B&amp;righter</source>
        <translation>&amp;Heller</translation>
    </message>
    <message>
        <source>Show everything a third of a stop brighter.</source>
        <translation>Alles um eine Drittelblende heller zeigen.</translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation>&amp;Dunkler</translation>
    </message>
    <message>
        <source>Show everything a third of a stop darker.</source>
        <translation>Alles um eine Drittelblende dunkler zeigen.</translation>
    </message>
    <message>
        <source>&amp;Normal exposure</source>
        <translation>N&amp;ormale Belichtung</translation>
    </message>
    <message>
        <source>Show the values as they are.</source>
        <translation>Die Werte zeigen, wie sie sind.</translation>
    </message>
    <message>
        <source>Look at single channels as gray.</source>
        <translation>Einzelne Kanäle als Grau ansehen.</translation>
    </message>
    <message>
        <source>&amp;All channels</source>
        <translation>&amp;Alle Kanäle</translation>
    </message>
    <message>
        <source>First channel (red)</source>
        <translation>Erster Kanal (Rot)</translation>
    </message>
    <message>
        <source>Second channel (green)</source>
        <translation>Zweiter Kanal (Grün)</translation>
    </message>
    <message>
        <source>Third channel (blue)</source>
        <translation>Dritter Kanal (Blau)</translation>
    </message>
    <message>
        <source>What is around the pictures.</source>
        <translation>Was um die Bilder herum ist.</translation>
    </message>
    <message>
        <source>&amp;Compute again</source>
        <translation>&amp;Neu berechnen</translation>
    </message>
    <message>
        <source>Compute the texton once more and watch it form.</source>
        <translation>Das Texton noch einmal berechnen und ihm beim Entstehen zusehen.</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Stop computing the texton.</source>
        <translation>Die Berechnung des Textons anhalten.</translation>
    </message>
    <message>
        <source>New &amp;seed</source>
        <translation>Neuer &amp;Startwert</translation>
    </message>
    <message>
        <source>Another random result of what is under the mouse: Gaussian version, texton or noise.</source>
        <translation>Ein anderes Zufallsergebnis für das, was unter der Maus ist: Gauß-Version, Texton oder Rauschen.</translation>
    </message>
    <message>
        <source>Gaussian method</source>
        <translation>Gauß-Verfahren</translation>
    </message>
    <message>
        <source>Random phases and random strengths: what texton noise comes to.</source>
        <translation>Zufällige Phasen und zufällige Stärken: wohin Texton-Rauschen führt.</translation>
    </message>
    <message>
        <source>Random phases only: keeps the exact spectrum of the photo.</source>
        <translation>Nur zufällige Phasen: behält das genaue Spektrum des Fotos.</translation>
    </message>
    <message>
        <source>The texton&apos;s seed is locked.</source>
        <translation>Der Startwert des Textons ist festgestellt.</translation>
    </message>
    <message>
        <source>New seed</source>
        <translation>Neuer Startwert</translation>
    </message>
    <message>
        <source>Show or hide this panel.</source>
        <translation>Dieses Feld zeigen oder verbergen.</translation>
    </message>
    <message>
        <source>&amp;Hide panels</source>
        <translation>Felder &amp;verbergen</translation>
    </message>
    <message>
        <source>Nothing but the pictures; the same key brings the panels back.</source>
        <translation>Nichts als die Bilder; dieselbe Taste bringt die Felder zurück.</translation>
    </message>
    <message>
        <source>&amp;Next panel</source>
        <translation>&amp;Nächstes Feld</translation>
    </message>
    <message>
        <source>Go on to the next panel with the keyboard.</source>
        <translation>Mit der Tastatur zum nächsten Feld gehen.</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Put all panels back where they belong.</source>
        <translation>Alle Felder dorthin, wohin sie gehören.</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>V&amp;ollbild</translation>
    </message>
    <message>
        <source>Use the whole screen.</source>
        <translation>Den ganzen Bildschirm verwenden.</translation>
    </message>
    <message>
        <source>The colors of the window.</source>
        <translation>Die Farben des Fensters.</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>&amp;Command palette</source>
        <translation>&amp;Befehlspalette</translation>
    </message>
    <message>
        <source>Find any command by typing a part of its name.</source>
        <translation>Jeden Befehl finden, indem man einen Teil seines Namens tippt.</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>All keys at a glance.</source>
        <translation>Alle Tasten auf einen Blick.</translation>
    </message>
    <message>
        <source>&amp;What is this?</source>
        <translation>&amp;Was ist das?</translation>
    </message>
    <message>
        <source>Then click on anything to read about it.</source>
        <translation>Danach anklicken, worüber es etwas zu lesen gibt.</translation>
    </message>
    <message>
        <source>&amp;About Texton Studio</source>
        <translation>Über Texton &amp;Studio</translation>
    </message>
    <message>
        <source>Version, method and license.</source>
        <translation>Version, Verfahren und Lizenz.</translation>
    </message>
    <message>
        <source>About Texton Studio</source>
        <translation>Über Texton Studio</translation>
    </message>
    <message>
        <source>&lt;b&gt;Texton Studio %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Texton Studio %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Endless material from a photo, by the method of Galerne, Leclaire and Moisan (2014, 2017). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Endloses Material aus einem Foto, nach dem Verfahren von Galerne, Leclaire und Moisan (2014, 2017). Freie Software unter der GNU General Public License, Version 3 oder später.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open a sa&amp;mple</source>
        <translation>Beis&amp;piel öffnen</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Channels</source>
        <translation>K&amp;anäle</translation>
    </message>
    <message>
        <source>S&amp;urround</source>
        <translation>&amp;Umgebung</translation>
    </message>
    <message>
        <source>&amp;Texton</source>
        <translation>&amp;Texton</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>Far&amp;bschema</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Diese Liste leeren</translation>
    </message>
    <message>
        <source>The language changes when you start Texton Studio again.</source>
        <translation>Die Sprache wechselt beim nächsten Start von Texton Studio.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Das Bild sichern</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gesichert</translation>
    </message>
    <message>
        <source>&amp;Photo inside the project</source>
        <translation>Foto &amp;im Projekt</translation>
    </message>
    <message>
        <source>On, a project holds the photo itself; off, it only remembers where the photo is.</source>
        <translation>Ein: das Projekt enthält das Foto selbst; aus: es merkt sich nur, wo das Foto ist.</translation>
    </message>
    <message>
        <source>Link the photo</source>
        <translation>Das Foto verknüpfen</translation>
    </message>
    <message>
        <source>Photo inside the project</source>
        <translation>Foto im Projekt</translation>
    </message>
    <message>
        <source>&amp;Gaussian version: ADSN</source>
        <translation>&amp;Gauß-Version: ADSN</translation>
    </message>
    <message>
        <source>Gaussian version: &amp;RPN</source>
        <translation>Gauß-Version: &amp;RPN</translation>
    </message>
    <message>
        <source>The language of the window, from the next start on.</source>
        <translation>Die Sprache des Fensters, vom nächsten Start an.</translation>
    </message>
    <message>
        <source>Looking for unsaved work</source>
        <translation>Ungesicherte Arbeit wird gesucht</translation>
    </message>
    <message>
        <source>Place and values of the pixel under the mouse.</source>
        <translation>Ort und Werte des Pixels unter der Maus.</translation>
    </message>
    <message>
        <source>How far the texton is from the photo; see the Texton panel.</source>
        <translation>Wie weit das Texton vom Foto entfernt ist; siehe das Feld Texton.</translation>
    </message>
    <message>
        <source>&amp;Zoom in</source>
        <translation>Ve&amp;rgrößern</translation>
    </message>
    <message>
        <source>Larger, at the mouse.</source>
        <translation>Größer, an der Maus.</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Smaller, at the mouse.</source>
        <translation>Kleiner, an der Maus.</translation>
    </message>
    <message>
        <source>There is no finished noise to save yet. Please wait a moment, or open a photo.</source>
        <translation>Es gibt noch kein fertiges Rauschen zu sichern. Bitte kurz warten oder ein Foto öffnen.</translation>
    </message>
    <message>
        <source>Saving the picture</source>
        <translation>Das Bild wird gesichert</translation>
    </message>
    <message>
        <source>What draws the noise: %1</source>
        <translation>Was das Rauschen zeichnet: %1</translation>
    </message>
    <message>
        <source>How the pictures are shown: screen pixels for each pixel of the photo, exposure, channel.</source>
        <translation>Wie die Bilder gezeigt werden: Bildschirmpixel für jedes Pixel des Fotos, Belichtung, Kanal.</translation>
    </message>
    <message>
        <source>Zoom %1 %</source>
        <translation>Zoom %1 %</translation>
    </message>
    <message>
        <source>exposure %1%2</source>
        <translation>Belichtung %1%2</translation>
    </message>
    <message>
        <source>channel %1 only</source>
        <translation>nur Kanal %1</translation>
    </message>
    <message>
        <source>Stop the export?</source>
        <translation>Export anhalten?</translation>
    </message>
    <message>
        <source>An export is still being written.</source>
        <translation>Ein Export wird noch geschrieben.</translation>
    </message>
    <message>
        <source>Stop it and close</source>
        <translation>Anhalten und schließen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Reset the &amp;exemplar</source>
        <translation>&amp;Vorlage zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the photo as it was opened.</source>
        <translation>Zurück zum Foto, wie es geöffnet wurde.</translation>
    </message>
    <message>
        <source>Reset the exemplar</source>
        <translation>Vorlage zurücksetzen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Surround</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Gray</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Schwarz</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>&amp;Flat</source>
        <translation>&amp;Flach</translation>
    </message>
    <message>
        <source>&amp;Ground</source>
        <translation>&amp;Boden</translation>
    </message>
    <message>
        <source>Mesh, by its &amp;UVs</source>
        <translation>Netz, nach seinen &amp;UVs</translation>
    </message>
    <message>
        <source>Mesh, any &amp;surface</source>
        <translation>Netz, jede &amp;Oberfläche</translation>
    </message>
    <message>
        <source>What the noise is shown on.</source>
        <translation>Worauf das Rauschen gezeigt wird.</translation>
    </message>
    <message>
        <source>Noise view</source>
        <translation>Ansicht des Rauschens</translation>
    </message>
    <message>
        <source>&amp;Lighting</source>
        <translation>Be&amp;leuchtung</translation>
    </message>
    <message>
        <source>Shade the mesh, or not.</source>
        <translation>Das Netz schattieren oder nicht.</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>&amp;Noise</source>
        <translation>&amp;Rauschen</translation>
    </message>
    <message>
        <source>Covariance error %1 × the floor</source>
        <translation>Kovarianzfehler %1 × die Grenze</translation>
    </message>
    <message>
        <source>&amp;Keep to compare</source>
        <translation>Zum Vergleich &amp;behalten</translation>
    </message>
    <message>
        <source>Keep the present texton as A. Change something, then look at both by turns.</source>
        <translation>Das jetzige Texton als A behalten. Etwas ändern und dann beide abwechselnd ansehen.</translation>
    </message>
    <message>
        <source>Look at the kept texton and its noise, and back at the present one.</source>
        <translation>Das behaltene Texton und sein Rauschen ansehen, und zurück zum jetzigen.</translation>
    </message>
    <message>
        <source>Show &amp;the kept one (A/B)</source>
        <translation>&amp;Das behaltene zeigen (A/B)</translation>
    </message>
    <message>
        <source>Kept and present side &amp;by side</source>
        <translation>Behaltenes &amp;und jetziges nebeneinander</translation>
    </message>
    <message>
        <source>The noise of the kept texton on the left, that of the present one on the right.</source>
        <translation>Links das Rauschen des behaltenen Textons, rechts das des jetzigen.</translation>
    </message>
    <message>
        <source>Mix</source>
        <translation>Mischen</translation>
    </message>
    <message>
        <source>&amp;Mix</source>
        <translation>&amp;Mischen</translation>
    </message>
    <message>
        <source>&amp;Open a second material...</source>
        <translation>Ein zweites Material ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Open another photo, to mix it with the first one.</source>
        <translation>Ein weiteres Foto öffnen, um es mit dem ersten zu mischen.</translation>
    </message>
    <message>
        <source>S&amp;wap A and B</source>
        <translation>A und B &amp;tauschen</translation>
    </message>
    <message>
        <source>Let the two materials change places. The noise stays as it is.</source>
        <translation>Die beiden Materialien die Plätze tauschen lassen. Das Rauschen bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>&amp;Remove the second material</source>
        <translation>&amp;Das zweite Material entfernen</translation>
    </message>
    <message>
        <source>Show the first material alone again.</source>
        <translation>Wieder nur das erste Material zeigen.</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>&amp;Ansehen</translation>
    </message>
    <message>
        <source>The mouse paints nothing.</source>
        <translation>Die Maus malt nichts.</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinsel</translation>
    </message>
    <message>
        <source>Paint where the second material is, in the noise seen from above.</source>
        <translation>Malen, wo das zweite Material ist, im Rauschen von oben.</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Glätten</translation>
    </message>
    <message>
        <source>Soften borders in the map.</source>
        <translation>Grenzen in der Karte weicher machen.</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>&amp;Radierer</translation>
    </message>
    <message>
        <source>Bring the first material back.</source>
        <translation>Das erste Material zurückholen.</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>&amp;Verlauf</translation>
    </message>
    <message>
        <source>Drag a line: one material at its start, the other at its end.</source>
        <translation>Eine Linie ziehen: ein Material am Anfang, das andere am Ende.</translation>
    </message>
    <message>
        <source>Ro&amp;und gradient</source>
        <translation>R&amp;under Verlauf</translation>
    </message>
    <message>
        <source>Drag from the middle: one material inside, the other around it.</source>
        <translation>Von der Mitte ziehen: ein Material innen, das andere rundherum.</translation>
    </message>
    <message>
        <source>L&amp;arger brush</source>
        <translation>Größ&amp;erer Pinsel</translation>
    </message>
    <message>
        <source>Make the brush a quarter larger.</source>
        <translation>Den Pinsel um ein Viertel vergrößern.</translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation>&amp;Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>Make the brush a quarter smaller.</source>
        <translation>Den Pinsel um ein Viertel verkleinern.</translation>
    </message>
    <message>
        <source>&amp;Fill the map</source>
        <translation>Die Karte f&amp;üllen</translation>
    </message>
    <message>
        <source>All of it becomes what the brush paints.</source>
        <translation>Alles wird zu dem, was der Pinsel malt.</translation>
    </message>
    <message>
        <source>One strip for each texton, from the first material on the left to the second one on the right.</source>
        <translation>Ein Streifen für jedes Texton, vom ersten Material links bis zum zweiten rechts.</translation>
    </message>
    <message>
        <source>&amp;Invert the map</source>
        <translation>Die Karte umke&amp;hren</translation>
    </message>
    <message>
        <source>The second material where the first one was.</source>
        <translation>Das zweite Material, wo das erste war.</translation>
    </message>
    <message>
        <source>Re&amp;peat the map</source>
        <translation>Die Karte &amp;wiederholen</translation>
    </message>
    <message>
        <source>Beyond its border the map comes again, instead of going on as it ends.</source>
        <translation>Jenseits ihres Randes kommt die Karte wieder, statt fortzusetzen, wie sie endet.</translation>
    </message>
    <message>
        <source>S&amp;how the map</source>
        <translation>Die Karte &amp;zeigen</translation>
    </message>
    <message>
        <source>Lay the map over the noise: blue is the first material, amber the second one.</source>
        <translation>Die Karte über das Rauschen legen: Blau ist das erste Material, Bernstein das zweite.</translation>
    </message>
    <message>
        <source>Import a map...</source>
        <translation>Eine Karte &amp;importieren...</translation>
    </message>
    <message>
        <source>Take a gray picture as the map: black is the first material, white the second.</source>
        <translation>Ein graues Bild als Karte nehmen: Schwarz ist das erste Material, Weiß das zweite.</translation>
    </message>
    <message>
        <source>E&amp;xport the map...</source>
        <translation>Die Karte e&amp;xportieren...</translation>
    </message>
    <message>
        <source>Save the map as a gray picture.</source>
        <translation>Die Karte als graues Bild sichern.</translation>
    </message>
    <message>
        <source>Import a map</source>
        <translation>Eine Karte importieren</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.tga *.bmp *.webp);;All files (*)</source>
        <translation>Bilder (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.tga *.bmp *.webp);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export the map</source>
        <translation>Die Karte exportieren</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.exr)</source>
        <translation>Bilder (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>S&amp;trips, left to right</source>
        <translation>&amp;Streifen von links nach rechts</translation>
    </message>
    <message>
        <source>Strips, top to bottom</source>
        <translation>Streifen von &amp;oben nach unten</translation>
    </message>
    <message>
        <source>One strip for each texton, from the first material at the top to the second one at the bottom.</source>
        <translation>Ein Streifen für jedes Texton, vom ersten Material oben bis zum zweiten unten.</translation>
    </message>
    <message>
        <source>Smooth passage</source>
        <translation>Sa&amp;nfter Übergang</translation>
    </message>
    <message>
        <source>From the first material on the left to the second one on the right, slowly at both ends.</source>
        <translation>Vom ersten Material links zum zweiten rechts, an beiden Enden langsam.</translation>
    </message>
</context>
<context>
    <name>txn::app::MapPainter</name>
    <message>
        <source>Smooth the map</source>
        <translation>Die Karte glätten</translation>
    </message>
    <message>
        <source>Erase in the map</source>
        <translation>In der Karte radieren</translation>
    </message>
    <message>
        <source>Gradient in the map</source>
        <translation>Verlauf in der Karte</translation>
    </message>
    <message>
        <source>Paint in the map</source>
        <translation>In der Karte malen</translation>
    </message>
</context>
<context>
    <name>txn::app::MessageBar</name>
    <message>
        <source>Dismiss the message</source>
        <translation>Die Meldung schließen</translation>
    </message>
    <message>
        <source>Dismiss the message.</source>
        <translation>Die Meldung schließen.</translation>
    </message>
</context>
<context>
    <name>txn::app::MixEditor</name>
    <message>
        <source>Swap A and B</source>
        <translation>A und B tauschen</translation>
    </message>
    <message>
        <source>Remove B</source>
        <translation>B entfernen</translation>
    </message>
    <message>
        <source>Fill the map</source>
        <translation>Die Karte füllen</translation>
    </message>
    <message>
        <source>Strips from A to B</source>
        <translation>Streifen von A bis B</translation>
    </message>
    <message>
        <source>Invert the map</source>
        <translation>Die Karte umkehren</translation>
    </message>
    <message>
        <source>Repeat the map</source>
        <translation>Die Karte wiederholen</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>Import the map</source>
        <translation>Die Karte importieren</translation>
    </message>
    <message>
        <source>Saving the map</source>
        <translation>Die Karte wird gesichert</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gesichert</translation>
    </message>
    <message>
        <source>Smooth passage from A to B</source>
        <translation>Sanfter Übergang von A bis B</translation>
    </message>
</context>
<context>
    <name>txn::app::MixPanel</name>
    <message>
        <source>Drop a photo</source>
        <translation>Ein Foto hierher ziehen</translation>
    </message>
    <message>
        <source>The first material. Click to open another one, or drop a photo here.</source>
        <translation>Das erste Material. Anklicken, um ein anderes zu öffnen, oder ein Foto hierher ziehen.</translation>
    </message>
    <message>
        <source>Drop a second photo</source>
        <translation>Ein zweites Foto hierher ziehen</translation>
    </message>
    <message>
        <source>The second material, to be mixed with the first. Click to open one, or drop a photo here.</source>
        <translation>Das zweite Material, das mit dem ersten gemischt wird. Anklicken, um eines zu öffnen, oder ein Foto hierher ziehen.</translation>
    </message>
    <message>
        <source>Let A and B change places.</source>
        <translation>A und B die Plätze tauschen lassen.</translation>
    </message>
    <message>
        <source>Take the second material away and show the first one alone.</source>
        <translation>Das zweite Material wegnehmen und nur das erste zeigen.</translation>
    </message>
    <message>
        <source>Textons from A to B</source>
        <translation>Textons von A bis B</translation>
    </message>
    <message>
        <source>The textons from A to B, each with a piece of its noise. Click one to see it alone and to paint with it; click it again to see the mixture.</source>
        <translation>Die Textons von A bis B, jedes mit einem Stück seines Rauschens. Eines anklicken, um es allein zu sehen und damit zu malen; noch einmal, um die Mischung zu sehen.</translation>
    </message>
    <message>
        <source>Textons</source>
        <translation>Textons</translation>
    </message>
    <message>
        <source>How many textons lie between A and B. More make the passage finer. Try 21.</source>
        <translation>Wie viele Textons zwischen A und B liegen. Mehr machen den Übergang feiner. Am besten 21 versuchen.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Radierer</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Round gradient</source>
        <translation>Runder Verlauf</translation>
    </message>
    <message>
        <source>What the mouse does in the noise seen from above. Brush paints B, or any mixture; the eraser brings A back. Shift draws straight lines.</source>
        <translation>Was die Maus im Rauschen von oben tut. Der Pinsel malt B oder jede Mischung; der Radierer holt A zurück. Umschalt zieht gerade Linien.</translation>
    </message>
    <message>
        <source>Paint with</source>
        <translation>Malen mit</translation>
    </message>
    <message>
        <source>What the brush paints: 0 is A, 1 is B, anything else lies between.</source>
        <translation>Was der Pinsel malt: 0 ist A, 1 ist B, alles andere liegt dazwischen.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>How large the brush is. The keys [ and ] change it, too.</source>
        <translation>Wie groß der Pinsel ist. Auch die Tasten [ und ] ändern ihn.</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>How sharp the rim of the brush is. Low passes softly from A to B.</source>
        <translation>Wie scharf der Rand des Pinsels ist. Wenig geht sanft von A nach B über.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>How far one stroke goes towards what it paints.</source>
        <translation>Wie weit ein Strich zu dem hin geht, was er malt.</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Links und rechts</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>Oben und unten</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beides</translation>
    </message>
    <message>
        <source>Strokes are mirrored about the middle of the map.</source>
        <translation>Striche werden an der Mitte der Karte gespiegelt.</translation>
    </message>
    <message>
        <source>A texton from a file cannot be mixed. Open a photo instead.</source>
        <translation>Ein Texton aus einer Datei lässt sich nicht mischen. Stattdessen ein Foto öffnen.</translation>
    </message>
    <message>
        <source>Open a photo, then a second one to mix it with.</source>
        <translation>Ein Foto öffnen, dann ein zweites, um beide zu mischen.</translation>
    </message>
    <message>
        <source>Drop a second material onto B, then paint where it is.</source>
        <translation>Ein zweites Material auf B ziehen, dann malen, wo es ist.</translation>
    </message>
    <message>
        <source>Computing the textons from A to B...</source>
        <translation>Die Textons von A bis B werden berechnet...</translation>
    </message>
    <message>
        <source>Textons so far: %1</source>
        <translation>Textons bisher: %1</translation>
    </message>
    <message>
        <source>Distance from A to B: %1</source>
        <translation>Abstand von A nach B: %1</translation>
    </message>
    <message>
        <source>The textons from A to B are not up to date. Compute again with F5.</source>
        <translation>Die Textons von A bis B sind nicht aktuell. Mit F5 neu berechnen.</translation>
    </message>
</context>
<context>
    <name>txn::app::NoisePanel</name>
    <message>
        <source>Impacts per pixel</source>
        <translation>Impulse je Pixel</translation>
    </message>
    <message>
        <source>How many textons overlap at a pixel, on average (the MNI). Fewer is faster; too few show single textons. Try 12.</source>
        <translation>Wie viele Textons sich an einem Pixel im Mittel überlagern (die MNI). Weniger ist schneller; zu wenige zeigen einzelne Textons. Am besten 12 versuchen.</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Random, both signs</source>
        <translation>Zufällig, beide Vorzeichen</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufällig</translation>
    </message>
    <message>
        <source>How textons are scattered. Even (stratified) needs the fewest; random (Poisson) is the papers&apos; way and needs about 30 impacts.</source>
        <translation>Wie Textons verstreut werden. Gleichmäßig (geschichtet) braucht die wenigsten; zufällig (Poisson) ist der Weg der Arbeiten und braucht etwa 30 Impulse.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Another number gives another piece of the same material.</source>
        <translation>Eine andere Zahl ergibt ein anderes Stück desselben Materials.</translation>
    </message>
    <message>
        <source>Noise seed</source>
        <translation>Startwert des Rauschens</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Mesh, by its UVs</source>
        <translation>Netz, nach seinen UVs</translation>
    </message>
    <message>
        <source>Mesh, any surface</source>
        <translation>Netz, jede Oberfläche</translation>
    </message>
    <message>
        <source>What the noise is shown on. Drag in the view to look around. Any surface needs no texture coordinates.</source>
        <translation>Worauf das Rauschen gezeigt wird. In der Ansicht ziehen, um herumzusehen. Jede Oberfläche braucht keine Texturkoordinaten.</translation>
    </message>
    <message>
        <source>Noise view</source>
        <translation>Ansicht des Rauschens</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation>Aus einer Datei...</translation>
    </message>
    <message>
        <source>The object that wears the noise. OBJ and PLY files can be opened.</source>
        <translation>Der Gegenstand, der das Rauschen trägt. OBJ- und PLY-Dateien lassen sich öffnen.</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Shades the mesh. Switch it off to judge colors.</source>
        <translation>Schattiert das Netz. Ausschalten, um Farben zu beurteilen.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Isotropic</source>
        <translation>Isotrop</translation>
    </message>
    <message>
        <source>Anisotropic</source>
        <translation>Anisotrop</translation>
    </message>
    <message>
        <source>Of the graphics card</source>
        <translation>Von der Grafikkarte</translation>
    </message>
    <message>
        <source>Keeps distant noise from flickering. Anisotropic is the sharpest at a slant.</source>
        <translation>Verhindert, dass fernes Rauschen flimmert. Anisotrop ist in der Schräge am schärfsten.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>How large the grain is, next to that of the photo.</source>
        <translation>Wie groß das Korn ist, verglichen mit dem des Fotos.</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Strengthens or softens the grain. Less of it clips fewer colors.</source>
        <translation>Verstärkt oder mildert das Korn. Weniger schneidet weniger Farben ab.</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Makes the whole material lighter or darker.</source>
        <translation>Macht das ganze Material heller oder dunkler.</translation>
    </message>
    <message>
        <source>What the picture costs: the time to draw one, and how often the texton is looked up for each pixel.</source>
        <translation>Was das Bild kostet: die Zeit, eines zu zeichnen, und wie oft das Texton je Pixel abgefragt wird.</translation>
    </message>
    <message>
        <source>Values that are darker than black or lighter than white. Lower the contrast, or export EXR, which keeps them.</source>
        <translation>Werte, die dunkler als Schwarz oder heller als Weiß sind. Den Kontrast senken oder EXR exportieren, das sie behält.</translation>
    </message>
    <message>
        <source>Save picture...</source>
        <translation>Bild sichern...</translation>
    </message>
    <message>
        <source>Saves what the noise view shows as a PNG file.</source>
        <translation>Sichert, was die Ansicht des Rauschens zeigt, als PNG-Datei.</translation>
    </message>
    <message>
        <source>Open a mesh</source>
        <translation>Ein Netz öffnen</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.ply);;All files (*)</source>
        <translation>Netze (*.obj *.ply);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 frames per second, %2 fetches per pixel</source>
        <translation>%1 Bilder je Sekunde, %2 Abfragen je Pixel</translation>
    </message>
    <message>
        <source>%1 % of the values are clipped</source>
        <translation>%1 % der Werte sind abgeschnitten</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>All maps of the material together under a light, or one of them.</source>
        <translation>Alle Karten des Materials zusammen unter einem Licht, oder eine davon.</translation>
    </message>
    <message>
        <source>Shown map</source>
        <translation>Gezeigte Karte</translation>
    </message>
    <message>
        <source>Light from</source>
        <translation>Licht von</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 is the right, 90 the top. Or drag with the right button in the view.</source>
        <translation>Woher das Licht kommt: 0 ist rechts, 90 oben. Oder mit der rechten Taste in der Ansicht ziehen.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Light height</source>
        <translation>Lichthöhe</translation>
    </message>
    <message>
        <source>How high the light stands. Low light shows the relief, high light the colors.</source>
        <translation>Wie hoch das Licht steht. Tiefes Licht zeigt das Relief, hohes die Farben.</translation>
    </message>
</context>
<context>
    <name>txn::app::PictureView</name>
    <message>
        <source>%1 fps</source>
        <translation>%1 B/s</translation>
    </message>
    <message>
        <source>Drop a photo here</source>
        <translation>Ein Foto hierher ziehen</translation>
    </message>
    <message>
        <source>A texton from a file has no exemplar</source>
        <translation>Ein Texton aus einer Datei hat keine Vorlage</translation>
    </message>
    <message>
        <source>A texton from a file has no Gaussian version</source>
        <translation>Ein Texton aus einer Datei hat keine Gauß-Version</translation>
    </message>
    <message>
        <source>Gaussian method</source>
        <translation>Gauß-Verfahren</translation>
    </message>
    <message>
        <source>Gaussian seed</source>
        <translation>Startwert der Gauß-Version</translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation>%1 x %2 px</translation>
    </message>
    <message>
        <source>A picture. The wheel zooms where the mouse is, the middle button or Space moves it, F shows it whole. Hold ` to see the exemplar instead. The right button moves the light of a material.</source>
        <translation>Ein Bild. Das Rad zoomt, wo die Maus ist, die mittlere Taste oder Leertaste verschiebt es, F zeigt es ganz. ` halten, um stattdessen die Vorlage zu sehen. Die rechte Taste bewegt das Licht eines Materials.</translation>
    </message>
    <message>
        <source>A (kept)</source>
        <translation>A (behalten)</translation>
    </message>
    <message>
        <source>B (present)</source>
        <translation>B (jetzt)</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
</context>
<context>
    <name>txn::app::Pipeline</name>
    <message>
        <source>Preparing the exemplar</source>
        <translation>Die Vorlage wird vorbereitet</translation>
    </message>
    <message>
        <source>Making the Gaussian version</source>
        <translation>Die Gauß-Version wird gemacht</translation>
    </message>
    <message>
        <source>Computing the texton</source>
        <translation>Das Texton wird berechnet</translation>
    </message>
    <message>
        <source>Judging the exemplar</source>
        <translation>Die Vorlage wird beurteilt</translation>
    </message>
    <message>
        <source>Measuring spectra</source>
        <translation>Spektren werden gemessen</translation>
    </message>
    <message>
        <source>Loading the mesh</source>
        <translation>Das Netz wird geladen</translation>
    </message>
    <message>
        <source>Preparing the second exemplar</source>
        <translation>Die zweite Vorlage wird vorbereitet</translation>
    </message>
    <message>
        <source>Computing the textons from A to B</source>
        <translation>Die Textons von A bis B werden berechnet</translation>
    </message>
</context>
<context>
    <name>txn::app::ProjectDocument</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
</context>
<context>
    <name>txn::app::RecoveryDialog</name>
    <message>
        <source>Recover your work</source>
        <translation>Die Arbeit zurückholen</translation>
    </message>
    <message>
        <source>Texton Studio was not closed properly last time. This can come back:</source>
        <translation>Texton Studio wurde beim letzten Mal nicht richtig geschlossen. Das kann zurückkommen:</translation>
    </message>
    <message>
        <source>Work that can come back</source>
        <translation>Arbeit, die zurückkommen kann</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Delete this copy</source>
        <translation>Diese Kopie löschen</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Keeps the copies and asks again next time.</source>
        <translation>Behält die Kopien und fragt beim nächsten Mal wieder.</translation>
    </message>
    <message>
        <source>The newest is at the top.</source>
        <translation>Die neueste steht oben.</translation>
    </message>
    <message>
        <source>Opens this work again. Save it then; the original file is untouched.</source>
        <translation>Öffnet diese Arbeit wieder. Danach sichern; die ursprüngliche Datei bleibt unberührt.</translation>
    </message>
    <message>
        <source>Gives this work up for good.</source>
        <translation>Gibt diese Arbeit endgültig auf.</translation>
    </message>
</context>
<context>
    <name>txn::app::SeedField</name>
    <message>
        <source>Roll the dice</source>
        <translation>Würfeln</translation>
    </message>
    <message>
        <source>Another random result.</source>
        <translation>Ein anderes Zufallsergebnis.</translation>
    </message>
    <message>
        <source>Keep this seed</source>
        <translation>Diesen Startwert behalten</translation>
    </message>
    <message>
        <source>Keeps this number when new seeds are rolled.</source>
        <translation>Behält diese Zahl, wenn neue Startwerte gewürfelt werden.</translation>
    </message>
</context>
<context>
    <name>txn::app::ShortcutEditor</name>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Befehle suchen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Press the keys that you want for the chosen command.</source>
        <translation>Die gewünschten Tasten für den gewählten Befehl drücken.</translation>
    </message>
    <message>
        <source>No keys</source>
        <translation>Keine Tasten</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>These keys were those of &quot;%1&quot;, which has none now.</source>
        <translation>Diese Tasten gehörten zu „%1“, das nun keine hat.</translation>
    </message>
    <message>
        <source>Type a part of a command&apos;s name.</source>
        <translation>Einen Teil des Namens eines Befehls tippen.</translation>
    </message>
    <message>
        <source>Choose a command to give it other keys.</source>
        <translation>Einen Befehl wählen, um ihm andere Tasten zu geben.</translation>
    </message>
    <message>
        <source>Takes the chosen command&apos;s keys away.</source>
        <translation>Nimmt dem gewählten Befehl seine Tasten.</translation>
    </message>
    <message>
        <source>Back to the keys that the program came with.</source>
        <translation>Zurück zu den Tasten, mit denen das Programm kam.</translation>
    </message>
    <message>
        <source>Closes this window. Changes are kept already.</source>
        <translation>Schließt dieses Fenster. Änderungen gelten schon.</translation>
    </message>
</context>
<context>
    <name>txn::app::SpectrumPanel</name>
    <message>
        <source>Exemplar</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation>Gauß-Version</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Power spectrum</source>
        <translation>Leistungsspektrum</translation>
    </message>
    <message>
        <source>How strong waves of each direction and length are: long ones in the middle, fine grain outside. The three should look alike.</source>
        <translation>Wie stark Wellen jeder Richtung und Länge sind: lange in der Mitte, feines Korn außen. Die drei sollten sich gleichen.</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autokorrelation</translation>
    </message>
    <message>
        <source>How alike two points are at each distance and direction. The size of the bright patch is that of the grain; it should fit into the support.</source>
        <translation>Wie ähnlich sich zwei Punkte in jedem Abstand und jeder Richtung sind. Der helle Fleck ist so groß wie das Korn; er sollte in den Träger passen.</translation>
    </message>
</context>
<context>
    <name>txn::app::TextonPanel</name>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>As close as two photos of this material</source>
        <translation>So nah wie zwei Fotos dieses Materials</translation>
    </message>
    <message>
        <source>Long grain is lost. Try a larger support</source>
        <translation>Langes Korn geht verloren. Ein größerer Träger hilft</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>Noch %n s</numerusform>
            <numerusform>Noch %n s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n min left</source>
        <translation>
            <numerusform>Noch %n min</numerusform>
            <numerusform>Noch %n min</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress of the texton</source>
        <translation>Fortschritt des Textons</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop computing and go back to the last finished texton. Change anything to start again.</source>
        <translation>Die Berechnung anhalten und zum letzten fertigen Texton zurückkehren. Etwas ändern, um neu zu beginnen.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>The outline of the texton. A square suits almost everything; a rectangle follows long grain.</source>
        <translation>Der Umriss des Textons. Ein Quadrat passt fast immer; ein Rechteck folgt langem Korn.</translation>
    </message>
    <message>
        <source>Texton shape</source>
        <translation>Form des Textons</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Träger</translation>
    </message>
    <message>
        <source>How large the texton is. Features longer than this get lost; larger takes longer to compute. Try 64 first, 128 for long grain.</source>
        <translation>Wie groß das Texton ist. Längere Merkmale gehen verloren; größere brauchen länger. Erst 64 versuchen, 128 für langes Korn.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>The height of a rectangular texton. Make it small where the grain runs from left to right.</source>
        <translation>Die Höhe eines rechteckigen Textons. Klein wählen, wo das Korn von links nach rechts läuft.</translation>
    </message>
    <message>
        <source>Support height</source>
        <translation>Höhe des Trägers</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Nächster Wert</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Kubisch</translation>
    </message>
    <message>
        <source>Quintic</source>
        <translation>Quintisch</translation>
    </message>
    <message>
        <source>How values between the texton&apos;s pixels are found. Linear is what graphics cards do for free; cubic is smoother when magnified.</source>
        <translation>Wie Werte zwischen den Pixeln des Textons gefunden werden. Linear können Grafikkarten umsonst; kubisch ist vergrößert glatter.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>How long the texton is refined. Watch the curve: where it runs flat, more brings nothing.</source>
        <translation>Wie lange das Texton verfeinert wird. Auf die Kurve achten: wo sie flach ist, bringt mehr nichts.</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Schwung</translation>
    </message>
    <message>
        <source>Gets there in fewer iterations. 0.9 is good; 0 is the plain method of the papers.</source>
        <translation>Kommt in weniger Schritten ans Ziel. 0,9 ist gut; 0 ist das einfache Verfahren der Arbeiten.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Another number gives another, equally good texton. Roll the dice, or lock the one you like.</source>
        <translation>Eine andere Zahl ergibt ein anderes, ebenso gutes Texton. Würfeln oder das schönste feststellen.</translation>
    </message>
    <message>
        <source>Texton seed</source>
        <translation>Startwert des Textons</translation>
    </message>
    <message>
        <source>Lock the texton seed</source>
        <translation>Startwert des Textons feststellen</translation>
    </message>
    <message>
        <source>Unlock the texton seed</source>
        <translation>Startwert des Textons lösen</translation>
    </message>
    <message>
        <source>Exact colors</source>
        <translation>Genaue Farben</translation>
    </message>
    <message>
        <source>Corrects the texton so that the noise has exactly the colors of the photo. Leave it on unless you compare with the papers.</source>
        <translation>Berichtigt das Texton, so dass das Rauschen genau die Farben des Fotos hat. Eingeschaltet lassen, außer zum Vergleich mit den Arbeiten.</translation>
    </message>
    <message>
        <source>Open a photo to compute its texton</source>
        <translation>Ein Foto öffnen, um sein Texton zu berechnen</translation>
    </message>
    <message>
        <source>A texton from a file</source>
        <translation>Ein Texton aus einer Datei</translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation>%1 x %2 px</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Berechnung läuft</translation>
    </message>
    <message>
        <source>Compute again</source>
        <translation>Neu berechnen</translation>
    </message>
    <message>
        <source>As close as this method gets</source>
        <translation>So nah, wie dieses Verfahren kommt</translation>
    </message>
    <message>
        <source>Choosing the number of kernels</source>
        <translation>Die Zahl der Kerne wird gewählt</translation>
    </message>
    <message>
        <source>Getting closer</source>
        <translation>Es wird besser</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Close. A larger support or another seed may help</source>
        <translation>Nah dran. Ein größerer Träger oder ein anderer Startwert kann helfen</translation>
    </message>
    <message>
        <source>Fair. The material has more order than noise can keep</source>
        <translation>Mäßig. Das Material hat mehr Ordnung, als Rauschen halten kann</translation>
    </message>
    <message>
        <source>Covariance error %1 × the floor (%2)</source>
        <translation>Kovarianzfehler %1 × die Grenze (%2)</translation>
    </message>
    <message>
        <source>Relative model error %1</source>
        <translation>Relativer Modellfehler %1</translation>
    </message>
    <message>
        <source>Error %1 after %2 iterations</source>
        <translation>Fehler %1 nach %2 Schritten</translation>
    </message>
    <message>
        <source>How far the noise&apos;s correlations are from the photo&apos;s. At 1 × the floor they are as close as one half of the photo is to all of it. The relative model error stays near 0.46 even for a perfect texton, because it compares with one photo, in which every wave&apos;s strength is random.</source>
        <translation>Wie weit die Korrelationen des Rauschens von denen des Fotos entfernt sind. Bei 1 × der Grenze sind sie so nah wie eine Hälfte des Fotos dem ganzen. Der relative Modellfehler bleibt selbst bei einem vollkommenen Texton um 0,46, weil er mit einem einzigen Foto vergleicht, in dem die Stärke jeder Welle zufällig ist.</translation>
    </message>
    <message>
        <source>Use the suggested support</source>
        <translation>Den vorgeschlagenen Träger verwenden</translation>
    </message>
    <message>
        <source>Suggested support</source>
        <translation>Vorgeschlagener Träger</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Best fit</source>
        <translation>Beste Anpassung</translation>
    </message>
    <message>
        <source>Papers&apos; projections</source>
        <translation>Projektionen der Arbeiten</translation>
    </message>
    <message>
        <source>How the texton is found. Best fit comes closest for the same cost; the projections are the papers&apos; own way, to compare with.</source>
        <translation>Wie das Texton gefunden wird. Beste Anpassung kommt zum selben Preis am nächsten; die Projektionen sind der Weg der Arbeiten, zum Vergleich.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Kernels</source>
        <translation>Kerne</translation>
    </message>
    <message>
        <source>Each impact picks one of so many small pictures. More follow colors and maps that vary independently, at the same speed. Automatic tries them on one half of the photo.</source>
        <translation>Jeder Impuls nimmt eines von so vielen kleinen Bildern. Mehr folgen Farben und Karten, die unabhängig schwanken, bei gleichem Tempo. Automatisch versucht sie an einer Hälfte des Fotos.</translation>
    </message>
    <message>
        <source>What was tried on one half of the photo: the error on the other half, and the memory on a graphics card. The fewest within 5 % of the best are taken.</source>
        <translation>Was an einer Hälfte des Fotos versucht wurde: der Fehler an der anderen Hälfte und der Speicher auf einer Grafikkarte. Genommen werden die wenigsten, die bis auf 5 % so gut sind wie die besten.</translation>
    </message>
    <message>
        <source>Suggested: %1 px</source>
        <translation>Vorschlag: %1 px</translation>
    </message>
    <message>
        <source>Suggested: none</source>
        <translation>Vorschlag: keiner</translation>
    </message>
    <message>
        <source>As large as the grain of this material needs. A texton of that size leaves out %1 % of the correlation.</source>
        <translation>So groß, wie das Korn dieses Materials es braucht. Ein Texton dieser Größe lässt %1 % der Korrelation weg.</translation>
    </message>
    <message>
        <source>The photo is too small to tell how large its grain is.</source>
        <translation>Das Foto ist zu klein, um zu sagen, wie groß sein Korn ist.</translation>
    </message>
    <message>
        <source>Error against iterations</source>
        <translation>Fehler gegen Schritte</translation>
    </message>
    <message>
        <source>The error while the texton is refined. Lower is closer.</source>
        <translation>Der Fehler, während das Texton verfeinert wird. Weniger ist näher.</translation>
    </message>
    <message>
        <source>Kernels: %1, error %2, %3 KB</source>
        <translation>Kerne: %1, Fehler %2, %3 KB</translation>
    </message>
</context>
<context>
    <name>txn::app::ViewTitle</name>
    <message>
        <source>Exemplar</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation>Gauß-Version</translation>
    </message>
    <message>
        <source>Texton</source>
        <translation>Texton</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Picture in this view</source>
        <translation>Bild in dieser Ansicht</translation>
    </message>
    <message>
        <source>Picture right of the border</source>
        <translation>Bild rechts der Grenze</translation>
    </message>
    <message>
        <source>What this view shows.</source>
        <translation>Was diese Ansicht zeigt.</translation>
    </message>
    <message>
        <source>What is shown right of the border that you can drag.</source>
        <translation>Was rechts der Grenze gezeigt wird, die sich ziehen lässt.</translation>
    </message>
    <message>
        <source>Method of the Gaussian version</source>
        <translation>Verfahren der Gauß-Version</translation>
    </message>
    <message>
        <source>ADSN: random phases and strengths, what texton noise comes to. RPN: random phases only, keeps the exact spectrum of the photo.</source>
        <translation>ADSN: zufällige Phasen und Stärken, wohin Texton-Rauschen führt. RPN: nur zufällige Phasen, behält das genaue Spektrum des Fotos.</translation>
    </message>
    <message>
        <source>ADSN</source>
        <translation>ADSN</translation>
    </message>
    <message>
        <source>RPN</source>
        <translation>RPN</translation>
    </message>
    <message>
        <source>Another Gaussian version</source>
        <translation>Eine andere Gauß-Version</translation>
    </message>
    <message>
        <source>Roll the dice for another Gaussian version.</source>
        <translation>Würfeln, um eine andere Gauß-Version zu sehen.</translation>
    </message>
    <message>
        <source>This is still an older result; the new one is being computed.</source>
        <translation>Das ist noch ein älteres Ergebnis; das neue wird berechnet.</translation>
    </message>
    <message>
        <source>Older result</source>
        <translation>Älteres Ergebnis</translation>
    </message>
</context>
</TS>
