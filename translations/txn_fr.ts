<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR">
<context>
    <name>Help</name>
    <message>
        <source>Show this help.</source>
        <translation>Afficher cette aide.</translation>
    </message>
    <message>
        <source>Show the version.</source>
        <translation>Afficher la version.</translation>
    </message>
    <message>
        <source>Language of the window, such as en or fr.</source>
        <translation>Langue de la fenêtre, par exemple en ou fr.</translation>
    </message>
    <message>
        <source>LANGUAGE</source>
        <translation>LANGUE</translation>
    </message>
    <message>
        <source>Makes endless material from a photo. FILES may be photos, textons or a project.</source>
        <translation>Fait d&apos;une photo une matière sans fin. FILES&#xa0;: des photos, des textons ou un projet.</translation>
    </message>
    <message>
        <source>What to open.</source>
        <translation>Ce qu&apos;il faut ouvrir.</translation>
    </message>
    <message>
        <source>texton-studio: %1 See texton-studio --help.</source>
        <translation>texton-studio&#xa0;: %1 Voir texton-studio --help.</translation>
    </message>
    <message>
        <source>With --version: those of all libraries, too.</source>
        <translation>Avec --version : celles de toutes les bibliothèques aussi.</translation>
    </message>
</context>
<context>
    <name>Warnings</name>
    <message>
        <source>%1 has changed since the project was saved.</source>
        <translation>%1 a changé depuis l&apos;enregistrement du projet.</translation>
    </message>
    <message>
        <source>%1 is missing; a sphere takes its place.</source>
        <translation>%1 est introuvable&#xa0;; une sphère prend sa place.</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>A value is out of its range; please choose another one.</source>
        <translation>Une valeur est hors limites&#xa0;; en choisir une autre.</translation>
    </message>
    <message>
        <source>The file is not there; please choose another one.</source>
        <translation>Le fichier n&apos;est pas là&#xa0;; en choisir un autre.</translation>
    </message>
    <message>
        <source>The file cannot be read; please open another copy of it.</source>
        <translation>Le fichier est illisible&#xa0;; en ouvrir une autre copie.</translation>
    </message>
    <message>
        <source>The file cannot be written; please choose another place.</source>
        <translation>Le fichier ne peut pas être écrit&#xa0;; choisir un autre endroit.</translation>
    </message>
    <message>
        <source>This is too large; please choose a smaller picture, part or size.</source>
        <translation>C&apos;est trop grand&#xa0;; choisir une image, une partie ou une taille plus petite.</translation>
    </message>
    <message>
        <source>This cannot be done with such a file; please choose another kind.</source>
        <translation>C&apos;est impossible avec un tel fichier&#xa0;; en choisir un d&apos;un autre type.</translation>
    </message>
    <message>
        <source>These do not fit together; please choose another picture, support or part.</source>
        <translation>Cela ne va pas ensemble&#xa0;; choisir une autre image, un autre support ou une autre partie.</translation>
    </message>
    <message>
        <source>The picture is all one color, or has values that are no numbers; please choose another one.</source>
        <translation>L&apos;image est d&apos;une seule couleur, ou contient des valeurs qui ne sont pas des nombres&#xa0;; en choisir une autre.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
</context>
<context>
    <name>txn::app::ActionRegistry</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>txn::app::Autosave</name>
    <message>
        <source>Keeping a copy</source>
        <translation>Copie de secours</translation>
    </message>
    <message>
        <source>No copy of your work can be kept (%1). Please save it.</source>
        <translation>Impossible de garder une copie du travail (%1). Veuillez l&apos;enregistrer.</translation>
    </message>
