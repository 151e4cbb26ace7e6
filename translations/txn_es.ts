<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES">
<context>
    <name>Help</name>
    <message>
        <source>Show this help.</source>
        <translation>Mostrar esta ayuda.</translation>
    </message>
    <message>
        <source>Show the version.</source>
        <translation>Mostrar la versión.</translation>
    </message>
    <message>
        <source>Language of the window, such as en or fr.</source>
        <translation>Idioma de la ventana, por ejemplo en o es.</translation>
    </message>
    <message>
        <source>LANGUAGE</source>
        <translation>IDIOMA</translation>
    </message>
    <message>
        <source>Makes endless material from a photo. FILES may be photos, textons or a project.</source>
        <translation>Crea material sin fin a partir de una foto. FILES: fotos, textones o un proyecto.</translation>
    </message>
    <message>
        <source>What to open.</source>
        <translation>Qué abrir.</translation>
    </message>
    <message>
        <source>texton-studio: %1 See texton-studio --help.</source>
        <translation>texton-studio: %1 Consulte texton-studio --help.</translation>
    </message>
    <message>
        <source>With --version: those of all libraries, too.</source>
        <translation>Con --version: también las de todas las bibliotecas.</translation>
    </message>
</context>
<context>
    <name>Warnings</name>
    <message>
        <source>%1 has changed since the project was saved.</source>
        <translation>%1 ha cambiado desde que se guardó el proyecto.</translation>
    </message>
    <message>
        <source>%1 is missing; a sphere takes its place.</source>
        <translation>Falta %1; una esfera ocupa su lugar.</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>A value is out of its range; please choose another one.</source>
        <translation>Un valor está fuera de rango; elija otro.</translation>
    </message>
    <message>
        <source>The file is not there; please choose another one.</source>
        <translation>El archivo no está ahí; elija otro.</translation>
    </message>
    <message>
        <source>The file cannot be read; please open another copy of it.</source>
        <translation>No se puede leer el archivo; abra otra copia.</translation>
    </message>
    <message>
        <source>The file cannot be written; please choose another place.</source>
        <translation>No se puede escribir el archivo; elija otro lugar.</translation>
    </message>
    <message>
        <source>This is too large; please choose a smaller picture, part or size.</source>
        <translation>Es demasiado grande; elija una imagen, una parte o un tamaño menor.</translation>
    </message>
    <message>
        <source>This cannot be done with such a file; please choose another kind.</source>
        <translation>No se puede hacer con un archivo así; elija otro tipo.</translation>
    </message>
    <message>
        <source>These do not fit together; please choose another picture, support or part.</source>
        <translation>No encajan entre sí; elija otra imagen, otro soporte u otra parte.</translation>
    </message>
    <message>
        <source>The picture is all one color, or has values that are no numbers; please choose another one.</source>
        <translation>La imagen es de un solo color o tiene valores que no son números; elija otra.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Cancelado.</translation>
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
        <translation>Guardando una copia</translation>
    </message>
    <message>
        <source>No copy of your work can be kept (%1). Please save it.</source>
        <translation>No se puede guardar ninguna copia de su trabajo (%1). Guárdelo, por favor.</translation>
    </message>
</context>
<context>
    <name>txn::app::BeforeAfter</name>
    <message>
        <source>Hold the mouse button or the space bar to see it as it was before.</source>
        <translation>Mantenga pulsado el botón del ratón o la barra espaciadora para ver cómo era antes.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>After (hold for before)</source>
        <translation>Después (mantener: antes)</translation>
    </message>
</context>
<context>
    <name>txn::app::CommandPalette</name>
    <message>
        <source>Type what you want to do</source>
        <translation>Escriba lo que quiere hacer</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Buscar comandos</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandos</translation>
    </message>
</context>
<context>
    <name>txn::app::ErrorPlot</name>
    <message>
        <source>Error against iterations</source>
        <translation>Error según las iteraciones</translation>
    </message>
</context>
<context>
    <name>txn::app::ExemplarPanel</name>
    <message>
        <source>8 bit</source>
        <translation>8&#xa0;bits</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16&#xa0;bits</translation>
    </message>
    <message>
        <source>16 bit float</source>
        <translation>flotante de 16&#xa0;bits</translation>
    </message>
    <message>
        <source>32 bit float</source>
        <translation>flotante de 32&#xa0;bits</translation>
    </message>
    <message>
        <source>gray</source>
        <translation>gris</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>%1 channels</source>
        <translation>%1&#xa0;canales</translation>
    </message>
    <message>
        <source>Colors will clip</source>
        <translation>Se truncarán colores</translation>
    </message>
    <message>
        <source>%1 % of the noise&apos;s values are darker than black or lighter than white. Lower the contrast of the noise, or export EXR.</source>
        <translation>El %1&#xa0;% de los valores del ruido son más oscuros que el negro o más claros que el blanco. Baje el contraste del ruido o exporte en EXR.</translation>
    </message>
    <message>
        <source>Suits, but highlights or shadows even out</source>
        <translation>Adecuada, pero se atenúan las luces o las sombras</translation>
    </message>
    <message>
        <source>Its values lean to one side; those of the noise are spread evenly around the mean.</source>
        <translation>Sus valores se inclinan hacia un lado; los del ruido se reparten por igual en torno a la media.</translation>
    </message>
    <message>
        <source>Suits texton noise</source>
        <translation>Adecuada para ruido de textones</translation>
    </message>
    <message>
        <source>It is all grain and no shapes, and its colors fit.</source>
        <translation>Todo es grano, sin formas, y sus colores encajan.</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Recortar</translation>
    </message>
    <message>
        <source>Drag over the part of the photo that looks the same all over.</source>
        <translation>Arrastre sobre la parte de la foto que tiene el mismo aspecto en todas partes.</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Enderezar</translation>
    </message>
    <message>
        <source>Draw a line along the grain; it becomes level or upright.</source>
        <translation>Trace una línea a lo largo del grano; quedará horizontal o vertical.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Back to the photo as it was opened.</source>
        <translation>Volver a la foto tal como se abrió.</translation>
    </message>
    <message>
        <source>Reset the exemplar</source>
        <translation>Restablecer la muestra</translation>
    </message>
    <message>
        <source>The photo and its crop</source>
        <translation>La foto y su recorte</translation>
    </message>
    <message>
        <source>Drag to use only a part of the photo. Arrow keys move it, with Shift they resize it.</source>
        <translation>Arrastre para usar solo una parte de la foto. Las flechas la mueven; con Mayúsculas, cambian su tamaño.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Turns the photo, counterclockwise. Or draw a line with Straighten.</source>
        <translation>Gira la foto en sentido antihorario. O trace una línea con Enderezar.</translation>
    </message>
    <message>
        <source>Work in</source>
        <translation>Trabajar en</translation>
    </message>
    <message>
        <source>sRGB values</source>
        <translation>Valores sRGB</translation>
    </message>
    <message>
        <source>Linear light</source>
        <translation>Luz lineal</translation>
    </message>
    <message>
        <source>sRGB values keep dark grain; linear light suits renderers. Try sRGB first.</source>
        <translation>Los valores sRGB conservan el grano oscuro; la luz lineal conviene a los motores de renderizado. Pruebe primero sRGB.</translation>
    </message>
    <message>
        <source>Even out the lighting</source>
        <translation>Igualar la iluminación</translation>
    </message>
    <message>
        <source>Takes away shade that is smoother than the radius, such as a dark corner.</source>
        <translation>Quita las sombras más suaves que el radio, como una esquina oscura.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>Only what is smoother than this goes away. Small values also take large grain.</source>
        <translation>Solo desaparece lo que es más suave que esto. Los valores pequeños se llevan también el grano grueso.</translation>
    </message>
    <message>
        <source>Lighting radius</source>
        <translation>Radio de iluminación</translation>
    </message>
    <message>
        <source>Lighting before and after</source>
        <translation>Iluminación antes y después</translation>
    </message>
    <message>
        <source>Remove the seam</source>
        <translation>Quitar la costura</translation>
    </message>
    <message>
        <source>Takes away the jump from one border of the photo to the other (the periodic component). Switch it off for pictures that tile already.</source>
        <translation>Quita el salto de un borde de la foto al otro (conserva la componente periódica). Desactívelo con imágenes que ya se repiten en mosaico.</translation>
    </message>
    <message>
        <source>Seam before and after</source>
        <translation>Costura antes y después</translation>
    </message>
    <message>
        <source>A texton from a file needs no exemplar.</source>
        <translation>Un textón de archivo no necesita muestra.</translation>
    </message>
    <message>
        <source>Open a photo of a material, or drop one here.</source>
        <translation>Abra la foto de un material o suelte una aquí.</translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation>%1&#xa0;×&#xa0;%2&#xa0;px</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>lineal</translation>
    </message>
    <message>
        <source>sRGB</source>
        <translation>sRGB</translation>
    </message>
    <message>
        <source>color profile converted</source>
        <translation>perfil de color convertido</translation>
    </message>
    <message>
        <source>transparency left out</source>
        <translation>transparencia omitida</translation>
    </message>
    <message>
        <source>Skewness %1, excess kurtosis %2, clipped values %3 %, sub-bands %4 standard deviations from those of its Gaussian versions.</source>
        <translation>Asimetría %1, exceso de curtosis %2, valores truncados %3&#xa0;%, subbandas a %4 desviaciones estándar de las de sus versiones gaussianas.</translation>
    </message>
    <message>
        <source>Has shapes that a Gaussian texture cannot keep</source>
        <translation>Tiene formas que una textura gaussiana no conserva</translation>
    </message>
    <message>
        <source>Edges, patches and single features even out into grain. Compare with the Gaussian version, or crop a part that is all grain.</source>
        <translation>Los bordes, las manchas y los detalles sueltos se funden en grano. Compare con la versión gaussiana o recorte una parte que sea toda grano.</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normales</translation>
    </message>
    <message>
        <source>Normals, green down</source>
        <translation>Normales, verde hacia abajo</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rugosidad</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Oclusión</translation>
    </message>
    <message>
        <source>Metalness</source>
        <translation>Metalicidad</translation>
    </message>
    <message>
        <source>Occlusion, roughness, metalness</source>
        <translation>Oclusión, rugosidad, metalicidad</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Datos</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The maps of this material, told by the words in their names. Their noise comes from the same impacts, so that they stay in register.</source>
        <translation>Los mapas de este material, reconocidos por las palabras de sus nombres. Su ruido viene de los mismos impactos, por lo que siguen alineados.</translation>
    </message>
    <message>
        <source>Green points the other way</source>
        <translation>El verde apunta al revés</translation>
    </message>
    <message>
        <source>For normal maps made for another program: switch it on if bumps look like dents.</source>
        <translation>Para mapas de normales hechos para otro programa: actívelo si los relieves parecen huecos.</translation>
    </message>
    <message>
        <source>Green of the normals</source>
        <translation>Verde de las normales</translation>
    </message>
