<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR">
<context>
    <name>HistogramPanel</name>
    <message>
        <source>Red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Warnings</name>
    <message>
        <source>%1 has changed since the project was saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is missing; a sphere takes its place.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>A value is out of its range; please choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is not there; please choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be read; please open another copy of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be written; please choose another place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is too large; please choose a smaller picture, part or size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This cannot be done with such a file; please choose another kind.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sizes do not fit together; please choose another support or part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is all one color, or has values that are no numbers; please choose another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::Autosave</name>
    <message>
        <source>Keeping a copy</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::BeforeAfter</name>
    <message>
        <source>Hold the mouse button or the space bar to see it as it was before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::CommandPalette</name>
    <message>
        <source>Type what you want to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1   (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::ErrorPlot</name>
    <message>
        <source>Iterations</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::ExemplarPanel</name>
    <message>
        <source>8 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>16 bit float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>32 bit float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colors will clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of the noise&apos;s values are darker than black or lighter than white. Lower the contrast of the noise, or export EXR.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suits, but highlights or shadows even out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its values lean to one side; those of the noise are spread evenly around the mean.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Has patches or shapes that even out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its grain is stronger in some places than in others, which a Gaussian texture cannot keep. Compare with the Gaussian version, or crop an even part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suits texton noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is all grain and no shapes, and its colors fit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag over the part of the photo that looks the same all over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw a line along the grain; it becomes level or upright.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the photo as it was opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the exemplar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The photo and its crop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to use only a part of the photo. Arrow keys move it, with Shift they resize it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns the photo, counterclockwise. Or draw a line with Straighten.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sRGB values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sRGB values keep dark grain; linear light suits renderers. Try sRGB first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even out the lighting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes away shade that is smoother than the radius, such as a dark corner.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only what is smoother than this goes away. Small values also take large grain.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lighting radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lighting before and after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes away the jump from one border of the photo to the other (the periodic component). Switch it off for pictures that tile already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seam before and after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A texton from a file needs no exemplar.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a photo of a material, or drop one here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sRGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>color profile converted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>transparency left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skewness %1, excess kurtosis %2, clipped values %3 %, sub-bands %4 standard deviations from those of its Gaussian versions.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::ExportDialog</name>
    <message>
        <source>PNG, 8 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG, 16 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EXR, 16 bit float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EXR, 32 bit float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TIFF, 8 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TIFF, 16 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TIFF, 32 bit float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EXR, exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every value as it is, with all parameters inside. The best choice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For programs that cannot read EXR. The JSON file tells how values are coded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>.texton, as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The format of the papers&apos; authors, for their programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Common sizes; any other can be typed below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 x %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles without a seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture repeats without a seam. Off, it is a piece of the endless plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where on the endless plane the piece is cut out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EXR keeps values beyond black and white; PNG and TIFF with 8 or 16 bits clip them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise texture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For engines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The noise as it is on screen, as a PNG picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything to draw endless material in your own program: the texton, one self-contained shader (GLSL 330, free to use under CC0), its parameters, and a small example program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choices that you saved under a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as preset...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words in braces are filled in: {name} {support} {mni} {seed} {size}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the files go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled. Nothing was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  (replaces a file)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no texton yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete all presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace files?</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) of these names exist already.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Wrote %n file(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 % of the values were clipped; EXR keeps them.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::FileController</name>
    <message>
        <source>Open %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a photo, texton or project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that can be opened (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp *.texton *.txnproj);;Photos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;Textons (*.texton *.exr *.png);;Projects (*.txnproj);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pasting a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texton Studio projects (*.txnproj)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save before closing?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving keeps the photo, all settings and the view in one project file.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::HistogramPanel</name>
    <message>
        <source>How often each value occurs. Where the noise reaches beyond 0 or 1, its colors are clipped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::JobRunner</name>
    <message>
        <source>there is not enough memory; try a smaller picture or size</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::JobsPanel</name>
    <message>
        <source>Work in progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is being computed right now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::JobsStatus</name>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the work is. The Jobs panel lists all of it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::KeyMapOverlay</name>
    <message>
        <source>All keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom at the mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle drag, Space drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look around the ground or mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold `</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See the exemplar instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See the difference, eightfold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fine steps of a slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slider: default; title: one view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::MainWindow</name>
    <message>
        <source>Opened the first of the files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovering %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That did not work: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The noise is drawn without the graphics card, from above only: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every change you made. Click one to go back to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What draws the noise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative model error %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x %1  y %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sRGB %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rust</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brushed metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cloth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leather</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close everything and start afresh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a photo, a texton or a project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the photo and all settings in one file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save project &amp;as...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save under another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write textons, textures and shaders for other programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;picture of the noise...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save what the noise view shows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the last change back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the change again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the picture or file in the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no picture in the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Shortcuts...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose your own keys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Single view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One picture fills the middle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side &amp;by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two pictures next to each other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exemplar, Gaussian version, texton and noise at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two pictures in one place, with a border to drag.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole exemplar.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One pixel of the picture is one of the screen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;200 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Twice as large.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;Gaussian version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the view under the mouse.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tile the exemplar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat the photo, to see the repetition that the noise does away with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B&amp;righter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show everything a third of a stop brighter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show everything a third of a stop darker.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N&amp;ormal exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the values as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at single channels as gray.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;All channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First channel (red)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second channel (green)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Third channel (blue)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is around the pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gray surround</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Black surround</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White surround</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compute again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute the texton once more and watch it form.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop computing the texton.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New &amp;seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another random result of what is under the mouse: Gaussian version, texton or noise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random phases and random strengths: what texton noise comes to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random phases only: keeps the exact spectrum of the photo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The texton&apos;s seed is locked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide this panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hide panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing but the pictures; the same key brings the panels back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on to the next panel with the keyboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put all panels back where they belong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the whole screen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colors of the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Command palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find any command by typing a part of its name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All keys at a glance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;What is this?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then click on anything to read about it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Texton Studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version, method and license.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Texton Studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Texton Studio %1&lt;/b&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Endless material from a photo, by the method of Galerne, Leclaire and Moisan (2014, 2017). Free software under the GNU General Public License, version 3 or later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a sa&amp;mple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;urround</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Texton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language changes when you start Texton Studio again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no noise to save yet. Open a photo first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written; please choose another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Photo inside the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On, a project holds the photo itself; off, it only remembers where the photo is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link the photo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photo inside the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian version: &amp;ADSN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian version: &amp;RPN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language of the window, from the next start on.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::MessageBar</name>
    <message>
        <source>Dismiss the message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss the message.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::NoisePanel</name>
    <message>
        <source>Impacts per pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many textons overlap at a pixel, on average (the MNI). Fewer is faster; too few show single textons. Try 12.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Placing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random, both signs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Random</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How textons are scattered. Even (stratified) needs the fewest; random (Poisson) is the papers&apos; way and needs about 30 impacts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another number gives another piece of the same material.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh, by its UVs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh, any surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the noise is shown on. Drag in the view to look around. Any surface needs no texture coordinates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The object that wears the noise. OBJ and PLY files can be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shades the mesh. Switch it off to judge colors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isotropic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anisotropic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the graphics card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps distant noise from flickering. Anisotropic is the sharpest at a slant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How large the grain is, next to that of the photo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strengthens or softens the grain. Less of it clips fewer colors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the whole material lighter or darker.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the picture costs: the time to draw one, and how often the texton is looked up for each pixel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values that are darker than black or lighter than white. Lower the contrast, or export EXR, which keeps them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves what the noise view shows as a PNG file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshes (*.obj *.ply);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 frames per second, %2 fetches per pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of the values are clipped</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::PictureView</name>
    <message>
        <source>%1 fps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop a photo here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A texton from a file has no exemplar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A texton from a file has no Gaussian version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::Pipeline</name>
    <message>
        <source>Preparing the exemplar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the Gaussian version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing the texton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Judging the exemplar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring spectra</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading the mesh</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::ProjectDocument</name>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::RecoveryDialog</name>
    <message>
        <source>Recover your work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texton Studio was not closed properly last time. This can come back:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work that can come back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete this copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the copies and asks again next time.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::SeedField</name>
    <message>
        <source>Roll the dice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another random result.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep this seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps this number when new seeds are rolled.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::ShortcutEditor</name>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the keys that you want for the chosen command.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These keys were those of &quot;%1&quot;, which has none now.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::SpectrumPanel</name>
    <message>
        <source>Exemplar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power spectrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How strong waves of each direction and length are: long ones in the middle, fine grain outside. The three should look alike.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How alike two points are at each distance and direction. The size of the bright patch is that of the grain; it should fit into the support.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::TextonPanel</name>
    <message>
        <source>px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Very close to the material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As close as two photos of this material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fair. A larger support may keep more of the grain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Long grain is lost. Try a larger support</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n min left</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>The relative model error: 0 is the same texture. The method leaves about 0.46 of the photo&apos;s own randomness, so do not expect 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the texton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop computing and go back to the last finished texton. Change anything to start again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline of the texton. A square suits almost everything; a rectangle follows long grain.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texton shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Support</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How large the texton is. Features longer than this get lost; larger takes longer to compute. Try 64 first, 128 for long grain.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The height of a rectangular texton. Make it small where the grain runs from left to right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Support height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quintic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How values between the texton&apos;s pixels are found. Linear is what graphics cards do for free; cubic is smoother when magnified.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long the texton is refined. Watch the curve: where it runs flat, more brings nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gets there in fewer iterations. 0.9 is good; 0 is the plain method of the papers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another number gives another, equally good texton. Roll the dice, or lock the one you like.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texton seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock the texton seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlock the texton seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exact colors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrects the texton so that the noise has exactly the colors of the photo. Leave it on unless you compare with the papers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative model error against iterations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The relative model error while the texton is refined. Lower is closer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a photo to compute its texton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A texton from a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative model error %1 after %2 iterations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>txn::app::ViewTitle</name>
    <message>
        <source>Exemplar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture in this view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture right of the border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What this view shows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is shown right of the border that you can drag.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method of the Gaussian version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ADSN: random phases and strengths, what texton noise comes to. RPN: random phases only, keeps the exact spectrum of the photo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ADSN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RPN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another Gaussian version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll the dice for another Gaussian version.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is still an older result; the new one is being computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Older result</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