</context>
<context>
    <name>txn::app::BeforeAfter</name>
    <message>
        <source>Hold the mouse button or the space bar to see it as it was before.</source>
        <translation>Maintenir le bouton de la souris ou la barre d&apos;espace pour voir l&apos;image d&apos;avant.</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>After (hold for before)</source>
        <translation>Après (tenir&#xa0;: avant)</translation>
    </message>
</context>
<context>
    <name>txn::app::CommandPalette</name>
    <message>
        <source>Type what you want to do</source>
        <translation>Taper ce qu&apos;il faut faire</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Rechercher une commande</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
</context>
<context>
    <name>txn::app::ErrorPlot</name>
    <message>
        <source>Error against iterations</source>
        <translation>Erreur selon les itérations</translation>
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
        <translation>flottant 16&#xa0;bits</translation>
    </message>
    <message>
        <source>32 bit float</source>
        <translation>flottant 32&#xa0;bits</translation>
    </message>
    <message>
        <source>gray</source>
        <translation>gris</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RVB</translation>
    </message>
    <message>
        <source>%1 channels</source>
        <translation>%1&#xa0;canaux</translation>
    </message>
    <message>
        <source>Colors will clip</source>
        <translation>Des couleurs seront écrêtées</translation>
    </message>
    <message>
        <source>%1 % of the noise&apos;s values are darker than black or lighter than white. Lower the contrast of the noise, or export EXR.</source>
        <translation>%1&#xa0;% des valeurs du bruit sont plus sombres que le noir ou plus claires que le blanc. Baisser le contraste du bruit, ou exporter en EXR.</translation>
    </message>
    <message>
        <source>Suits, but highlights or shadows even out</source>
        <translation>Convient, mais hautes lumières ou ombres s&apos;estompent</translation>
    </message>
    <message>
        <source>Its values lean to one side; those of the noise are spread evenly around the mean.</source>
        <translation>Ses valeurs penchent d&apos;un côté&#xa0;; celles du bruit se répartissent également autour de la moyenne.</translation>
    </message>
    <message>
        <source>Suits texton noise</source>
        <translation>Convient au bruit de textons</translation>
    </message>
    <message>
        <source>It is all grain and no shapes, and its colors fit.</source>
        <translation>Tout est grain, sans formes, et ses couleurs conviennent.</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Recadrer</translation>
    </message>
    <message>
        <source>Drag over the part of the photo that looks the same all over.</source>
        <translation>Glisser sur la partie de la photo qui a partout le même aspect.</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Redresser</translation>
    </message>
    <message>
        <source>Draw a line along the grain; it becomes level or upright.</source>
        <translation>Tracer une ligne le long du grain&#xa0;; elle devient horizontale ou verticale.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Back to the photo as it was opened.</source>
        <translation>Revenir à la photo telle qu&apos;elle a été ouverte.</translation>
    </message>
    <message>
        <source>Reset the exemplar</source>
        <translation>Réinitialiser l&apos;exemplaire</translation>
    </message>
    <message>
        <source>The photo and its crop</source>
        <translation>La photo et son recadrage</translation>
    </message>
    <message>
        <source>Drag to use only a part of the photo. Arrow keys move it, with Shift they resize it.</source>
        <translation>Glisser pour n&apos;utiliser qu&apos;une partie de la photo. Les flèches la déplacent&#xa0;; avec Maj, elles la redimensionnent.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Turns the photo, counterclockwise. Or draw a line with Straighten.</source>
        <translation>Tourne la photo dans le sens inverse des aiguilles d&apos;une montre. On peut aussi tracer une ligne avec Redresser.</translation>
    </message>
    <message>
        <source>Work in</source>
        <translation>Travailler en</translation>
    </message>
    <message>
        <source>sRGB values</source>
        <translation>Valeurs sRGB</translation>
    </message>
    <message>
        <source>Linear light</source>
        <translation>Lumière linéaire</translation>
    </message>
    <message>
        <source>sRGB values keep dark grain; linear light suits renderers. Try sRGB first.</source>
        <translation>Les valeurs sRGB gardent le grain sombre&#xa0;; la lumière linéaire convient aux moteurs de rendu. Essayer d&apos;abord sRGB.</translation>
    </message>
    <message>
        <source>Even out the lighting</source>
        <translation>Uniformiser l&apos;éclairage</translation>
    </message>
    <message>
        <source>Takes away shade that is smoother than the radius, such as a dark corner.</source>
        <translation>Enlève les ombres plus douces que le rayon, comme un coin sombre.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>Only what is smoother than this goes away. Small values also take large grain.</source>
        <translation>Seul ce qui est plus doux que cela disparaît. De petites valeurs emportent aussi le gros grain.</translation>
    </message>
    <message>
        <source>Lighting radius</source>
        <translation>Rayon d&apos;éclairage</translation>
    </message>
    <message>
        <source>Lighting before and after</source>
        <translation>Éclairage avant et après</translation>
    </message>
    <message>
        <source>Remove the seam</source>
        <translation>Supprimer le raccord</translation>
    </message>
    <message>
        <source>Takes away the jump from one border of the photo to the other (the periodic component). Switch it off for pictures that tile already.</source>
        <translation>Enlève le saut d&apos;un bord à l&apos;autre de la photo (ne garde que la composante périodique). À désactiver pour les images qui se répètent déjà en mosaïque.</translation>
    </message>
    <message>
        <source>Seam before and after</source>
        <translation>Raccord avant et après</translation>
    </message>
    <message>
        <source>A texton from a file needs no exemplar.</source>
        <translation>Un texton venu d&apos;un fichier n&apos;a pas besoin d&apos;exemplaire.</translation>
    </message>
    <message>
        <source>Open a photo of a material, or drop one here.</source>
        <translation>Ouvrir la photo d&apos;un matériau, ou en déposer une ici.</translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation>%1&#xa0;×&#xa0;%2&#xa0;px</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linéaire</translation>
    </message>
    <message>
        <source>sRGB</source>
        <translation>sRGB</translation>
    </message>
    <message>
        <source>color profile converted</source>
        <translation>profil de couleur converti</translation>
    </message>
    <message>
        <source>transparency left out</source>
        <translation>transparence ignorée</translation>
    </message>
    <message>
        <source>Skewness %1, excess kurtosis %2, clipped values %3 %, sub-bands %4 standard deviations from those of its Gaussian versions.</source>
        <translation>Asymétrie %1, excès d&apos;aplatissement %2, valeurs écrêtées %3&#xa0;%, sous-bandes à %4 écarts-types de celles de ses versions gaussiennes.</translation>
    </message>
    <message>
        <source>Has shapes that a Gaussian texture cannot keep</source>
        <translation>Contient des formes qu&apos;une texture gaussienne ne garde pas</translation>
    </message>
    <message>
        <source>Edges, patches and single features even out into grain. Compare with the Gaussian version, or crop a part that is all grain.</source>
        <translation>Les bords, les taches et les détails isolés se fondent en grain. Comparer avec la version gaussienne, ou recadrer une partie qui n&apos;est que grain.</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normales</translation>
    </message>
    <message>
        <source>Normals, green down</source>
        <translation>Normales, vert vers le bas</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rugosité</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Occlusion</translation>
    </message>
    <message>
        <source>Metalness</source>
        <translation>Métal</translation>
    </message>
    <message>
        <source>Occlusion, roughness, metalness</source>
        <translation>Occlusion, rugosité, métal</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Données</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>The maps of this material, told by the words in their names. Their noise comes from the same impacts, so that they stay in register.</source>
        <translation>Les cartes de ce matériau, reconnues aux mots de leurs noms. Leur bruit vient des mêmes impacts, elles restent donc alignées.</translation>
    </message>
    <message>
        <source>Green points the other way</source>
        <translation>Le vert pointe dans l&apos;autre sens</translation>
    </message>
    <message>
        <source>For normal maps made for another program: switch it on if bumps look like dents.</source>
        <translation>Pour les cartes de normales faites pour un autre programme : à activer si les bosses ont l&apos;air de creux.</translation>
    </message>
    <message>
        <source>Green of the normals</source>
        <translation>Vert des normales</translation>
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
        <translation>EXR, flottant 16&#xa0;bits</translation>
    </message>
    <message>
        <source>EXR, 32 bit float</source>
        <translation>EXR, flottant 32&#xa0;bits</translation>
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
        <translation>TIFF, flottant 32&#xa0;bits</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source> px</source>
        <translation>&#xa0;px</translation>
    </message>
    <message>
        <source>EXR, exact</source>
        <translation>EXR, exact</translation>
    </message>
    <message>
        <source>Every value as it is, with all parameters inside. The best choice.</source>
        <translation>Chaque valeur telle quelle, avec tous les paramètres. Le meilleur choix.</translation>
    </message>
    <message>
        <source>For programs that cannot read EXR. The JSON file tells how values are coded.</source>
        <translation>Pour les programmes qui ne lisent pas EXR. Le fichier JSON dit comment les valeurs sont codées.</translation>
    </message>
    <message>
        <source>.texton, as text</source>
        <translation>.texton, en texte</translation>
    </message>
    <message>
        <source>The format of the papers&apos; authors, for their programs.</source>
        <translation>Le format des auteurs des articles, pour leurs programmes.</translation>
    </message>
    <message>
        <source>Common sizes; any other can be typed below.</source>
        <translation>Tailles courantes&#xa0;; toute autre peut être saisie dessous.</translation>
    </message>
    <message>
        <source>%1 x %1</source>
        <translation>%1&#xa0;×&#xa0;%1</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Autre</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Tiles without a seam</source>
        <translation>Se répète sans raccord</translation>
    </message>
    <message>
        <source>The picture repeats without a seam. Off, it is a piece of the endless plane.</source>
        <translation>L&apos;image se répète en mosaïque sans raccord. Sinon, c&apos;est un morceau du plan infini.</translation>
    </message>
    <message>
        <source>From the left</source>
        <translation>Depuis la gauche</translation>
    </message>
    <message>
        <source>From the top</source>
        <translation>Depuis le haut</translation>
    </message>
    <message>
        <source>Where on the endless plane the piece is cut out.</source>
        <translation>L&apos;endroit du plan infini où le morceau est découpé.</translation>
    </message>
    <message>
        <source>EXR keeps values beyond black and white; PNG and TIFF with 8 or 16 bits clip them.</source>
        <translation>EXR garde les valeurs au-delà du noir et du blanc&#xa0;; PNG et TIFF en 8 ou 16&#xa0;bits les écrêtent.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What to export</source>
        <translation>Ce qu&apos;il faut exporter</translation>
    </message>
    <message>
        <source>Texton</source>
        <translation>Texton</translation>
    </message>
    <message>
        <source>Noise texture</source>
        <translation>Texture de bruit</translation>
    </message>
    <message>
        <source>Current view</source>
        <translation>Vue actuelle</translation>
    </message>
    <message>
        <source>For engines</source>
        <translation>Pour moteurs 3D</translation>
    </message>
    <message>
        <source>The noise as it is on screen, as a PNG picture.</source>
        <translation>Le bruit tel qu&apos;il est à l&apos;écran, en image PNG.</translation>
    </message>
    <message>
        <source>Everything to draw endless material in your own program: the texton, one self-contained shader (GLSL 330, free to use under CC0), its parameters, and a small example program.</source>
        <translation>Tout pour dessiner un matériau sans fin dans son propre programme&#xa0;: le texton, un seul shader autonome (GLSL 330, libre d&apos;emploi sous CC0), ses paramètres et un petit programme d&apos;exemple.</translation>
    </message>
    <message>
        <source>Choices that you saved under a name.</source>
        <translation>Réglages enregistrés sous un nom.</translation>
    </message>
    <message>
        <source>Save as preset...</source>
        <translation>Créer un préréglage...</translation>
    </message>
    <message>
        <source>Words in braces are filled in: {name} {support} {mni} {seed} {size}.</source>
        <translation>Les mots entre accolades sont remplacés&#xa0;: {name} {support} {mni} {seed} {size}.</translation>
    </message>
    <message>
        <source>Where the files go.</source>
        <translation>L&apos;endroit où vont les fichiers.</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Choisir...</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ouvrir le dossier</translation>
    </message>
    <message>
        <source>material</source>
        <translation>texture</translation>
    </message>
    <message>
        <source>%1  (replaces a file)</source>
        <translation>%1  (remplace un fichier)</translation>
    </message>
    <message>
        <source>There is no texton yet.</source>
        <translation>Pas encore de texton.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>Encore&#xa0;%n&#xa0;s</numerusform>
            <numerusform>Encore&#xa0;%n&#xa0;s</numerusform>
        </translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Créer un préréglage</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Nom du préréglage</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Choisir un dossier</translation>
    </message>
    <message>
        <source>Replace files?</source>
        <translation>Remplacer des fichiers&#xa0;?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) of these names exist already.</source>
        <translation>
            <numerusform>%n fichier de ce nom existe déjà.</numerusform>
            <numerusform>%n fichiers de ces noms existent déjà.</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Écriture</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Exportation</translation>
    </message>
    <message numerus="yes">
        <source>Wrote %n file(s).</source>
        <translation>
            <numerusform>%n fichier écrit.</numerusform>
            <numerusform>%n fichiers écrits.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 % of the values were clipped; EXR keeps them.</source>
        <translation>%1&#xa0;% des valeurs ont été écrêtées&#xa0;; EXR les garde.</translation>
    </message>
    <message>
        <source>Pixels of the picture. Large ones are written piece by piece.</source>
        <translation>Pixels de l&apos;image. Les grandes images sont écrites morceau par morceau.</translation>
    </message>
    <message>
        <source>What to write.</source>
        <translation>Ce qui sera écrit.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Forgets the chosen preset.</source>
        <translation>Oublie le préréglage choisi.</translation>
    </message>
    <message>
        <source>Remembers these choices under a name.</source>
        <translation>Retient ces choix sous un nom.</translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation>Choisir un autre dossier.</translation>
    </message>
    <message>
        <source>Shows where the files are.</source>
        <translation>Montre où sont les fichiers.</translation>
    </message>
    <message>
        <source>Writes the files that are listed.</source>
        <translation>Écrit les fichiers de la liste.</translation>
    </message>
    <message>
        <source>Stops the work, or else closes this window.</source>
        <translation>Arrête le travail en cours, sinon ferme cette fenêtre.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>Delete the preset?</source>
        <translation>Supprimer le préréglage&#xa0;?</translation>
    </message>
    <message>
        <source>The preset %1 will be gone.</source>
        <translation>Le préréglage %1 sera perdu.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Mixture</source>
        <translation>Mélange</translation>
    </message>
    <message>
        <source>All textons from A to B in a folder of their own: one EXR with a layer for each, the same as single files, a description, and the map as a gray picture. A noise texture of the mixture begins at the corner of the map; to tile, the map has to repeat.</source>
        <translation>Tous les textons de A à B dans un dossier à part : un EXR avec un calque pour chacun, les mêmes en fichiers séparés, une description et la carte en image grise. Une texture de bruit du mélange commence au coin de la carte ; pour se raccorder, la carte doit se répéter.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 de plus</translation>
    </message>
    <message>
        <source>There is no mixture yet. Open a second material first.</source>
        <translation>Il n&apos;y a pas encore de mélange. Ouvrez d&apos;abord une seconde matière.</translation>
    </message>
    <message>
        <source>The mixture is not ready. The Mix panel tells why.</source>
        <translation>Le mélange n&apos;est pas prêt. Le panneau Mélange dit pourquoi.</translation>
    </message>
    <message>
        <source>To tile, switch on Mix &gt; Repeat the map, and choose a multiple of %1 x %2 px.</source>
        <translation>Pour le raccord, activez Mélange &gt; Répéter la carte et choisissez un multiple de %1 x %2 px.</translation>
    </message>
</context>
<context>
    <name>txn::app::FileController</name>
    <message>
        <source>Open %1</source>
        <translation>Ouvrir %1</translation>
    </message>
    <message>
        <source>Making the sample</source>
        <translation>Création de l&apos;exemple</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message>
        <source>Open a photo, texton or project</source>
        <translation>Ouvrir une photo, un texton ou un projet</translation>
    </message>
    <message>
        <source>All that can be opened (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp *.texton *.txnproj);;Photos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;Textons (*.texton *.exr *.png);;Projects (*.txnproj);;All files (*)</source>
        <translation>Tout ce qui peut être ouvert (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp *.texton *.txnproj);;Photos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;Textons (*.texton *.exr *.png);;Projets (*.txnproj);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Pasting a picture</source>
        <translation>Collage d&apos;une image</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Image collée</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>Texton Studio projects (*.txnproj)</source>
        <translation>Projets Texton Studio (*.txnproj)</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 a été enregistré</translation>
    </message>
    <message>
        <source>Save before closing?</source>
        <translation>Enregistrer avant de fermer&#xa0;?</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 contient des changements non enregistrés.</translation>
    </message>
    <message>
        <source>Saving keeps the photo, all settings and the view in one project file.</source>
        <translation>Un seul fichier de projet garde la photo, tous les réglages et la vue.</translation>
    </message>
    <message>
        <source>Still saving. Please try again in a moment.</source>
        <translation>Enregistrement en cours. Veuillez réessayer dans un instant.</translation>
    </message>
    <message>
        <source>Opening the maps of a material</source>
        <translation>Ouverture des cartes d&apos;un matériau</translation>
    </message>
    <message>
        <source>Open %1 as B</source>
        <translation>Ouvrir %1 comme B</translation>
    </message>
    <message>
        <source>Open the second material</source>
        <translation>Ouvrir la seconde matière</translation>
    </message>
    <message>
        <source>Photos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;All files (*)</source>
        <translation>Photos (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.tga *.bmp *.webp);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open a photo first, then a second one to mix it with.</source>
        <translation>Ouvrez d&apos;abord une photo, puis une seconde à lui mélanger.</translation>
    </message>
    <message>
        <source>Open a very large picture?</source>
        <translation>Ouvrir une très grande image ?</translation>
    </message>
    <message>
        <source>Opening it may take long and much memory. Open only files that you trust this way.</source>
        <translation>L’ouvrir peut prendre du temps et beaucoup de mémoire. N’ouvrez ainsi que des fichiers sûrs.</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Ouvrir quand même</translation>
    </message>
    <message>
        <source>Files outside the project&apos;s folder</source>
        <translation>Fichiers hors du dossier du projet</translation>
    </message>
    <message>
        <source>%1 wants to open files outside its own folder. Do that only if you know where it comes from.</source>
        <translation>%1 veut ouvrir des fichiers hors de son dossier. Acceptez seulement si vous savez d’où il vient.</translation>
    </message>
    <message>
        <source>%1 is open in another Texton Studio. Please choose another name.</source>
        <translation>%1 est ouvert dans un autre Texton Studio. Veuillez choisir un autre nom.</translation>
    </message>
    <message>
        <source>%1 is open in another Texton Studio. This is a copy of it; please save it under another name.</source>
        <translation>%1 est ouvert dans un autre Texton Studio. Ceci en est une copie ; veuillez l&apos;enregistrer sous un autre nom.</translation>
    </message>
</context>
<context>
    <name>txn::app::HistogramPanel</name>
    <message>
        <source>How often each value occurs. Where the noise reaches beyond 0 or 1, its colors are clipped.</source>
        <translation>La fréquence de chaque valeur. Là où le bruit dépasse 0 ou 1, ses couleurs sont écrêtées.</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Exemplaire</translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation>Version gaussienne</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Bruit</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rouge</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Vert</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Bleu</translation>
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
        <translation>Histogramme</translation>
    </message>
</context>
<context>
    <name>txn::app::JobRunner</name>
    <message>
        <source>there is not enough memory; try a smaller picture or size</source>
        <translation>mémoire insuffisante&#xa0;; essayer une image ou une taille plus petite</translation>
    </message>
</context>
<context>
    <name>txn::app::JobsPanel</name>
    <message>
        <source>Work in progress</source>
        <translation>Travaux en cours</translation>
    </message>
    <message>
        <source>What is being computed right now.</source>
        <translation>Ce qui est calculé en ce moment.</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1&#xa0;s</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stops this work.</source>
        <translation>Arrête ce travail.</translation>
    </message>
</context>
<context>
    <name>txn::app::JobsStatus</name>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>How far the work is. The Jobs panel lists all of it.</source>
        <translation>L&apos;avancement du travail. Le panneau Tâches en montre le détail.</translation>
    </message>
</context>
<context>
    <name>txn::app::KeyMapOverlay</name>
    <message>
        <source>All keys</source>
        <translation>Toutes les touches</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Molette</translation>
    </message>
    <message>
        <source>Zoom at the mouse</source>
        <translation>Zoomer sous la souris</translation>
    </message>
    <message>
        <source>Middle drag, Space drag</source>
        <translation>Glisser milieu ou Espace</translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation>Déplacer l&apos;image</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Glisser, bouton gauche</translation>
    </message>
    <message>
        <source>Look around the ground or mesh</source>
        <translation>Regarder autour du sol ou maillage</translation>
    </message>
    <message>
        <source>Hold `</source>
        <translation>Maintenir `</translation>
    </message>
    <message>
        <source>See the exemplar instead</source>
        <translation>Voir l&apos;exemplaire à la place</translation>
    </message>
    <message>
        <source>Hold X</source>
        <translation>Maintenir X</translation>
    </message>
    <message>
        <source>See the difference, eightfold</source>
        <translation>Voir la différence, 8 fois plus forte</translation>
    </message>
    <message>
        <source>Shift drag</source>
        <translation>Maj + glisser</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Double clic</translation>
    </message>
    <message>
        <source>In a view</source>
        <translation>Dans une vue</translation>
    </message>
    <message>
        <source>Double-click the title</source>
        <translation>Double-clic sur le titre</translation>
    </message>
    <message>
        <source>This view only</source>
        <translation>Cette vue seulement</translation>
    </message>
    <message>
        <source>On a slider</source>
        <translation>Sur un curseur</translation>
    </message>
    <message>
        <source>Fine steps</source>
        <translation>Pas fins</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Valeur par défaut</translation>
    </message>
    <message>
        <source>Any key closes this.</source>
        <translation>N&apos;importe quelle touche ferme ceci.</translation>
    </message>
</context>
<context>
    <name>txn::app::MainWindow</name>
    <message>
        <source>Recovering %1</source>
        <translation>Récupération de %1</translation>
    </message>
    <message>
        <source>That did not work: %1</source>
        <translation>Cela n&apos;a pas marché&#xa0;: %1</translation>
    </message>
    <message>
        <source>The noise is drawn without the graphics card, from above only: %1</source>
        <translation>Le bruit est dessiné sans la carte graphique, vu de dessus seulement&#xa0;: %1</translation>
    </message>
    <message>
        <source>Exemplar</source>
        <translation>Exemplaire</translation>
    </message>
    <message>
        <source>Texton</source>
        <translation>Texton</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Bruit</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spectre</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramme</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Every change you made. Click one to go back to it.</source>
        <translation>Tous les changements. Cliquer sur l&apos;un d&apos;eux pour y revenir.</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Tâches</translation>
    </message>
    <message>
        <source>What draws the noise.</source>
        <translation>Ce qui dessine le bruit.</translation>
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
        <translation>linéaire %1</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Bois</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>Pierre</translation>
    </message>
    <message>
        <source>Sand</source>
        <translation>Sable</translation>
    </message>
    <message>
        <source>Rust</source>
        <translation>Rouille</translation>
    </message>
    <message>
        <source>Brushed metal</source>
        <translation>Métal brossé</translation>
    </message>
    <message>
        <source>Cloth</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>Leather</source>
        <translation>Cuir</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nouveau</translation>
    </message>
    <message>
        <source>Close everything and start afresh.</source>
        <translation>Tout fermer et repartir de zéro.</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Ouvrir...</translation>
    </message>
    <message>
        <source>Open a photo, a texton or a project.</source>
        <translation>Ouvrir une photo, un texton ou un projet.</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>&amp;Enregistrer le projet</translation>
    </message>
    <message>
        <source>Keep the photo and all settings in one file.</source>
        <translation>Garder la photo et tous les réglages dans un seul fichier.</translation>
    </message>
    <message>
        <source>Save project &amp;as...</source>
        <translation>Enregistrer le projet &amp;sous...</translation>
    </message>
    <message>
        <source>Save under another name.</source>
        <translation>Enregistrer sous un autre nom.</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>E&amp;xporter...</translation>
    </message>
    <message>
        <source>Write textons, textures and shaders for other programs.</source>
        <translation>Écrire des textons, textures et shaders pour d&apos;autres programmes.</translation>
    </message>
    <message>
        <source>Save picture of &amp;the noise...</source>
        <translation>Enregistrer l&apos;&amp;image du bruit...</translation>
    </message>
    <message>
        <source>Save what the noise view shows.</source>
        <translation>Enregistrer ce que montre la vue du bruit.</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Close the program.</source>
        <translation>Fermer le programme.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Take the last change back.</source>
        <translation>Revenir sur le dernier changement.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Make the change again.</source>
        <translation>Refaire le changement.</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Coller</translation>
    </message>
    <message>
        <source>Open the picture or file in the clipboard.</source>
        <translation>Ouvrir l&apos;image ou le fichier du presse-papiers.</translation>
    </message>
    <message>
        <source>There is no picture in the clipboard.</source>
        <translation>Il n&apos;y a pas d&apos;image dans le presse-papiers.</translation>
    </message>
    <message>
        <source>&amp;Shortcuts...</source>
        <translation>Raccourci&amp;s...</translation>
    </message>
    <message>
        <source>Choose your own keys.</source>
        <translation>Choisir ses propres touches.</translation>
    </message>
    <message>
        <source>&amp;Single view</source>
        <translation>Vue &amp;unique</translation>
    </message>
    <message>
        <source>One picture fills the middle.</source>
        <translation>Une seule image remplit le milieu.</translation>
    </message>
    <message>
        <source>Side &amp;by side</source>
        <translation>&amp;Côte à côte</translation>
    </message>
    <message>
        <source>Two pictures next to each other.</source>
        <translation>Deux images l&apos;une à côté de l&apos;autre.</translation>
    </message>
    <message>
        <source>&amp;Four views</source>
        <translation>&amp;Quatre vues</translation>
    </message>
    <message>
        <source>Exemplar, Gaussian version, texton and noise at once.</source>
        <translation>Exemplaire, version gaussienne, texton et bruit à la fois.</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Volet</translation>
    </message>
    <message>
        <source>Two pictures in one place, with a border to drag.</source>
        <translation>Deux images au même endroit, avec une limite à faire glisser.</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>A&amp;juster</translation>
    </message>
    <message>
        <source>Show the whole exemplar.</source>
        <translation>Montrer tout l&apos;exemplaire.</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100&#xa0;%</translation>
    </message>
    <message>
        <source>One pixel of the picture is one of the screen.</source>
        <translation>Un pixel de l&apos;image est un pixel de l&apos;écran.</translation>
    </message>
    <message>
        <source>&amp;200 %</source>
        <translation>&amp;200&#xa0;%</translation>
    </message>
    <message>
        <source>Twice as large.</source>
        <translation>Deux fois plus grand.</translation>
    </message>
    <message>
        <source>Show the &amp;Gaussian version</source>
        <translation>Montrer la version &amp;gaussienne</translation>
    </message>
    <message>
        <source>In the view under the mouse.</source>
        <translation>Dans la vue sous la souris.</translation>
    </message>
    <message>
        <source>&amp;Tile the exemplar</source>
        <translation>Exemplaire en &amp;mosaïque</translation>
    </message>
    <message>
        <source>Repeat the photo, to see the repetition that the noise does away with.</source>
        <translation>Répéter la photo en mosaïque, pour voir la répétition que le bruit évite.</translation>
    </message>
    <message>
        <source>B&amp;righter</source>
        <translation>Plus c&amp;lair</translation>
    </message>
    <message>
        <source>Show everything a third of a stop brighter.</source>
        <translation>Éclaircir tout d&apos;un tiers de diaphragme.</translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation>Plus &amp;sombre</translation>
    </message>
    <message>
        <source>Show everything a third of a stop darker.</source>
        <translation>Assombrir tout d&apos;un tiers de diaphragme.</translation>
    </message>
    <message>
        <source>&amp;Normal exposure</source>
        <translation>&amp;Exposition normale</translation>
    </message>
    <message>
        <source>Show the values as they are.</source>
        <translation>Montrer les valeurs telles quelles.</translation>
    </message>
    <message>
        <source>Look at single channels as gray.</source>
        <translation>Regarder un seul canal, en gris.</translation>
    </message>
    <message>
        <source>&amp;All channels</source>
        <translation>&amp;Tous les canaux</translation>
    </message>
    <message>
        <source>First channel (red)</source>
        <translation>Premier canal (rouge)</translation>
    </message>
    <message>
        <source>Second channel (green)</source>
        <translation>Deuxième canal (vert)</translation>
    </message>
    <message>
        <source>Third channel (blue)</source>
        <translation>Troisième canal (bleu)</translation>
    </message>
    <message>
        <source>What is around the pictures.</source>
        <translation>Ce qui entoure les images.</translation>
    </message>
    <message>
        <source>&amp;Compute again</source>
        <translation>Re&amp;calculer</translation>
    </message>
    <message>
        <source>Compute the texton once more and watch it form.</source>
        <translation>Calculer le texton encore une fois et le regarder se former.</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>Annuler le ca&amp;lcul</translation>
    </message>
    <message>
        <source>Stop computing the texton.</source>
        <translation>Arrêter le calcul du texton.</translation>
    </message>
    <message>
        <source>New &amp;seed</source>
        <translation>Nouvelle &amp;graine</translation>
    </message>
    <message>
        <source>Another random result of what is under the mouse: Gaussian version, texton or noise.</source>
        <translation>Un autre résultat aléatoire de ce qui est sous la souris&#xa0;: version gaussienne, texton ou bruit.</translation>
    </message>
    <message>
        <source>Gaussian method</source>
        <translation>Méthode gaussienne</translation>
    </message>
    <message>
        <source>Random phases and random strengths: what texton noise comes to.</source>
        <translation>Phases et amplitudes aléatoires&#xa0;: ce vers quoi tend le bruit de textons.</translation>
    </message>
    <message>
        <source>Random phases only: keeps the exact spectrum of the photo.</source>
        <translation>Phases aléatoires seulement&#xa0;: garde le spectre exact de la photo.</translation>
    </message>
    <message>
        <source>The texton&apos;s seed is locked.</source>
        <translation>La graine du texton est verrouillée.</translation>
    </message>
    <message>
        <source>New seed</source>
        <translation>Nouvelle graine</translation>
    </message>
    <message>
        <source>Show or hide this panel.</source>
        <translation>Montrer ou cacher ce panneau.</translation>
    </message>
    <message>
        <source>&amp;Hide panels</source>
        <translation>&amp;Masquer les panneaux</translation>
    </message>
    <message>
        <source>Nothing but the pictures; the same key brings the panels back.</source>
        <translation>Rien que les images&#xa0;; la même touche ramène les panneaux.</translation>
    </message>
    <message>
        <source>&amp;Next panel</source>
        <translation>Panneau &amp;suivant</translation>
    </message>
    <message>
        <source>Go on to the next panel with the keyboard.</source>
        <translation>Passer au panneau suivant avec le clavier.</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Réinitialiser la disposition</translation>
    </message>
    <message>
        <source>Put all panels back where they belong.</source>
        <translation>Remettre tous les panneaux à leur place.</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>Use the whole screen.</source>
        <translation>Utiliser tout l&apos;écran.</translation>
    </message>
    <message>
        <source>The colors of the window.</source>
        <translation>Les couleurs de la fenêtre.</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Comme le s&amp;ystème</translation>
    </message>
    <message>
        <source>&amp;Command palette</source>
        <translation>&amp;Palette de commandes</translation>
    </message>
    <message>
        <source>Find any command by typing a part of its name.</source>
        <translation>Trouver une commande en tapant une partie de son nom.</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Touches</translation>
    </message>
    <message>
        <source>All keys at a glance.</source>
        <translation>Toutes les touches d&apos;un coup d&apos;œil.</translation>
    </message>
    <message>
        <source>&amp;What is this?</source>
        <translation>&amp;Qu&apos;est-ce que c&apos;est&#xa0;?</translation>
    </message>
    <message>
        <source>Then click on anything to read about it.</source>
        <translation>Cliquer ensuite sur un élément pour lire ce qu&apos;il est.</translation>
    </message>
    <message>
        <source>&amp;About Texton Studio</source>
        <translation>À p&amp;ropos de Texton Studio</translation>
    </message>
    <message>
        <source>Version, method and license.</source>
        <translation>Version, méthode et licence.</translation>
    </message>
    <message>
        <source>About Texton Studio</source>
        <translation>À propos de Texton Studio</translation>
    </message>
    <message>
        <source>&lt;b&gt;Texton Studio %1&lt;/b&gt;</source>
        <translation>&lt;b&gt;Texton Studio %1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Endless material from a photo, by the method of Galerne, Leclaire and Moisan (2014, 2017). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>Un matériau sans fin à partir d&apos;une photo, par la méthode de Galerne, Leclaire et Moisan (2014, 2017). Logiciel libre sous la licence publique générale GNU, version 3 ou ultérieure.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ouvrir un fichier &amp;récent</translation>
    </message>
    <message>
        <source>Open a sa&amp;mple</source>
        <translation>Ouvrir un exe&amp;mple</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Channels</source>
        <translation>Ca&amp;naux</translation>
    </message>
    <message>
        <source>S&amp;urround</source>
        <translation>&amp;Fond</translation>
    </message>
    <message>
        <source>&amp;Texton</source>
        <translation>&amp;Texton</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Fe&amp;nêtre</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Vider cette liste</translation>
    </message>
    <message>
        <source>The language changes when you start Texton Studio again.</source>
        <translation>La langue changera au prochain démarrage de Texton Studio.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l&apos;image</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>Images PNG (*.png)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 a été enregistré</translation>
    </message>
    <message>
        <source>&amp;Photo inside the project</source>
        <translation>&amp;Photo dans le projet</translation>
    </message>
    <message>
        <source>On, a project holds the photo itself; off, it only remembers where the photo is.</source>
        <translation>Activé, le projet contient la photo elle-même&#xa0;; sinon, il retient seulement où elle se trouve.</translation>
    </message>
    <message>
        <source>Link the photo</source>
        <translation>Lier la photo</translation>
    </message>
    <message>
        <source>Photo inside the project</source>
        <translation>Photo dans le projet</translation>
    </message>
    <message>
        <source>&amp;Gaussian version: ADSN</source>
        <translation>&amp;Version gaussienne&#xa0;: ADSN</translation>
    </message>
    <message>
        <source>Gaussian version: &amp;RPN</source>
        <translation>Version gaussienne&#xa0;: &amp;RPN</translation>
    </message>
    <message>
        <source>The language of the window, from the next start on.</source>
        <translation>La langue de la fenêtre, dès le prochain démarrage.</translation>
    </message>
    <message>
        <source>Looking for unsaved work</source>
        <translation>Recherche de travail non enregistré</translation>
    </message>
    <message>
        <source>Place and values of the pixel under the mouse.</source>
        <translation>Position et valeurs du pixel sous la souris.</translation>
    </message>
    <message>
        <source>How far the texton is from the photo; see the Texton panel.</source>
        <translation>Écart entre le texton et la photo&#xa0;; voir le panneau Texton.</translation>
    </message>
    <message>
        <source>&amp;Zoom in</source>
        <translation>&amp;Agrandir</translation>
    </message>
    <message>
        <source>Larger, at the mouse.</source>
        <translation>Plus grand, à l&apos;endroit de la souris.</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>&amp;Réduire</translation>
    </message>
    <message>
        <source>Smaller, at the mouse.</source>
        <translation>Plus petit, à l&apos;endroit de la souris.</translation>
    </message>
    <message>
        <source>There is no finished noise to save yet. Please wait a moment, or open a photo.</source>
        <translation>Pas encore de bruit terminé à enregistrer. Veuillez attendre un instant, ou ouvrir une photo.</translation>
    </message>
    <message>
        <source>Saving the picture</source>
        <translation>Enregistrement de l&apos;image</translation>
    </message>
    <message>
        <source>What draws the noise: %1</source>
        <translation>Ce qui dessine le bruit&#xa0;: %1</translation>
    </message>
    <message>
        <source>How the pictures are shown: screen pixels for each pixel of the photo, exposure, channel.</source>
        <translation>Affichage des images&#xa0;: pixels d&apos;écran pour chaque pixel de la photo, exposition, canal.</translation>
    </message>
    <message>
        <source>Zoom %1 %</source>
        <translation>Zoom %1&#xa0;%</translation>
    </message>
    <message>
        <source>exposure %1%2</source>
        <translation>exposition %1%2</translation>
    </message>
    <message>
        <source>channel %1 only</source>
        <translation>canal %1 seul</translation>
    </message>
    <message>
        <source>Stop the export?</source>
        <translation>Arrêter l&apos;export&#xa0;?</translation>
    </message>
    <message>
        <source>An export is still being written.</source>
        <translation>Un export est encore en cours d&apos;écriture.</translation>
    </message>
    <message>
        <source>Stop it and close</source>
        <translation>Arrêter et fermer</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Reset the &amp;exemplar</source>
        <translation>Rétablir l&apos;&amp;exemplaire</translation>
    </message>
    <message>
        <source>Back to the photo as it was opened.</source>
        <translation>Retour à la photo telle qu&apos;elle a été ouverte.</translation>
    </message>
    <message>
        <source>Reset the exemplar</source>
        <translation>Réinitialiser l&apos;exemplaire</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Canaux</translation>
    </message>
    <message>
        <source>Surround</source>
        <translation>Fond</translation>
    </message>
    <message>
        <source>Gray</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Noir</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanc</translation>
    </message>
    <message>
        <source>&amp;Flat</source>
        <translation>À &amp;plat</translation>
    </message>
    <message>
        <source>&amp;Ground</source>
        <translation>&amp;Sol</translation>
    </message>
    <message>
        <source>Mesh, by its &amp;UVs</source>
        <translation>Maillage, par ses &amp;UV</translation>
    </message>
    <message>
        <source>Mesh, any &amp;surface</source>
        <translation>&amp;Maillage, toute surface</translation>
    </message>
    <message>
        <source>What the noise is shown on.</source>
        <translation>Ce sur quoi le bruit est montré.</translation>
    </message>
    <message>
        <source>Noise view</source>
        <translation>Vue du bruit</translation>
    </message>
    <message>
        <source>&amp;Lighting</source>
        <translation>É&amp;clairage</translation>
    </message>
    <message>
        <source>Shade the mesh, or not.</source>
        <translation>Ombrer le maillage, ou non.</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Éclairage</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panneau</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>&amp;Noise</source>
        <translation>&amp;Bruit</translation>
    </message>
    <message>
        <source>Covariance error %1 × the floor</source>
        <translation>Erreur de covariance %1 × le plancher</translation>
    </message>
    <message>
        <source>&amp;Keep to compare</source>
        <translation>Garder &amp;pour comparer</translation>
    </message>
    <message>
        <source>Keep the present texton as A. Change something, then look at both by turns.</source>
        <translation>Garde le texton actuel comme A. Changez quelque chose, puis regardez les deux tour à tour.</translation>
    </message>
    <message>
        <source>Look at the kept texton and its noise, and back at the present one.</source>
        <translation>Montre le texton gardé et son bruit, puis de nouveau l&apos;actuel.</translation>
    </message>
    <message>
        <source>Show &amp;the kept one (A/B)</source>
        <translation>Voir le texton gardé (&amp;A/B)</translation>
    </message>
    <message>
        <source>Kept and present side &amp;by side</source>
        <translation>Gardé &amp;et actuel côte à côte</translation>
    </message>
    <message>
        <source>The noise of the kept texton on the left, that of the present one on the right.</source>
        <translation>Le bruit du texton gardé à gauche, celui de l&apos;actuel à droite.</translation>
    </message>
    <message>
        <source>Mix</source>
        <translation>Mélange</translation>
    </message>
    <message>
        <source>&amp;Mix</source>
        <translation>&amp;Mélange</translation>
    </message>
    <message>
        <source>&amp;Open a second material...</source>
        <translation>&amp;Ouvrir une seconde matière...</translation>
    </message>
    <message>
        <source>Open another photo, to mix it with the first one.</source>
        <translation>Ouvrir une autre photo, à mélanger avec la première.</translation>
    </message>
    <message>
        <source>S&amp;wap A and B</source>
        <translation>&amp;Échanger A et B</translation>
    </message>
    <message>
        <source>Let the two materials change places. The noise stays as it is.</source>
        <translation>Les deux matières changent de place. Le bruit garde son aspect.</translation>
    </message>
    <message>
        <source>&amp;Remove the second material</source>
        <translation>&amp;Retirer la seconde matière</translation>
    </message>
    <message>
        <source>Show the first material alone again.</source>
        <translation>Montrer de nouveau la première matière seule.</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>R&amp;egarder</translation>
    </message>
    <message>
        <source>The mouse paints nothing.</source>
        <translation>La souris ne peint rien.</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinceau</translation>
    </message>
    <message>
        <source>Paint where the second material is, in the noise seen from above.</source>
        <translation>Peindre où se trouve la seconde matière, dans le bruit vu de dessus.</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Adoucir</translation>
    </message>
    <message>
        <source>Soften borders in the map.</source>
        <translation>Adoucir les bords dans la carte.</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>&amp;Gomme</translation>
    </message>
    <message>
        <source>Bring the first material back.</source>
        <translation>Faire revenir la première matière.</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>&amp;Dégradé</translation>
    </message>
    <message>
        <source>Drag a line: one material at its start, the other at its end.</source>
        <translation>Tirer une ligne : une matière à son début, l&apos;autre à sa fin.</translation>
    </message>
    <message>
        <source>Ro&amp;und gradient</source>
        <translation>Dégradé ro&amp;nd</translation>
    </message>
    <message>
        <source>Drag from the middle: one material inside, the other around it.</source>
        <translation>Tirer depuis le milieu : une matière dedans, l&apos;autre autour.</translation>
    </message>
    <message>
        <source>L&amp;arger brush</source>
        <translation>Pin&amp;ceau plus grand</translation>
    </message>
    <message>
        <source>Make the brush a quarter larger.</source>
        <translation>Agrandir le pinceau d&apos;un quart.</translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation>Pincea&amp;u plus petit</translation>
    </message>
    <message>
        <source>Make the brush a quarter smaller.</source>
        <translation>Réduire le pinceau d&apos;un quart.</translation>
    </message>
    <message>
        <source>&amp;Fill the map</source>
        <translation>Re&amp;mplir la carte</translation>
    </message>
    <message>
        <source>All of it becomes what the brush paints.</source>
        <translation>Elle devient partout ce que le pinceau peint.</translation>
    </message>
    <message>
        <source>One strip for each texton, from the first material on the left to the second one on the right.</source>
        <translation>Une bande par texton, de la première matière à gauche à la seconde à droite.</translation>
    </message>
    <message>
        <source>&amp;Invert the map</source>
        <translation>&amp;Inverser la carte</translation>
    </message>
    <message>
        <source>The second material where the first one was.</source>
        <translation>La seconde matière là où était la première.</translation>
    </message>
    <message>
        <source>Re&amp;peat the map</source>
        <translation>Répé&amp;ter la carte</translation>
    </message>
    <message>
        <source>Beyond its border the map comes again, instead of going on as it ends.</source>
        <translation>Au-delà de son bord, la carte recommence au lieu de se prolonger.</translation>
    </message>
    <message>
        <source>S&amp;how the map</source>
        <translation>&amp;Voir la carte</translation>
    </message>
    <message>
        <source>Lay the map over the noise: blue is the first material, amber the second one.</source>
        <translation>Poser la carte sur le bruit : bleu pour la première matière, ambre pour la seconde.</translation>
    </message>
    <message>
        <source>Import a map...</source>
        <translation>Importer une carte...</translation>
    </message>
    <message>
        <source>Take a gray picture as the map: black is the first material, white the second.</source>
        <translation>Prendre une image grise pour carte : noir pour la première matière, blanc pour la seconde.</translation>
    </message>
    <message>
        <source>E&amp;xport the map...</source>
        <translation>E&amp;xporter la carte...</translation>
    </message>
    <message>
        <source>Save the map as a gray picture.</source>
        <translation>Enregistrer la carte comme image grise.</translation>
    </message>
    <message>
        <source>Import a map</source>
        <translation>Importer une carte</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.tga *.bmp *.webp);;All files (*)</source>
        <translation>Images (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.tga *.bmp *.webp);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Export the map</source>
        <translation>Exporter la carte</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.exr)</source>
        <translation>Images (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>S&amp;trips, left to right</source>
        <translation>Bande&amp;s de gauche à droite</translation>
    </message>
    <message>
        <source>Strips, top to bottom</source>
        <translation>Bandes de haut en &amp;bas</translation>
    </message>
    <message>
        <source>One strip for each texton, from the first material at the top to the second one at the bottom.</source>
        <translation>Une bande par texton, de la première matière en haut à la seconde en bas.</translation>
    </message>
    <message>
        <source>Smooth passage</source>
        <translation>Passage doux</translation>
    </message>
    <message>
        <source>From the first material on the left to the second one on the right, slowly at both ends.</source>
        <translation>De la première matière à gauche à la seconde à droite, doucement aux deux bouts.</translation>
    </message>
</context>
<context>
    <name>txn::app::MapPainter</name>
    <message>
        <source>Smooth the map</source>
        <translation>Adoucir la carte</translation>
    </message>
    <message>
        <source>Erase in the map</source>
        <translation>Gommer dans la carte</translation>
    </message>
    <message>
        <source>Gradient in the map</source>
        <translation>Dégradé dans la carte</translation>
    </message>
    <message>
        <source>Paint in the map</source>
        <translation>Peindre dans la carte</translation>
    </message>
</context>
<context>
    <name>txn::app::MessageBar</name>
    <message>
        <source>Dismiss the message</source>
        <translation>Fermer le message</translation>
    </message>
    <message>
        <source>Dismiss the message.</source>
        <translation>Fermer le message.</translation>
    </message>
</context>
<context>
    <name>txn::app::MixEditor</name>
    <message>
        <source>Swap A and B</source>
        <translation>Échanger A et B</translation>
    </message>
    <message>
        <source>Remove B</source>
        <translation>Retirer B</translation>
    </message>
    <message>
        <source>Fill the map</source>
        <translation>Remplir la carte</translation>
    </message>
    <message>
        <source>Strips from A to B</source>
        <translation>Bandes de A à B</translation>
    </message>
    <message>
        <source>Invert the map</source>
        <translation>Inverser la carte</translation>
    </message>
    <message>
        <source>Repeat the map</source>
        <translation>Répéter la carte</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message>
        <source>Import the map</source>
        <translation>Importer la carte</translation>
    </message>
    <message>
        <source>Saving the map</source>
        <translation>Enregistrement de la carte</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <source>Smooth passage from A to B</source>
        <translation>Passage doux de A à B</translation>
    </message>
</context>
<context>
    <name>txn::app::MixPanel</name>
    <message>
        <source>Drop a photo</source>
        <translation>Déposez une photo</translation>
    </message>
    <message>
        <source>The first material. Click to open another one, or drop a photo here.</source>
        <translation>La première matière. Cliquez pour en ouvrir une autre, ou déposez une photo ici.</translation>
    </message>
    <message>
        <source>Drop a second photo</source>
        <translation>Déposez une seconde photo</translation>
    </message>
    <message>
        <source>The second material, to be mixed with the first. Click to open one, or drop a photo here.</source>
        <translation>La seconde matière, à mélanger avec la première. Cliquez pour en ouvrir une, ou déposez une photo ici.</translation>
    </message>
    <message>
        <source>Let A and B change places.</source>
        <translation>Échanger A et B.</translation>
    </message>
    <message>
        <source>Take the second material away and show the first one alone.</source>
        <translation>Retirer la seconde matière et montrer la première seule.</translation>
    </message>
    <message>
        <source>Textons from A to B</source>
        <translation>Textons de A à B</translation>
    </message>
    <message>
        <source>The textons from A to B, each with a piece of its noise. Click one to see it alone and to paint with it; click it again to see the mixture.</source>
        <translation>Les textons de A à B, chacun avec un morceau de son bruit. Cliquez-en un pour le voir seul et peindre avec lui ; cliquez encore pour voir le mélange.</translation>
    </message>
    <message>
        <source>Textons</source>
        <translation>Textons</translation>
    </message>
    <message>
        <source>How many textons lie between A and B. More make the passage finer. Try 21.</source>
        <translation>Combien de textons mènent de A à B. Plus il y en a, plus le passage est fin. Essayez 21.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Regarder</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Adoucir</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Gomme</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Dégradé</translation>
    </message>
    <message>
        <source>Round gradient</source>
        <translation>Dégradé rond</translation>
    </message>
    <message>
        <source>What the mouse does in the noise seen from above. Brush paints B, or any mixture; the eraser brings A back. Shift draws straight lines.</source>
        <translation>Ce que fait la souris dans le bruit vu de dessus. Le pinceau peint B, ou tout mélange ; la gomme fait revenir A. Maj trace des lignes droites.</translation>
    </message>
    <message>
        <source>Paint with</source>
        <translation>Peindre avec</translation>
    </message>
    <message>
        <source>What the brush paints: 0 is A, 1 is B, anything else lies between.</source>
        <translation>Ce que peint le pinceau : 0 pour A, 1 pour B, le reste entre les deux.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>How large the brush is. The keys [ and ] change it, too.</source>
        <translation>La taille du pinceau. Les touches [ et ] la changent aussi.</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Dureté</translation>
    </message>
    <message>
        <source>How sharp the rim of the brush is. Low passes softly from A to B.</source>
        <translation>La netteté du bord du pinceau. Faible, elle passe doucement de A à B.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>How far one stroke goes towards what it paints.</source>
        <translation>Jusqu&apos;où va un trait vers ce qu&apos;il peint.</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Left and right</source>
        <translation>Gauche et droite</translation>
    </message>
    <message>
        <source>Up and down</source>
        <translation>Haut et bas</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Strokes are mirrored about the middle of the map.</source>
        <translation>Les traits sont reflétés autour du milieu de la carte.</translation>
    </message>
    <message>
        <source>A texton from a file cannot be mixed. Open a photo instead.</source>
        <translation>Un texton venant d&apos;un fichier ne peut être mélangé. Ouvrez plutôt une photo.</translation>
    </message>
    <message>
        <source>Open a photo, then a second one to mix it with.</source>
        <translation>Ouvrez une photo, puis une seconde à lui mélanger.</translation>
    </message>
    <message>
        <source>Drop a second material onto B, then paint where it is.</source>
        <translation>Déposez une seconde matière sur B, puis peignez où elle se trouve.</translation>
    </message>
    <message>
        <source>Computing the textons from A to B...</source>
        <translation>Calcul des textons de A à B...</translation>
    </message>
    <message>
        <source>Textons so far: %1</source>
        <translation>Textons jusqu&apos;ici : %1</translation>
    </message>
    <message>
        <source>Distance from A to B: %1</source>
        <translation>Distance de A à B : %1</translation>
    </message>
    <message>
        <source>The textons from A to B are not up to date. Compute again with F5.</source>
        <translation>Les textons de A à B ne sont pas à jour. Recalculez avec F5.</translation>
    </message>
</context>
<context>
    <name>txn::app::NoisePanel</name>
    <message>
        <source>Impacts per pixel</source>
        <translation>Impacts par pixel</translation>
    </message>
    <message>
        <source>How many textons overlap at a pixel, on average (the MNI). Fewer is faster; too few show single textons. Try 12.</source>
        <translation>Le nombre moyen de textons superposés en un pixel (le MNI). Moins, c&apos;est plus rapide&#xa0;; trop peu laisse voir des textons isolés. Essayer 12.</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>Placement</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Régulier</translation>
    </message>
    <message>
        <source>Random, both signs</source>
        <translation>Aléatoire, deux signes</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Aléatoire</translation>
    </message>
    <message>
        <source>How textons are scattered. Even (stratified) needs the fewest; random (Poisson) is the papers&apos; way and needs about 30 impacts.</source>
        <translation>La façon de disperser les textons. Régulier (stratifié) en demande le moins&#xa0;; aléatoire (Poisson) est la méthode des articles et demande environ 30 impacts.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Another number gives another piece of the same material.</source>
        <translation>Un autre nombre donne un autre morceau du même matériau.</translation>
    </message>
    <message>
        <source>Noise seed</source>
        <translation>Graine du bruit</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>À plat</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Mesh, by its UVs</source>
        <translation>Maillage, par ses UV</translation>
    </message>
    <message>
        <source>Mesh, any surface</source>
        <translation>Maillage, toute surface</translation>
    </message>
    <message>
        <source>What the noise is shown on. Drag in the view to look around. Any surface needs no texture coordinates.</source>
        <translation>Ce sur quoi le bruit est montré. Glisser dans la vue pour regarder autour. Toute surface se passe de coordonnées de texture.</translation>
    </message>
    <message>
        <source>Noise view</source>
        <translation>Vue du bruit</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Tore</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>From a file...</source>
        <translation>Depuis un fichier...</translation>
    </message>
    <message>
        <source>The object that wears the noise. OBJ and PLY files can be opened.</source>
        <translation>L&apos;objet qui porte le bruit. On peut ouvrir des fichiers OBJ et PLY.</translation>
    </message>
    <message>
        <source>Lighting</source>
        <translation>Éclairage</translation>
    </message>
    <message>
        <source>Shades the mesh. Switch it off to judge colors.</source>
        <translation>Ombre le maillage. À désactiver pour juger les couleurs.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Isotropic</source>
        <translation>Isotrope</translation>
    </message>
    <message>
        <source>Anisotropic</source>
        <translation>Anisotrope</translation>
    </message>
    <message>
        <source>Of the graphics card</source>
        <translation>Carte graphique</translation>
    </message>
    <message>
        <source>Keeps distant noise from flickering. Anisotropic is the sharpest at a slant.</source>
        <translation>Empêche le bruit lointain de scintiller. Anisotrope est le plus net en vue rasante.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>How large the grain is, next to that of the photo.</source>
        <translation>La taille du grain, par rapport à celui de la photo.</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Contraste</translation>
    </message>
    <message>
        <source>Strengthens or softens the grain. Less of it clips fewer colors.</source>
        <translation>Renforce ou adoucit le grain. Moins il y en a, moins de couleurs sont écrêtées.</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Luminosité</translation>
    </message>
    <message>
        <source>Makes the whole material lighter or darker.</source>
        <translation>Rend tout le matériau plus clair ou plus sombre.</translation>
    </message>
    <message>
        <source>What the picture costs: the time to draw one, and how often the texton is looked up for each pixel.</source>
        <translation>Ce que coûte l&apos;image&#xa0;: le temps pour en dessiner une, et le nombre de lectures du texton par pixel.</translation>
    </message>
    <message>
        <source>Values that are darker than black or lighter than white. Lower the contrast, or export EXR, which keeps them.</source>
        <translation>Valeurs plus sombres que le noir ou plus claires que le blanc. Baisser le contraste, ou exporter en EXR, qui les garde.</translation>
    </message>
    <message>
        <source>Save picture...</source>
        <translation>Enregistrer l&apos;image...</translation>
    </message>
    <message>
        <source>Saves what the noise view shows as a PNG file.</source>
        <translation>Enregistre ce que montre la vue du bruit dans un fichier PNG.</translation>
    </message>
    <message>
        <source>Open a mesh</source>
        <translation>Ouvrir un maillage</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.ply);;All files (*)</source>
        <translation>Maillages (*.obj *.ply);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1 frames per second, %2 fetches per pixel</source>
        <translation>%1 images par seconde, %2 lectures par pixel</translation>
    </message>
    <message>
        <source>%1 % of the values are clipped</source>
        <translation>%1&#xa0;% des valeurs sont écrêtées</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>All maps of the material together under a light, or one of them.</source>
        <translation>Toutes les cartes du matériau ensemble sous une lumière, ou l&apos;une d&apos;elles.</translation>
    </message>
    <message>
        <source>Shown map</source>
        <translation>Carte montrée</translation>
    </message>
    <message>
        <source>Light from</source>
        <translation>Lumière depuis</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 is the right, 90 the top. Or drag with the right button in the view.</source>
        <translation>D&apos;où vient la lumière : 0 est la droite, 90 le haut. Ou glissez avec le bouton droit dans la vue.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lumière</translation>
    </message>
    <message>
        <source>Light height</source>
        <translation>Hauteur lumière</translation>
    </message>
    <message>
        <source>How high the light stands. Low light shows the relief, high light the colors.</source>
        <translation>La hauteur de la lumière. Rasante, elle montre le relief ; haute, les couleurs.</translation>
    </message>