</context>
<context>
    <name>txn::app::ExportDialog</name>
    <message>
        <source>PNG, 8 bit</source>
        <translation>PNG, 8&#xa0;bits</translation>
    </message>
    <message>
        <source>PNG, 16 bit</source>
        <translation>PNG, 16&#xa0;bits</translation>
    </message>
    <message>
        <source>EXR, 16 bit float</source>
        <translation>EXR, flotante de 16&#xa0;bits</translation>
    </message>
    <message>
        <source>EXR, 32 bit float</source>
        <translation>EXR, flotante de 32&#xa0;bits</translation>
    </message>
    <message>
        <source>TIFF, 8 bit</source>
        <translation>TIFF, 8&#xa0;bits</translation>
    </message>
    <message>
        <source>TIFF, 16 bit</source>
        <translation>TIFF, 16&#xa0;bits</translation>
    </message>
    <message>
        <source>TIFF, 32 bit float</source>
        <translation>TIFF, flotante de 32&#xa0;bits</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source> px</source>
        <translation>&#xa0;px</translation>
    </message>
    <message>
        <source>EXR, exact</source>
        <translation>EXR, exacto</translation>
    </message>
    <message>
        <source>Every value as it is, with all parameters inside. The best choice.</source>
        <translation>Cada valor tal cual, con todos los parámetros dentro. La mejor opción.</translation>
    </message>
    <message>
        <source>For programs that cannot read EXR. The JSON file tells how values are coded.</source>
        <translation>Para programas que no leen EXR. El archivo JSON indica cómo se codifican los valores.</translation>
    </message>
    <message>
        <source>.texton, as text</source>
        <translation>.texton, como texto</translation>
    </message>
    <message>
        <source>The format of the papers&apos; authors, for their programs.</source>
        <translation>El formato de los autores de los artículos, para sus programas.</translation>
    </message>
    <message>
        <source>Common sizes; any other can be typed below.</source>
        <translation>Tamaños habituales; abajo se puede escribir cualquier otro.</translation>
    </message>
    <message>
        <source>%1 x %1</source>
        <translation>%1&#xa0;×&#xa0;%1</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Otro</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>Tiles without a seam</source>
        <translation>Se repite sin costuras</translation>
    </message>
    <message>
        <source>The picture repeats without a seam. Off, it is a piece of the endless plane.</source>
        <translation>La imagen se repite en mosaico sin costuras. Si no, es un trozo del plano infinito.</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Desde la izquierda</translation>
    </message>
    <message>
        <source>From the top</source>
        <translation>Desde arriba</translation>
    </message>
    <message>
        <source>Where on the endless plane the piece is cut out.</source>
        <translation>De qué lugar del plano infinito se toma el trozo.</translation>
    </message>
    <message>
        <source>EXR keeps values beyond black and white; PNG and TIFF with 8 or 16 bits clip them.</source>
        <translation>EXR conserva los valores más allá del negro y del blanco; PNG y TIFF de 8 o 16&#xa0;bits los truncan.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>What to export</source>
        <translation>Qué exportar</translation>
    </message>
    <message>
        <source>Texton</source>
        <translation>Textón</translation>
    </message>
    <message>
        <source>Noise texture</source>
        <translation>Textura de ruido</translation>
    </message>
    <message>
        <source>Current view</source>
        <translation>Vista actual</translation>
    </message>
    <message>
        <source>For engines</source>
        <translation>Para motores 3D</translation>
    </message>
    <message>
        <source>The noise as it is on screen, as a PNG picture.</source>
        <translation>El ruido tal como está en pantalla, como imagen PNG.</translation>
    </message>
    <message>
        <source>Everything to draw endless material in your own program: the texton, one self-contained shader (GLSL 330, free to use under CC0), its parameters, and a small example program.</source>
        <translation>Todo para dibujar material sin fin en su propio programa: el textón, un solo shader autónomo (GLSL 330, de libre uso con CC0), sus parámetros y un pequeño programa de ejemplo.</translation>
    </message>
    <message>
        <source>Choices that you saved under a name.</source>
        <translation>Ajustes guardados con un nombre.</translation>
    </message>
    <message>
        <source>Save as preset...</source>
        <translation>Guardar preajuste...</translation>
    </message>
    <message>
        <source>Words in braces are filled in: {name} {support} {mni} {seed} {size}.</source>
        <translation>Las palabras entre llaves se sustituyen: {name} {support} {mni} {seed} {size}.</translation>
    </message>
    <message>
        <source>Where the files go.</source>
        <translation>Dónde van los archivos.</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Elegir...</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Abrir la carpeta</translation>
    </message>
    <message>
        <source>material</source>
        <translation>material</translation>
    </message>
    <message>
        <source>%1  (replaces a file)</source>
        <translation>%1  (reemplaza un archivo)</translation>
    </message>
    <message>
        <source>There is no texton yet.</source>
        <translation>Aún no hay ningún textón.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>Queda %n&#xa0;s</numerusform>
            <numerusform>Quedan %n&#xa0;s</numerusform>
        </translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Guardar preajuste</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nombre del preajuste</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Elegir una carpeta</translation>
    </message>
    <message>
        <source>Replace files?</source>
        <translation>¿Reemplazar archivos?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) of these names exist already.</source>
        <translation>
            <numerusform>Ya existe %n archivo con este nombre.</numerusform>
            <numerusform>Ya existen %n archivos con estos nombres.</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Escribiendo</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Exportando</translation>
    </message>
    <message numerus="yes">
        <source>Wrote %n file(s).</source>
        <translation>
            <numerusform>Se ha escrito %n archivo.</numerusform>
            <numerusform>Se han escrito %n archivos.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 % of the values were clipped; EXR keeps them.</source>
        <translation>El %1&#xa0;% de los valores se truncaron; EXR los conserva.</translation>
    </message>
    <message>
        <source>Pixels of the picture. Large ones are written piece by piece.</source>
        <translation>Píxeles de la imagen. Las grandes se escriben por partes.</translation>
    </message>
    <message>
        <source>What to write.</source>
        <translation>Qué se escribirá.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Forgets the chosen preset.</source>
        <translation>Olvida el preajuste elegido.</translation>
    </message>
    <message>
        <source>Remembers these choices under a name.</source>
        <translation>Recuerda estos ajustes con un nombre.</translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation>Elegir otra carpeta.</translation>
    </message>
    <message>
        <source>Shows where the files are.</source>
        <translation>Muestra dónde están los archivos.</translation>
    </message>
    <message>
        <source>Writes the files that are listed.</source>
        <translation>Escribe los archivos de la lista.</translation>
    </message>
    <message>
        <source>Stops the work, or else closes this window.</source>
        <translation>Detiene el trabajo o, si no lo hay, cierra esta ventana.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Cancelado.</translation>
    </message>
    <message>
        <source>Delete the preset?</source>
        <translation>¿Eliminar el preajuste?</translation>
    </message>
    <message>
        <source>The preset %1 will be gone.</source>
        <translation>El preajuste %1 se perderá.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Mixture</source>
        <translation>Mezcla</translation>
    </message>
    <message>
        <source>All textons from A to B in a folder of their own: one EXR with a layer for each, the same as single files, a description, and the map as a gray picture. A noise texture of the mixture begins at the corner of the map; to tile, the map has to repeat.</source>
        <translation>Todos los textones de A a B en una carpeta propia: un EXR con una capa para cada uno, los mismos en archivos sueltos, una descripción y el mapa como imagen gris. Una textura de ruido de la mezcla empieza en la esquina del mapa; para que encaje en mosaico, el mapa debe repetirse.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>y %1 más</translation>
    </message>
    <message>
        <source>There is no mixture yet. Open a second material first.</source>
        <translation>Aún no hay ninguna mezcla. Abra antes un segundo material.</translation>
    </message>
    <message>
        <source>The mixture is not ready. The Mix panel tells why.</source>
        <translation>La mezcla no está lista. El panel Mezcla explica por qué.</translation>
    </message>
    <message>
        <source>To tile, switch on Mix &gt; Repeat the map, and choose a multiple of %1 x %2 px.</source>
        <translation>Para que encaje en mosaico, active Mezcla &gt; Repetir el mapa y elija un múltiplo de %1&#xa0;×&#xa0;%2&#xa0;px.</translation>
    </message>
</context>
<context>
    <name>txn::app::FileController</name>
    <message>
        <source>Open %1</source>
        <translation>Abrir %1</translation>
    </message>
    <message>
        <source>Making the sample</source>
        <translation>Creando el ejemplo</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Abriendo %1</translation>
    </message>
    <message>
        <source>Open a photo, texton or project</source>
        <translation>Abrir una foto, un textón o un proyecto</translation>
    </message>
    <message>
        <source>All that can be opened (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp *.texton *.txnproj);;Photos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;Textons (*.texton *.exr *.png);;Projects (*.txnproj);;All files (*)</source>
        <translation>Todo lo que se puede abrir (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp *.texton *.txnproj);;Fotos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;Textones (*.texton *.exr *.png);;Proyectos (*.txnproj);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Pasting a picture</source>
        <translation>Pegando una imagen</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Imagen pegada</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Guardar el proyecto</translation>
    </message>
    <message>
        <source>Texton Studio projects (*.txnproj)</source>
        <translation>Proyectos de Texton Studio (*.txnproj)</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Guardando</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Se ha guardado %1</translation>
    </message>
    <message>
        <source>Save before closing?</source>
        <translation>¿Guardar antes de cerrar?</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>Saving keeps the photo, all settings and the view in one project file.</source>
        <translation>Al guardar, la foto, todos los ajustes y la vista quedan en un solo archivo de proyecto.</translation>
    </message>
    <message>
        <source>Still saving. Please try again in a moment.</source>
        <translation>Aún se está guardando. Vuelva a intentarlo en un momento.</translation>
    </message>
    <message>
        <source>Opening the maps of a material</source>
        <translation>Abriendo los mapas de un material</translation>
    </message>
    <message>
        <source>Open %1 as B</source>
        <translation>Abrir %1 como B</translation>
    </message>
    <message>
        <source>Open the second material</source>
        <translation>Abrir el segundo material</translation>
    </message>
    <message>
        <source>Photos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;All files (*)</source>
        <translation>Fotos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Open a photo first, then a second one to mix it with.</source>
        <translation>Abra primero una foto y luego una segunda para mezclarla con ella.</translation>
    </message>
    <message>
        <source>Open a very large picture?</source>
        <translation>¿Abrir una imagen muy grande?</translation>
    </message>
    <message>
        <source>Opening it may take long and much memory. Open only files that you trust this way.</source>
        <translation>Abrirla puede llevar tiempo y ocupar mucha memoria. Abra así solo archivos de confianza.</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Abrir de todos modos</translation>
    </message>
    <message>
        <source>Files outside the project&apos;s folder</source>
        <translation>Archivos fuera de la carpeta del proyecto</translation>
    </message>
    <message>
        <source>%1 wants to open files outside its own folder. Do that only if you know where it comes from.</source>
        <translation>%1 quiere abrir archivos fuera de su carpeta. Acéptelo solo si sabe de dónde viene.</translation>
    </message>
    <message>
        <source>%1 is open in another Texton Studio. Please choose another name.</source>
        <translation>%1 está abierto en otro Texton Studio. Elija otro nombre.</translation>
    </message>
    <message>
        <source>%1 is open in another Texton Studio. This is a copy of it; please save it under another name.</source>
        <translation>%1 está abierto en otro Texton Studio. Esta es una copia; guárdela con otro nombre.</translation>
    </message>
</context>
<context>
    <name>txn::app::HistogramPanel</name>
    <message>
        <source>How often each value occurs. Where the noise reaches beyond 0 or 1, its colors are clipped.</source>
        <translation>Con qué frecuencia aparece cada valor. Donde el ruido pasa de 0 o de 1, sus colores se truncan.</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Muestra</translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation>Versión gaussiana</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rojo</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Verde</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Azul</translation>
    </message>
    <message>
        <source>Gray</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Channel %1</source>
        <translation>Canal %1</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histograma</translation>
    </message>
</context>
<context>
    <name>txn::app::JobRunner</name>
    <message>
        <source>there is not enough memory; try a smaller picture or size</source>
        <translation>no hay memoria suficiente; pruebe una imagen o un tamaño menor</translation>
    </message>
</context>
<context>
    <name>txn::app::JobsPanel</name>
    <message>
        <source>Work in progress</source>
        <translation>Trabajo en curso</translation>
    </message>
    <message>
        <source>What is being computed right now.</source>
        <translation>Lo que se está calculando ahora mismo.</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Tarea</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>en espera</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stops this work.</source>
        <translation>Detiene esta tarea.</translation>
    </message>
</context>
<context>
    <name>txn::app::JobsStatus</name>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>How far the work is. The Jobs panel lists all of it.</source>
        <translation>Cuánto ha avanzado el trabajo. El panel Tareas lo muestra todo.</translation>
    </message>
</context>
<context>
    <name>txn::app::KeyMapOverlay</name>
    <message>
        <source>All keys</source>
        <translation>Todas las teclas</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rueda</translation>
    </message>
    <message>
        <source>Zoom at the mouse</source>
        <translation>Zoom en el puntero</translation>
    </message>
    <message>
        <source>Middle drag, Space drag</source>
        <translation>Arrastrar: central o Espacio</translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation>Mover la imagen</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Arrastrar: botón izquierdo</translation>
    </message>
    <message>
        <source>Look around the ground or mesh</source>
        <translation>Girar en torno al suelo o la malla</translation>
    </message>
    <message>
        <source>Hold `</source>
        <translation>Mantener `</translation>
    </message>
    <message>
        <source>See the exemplar instead</source>
        <translation>Ver la muestra en su lugar</translation>
    </message>
    <message>
        <source>Hold X</source>
        <translation>Mantener X</translation>
    </message>
    <message>
        <source>See the difference, eightfold</source>
        <translation>Ver la diferencia, 8 veces mayor</translation>
    </message>
    <message>
        <source>Shift drag</source>
        <translation>Mayúsculas + arrastrar</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Doble clic</translation>
    </message>
    <message>
        <source>In a view</source>
        <translation>En una vista</translation>
    </message>
    <message>
        <source>Double-click the title</source>
        <translation>Doble clic en el título</translation>
    </message>
    <message>
        <source>This view only</source>
        <translation>Solo esta vista</translation>
    </message>
    <message>
        <source>On a slider</source>
        <translation>En un deslizador</translation>
    </message>
    <message>
        <source>Fine steps</source>
        <translation>Pasos finos</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Valor predeterminado</translation>
    </message>
    <message>
        <source>Any key closes this.</source>
        <translation>Cualquier tecla cierra esto.</translation>
    </message>