</context>
<context>
    <name>txn::app::PictureView</name>
    <message>
        <source>%1 fps</source>
        <translation>%1&#xa0;i/s</translation>
    </message>
    <message>
        <source>Drop a photo here</source>
        <translation>Déposer une photo ici</translation>
    </message>
    <message>
        <source>A texton from a file has no exemplar</source>
        <translation>Un texton venu d&apos;un fichier n&apos;a pas d&apos;exemplaire</translation>
    </message>
    <message>
        <source>A texton from a file has no Gaussian version</source>
        <translation>Un texton venu d&apos;un fichier n&apos;a pas de version gaussienne</translation>
    </message>
    <message>
        <source>Gaussian method</source>
        <translation>Méthode gaussienne</translation>
    </message>
    <message>
        <source>Gaussian seed</source>
        <translation>Graine gaussienne</translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation>%1&#xa0;×&#xa0;%2&#xa0;px</translation>
    </message>
    <message>
        <source>A picture. The wheel zooms where the mouse is, the middle button or Space moves it, F shows it whole. Hold ` to see the exemplar instead. The right button moves the light of a material.</source>
        <translation>Une image. La molette agrandit sous la souris, le bouton du milieu ou Espace la déplace, F la montre entière. Maintenez ` pour voir l&apos;exemplaire à la place. Le bouton droit déplace la lumière d&apos;un matériau.</translation>
    </message>
    <message>
        <source>A (kept)</source>
        <translation>A (gardé)</translation>
    </message>
    <message>
        <source>B (present)</source>
        <translation>B (actuel)</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lumière</translation>
    </message>
</context>
<context>
    <name>txn::app::Pipeline</name>
    <message>
        <source>Preparing the exemplar</source>
        <translation>Préparation de l&apos;exemplaire</translation>
    </message>
    <message>
        <source>Making the Gaussian version</source>
        <translation>Création de la version gaussienne</translation>
    </message>
    <message>
        <source>Computing the texton</source>
        <translation>Calcul du texton</translation>
    </message>
    <message>
        <source>Judging the exemplar</source>
        <translation>Évaluation de l&apos;exemplaire</translation>
    </message>
    <message>
        <source>Measuring spectra</source>
        <translation>Mesure des spectres</translation>
    </message>
    <message>
        <source>Loading the mesh</source>
        <translation>Chargement du maillage</translation>
    </message>
    <message>
        <source>Preparing the second exemplar</source>
        <translation>Préparation du second exemplaire</translation>
    </message>
    <message>
        <source>Computing the textons from A to B</source>
        <translation>Calcul des textons de A à B</translation>
    </message>
</context>
<context>
    <name>txn::app::ProjectDocument</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
</context>
<context>
    <name>txn::app::RecoveryDialog</name>
    <message>
        <source>Recover your work</source>
        <translation>Récupérer le travail</translation>
    </message>
    <message>
        <source>Texton Studio was not closed properly last time. This can come back:</source>
        <translation>Texton Studio n&apos;a pas été fermé correctement la dernière fois. Ceci peut être récupéré&#xa0;:</translation>
    </message>
    <message>
        <source>Work that can come back</source>
        <translation>Travaux récupérables</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Delete this copy</source>
        <translation>Supprimer cette copie</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Plus tard</translation>
    </message>
    <message>
        <source>Keeps the copies and asks again next time.</source>
        <translation>Garde les copies et redemande la prochaine fois.</translation>
    </message>
    <message>
        <source>The newest is at the top.</source>
        <translation>Le plus récent est en haut.</translation>
    </message>
    <message>
        <source>Opens this work again. Save it then; the original file is untouched.</source>
        <translation>Rouvre ce travail. L&apos;enregistrer ensuite&#xa0;; le fichier d&apos;origine reste intact.</translation>
    </message>
    <message>
        <source>Gives this work up for good.</source>
        <translation>Abandonne ce travail pour de bon.</translation>
    </message>