</context>
<context>
    <name>txn::app::MainWindow</name>
    <message>
        <source>Recovering %1</source>
        <translation>Recuperando %1</translation>
    </message>
    <message>
        <source>That did not work: %1</source>
        <translation>No ha funcionado: %1</translation>
    </message>
    <message>
        <source>The noise is drawn without the graphics card, from above only: %1</source>
        <translation>El ruido se dibuja sin la tarjeta gráfica, solo visto desde arriba: %1</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Muestra</translation>
    </message>
    <message>
        <source>Texton</source>
        <translation>Textón</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Espectro</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histograma</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Every change you made. Click one to go back to it.</source>
        <translation>Todos los cambios que ha hecho. Haga clic en uno para volver a él.</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Tareas</translation>
    </message>
    <message>
        <source>What draws the noise.</source>
        <translation>Lo que dibuja el ruido.</translation>
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
        <translation>lineal %1</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Madera</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>Piedra</translation>
    </message>
    <message>
        <source>Sand</source>
        <translation>Arena</translation>
    </message>
    <message>
        <source>Rust</source>
        <translation>Óxido</translation>
    </message>
    <message>
        <source>Brushed metal</source>
        <translation>Metal cepillado</translation>
    </message>
    <message>
        <source>Cloth</source>
        <translation>Tela</translation>
    </message>
    <message>
        <source>Leather</source>
        <translation>Cuero</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuevo</translation>
    </message>
    <message>
        <source>Close everything and start afresh.</source>
        <translation>Cerrar todo y empezar de cero.</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>Open a photo, a texton or a project.</source>
        <translation>Abrir una foto, un textón o un proyecto.</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>&amp;Guardar el proyecto</translation>
    </message>
    <message>
        <source>Keep the photo and all settings in one file.</source>
        <translation>Guardar la foto y todos los ajustes en un solo archivo.</translation>
    </message>
    <message>
        <source>Save project &amp;as...</source>
        <translation>Guardar el proyecto &amp;como...</translation>
    </message>
    <message>
        <source>Save under another name.</source>
        <translation>Guardar con otro nombre.</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>E&amp;xportar...</translation>
    </message>
    <message>
        <source>Write textons, textures and shaders for other programs.</source>
        <translation>Escribir textones, texturas y shaders para otros programas.</translation>
    </message>
    <message>
        <source>Save picture of &amp;the noise...</source>
        <translation>Guardar la &amp;imagen del ruido...</translation>
    </message>
    <message>
        <source>Save what the noise view shows.</source>
        <translation>Guardar lo que muestra la vista del ruido.</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Close the program.</source>
        <translation>Cerrar el programa.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Take the last change back.</source>
        <translation>Deshacer el último cambio.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Make the change again.</source>
        <translation>Hacer de nuevo el cambio.</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>Open the picture or file in the clipboard.</source>
        <translation>Abrir la imagen o el archivo del portapapeles.</translation>
    </message>
    <message>
        <source>There is no picture in the clipboard.</source>
        <translation>No hay ninguna imagen en el portapapeles.</translation>
    </message>
    <message>
        <source>&amp;Shortcuts...</source>
        <translation>&amp;Atajos...</translation>
    </message>
    <message>
        <source>Choose your own keys.</source>
        <translation>Elegir sus propias teclas.</translation>
    </message>
    <message>
        <source>&amp;Single view</source>
        <translation>V&amp;ista única</translation>
    </message>
    <message>
        <source>One picture fills the middle.</source>
        <translation>Una sola imagen llena el centro.</translation>
    </message>
    <message>
        <source>Side &amp;by side</source>
        <translation>&amp;Lado a lado</translation>
    </message>
    <message>
        <source>Two pictures next to each other.</source>
        <translation>Dos imágenes, una junto a la otra.</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>&amp;Cuatro vistas</translation>
    </message>
    <message>
        <source>Exemplar, Gaussian version, texton and noise at once.</source>
        <translation>Muestra, versión gaussiana, textón y ruido a la vez.</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>Cor&amp;tinilla</translation>
    </message>
    <message>
        <source>Two pictures in one place, with a border to drag.</source>
        <translation>Dos imágenes en el mismo lugar, con un límite que se arrastra.</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>A&amp;justar</translation>
    </message>
    <message>
        <source>Show the whole exemplar.</source>
        <translation>Ver la muestra entera.</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100&#xa0;%</translation>
    </message>
    <message>
        <source>One pixel of the picture is one of the screen.</source>
        <translation>Un píxel de la imagen es un píxel de la pantalla.</translation>
    </message>
    <message>
        <source>&amp;200 %</source>
        <translation>&amp;200&#xa0;%</translation>
    </message>
    <message>
        <source>Twice as large.</source>
        <translation>El doble de grande.</translation>
    </message>
    <message>
        <source>Show the &amp;Gaussian version</source>
        <translation>Mostrar la versión &amp;gaussiana</translation>
    </message>
    <message>
        <source>In the view under the mouse.</source>
        <translation>En la vista bajo el puntero.</translation>
    </message>
    <message>
        <source>&amp;Tile the exemplar</source>
        <translation>&amp;Muestra en mosaico</translation>
    </message>
    <message>
        <source>Repeat the photo, to see the repetition that the noise does away with.</source>
        <translation>Repetir la foto, para ver la repetición que el ruido evita.</translation>
    </message>
    <message>
        <source>B&amp;righter</source>
        <translation>Más cla&amp;ro</translation>
    </message>
    <message>
        <source>Show everything a third of a stop brighter.</source>
        <translation>Aclarar todo un tercio de paso.</translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation>Más &amp;oscuro</translation>
    </message>
    <message>
        <source>Show everything a third of a stop darker.</source>
        <translation>Oscurecer todo un tercio de paso.</translation>
    </message>
    <message>
        <source>&amp;Normal exposure</source>
        <translation>E&amp;xposición normal</translation>
    </message>
    <message>
        <source>Show the values as they are.</source>
        <translation>Mostrar los valores tal cual.</translation>
    </message>
    <message>
        <source>Look at single channels as gray.</source>
        <translation>Ver un solo canal, en gris.</translation>
    </message>
    <message>
        <source>&amp;All channels</source>
        <translation>&amp;Todos los canales</translation>
    </message>
    <message>
        <source>First channel (red)</source>
        <translation>Primer canal (rojo)</translation>
    </message>
    <message>
        <source>Second channel (green)</source>
        <translation>Segundo canal (verde)</translation>
    </message>
    <message>
        <source>Third channel (blue)</source>
        <translation>Tercer canal (azul)</translation>
    </message>
    <message>
        <source>What is around the pictures.</source>
        <translation>Lo que rodea las imágenes.</translation>
    </message>
    <message>
        <source>&amp;Compute again</source>
        <translation>&amp;Calcular de nuevo</translation>
    </message>
    <message>
        <source>Compute the texton once more and watch it form.</source>
        <translation>Calcular el textón otra vez y ver cómo se forma.</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>Ca&amp;ncelar el cálculo</translation>
    </message>
    <message>
        <source>Stop computing the texton.</source>
        <translation>Detener el cálculo del textón.</translation>
    </message>
    <message>
        <source>New &amp;seed</source>
        <translation>Nueva &amp;semilla</translation>
    </message>
    <message>
        <source>Another random result of what is under the mouse: Gaussian version, texton or noise.</source>
        <translation>Otro resultado aleatorio de lo que está bajo el puntero: versión gaussiana, textón o ruido.</translation>
    </message>
    <message>
        <source>Gaussian method</source>
        <translation>Método gaussiano</translation>
    </message>
    <message>
        <source>Random phases and random strengths: what texton noise comes to.</source>
        <translation>Fases y amplitudes aleatorias: a lo que tiende el ruido de textones.</translation>
    </message>
    <message>
        <source>Random phases only: keeps the exact spectrum of the photo.</source>
        <translation>Solo fases aleatorias: conserva el espectro exacto de la foto.</translation>
    </message>
    <message>
        <source>The texton&apos;s seed is locked.</source>
        <translation>La semilla del textón está bloqueada.</translation>
    </message>
    <message>
        <source>New seed</source>
        <translation>Nueva semilla</translation>
    </message>
    <message>
        <source>Show or hide this panel.</source>
        <translation>Mostrar u ocultar este panel.</translation>
    </message>
    <message>
        <source>&amp;Hide panels</source>
        <translation>&amp;Ocultar los paneles</translation>
    </message>
    <message>
        <source>Nothing but the pictures; the same key brings the panels back.</source>
        <translation>Nada más que las imágenes; la misma tecla trae de vuelta los paneles.</translation>
    </message>
    <message>
        <source>&amp;Next panel</source>
        <translation>&amp;Panel siguiente</translation>
    </message>
    <message>
        <source>Go on to the next panel with the keyboard.</source>
        <translation>Pasar al panel siguiente con el teclado.</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Restablecer la disposición</translation>
    </message>
    <message>
        <source>Put all panels back where they belong.</source>
        <translation>Devolver todos los paneles a su sitio.</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>Pantalla &amp;completa</translation>
    </message>
    <message>
        <source>Use the whole screen.</source>
        <translation>Usar toda la pantalla.</translation>
    </message>
    <message>
        <source>The colors of the window.</source>
        <translation>Los colores de la ventana.</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Como el &amp;sistema</translation>
    </message>
    <message>
        <source>&amp;Command palette</source>
        <translation>&amp;Paleta de comandos</translation>
    </message>
    <message>
        <source>Find any command by typing a part of its name.</source>
        <translation>Encontrar cualquier comando escribiendo parte de su nombre.</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Teclas</translation>
    </message>
    <message>
        <source>All keys at a glance.</source>
        <translation>Todas las teclas de un vistazo.</translation>
    </message>
    <message>
        <source>&amp;What is this?</source>
        <translation>¿&amp;Qué es esto?</translation>
    </message>
    <message>
        <source>Then click on anything to read about it.</source>
        <translation>Haga clic después en cualquier elemento para leer sobre él.</translation>
    </message>
    <message>
        <source>&amp;About Texton Studio</source>
        <translation>&amp;Acerca de Texton Studio</translation>
    </message>
    <message>
        <source>Version, method and license.</source>
        <translation>Versión, método y licencia.</translation>
    </message>
    <message>
        <source>About Texton Studio</source>
        <translation>Acerca de Texton Studio</translation>
    </message>
    <message>
        <source>&lt;b&gt;Texton Studio %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Texton Studio %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Endless material from a photo, by the method of Galerne, Leclaire and Moisan (2014, 2017). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Material sin fin a partir de una foto, con el método de Galerne, Leclaire y Moisan (2014, 2017). Software libre bajo la Licencia Pública General de GNU, versión 3 o posterior.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>Open a sa&amp;mple</source>
        <translation>Abrir un &amp;ejemplo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Channels</source>
        <translation>Ca&amp;nales</translation>
    </message>
    <message>
        <source>S&amp;urround</source>
        <translation>&amp;Fondo</translation>
    </message>
    <message>
        <source>&amp;Texton</source>
        <translation>&amp;Textón</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Ve&amp;ntana</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Vaciar esta lista</translation>
    </message>
    <message>
        <source>The language changes when you start Texton Studio again.</source>
        <translation>El idioma cambiará la próxima vez que inicie Texton Studio.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Guardar la imagen</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Imágenes PNG (*.png)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Se ha guardado %1</translation>
    </message>
    <message>
        <source>&amp;Photo inside the project</source>
        <translation>&amp;Foto dentro del proyecto</translation>
    </message>
    <message>
        <source>On, a project holds the photo itself; off, it only remembers where the photo is.</source>
        <translation>Activado, el proyecto contiene la foto misma; si no, solo recuerda dónde está.</translation>
    </message>
    <message>
        <source>Link the photo</source>
        <translation>Enlazar la foto</translation>
    </message>
    <message>
        <source>Photo inside the project</source>
        <translation>Foto dentro del proyecto</translation>
    </message>
    <message>
        <source>&amp;Gaussian version: ADSN</source>
        <translation>Versión gaussiana: A&amp;DSN</translation>
    </message>
    <message>
        <source>Gaussian version: &amp;RPN</source>
        <translation>Versión gaussiana: &amp;RPN</translation>
    </message>
    <message>
        <source>The language of the window, from the next start on.</source>
        <translation>El idioma de la ventana, a partir del próximo inicio.</translation>
    </message>
    <message>
        <source>Looking for unsaved work</source>
        <translation>Buscando trabajo sin guardar</translation>
    </message>
    <message>
        <source>Place and values of the pixel under the mouse.</source>
        <translation>Posición y valores del píxel bajo el puntero.</translation>
    </message>
    <message>
        <source>How far the texton is from the photo; see the Texton panel.</source>
        <translation>Cuánto se aparta el textón de la foto; vea el panel Textón.</translation>
    </message>
    <message>
        <source>&amp;Zoom in</source>
        <translation>&amp;Acercar</translation>
    </message>
    <message>
        <source>Larger, at the mouse.</source>
        <translation>Más grande, en el puntero.</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Al&amp;ejar</translation>
    </message>
    <message>
        <source>Smaller, at the mouse.</source>
        <translation>Más pequeño, en el puntero.</translation>
    </message>
    <message>
        <source>There is no finished noise to save yet. Please wait a moment, or open a photo.</source>
        <translation>Aún no hay ruido terminado que guardar. Espere un momento o abra una foto.</translation>
    </message>
    <message>
        <source>Saving the picture</source>
        <translation>Guardando la imagen</translation>
    </message>
    <message>
        <source>What draws the noise: %1</source>
        <translation>Lo que dibuja el ruido: %1</translation>
    </message>
    <message>
        <source>How the pictures are shown: screen pixels for each pixel of the photo, exposure, channel.</source>
        <translation>Cómo se muestran las imágenes: píxeles de pantalla por cada píxel de la foto, exposición, canal.</translation>
    </message>
    <message>
        <source>Zoom %1 %</source>
        <translation>Zoom %1&#xa0;%</translation>
    </message>
    <message>
        <source>exposure %1%2</source>
        <translation>exposición %1%2</translation>
    </message>
    <message>
        <source>channel %1 only</source>
        <translation>solo el canal %1</translation>
    </message>
    <message>
        <source>Stop the export?</source>
        <translation>¿Detener la exportación?</translation>
    </message>
    <message>
        <source>An export is still being written.</source>
        <translation>Aún se está escribiendo una exportación.</translation>
    </message>
    <message>
        <source>Stop it and close</source>
        <translation>Detener y cerrar</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>Reset the &amp;exemplar</source>
        <translation>Restablecer la &amp;muestra</translation>
    </message>
    <message>
        <source>Back to the photo as it was opened.</source>
        <translation>Volver a la foto tal como se abrió.</translation>
    </message>
    <message>
        <source>Reset the exemplar</source>
        <translation>Restablecer la muestra</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Canales</translation>
    </message>
    <message>
        <source>Surround</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Gray</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Negro</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanco</translation>
    </message>
    <message>
        <source>&amp;Flat</source>
        <translation>&amp;Plano</translation>
    </message>
    <message>
        <source>&amp;Ground</source>
        <translation>&amp;Suelo</translation>
    </message>
    <message>
        <source>Mesh, by its &amp;UVs</source>
        <translation>Malla, por sus &amp;UV</translation>
    </message>
    <message>
        <source>Mesh, any &amp;surface</source>
        <translation>Malla, &amp;cualquier superficie</translation>
    </message>
    <message>
        <source>What the noise is shown on.</source>
        <translation>Sobre qué se muestra el ruido.</translation>
    </message>
    <message>
        <source>Noise view</source>
        <translation>Vista del ruido</translation>
    </message>
    <message>
        <source>&amp;Lighting</source>
        <translation>&amp;Iluminación</translation>
    </message>
    <message>
        <source>Shade the mesh, or not.</source>
        <translation>Sombrear la malla o no.</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Iluminación</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>&amp;Noise</source>
        <translation>&amp;Ruido</translation>
    </message>
    <message>
        <source>Covariance error %1 × the floor</source>
        <translation>Error de covarianza %1 × el mínimo</translation>
    </message>
    <message>
        <source>&amp;Keep to compare</source>
        <translation>C&amp;onservar para comparar</translation>
    </message>
    <message>
        <source>Keep the present texton as A. Change something, then look at both by turns.</source>
        <translation>Conservar el textón actual como A. Cambie algo y luego alterne entre los dos.</translation>
    </message>
    <message>
        <source>Look at the kept texton and its noise, and back at the present one.</source>
        <translation>Mostrar el textón conservado y su ruido, y de nuevo el actual.</translation>
    </message>
    <message>
        <source>Show &amp;the kept one (A/B)</source>
        <translation>Mostrar el conservado (&amp;A/B)</translation>
    </message>
    <message>
        <source>Kept and present side &amp;by side</source>
        <translation>Conservado y actual &amp;lado a lado</translation>
    </message>
    <message>
        <source>The noise of the kept texton on the left, that of the present one on the right.</source>
        <translation>El ruido del textón conservado a la izquierda, el del actual a la derecha.</translation>
    </message>
    <message>
        <source>Mix</source>
        <translation>Mezcla</translation>
    </message>
    <message>
        <source>&amp;Mix</source>
        <translation>&amp;Mezcla</translation>
    </message>
    <message>
        <source>&amp;Open a second material...</source>
        <translation>&amp;Abrir un segundo material...</translation>
    </message>
    <message>
        <source>Open another photo, to mix it with the first one.</source>
        <translation>Abrir otra foto, para mezclarla con la primera.</translation>
    </message>
    <message>
        <source>S&amp;wap A and B</source>
        <translation>&amp;Intercambiar A y B</translation>
    </message>
    <message>
        <source>Let the two materials change places. The noise stays as it is.</source>
        <translation>Los dos materiales cambian de lugar. El ruido sigue igual.</translation>
    </message>
    <message>
        <source>&amp;Remove the second material</source>
        <translation>&amp;Quitar el segundo material</translation>
    </message>
    <message>
        <source>Show the first material alone again.</source>
        <translation>Mostrar de nuevo solo el primer material.</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>&amp;Mirar</translation>
    </message>
    <message>
        <source>The mouse paints nothing.</source>
        <translation>El ratón no pinta nada.</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pincel</translation>
    </message>
    <message>
        <source>Paint where the second material is, in the noise seen from above.</source>
        <translation>Pintar donde debe estar el segundo material, en el ruido visto desde arriba.</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Suavizar</translation>
    </message>
    <message>
        <source>Soften borders in the map.</source>
        <translation>Suavizar los bordes del mapa.</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>&amp;Borrador</translation>
    </message>
    <message>
        <source>Bring the first material back.</source>
        <translation>Recuperar el primer material.</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>&amp;Degradado</translation>
    </message>
    <message>
        <source>Drag a line: one material at its start, the other at its end.</source>
        <translation>Arrastre una línea: un material al principio, el otro al final.</translation>
    </message>
    <message>
        <source>Ro&amp;und gradient</source>
        <translation>Degradado &amp;radial</translation>
    </message>
    <message>
        <source>Drag from the middle: one material inside, the other around it.</source>
        <translation>Arrastre desde el centro: un material dentro, el otro alrededor.</translation>
    </message>
    <message>
        <source>L&amp;arger brush</source>
        <translation>Pincel más &amp;grande</translation>
    </message>
    <message>
        <source>Make the brush a quarter larger.</source>
        <translation>Agrandar el pincel un cuarto.</translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation>Pincel más peq&amp;ueño</translation>
    </message>
    <message>
        <source>Make the brush a quarter smaller.</source>
        <translation>Reducir el pincel un cuarto.</translation>
    </message>
    <message>
        <source>&amp;Fill the map</source>
        <translation>Re&amp;llenar el mapa</translation>
    </message>
    <message>
        <source>All of it becomes what the brush paints.</source>
        <translation>Todo él pasa a ser lo que pinta el pincel.</translation>
    </message>
    <message>
        <source>One strip for each texton, from the first material on the left to the second one on the right.</source>
        <translation>Una banda por textón, del primer material a la izquierda al segundo a la derecha.</translation>
    </message>
    <message>
        <source>&amp;Invert the map</source>
        <translation>In&amp;vertir el mapa</translation>
    </message>
    <message>
        <source>The second material where the first one was.</source>
        <translation>El segundo material donde estaba el primero.</translation>
    </message>
    <message>
        <source>Re&amp;peat the map</source>
        <translation>R&amp;epetir el mapa</translation>
    </message>
    <message>
        <source>Beyond its border the map comes again, instead of going on as it ends.</source>
        <translation>Más allá de su borde, el mapa vuelve a empezar en lugar de prolongarse.</translation>
    </message>
    <message>
        <source>S&amp;how the map</source>
        <translation>M&amp;ostrar el mapa</translation>
    </message>
    <message>
        <source>Lay the map over the noise: blue is the first material, amber the second one.</source>
        <translation>Poner el mapa sobre el ruido: azul es el primer material, ámbar el segundo.</translation>
    </message>
    <message>
        <source>Import a map...</source>
        <translation>Importar u&amp;n mapa...</translation>
    </message>
    <message>
        <source>Take a gray picture as the map: black is the first material, white the second.</source>
        <translation>Tomar una imagen gris como mapa: negro es el primer material, blanco el segundo.</translation>
    </message>
    <message>
        <source>E&amp;xport the map...</source>
        <translation>E&amp;xportar el mapa...</translation>
    </message>
    <message>
        <source>Save the map as a gray picture.</source>
        <translation>Guardar el mapa como imagen gris.</translation>
    </message>
    <message>
        <source>Import a map</source>
        <translation>Importar un mapa</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.tga *.bmp *.webp);;All files (*)</source>
        <translation>Imágenes (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.tga *.bmp *.webp);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Export the map</source>
        <translation>Exportar el mapa</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.exr)</source>
        <translation>Imágenes (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>S&amp;trips, left to right</source>
        <translation>Bandas de i&amp;zquierda a derecha</translation>
    </message>
    <message>
        <source>Strips, top to bottom</source>
        <translation>Bandas de arriba aba&amp;jo</translation>
    </message>
    <message>
        <source>One strip for each texton, from the first material at the top to the second one at the bottom.</source>
        <translation>Una banda por textón, del primer material arriba al segundo abajo.</translation>
    </message>
    <message>
        <source>Smooth passage</source>
        <translation>&amp;Transición suave</translation>
    </message>
    <message>
        <source>From the first material on the left to the second one on the right, slowly at both ends.</source>
        <translation>Del primer material a la izquierda al segundo a la derecha, despacio en ambos extremos.</translation>
    </message>
</context>
<context>
    <name>txn::app::MapPainter</name>
    <message>
        <source>Smooth the map</source>
        <translation>Suavizar el mapa</translation>
    </message>
    <message>
        <source>Erase in the map</source>
        <translation>Borrar en el mapa</translation>
    </message>
    <message>
        <source>Gradient in the map</source>
        <translation>Degradado en el mapa</translation>
    </message>
    <message>
        <source>Paint in the map</source>
        <translation>Pintar en el mapa</translation>
    </message>
</context>
<context>
    <name>txn::app::MessageBar</name>
    <message>
        <source>Dismiss the message</source>
        <translation>Cerrar el mensaje</translation>
    </message>
    <message>
        <source>Dismiss the message.</source>
        <translation>Cerrar el mensaje.</translation>
    </message>
</context>
<context>
    <name>txn::app::MixEditor</name>
    <message>
        <source>Swap A and B</source>
        <translation>Intercambiar A y B</translation>
    </message>
    <message>
        <source>Remove B</source>
        <translation>Quitar B</translation>
    </message>
    <message>
        <source>Fill the map</source>
        <translation>Rellenar el mapa</translation>
    </message>
    <message>
        <source>Strips from A to B</source>
        <translation>Bandas de A a B</translation>
    </message>
    <message>
        <source>Invert the map</source>
        <translation>Invertir el mapa</translation>
    </message>
    <message>
        <source>Repeat the map</source>
        <translation>Repetir el mapa</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Abriendo %1</translation>
    </message>
    <message>
        <source>Import the map</source>
        <translation>Importar el mapa</translation>
    </message>
    <message>
        <source>Saving the map</source>
        <translation>Guardando el mapa</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Se ha guardado %1</translation>
    </message>
    <message>
        <source>Smooth passage from A to B</source>
        <translation>Transición suave de A a B</translation>
    </message>
</context>
<context>
    <name>txn::app::MixPanel</name>
    <message>
        <source>Drop a photo</source>
        <translation>Suelte una foto</translation>
    </message>
    <message>
        <source>The first material. Click to open another one, or drop a photo here.</source>
        <translation>El primer material. Haga clic para abrir otro o suelte una foto aquí.</translation>
    </message>
    <message>
        <source>Drop a second photo</source>
        <translation>Suelte otra foto</translation>
    </message>
    <message>
        <source>The second material, to be mixed with the first. Click to open one, or drop a photo here.</source>
        <translation>El segundo material, para mezclarlo con el primero. Haga clic para abrir uno o suelte una foto aquí.</translation>
    </message>
    <message>
        <source>Let A and B change places.</source>
        <translation>Intercambiar A y B.</translation>
    </message>
    <message>
        <source>Take the second material away and show the first one alone.</source>
        <translation>Quitar el segundo material y mostrar solo el primero.</translation>
    </message>
    <message>
        <source>Textons from A to B</source>
        <translation>Textones de A a B</translation>
    </message>
    <message>
        <source>The textons from A to B, each with a piece of its noise. Click one to see it alone and to paint with it; click it again to see the mixture.</source>
        <translation>Los textones de A a B, cada uno con un trozo de su ruido. Haga clic en uno para verlo solo y pintar con él; haga clic otra vez para ver la mezcla.</translation>
    </message>
    <message>
        <source>Textons</source>
        <translation>Textones</translation>
    </message>
    <message>
        <source>How many textons lie between A and B. More make the passage finer. Try 21.</source>
        <translation>Cuántos textones llevan de A a B. Cuantos más haya, más fina es la transición. Pruebe 21.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Mirar</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suavizar</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Borrador</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Degradado</translation>
    </message>
    <message>
        <source>Round gradient</source>
        <translation>Degradado radial</translation>
    </message>
    <message>
        <source>What the mouse does in the noise seen from above. Brush paints B, or any mixture; the eraser brings A back. Shift draws straight lines.</source>
        <translation>Lo que hace el ratón en el ruido visto desde arriba. El pincel pinta B o cualquier mezcla; el borrador recupera A. Mayúsculas traza líneas rectas.</translation>
    </message>
    <message>
        <source>Paint with</source>
        <translation>Pintar con</translation>
    </message>
    <message>
        <source>What the brush paints: 0 is A, 1 is B, anything else lies between.</source>
        <translation>Lo que pinta el pincel: 0 es A, 1 es B y lo demás queda entre ambos.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>How large the brush is. The keys [ and ] change it, too.</source>
        <translation>El tamaño del pincel. Las teclas [ y ] también lo cambian.</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Dureza</translation>
    </message>
    <message>
        <source>How sharp the rim of the brush is. Low passes softly from A to B.</source>
        <translation>La nitidez del borde del pincel. Con poca, pasa suavemente de A a B.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Fuerza</translation>
    </message>
    <message>
        <source>How far one stroke goes towards what it paints.</source>
        <translation>Cuánto se acerca un trazo a lo que pinta.</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simetría</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Izquierda y derecha</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>Arriba y abajo</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Ambas</translation>
    </message>
    <message>
        <source>Strokes are mirrored about the middle of the map.</source>
        <translation>Los trazos se reflejan respecto al centro del mapa.</translation>
    </message>
    <message>
        <source>A texton from a file cannot be mixed. Open a photo instead.</source>
        <translation>Un textón de archivo no se puede mezclar. Abra una foto en su lugar.</translation>
    </message>
    <message>
        <source>Open a photo, then a second one to mix it with.</source>
        <translation>Abra una foto y luego una segunda para mezclarla con ella.</translation>
    </message>
    <message>
        <source>Drop a second material onto B, then paint where it is.</source>
        <translation>Suelte un segundo material sobre B y luego pinte dónde va.</translation>
    </message>
    <message>
        <source>Computing the textons from A to B...</source>
        <translation>Calculando los textones de A a B...</translation>
    </message>
    <message>
        <source>Textons so far: %1</source>
        <translation>Textones hasta ahora: %1</translation>
    </message>
    <message>
        <source>Distance from A to B: %1</source>
        <translation>Distancia de A a B: %1</translation>
    </message>
    <message>
        <source>The textons from A to B are not up to date. Compute again with F5.</source>
        <translation>Los textones de A a B no están al día. Calcule de nuevo con F5.</translation>
    </message>
</context>
<context>
    <name>txn::app::NoisePanel</name>
    <message>
        <source>Impacts per pixel</source>
        <translation>Impactos por píxel</translation>
    </message>
    <message>
        <source>How many textons overlap at a pixel, on average (the MNI). Fewer is faster; too few show single textons. Try 12.</source>
        <translation>Cuántos textones se superponen en un píxel, en promedio (el MNI). Menos es más rápido; con muy pocos se ven textones sueltos. Pruebe 12.</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>Colocación</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Regular</translation>
    </message>
    <message>
        <source>Random, both signs</source>
        <translation>Aleatoria, dos signos</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Aleatoria</translation>
    </message>
    <message>
        <source>How textons are scattered. Even (stratified) needs the fewest; random (Poisson) is the papers&apos; way and needs about 30 impacts.</source>
        <translation>Cómo se esparcen los textones. La regular (estratificada) requiere menos impactos; la aleatoria (Poisson) es la de los artículos y requiere unos 30.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Another number gives another piece of the same material.</source>
        <translation>Otro número da otro trozo del mismo material.</translation>
    </message>
    <message>
        <source>Noise seed</source>
        <translation>Semilla del ruido</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>Mesh, by its UVs</source>
        <translation>Malla, por sus UV</translation>
    </message>
    <message>
        <source>Mesh, any surface</source>
        <translation>Malla, cualquier superficie</translation>
    </message>
    <message>
        <source>What the noise is shown on. Drag in the view to look around. Any surface needs no texture coordinates.</source>
        <translation>Sobre qué se muestra el ruido. Arrastre en la vista para mirar alrededor. «Cualquier superficie» no necesita coordenadas de textura.</translation>
    </message>
    <message>
        <source>Noise view</source>
        <translation>Vista del ruido</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Malla</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Toro</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation>De un archivo...</translation>
    </message>
    <message>
        <source>The object that wears the noise. OBJ and PLY files can be opened.</source>
        <translation>El objeto que lleva el ruido. Se pueden abrir archivos OBJ y PLY.</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Iluminación</translation>
    </message>
    <message>
        <source>Shades the mesh. Switch it off to judge colors.</source>
        <translation>Sombrea la malla. Desactívela para juzgar los colores.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Isotropic</source>
        <translation>Isotrópico</translation>
    </message>
    <message>
        <source>Anisotropic</source>
        <translation>Anisotrópico</translation>
    </message>
    <message>
        <source>Of the graphics card</source>
        <translation>Tarjeta gráfica</translation>
    </message>
    <message>
        <source>Keeps distant noise from flickering. Anisotropic is the sharpest at a slant.</source>
        <translation>Evita que el ruido lejano parpadee. El anisotrópico es el más nítido en vistas oblicuas.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>How large the grain is, next to that of the photo.</source>
        <translation>El tamaño del grano, comparado con el de la foto.</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Contraste</translation>
    </message>
    <message>
        <source>Strengthens or softens the grain. Less of it clips fewer colors.</source>
        <translation>Refuerza o suaviza el grano. Con menos, se truncan menos colores.</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Brillo</translation>
    </message>
    <message>
        <source>Makes the whole material lighter or darker.</source>
        <translation>Aclara u oscurece todo el material.</translation>
    </message>
    <message>
        <source>What the picture costs: the time to draw one, and how often the texton is looked up for each pixel.</source>
        <translation>Lo que cuesta la imagen: el tiempo para dibujarla y cuántas veces se lee el textón por cada píxel.</translation>
    </message>
    <message>
        <source>Values that are darker than black or lighter than white. Lower the contrast, or export EXR, which keeps them.</source>
        <translation>Valores más oscuros que el negro o más claros que el blanco. Baje el contraste o exporte en EXR, que los conserva.</translation>
    </message>
    <message>
        <source>Save picture...</source>
        <translation>Guardar imagen...</translation>
    </message>
    <message>
        <source>Saves what the noise view shows as a PNG file.</source>
        <translation>Guarda lo que muestra la vista del ruido en un archivo PNG.</translation>
    </message>
    <message>
        <source>Open a mesh</source>
        <translation>Abrir una malla</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.ply);;All files (*)</source>
        <translation>Mallas (*.obj *.ply);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>%1 frames per second, %2 fetches per pixel</source>
        <translation>%1&#xa0;fps, %2 lecturas por píxel</translation>
    </message>
    <message>
        <source>%1 % of the values are clipped</source>
        <translation>%1&#xa0;% de valores truncados</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>All maps of the material together under a light, or one of them.</source>
        <translation>Todos los mapas del material juntos bajo una luz, o uno de ellos.</translation>
    </message>
    <message>
        <source>Shown map</source>
        <translation>Mapa mostrado</translation>
    </message>
    <message>
        <source>Light from</source>
        <translation>Luz desde</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 is the right, 90 the top. Or drag with the right button in the view.</source>
        <translation>De dónde viene la luz: 0 es la derecha, 90 arriba. O arrastre con el botón derecho en la vista.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>Light height</source>
        <translation>Altura de luz</translation>
    </message>
    <message>
        <source>How high the light stands. Low light shows the relief, high light the colors.</source>
        <translation>La altura de la luz. Si es baja, resalta el relieve; si es alta, los colores.</translation>
    </message>