</context>
<context>
    <name>txn::app::SeedField</name>
    <message>
        <source>Roll the dice</source>
        <translation>Lancer les dés</translation>
    </message>
    <message>
        <source>Another random result.</source>
        <translation>Un autre résultat aléatoire.</translation>
    </message>
    <message>
        <source>Keep this seed</source>
        <translation>Garder cette graine</translation>
    </message>
    <message>
        <source>Keeps this number when new seeds are rolled.</source>
        <translation>Garde ce nombre quand de nouvelles graines sont tirées.</translation>
    </message>
</context>
<context>
    <name>txn::app::ShortcutEditor</name>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation>Rechercher une commande</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>Press the keys that you want for the chosen command.</source>
        <translation>Appuyer sur les touches voulues pour la commande choisie.</translation>
    </message>
    <message>
        <source>No keys</source>
        <translation>Aucune touche</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Tout réinitialiser</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>These keys were those of &quot;%1&quot;, which has none now.</source>
        <translation>Ces touches étaient celles de «&#xa0;%1&#xa0;», qui n&apos;en a plus.</translation>
    </message>
    <message>
        <source>Type a part of a command&apos;s name.</source>
        <translation>Taper une partie du nom d&apos;une commande.</translation>
    </message>
    <message>
        <source>Choose a command to give it other keys.</source>
        <translation>Choisir une commande pour lui donner d&apos;autres touches.</translation>
    </message>
    <message>
        <source>Takes the chosen command&apos;s keys away.</source>
        <translation>Retire les touches de la commande choisie.</translation>
    </message>
    <message>
        <source>Back to the keys that the program came with.</source>
        <translation>Retour aux touches d&apos;origine.</translation>
    </message>
    <message>
        <source>Closes this window. Changes are kept already.</source>
        <translation>Ferme cette fenêtre. Les changements sont déjà retenus.</translation>
    </message>
</context>
<context>
    <name>txn::app::SpectrumPanel</name>
    <message>
        <source>Exemplar</source>
        <translation>Exemplaire</translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation>Version gaussienne</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Bruit</translation>
    </message>
    <message>
        <source>Power spectrum</source>
        <translation>Spectre de puissance</translation>
    </message>
    <message>
        <source>How strong waves of each direction and length are: long ones in the middle, fine grain outside. The three should look alike.</source>
        <translation>La force des ondes de chaque direction et longueur&#xa0;: les longues au milieu, le grain fin à l&apos;extérieur. Les trois devraient se ressembler.</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Autocorrélation</translation>
    </message>
    <message>
        <source>How alike two points are at each distance and direction. The size of the bright patch is that of the grain; it should fit into the support.</source>
        <translation>La ressemblance de deux points à chaque distance et direction. La tache claire a la taille du grain&#xa0;; elle devrait tenir dans le support.</translation>
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
        <translation>Aussi proche que deux photos de ce matériau</translation>
    </message>
    <message>
        <source>Long grain is lost. Try a larger support</source>
        <translation>Le grain long se perd. Essayer un support plus grand</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>Encore&#xa0;%n&#xa0;s</numerusform>
            <numerusform>Encore&#xa0;%n&#xa0;s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n min left</source>
        <translation>
            <numerusform>Encore&#xa0;%n&#xa0;min</numerusform>
            <numerusform>Encore&#xa0;%n&#xa0;min</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress of the texton</source>
        <translation>Avancement du texton</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stop computing and go back to the last finished texton. Change anything to start again.</source>
        <translation>Arrêter le calcul et revenir au dernier texton terminé. Tout changement le relance.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Carré</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Disque</translation>
    </message>
    <message>
        <source>The outline of the texton. A square suits almost everything; a rectangle follows long grain.</source>
        <translation>Le contour du texton. Un carré convient à presque tout&#xa0;; un rectangle suit un grain long.</translation>
    </message>
    <message>
        <source>Texton shape</source>
        <translation>Forme du texton</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Support</translation>
    </message>
    <message>
        <source>How large the texton is. Features longer than this get lost; larger takes longer to compute. Try 64 first, 128 for long grain.</source>
        <translation>La taille du texton. Les motifs plus longs se perdent&#xa0;; plus grand, il est plus long à calculer. Essayer d&apos;abord 64, ou 128 pour un grain long.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>The height of a rectangular texton. Make it small where the grain runs from left to right.</source>
        <translation>La hauteur d&apos;un texton rectangulaire. Petite là où le grain va de gauche à droite.</translation>
    </message>
    <message>
        <source>Support height</source>
        <translation>Hauteur du support</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Plus proche</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linéaire</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Cubique</translation>
    </message>
    <message>
        <source>Quintic</source>
        <translation>Quintique</translation>
    </message>
    <message>
        <source>How values between the texton&apos;s pixels are found. Linear is what graphics cards do for free; cubic is smoother when magnified.</source>
        <translation>La façon de trouver les valeurs entre les pixels du texton. Linéaire ne coûte rien aux cartes graphiques&#xa0;; cubique est plus lisse en agrandissement.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>How long the texton is refined. Watch the curve: where it runs flat, more brings nothing.</source>
        <translation>La durée de l&apos;affinage du texton. Suivre la courbe&#xa0;: là où elle devient plate, continuer n&apos;apporte rien.</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Inertie</translation>
    </message>
    <message>
        <source>Gets there in fewer iterations. 0.9 is good; 0 is the plain method of the papers.</source>
        <translation>Arrive au but en moins d&apos;itérations. 0,9 convient&#xa0;; 0 est la méthode simple des articles.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Graine</translation>
    </message>
    <message>
        <source>Another number gives another, equally good texton. Roll the dice, or lock the one you like.</source>
        <translation>Un autre nombre donne un autre texton, tout aussi bon. Lancer les dés, ou verrouiller celui qui plaît.</translation>
    </message>
    <message>
        <source>Texton seed</source>
        <translation>Graine du texton</translation>
    </message>
    <message>
        <source>Lock the texton seed</source>
        <translation>Verrouiller la graine du texton</translation>
    </message>
    <message>
        <source>Unlock the texton seed</source>
        <translation>Déverrouiller la graine du texton</translation>
    </message>
    <message>
        <source>Exact colors</source>
        <translation>Couleurs exactes</translation>
    </message>
    <message>
        <source>Corrects the texton so that the noise has exactly the colors of the photo. Leave it on unless you compare with the papers.</source>
        <translation>Corrige le texton pour que le bruit ait exactement les couleurs de la photo. À laisser activé, sauf pour comparer avec les articles.</translation>
    </message>
    <message>
        <source>Open a photo to compute its texton</source>
        <translation>Ouvrir une photo pour calculer son texton</translation>
    </message>
    <message>
        <source>A texton from a file</source>
        <translation>Un texton venu d&apos;un fichier</translation>
    </message>
    <message>
        <source>%1 x %2 px</source>
        <translation>%1&#xa0;×&#xa0;%2&#xa0;px</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Calcul en cours</translation>
    </message>
    <message>
        <source>Compute again</source>
        <translation>Recalculer</translation>
    </message>
    <message>
        <source>As close as this method gets</source>
        <translation>Aussi proche que la méthode le permet</translation>
    </message>
    <message>
        <source>Choosing the number of kernels</source>
        <translation>Choix du nombre de noyaux</translation>
    </message>
    <message>
        <source>Getting closer</source>
        <translation>De plus en plus proche</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Close. A larger support or another seed may help</source>
        <translation>Proche. Un support plus grand ou une autre graine peut aider</translation>
    </message>
    <message>
        <source>Fair. The material has more order than noise can keep</source>
        <translation>Correct. Le matériau a plus d&apos;ordre qu&apos;un bruit ne peut en garder</translation>
    </message>
    <message>
        <source>Covariance error %1 × the floor (%2)</source>
        <translation>Erreur de covariance %1 × le plancher (%2)</translation>
    </message>
    <message>
        <source>Relative model error %1</source>
        <translation>Erreur relative du modèle %1</translation>
    </message>
    <message>
        <source>Error %1 after %2 iterations</source>
        <translation>Erreur %1 après %2 itérations</translation>
    </message>
    <message>
        <source>How far the noise&apos;s correlations are from the photo&apos;s. At 1 × the floor they are as close as one half of the photo is to all of it. The relative model error stays near 0.46 even for a perfect texton, because it compares with one photo, in which every wave&apos;s strength is random.</source>
        <translation>L&apos;écart entre les corrélations du bruit et celles de la photo. À 1 × le plancher, elles sont aussi proches qu&apos;une moitié de la photo l&apos;est du tout. L&apos;erreur relative du modèle reste près de 0,46 même pour un texton parfait, car elle compare avec une seule photo, où la force de chaque onde est due au hasard.</translation>
    </message>
    <message>
        <source>Use the suggested support</source>
        <translation>Utiliser le support suggéré</translation>
    </message>
    <message>
        <source>Suggested support</source>
        <translation>Support suggéré</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Best fit</source>
        <translation>Meilleur ajustement</translation>
    </message>
    <message>
        <source>Papers&apos; projections</source>
        <translation>Projections (articles)</translation>
    </message>
    <message>
        <source>How the texton is found. Best fit comes closest for the same cost; the projections are the papers&apos; own way, to compare with.</source>
        <translation>Comment le texton est trouvé. Le meilleur ajustement est le plus proche pour le même coût ; les projections sont la méthode des articles, pour comparer.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Kernels</source>
        <translation>Noyaux</translation>
    </message>
    <message>
        <source>Each impact picks one of so many small pictures. More follow colors and maps that vary independently, at the same speed. Automatic tries them on one half of the photo.</source>
        <translation>Chaque impact choisit une image parmi tant de petites. Davantage suivent des couleurs et des cartes qui varient indépendamment, à la même vitesse. Automatique les essaie sur une moitié de la photo.</translation>
    </message>
    <message>
        <source>What was tried on one half of the photo: the error on the other half, and the memory on a graphics card. The fewest within 5 % of the best are taken.</source>
        <translation>Ce qui a été essayé sur une moitié de la photo : l&apos;erreur sur l&apos;autre moitié et la mémoire sur une carte graphique. Le plus petit nombre à moins de 5 % du meilleur est pris.</translation>
    </message>
    <message>
        <source>Suggested: %1 px</source>
        <translation>Suggéré : %1 px</translation>
    </message>
    <message>
        <source>Suggested: none</source>
        <translation>Suggéré : aucun</translation>
    </message>
    <message>
        <source>As large as the grain of this material needs. A texton of that size leaves out %1 % of the correlation.</source>
        <translation>Aussi grand que le grain de ce matériau le demande. Un texton de cette taille laisse de côté %1 % de la corrélation.</translation>
    </message>
    <message>
        <source>The photo is too small to tell how large its grain is.</source>
        <translation>La photo est trop petite pour dire la taille de son grain.</translation>
    </message>
    <message>
        <source>Error against iterations</source>
        <translation>Erreur selon les itérations</translation>
    </message>
    <message>
        <source>The error while the texton is refined. Lower is closer.</source>
        <translation>L&apos;erreur pendant que le texton s&apos;affine. Plus bas, plus proche.</translation>
    </message>
    <message>
        <source>Kernels: %1, error %2, %3 KB</source>
        <translation>Noyaux : %1, erreur %2, %3 Ko</translation>
    </message>