</context>
<context>
    <name>txn::app::PictureView</name>
    <message>
        <source>%1 fps</source>
        <translation>%1&#xa0;fps</translation>
    </message>
    <message>
        <source>Drop a photo here</source>
        <translation>Suelte una foto aquí</translation>
    </message>
    <message>
        <source>A texton from a file has no exemplar</source>
        <translation>Un textón de archivo no tiene muestra</translation>
    </message>
    <message>
        <source>A texton from a file has no Gaussian version</source>
        <translation>Un textón de archivo no tiene versión gaussiana</translation>
    </message>
    <message>
        <source>Gaussian method</source>
        <translation>Método gaussiano</translation>
    </message>
    <message>
        <source>Gaussian seed</source>
        <translation>Semilla gaussiana</translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation>%1&#xa0;×&#xa0;%2&#xa0;px</translation>
    </message>
    <message>
        <source>A picture. The wheel zooms where the mouse is, the middle button or Space moves it, F shows it whole. Hold ` to see the exemplar instead. The right button moves the light of a material.</source>
        <translation>Una imagen. La rueda hace zoom en el puntero, el botón central o Espacio la mueve, F la muestra entera. Mantenga pulsada ` para ver la muestra en su lugar. El botón derecho mueve la luz de un material.</translation>
    </message>
    <message>
        <source>A (kept)</source>
        <translation>A (conservado)</translation>
    </message>
    <message>
        <source>B (present)</source>
        <translation>B (actual)</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Luz</translation>
    </message>
</context>
<context>
    <name>txn::app::Pipeline</name>
    <message>
        <source>Preparing the exemplar</source>
        <translation>Preparando la muestra</translation>
    </message>
    <message>
        <source>Making the Gaussian version</source>
        <translation>Creando la versión gaussiana</translation>
    </message>
    <message>
        <source>Computing the texton</source>
        <translation>Calculando el textón</translation>
    </message>
    <message>
        <source>Judging the exemplar</source>
        <translation>Evaluando la muestra</translation>
    </message>
    <message>
        <source>Measuring spectra</source>
        <translation>Midiendo los espectros</translation>
    </message>
    <message>
        <source>Loading the mesh</source>
        <translation>Cargando la malla</translation>
    </message>
    <message>
        <source>Preparing the second exemplar</source>
        <translation>Preparando la segunda muestra</translation>
    </message>
    <message>
        <source>Computing the textons from A to B</source>
        <translation>Calculando los textones de A a B</translation>
    </message>
</context>
<context>
    <name>txn::app::ProjectDocument</name>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
</context>
<context>
    <name>txn::app::RecoveryDialog</name>
    <message>
        <source>Recover your work</source>
        <translation>Recuperar su trabajo</translation>
    </message>
    <message>
        <source>Texton Studio was not closed properly last time. This can come back:</source>
        <translation>Texton Studio no se cerró bien la última vez. Se puede recuperar esto:</translation>
    </message>
    <message>
        <source>Work that can come back</source>
        <translation>Trabajo recuperable</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Delete this copy</source>
        <translation>Eliminar esta copia</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Más tarde</translation>
    </message>
    <message>
        <source>Keeps the copies and asks again next time.</source>
        <translation>Conserva las copias y vuelve a preguntar la próxima vez.</translation>
    </message>
    <message>
        <source>The newest is at the top.</source>
        <translation>Lo más reciente está arriba.</translation>
    </message>
    <message>
        <source>Opens this work again. Save it then; the original file is untouched.</source>
        <translation>Abre de nuevo este trabajo. Guárdelo después; el archivo original queda intacto.</translation>
    </message>
    <message>
        <source>Gives this work up for good.</source>
        <translation>Descarta este trabajo para siempre.</translation>
    </message>