</context>
<context>
    <name>txn::app::ViewTitle</name>
    <message>
        <source>Exemplar</source>
        <translation>Exemplaire</translation>
    </message>
    <message>
        <source>Gaussian version</source>
        <translation>Version gaussienne</translation>
    </message>
    <message>
        <source>Texton</source>
        <translation>Texton</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Bruit</translation>
    </message>
    <message>
        <source>Picture in this view</source>
        <translation>Image de cette vue</translation>
    </message>
    <message>
        <source>Picture right of the border</source>
        <translation>Image à droite de la limite</translation>
    </message>
    <message>
        <source>What this view shows.</source>
        <translation>Ce que montre cette vue.</translation>
    </message>
    <message>
        <source>What is shown right of the border that you can drag.</source>
        <translation>Ce qui est montré à droite de la limite que l&apos;on fait glisser.</translation>
    </message>
    <message>
        <source>Method of the Gaussian version</source>
        <translation>Méthode de la version gaussienne</translation>
    </message>
    <message>
        <source>ADSN: random phases and strengths, what texton noise comes to. RPN: random phases only, keeps the exact spectrum of the photo.</source>
        <translation>ADSN&#xa0;: phases et amplitudes aléatoires, ce vers quoi tend le bruit de textons. RPN&#xa0;: phases aléatoires seulement, garde le spectre exact de la photo.</translation>
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
        <translation>Une autre version gaussienne</translation>
    </message>
    <message>
        <source>Roll the dice for another Gaussian version.</source>
        <translation>Lancer les dés pour une autre version gaussienne.</translation>
    </message>
    <message>
        <source>This is still an older result; the new one is being computed.</source>
        <translation>C&apos;est encore un résultat périmé&#xa0;; le nouveau est en cours de calcul.</translation>
    </message>
    <message>
        <source>Older result</source>
        <translation>Résultat périmé</translation>
    </message>
</context>
</TS>