</context>
<context>
    <name>txn::app::SeedField</name>
    <message>
        <source>Roll the dice</source>
        <translation>Tirar los dados</translation>
    </message>
    <message>
        <source>Another random result.</source>
        <translation>Otro resultado aleatorio.</translation>
    </message>
    <message>
        <source>Keep this seed</source>
        <translation>Conservar esta semilla</translation>
    </message>
    <message>
        <source>Keeps this number when new seeds are rolled.</source>
        <translation>Conserva este número cuando se generan nuevas semillas.</translation>
    </message>
</context>
<context>
    <name>txn::app::ShortcutEditor</name>
    <message>
        <source>Shortcuts</source>
        <translation>Atajos</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Buscar comandos</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Comandos</translation>
    </message>
    <message>
        <source>Press the keys that you want for the chosen command.</source>
        <translation>Pulse las teclas que quiera para el comando elegido.</translation>
    </message>
    <message>
        <source>No keys</source>
        <translation>Sin teclas</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restablecer todo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>These keys were those of &quot;%1&quot;, which has none now.</source>
        <translation>Estas teclas eran las de «%1», que ahora no tiene ninguna.</translation>
    </message>
    <message>
        <source>Type a part of a command&apos;s name.</source>
        <translation>Escriba parte del nombre de un comando.</translation>
    </message>
    <message>
        <source>Choose a command to give it other keys.</source>
        <translation>Elija un comando para darle otras teclas.</translation>
    </message>
    <message>
        <source>Takes the chosen command&apos;s keys away.</source>
        <translation>Quita las teclas del comando elegido.</translation>
    </message>
    <message>
        <source>Back to the keys that the program came with.</source>
        <translation>Vuelve a las teclas originales del programa.</translation>
    </message>
    <message>
        <source>Closes this window. Changes are kept already.</source>
        <translation>Cierra esta ventana. Los cambios ya están guardados.</translation>
    </message>
</context>
<context>
    <name>txn::app::SpectrumPanel</name>
    <message>
        <source>Exemplar</source>
        <translation>Muestra</translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation>Versión gaussiana</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>Power spectrum</source>
        <translation>Espectro de potencia</translation>
    </message>
    <message>
        <source>How strong waves of each direction and length are: long ones in the middle, fine grain outside. The three should look alike.</source>
        <translation>La fuerza de las ondas de cada dirección y longitud: las largas en el centro, el grano fino fuera. Los tres deberían parecerse.</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autocorrelación</translation>
    </message>
    <message>
        <source>How alike two points are at each distance and direction. The size of the bright patch is that of the grain; it should fit into the support.</source>
        <translation>Cuánto se parecen dos puntos a cada distancia y dirección. La mancha clara tiene el tamaño del grano; debería caber en el soporte.</translation>
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
        <translation>Tan cerca como dos fotos de este material</translation>
    </message>
    <message>
        <source>Long grain is lost. Try a larger support</source>
        <translation>Se pierde el grano largo. Pruebe un soporte mayor</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>Queda %n&#xa0;s</numerusform>
            <numerusform>Quedan %n&#xa0;s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n min left</source>
        <translation>
            <numerusform>Queda %n&#xa0;min</numerusform>
            <numerusform>Quedan %n&#xa0;min</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress of the texton</source>
        <translation>Progreso del textón</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop computing and go back to the last finished texton. Change anything to start again.</source>
        <translation>Detener el cálculo y volver al último textón terminado. Cualquier cambio lo inicia de nuevo.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Cuadrado</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Disco</translation>
    </message>
    <message>
        <source>The outline of the texton. A square suits almost everything; a rectangle follows long grain.</source>
        <translation>El contorno del textón. Un cuadrado sirve para casi todo; un rectángulo sigue el grano largo.</translation>
    </message>
    <message>
        <source>Texton shape</source>
        <translation>Forma del textón</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Soporte</translation>
    </message>
    <message>
        <source>How large the texton is. Features longer than this get lost; larger takes longer to compute. Try 64 first, 128 for long grain.</source>
        <translation>El tamaño del textón. Lo que es más largo se pierde; uno mayor tarda más en calcularse. Pruebe primero 64, o 128 si el grano es largo.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>The height of a rectangular texton. Make it small where the grain runs from left to right.</source>
        <translation>El alto de un textón rectangular. Hágalo pequeño si el grano va de izquierda a derecha.</translation>
    </message>
    <message>
        <source>Support height</source>
        <translation>Alto del soporte</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolación</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Más cercana</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Lineal</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Cúbica</translation>
    </message>
    <message>
        <source>Quintic</source>
        <translation>Quíntica</translation>
    </message>
    <message>
        <source>How values between the texton&apos;s pixels are found. Linear is what graphics cards do for free; cubic is smoother when magnified.</source>
        <translation>Cómo se hallan los valores entre los píxeles del textón. La lineal no cuesta nada a las tarjetas gráficas; la cúbica es más suave al ampliar.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iteraciones</translation>
    </message>
    <message>
        <source>How long the texton is refined. Watch the curve: where it runs flat, more brings nothing.</source>
        <translation>Cuánto se refina el textón. Observe la curva: donde se aplana, seguir no aporta nada.</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Inercia</translation>
    </message>
    <message>
        <source>Gets there in fewer iterations. 0.9 is good; 0 is the plain method of the papers.</source>
        <translation>Llega en menos iteraciones. 0,9 va bien; 0 es el método simple de los artículos.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Another number gives another, equally good texton. Roll the dice, or lock the one you like.</source>
        <translation>Otro número da otro textón igual de bueno. Tire los dados o bloquee el que le guste.</translation>
    </message>
    <message>
        <source>Texton seed</source>
        <translation>Semilla del textón</translation>
    </message>
    <message>
        <source>Lock the texton seed</source>
        <translation>Bloquear la semilla del textón</translation>
    </message>
    <message>
        <source>Unlock the texton seed</source>
        <translation>Desbloquear la semilla del textón</translation>
    </message>
    <message>
        <source>Exact colors</source>
        <translation>Colores exactos</translation>
    </message>
    <message>
        <source>Corrects the texton so that the noise has exactly the colors of the photo. Leave it on unless you compare with the papers.</source>
        <translation>Corrige el textón para que el ruido tenga exactamente los colores de la foto. Déjelo activado, salvo para comparar con los artículos.</translation>
    </message>
    <message>
        <source>Open a photo to compute its texton</source>
        <translation>Abra una foto para calcular su textón</translation>
    </message>
    <message>
        <source>A texton from a file</source>
        <translation>Un textón de archivo</translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation>%1&#xa0;×&#xa0;%2&#xa0;px</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Calculando</translation>
    </message>
    <message>
        <source>Compute again</source>
        <translation>Calcular de nuevo</translation>
    </message>
    <message>
        <source>As close as this method gets</source>
        <translation>Tan cerca como permite el método</translation>
    </message>
    <message>
        <source>Choosing the number of kernels</source>
        <translation>Eligiendo el número de núcleos</translation>
    </message>
    <message>
        <source>Getting closer</source>
        <translation>Cada vez más cerca</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminado</translation>
    </message>
    <message>
        <source>Close. A larger support or another seed may help</source>
        <translation>Cerca. Un soporte mayor u otra semilla puede ayudar</translation>
    </message>
    <message>
        <source>Fair. The material has more order than noise can keep</source>
        <translation>Aceptable. El material tiene más orden del que un ruido conserva</translation>
    </message>
    <message>
        <source>Covariance error %1 × the floor (%2)</source>
        <translation>Error de covarianza %1 × el mínimo (%2)</translation>
    </message>
    <message>
        <source>Relative model error %1</source>
        <translation>Error relativo del modelo %1</translation>
    </message>
    <message>
        <source>Error %1 after %2 iterations</source>
        <translation>Error %1 tras %2 iteraciones</translation>
    </message>
    <message>
        <source>How far the noise&apos;s correlations are from the photo&apos;s. At 1 × the floor they are as close as one half of the photo is to all of it. The relative model error stays near 0.46 even for a perfect texton, because it compares with one photo, in which every wave&apos;s strength is random.</source>
        <translation>Cuánto se apartan las correlaciones del ruido de las de la foto. Con 1 × el mínimo están tan cerca como la mitad de la foto lo está de la foto entera. El error relativo del modelo queda cerca de 0,46 incluso con un textón perfecto, porque compara con una sola foto, en la que la fuerza de cada onda es aleatoria.</translation>
    </message>
    <message>
        <source>Use the suggested support</source>
        <translation>Usar el soporte sugerido</translation>
    </message>
    <message>
        <source>Suggested support</source>
        <translation>Soporte sugerido</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Best fit</source>
        <translation>Mejor ajuste</translation>
    </message>
    <message>
        <source>Papers&apos; projections</source>
        <translation>Proyecciones (artículos)</translation>
    </message>
    <message>
        <source>How the texton is found. Best fit comes closest for the same cost; the projections are the papers&apos; own way, to compare with.</source>
        <translation>Cómo se halla el textón. El mejor ajuste se acerca más con el mismo cálculo; las proyecciones son el método de los artículos, para comparar.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Kernels</source>
        <translation>Núcleos</translation>
    </message>
    <message>
        <source>Each impact picks one of so many small pictures. More follow colors and maps that vary independently, at the same speed. Automatic tries them on one half of the photo.</source>
        <translation>Cada impacto elige una entre este número de imágenes pequeñas. Con más se siguen colores y mapas que varían por separado, a la misma velocidad. Automático los prueba con la mitad de la foto.</translation>
    </message>
    <message>
        <source>What was tried on one half of the photo: the error on the other half, and the memory on a graphics card. The fewest within 5 % of the best are taken.</source>
        <translation>Lo que se probó con la mitad de la foto: el error en la otra mitad y la memoria en una tarjeta gráfica. Se toma el menor número que queda a menos de un 5&#xa0;% del mejor.</translation>
    </message>
    <message>
        <source>Suggested: %1 px</source>
        <translation>Sugerido: %1&#xa0;px</translation>
    </message>
    <message>
        <source>Suggested: none</source>
        <translation>Sugerido: ninguno</translation>
    </message>
    <message>
        <source>As large as the grain of this material needs. A texton of that size leaves out %1 % of the correlation.</source>
        <translation>Tan grande como pide el grano de este material. Un textón de ese tamaño deja fuera el %1&#xa0;% de la correlación.</translation>
    </message>
    <message>
        <source>The photo is too small to tell how large its grain is.</source>
        <translation>La foto es demasiado pequeña para saber el tamaño de su grano.</translation>
    </message>
    <message>
        <source>Error against iterations</source>
        <translation>Error según las iteraciones</translation>
    </message>
    <message>
        <source>The error while the texton is refined. Lower is closer.</source>
        <translation>El error mientras se refina el textón. Cuanto más bajo, más cerca.</translation>
    </message>
    <message>
        <source>Kernels: %1, error %2, %3 KB</source>
        <translation>Núcleos: %1, error %2, %3&#xa0;KB</translation>
    </message>
</context>
<context>
    <name>txn::app::ViewTitle</name>
    <message>
        <source>Exemplar</source>
        <translation>Muestra</translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation>Versión gaussiana</translation>
    </message>
    <message>
        <source>Texton</source>
        <translation>Textón</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>Picture in this view</source>
        <translation>Imagen de esta vista</translation>
    </message>
    <message>
        <source>Picture right of the border</source>
        <translation>Imagen a la derecha del límite</translation>
    </message>
    <message>
        <source>What this view shows.</source>
        <translation>Lo que muestra esta vista.</translation>
    </message>
    <message>
        <source>What is shown right of the border that you can drag.</source>
        <translation>Lo que se muestra a la derecha del límite que se arrastra.</translation>
    </message>
    <message>
        <source>Method of the Gaussian version</source>
        <translation>Método de la versión gaussiana</translation>
    </message>
    <message>
        <source>ADSN: random phases and strengths, what texton noise comes to. RPN: random phases only, keeps the exact spectrum of the photo.</source>
        <translation>ADSN: fases y amplitudes aleatorias, a lo que tiende el ruido de textones. RPN: solo fases aleatorias, conserva el espectro exacto de la foto.</translation>
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
        <translation>Otra versión gaussiana</translation>
    </message>
    <message>
        <source>Roll the dice for another Gaussian version.</source>
        <translation>Tirar los dados para obtener otra versión gaussiana.</translation>
    </message>
    <message>
        <source>This is still an older result; the new one is being computed.</source>
        <translation>Aún es un resultado anterior; el nuevo se está calculando.</translation>
    </message>
    <message>
        <source>Older result</source>
        <translation>Resultado anterior</translation>
    </message>
</context>
</TS>
