<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es">
<context>
    <name>QComboBox</name>
    <message>
        <source>new %1</source>
        <translation>nuevo %1</translation>
    </message>
</context>
<context>
    <name>QDialog</name>
    <message>
        <source>3D view</source>
        <translation>Vista 3D</translation>
    </message>
    <message>
        <source>Actions and keyboard shortcuts</source>
        <translation>Acciones y atajos de teclado</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search actions and shortcuts</source>
        <translation>Buscar acciones y atajos</translation>
    </message>
    <message>
        <source>Show only actions whose key, name or description has these words or a synonym</source>
        <translation>Muestra solo las acciones cuya tecla, nombre o descripción contenga estas palabras o un sinónimo</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Atajos</translation>
    </message>
    <message>
        <source>Keys and their actions; Return or a double click runs one</source>
        <translation>Teclas y sus acciones; Intro o un doble clic ejecuta una</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <source>Select a face; with Shift add it, with Ctrl remove it</source>
        <translation>Selecciona una cara; con Mayúsculas la añade, con Ctrl la quita</translation>
    </message>
    <message>
        <source>Drag from a face</source>
        <translation>Arrastrar desde una cara</translation>
    </message>
    <message>
        <source>Select the faces in a box, with Alt in a lasso</source>
        <translation>Selecciona las caras de un recuadro, con Alt las de un lazo</translation>
    </message>
    <message>
        <source>Alt + click</source>
        <translation>Alt + clic</translation>
    </message>
    <message>
        <source>Select the face loop through the nearest edge; with Ctrl the loop that crosses it</source>
        <translation>Selecciona el bucle de caras por la arista más cercana; con Ctrl el que lo cruza</translation>
    </message>
    <message>
        <source>[ and ], Shift + wheel</source>
        <translation>[ y ], Mayúsculas + rueda</translation>
    </message>
    <message>
        <source>Change the radius of the brush</source>
        <translation>Cambia el radio de la brocha</translation>
    </message>
    <message>
        <source>Drag from the background, or middle button</source>
        <translation>Arrastrar desde el fondo, o botón central</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Orbita</translation>
    </message>
    <message>
        <source>Shift + middle button</source>
        <translation>Mayúsculas + botón central</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Desplaza</translation>
    </message>
    <message>
        <source>Wheel, + and -</source>
        <translation>Rueda, + y -</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Acerca y aleja</translation>
    </message>
    <message>
        <source>Right button, with W A S D Q E</source>
        <translation>Botón derecho, con W A S D Q E</translation>
    </message>
    <message>
        <source>Look around and fly</source>
        <translation>Mira alrededor y vuela</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doble clic</translation>
    </message>
    <message>
        <source>Set the orbit centre</source>
        <translation>Fija el centro de la órbita</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Flechas</translation>
    </message>
    <message>
        <source>Orbit; with Shift pan</source>
        <translation>Orbitan; con Mayúsculas desplazan</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
    <message>
        <source>Select or deselect the face in the middle</source>
        <translation>Selecciona o deselecciona la cara del centro</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Escape</translation>
    </message>
    <message>
        <source>Cancel a gesture</source>
        <translation>Cancela un gesto</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>above %1</source>
        <translation>mayor que %1</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 o más</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>entre %1 y %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>path</source>
        <translation>ruta</translation>
    </message>
    <message>
        <source>path without .%1</source>
        <translation>ruta sin .%1</translation>
    </message>
    <message>
        <source>path: %1</source>
        <translation>ruta: %1</translation>
    </message>
    <message>
        <source>HOST:PORT, or none</source>
        <translation>HOST:PUERTO, o nada</translation>
    </message>
    <message>
        <source>a name, or none</source>
        <translation>un nombre, o nada</translation>
    </message>
    <message>
        <source>see the Camera dock</source>
        <translation>véase el panel Cámaras</translation>
    </message>
    <message>
        <source>two whole numbers, 1 to 65535</source>
        <translation>dos números enteros, de 1 a 65535</translation>
    </message>
    <message>
        <source>three numbers, 0 or more</source>
        <translation>tres números, 0 o más</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>tres números</translation>
    </message>
    <message>
        <source>one of the list</source>
        <translation>uno de la lista</translation>
    </message>
    <message>
        <source>any of these</source>
        <translation>cualquiera de estos</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>verdadero o falso</translation>
    </message>
    <message>
        <source>two whole numbers, %1, the second at most the first</source>
        <translation>dos números enteros, %1, el segundo como máximo igual al primero</translation>
    </message>
    <message>
        <source>two whole numbers, %1</source>
        <translation>dos números enteros, %1</translation>
    </message>
    <message>
        <source>%1
Values: %2. Default: %3.</source>
        <translation>%1
Valores: %2. Por defecto: %3.</translation>
    </message>
    <message>
        <source>Options (*.op);;All files (*)</source>
        <translation>Opciones (*.op);;Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>ShortcutKeys</name>
    <message>
        <source>en</source>
        <comment>code of the language of the texts</comment>
        <translation>es</translation>
    </message>
</context>
<context>
    <name>editor</name>
    <message>
        <source>The faces belong to a mesh light, which has a radiance and does not reflect.</source>
        <translation>Las caras son de una malla emisora, que tiene radiancia y no refleja.</translation>
    </message>
</context>
<context>
    <name>editor::BakeController</name>
    <message>
        <source>Bake irradiance</source>
        <translation>Precalcular la irradiancia</translation>
    </message>
    <message>
        <source>Stop and keep the irradiance computed so far</source>
        <translation>Detiene el cálculo y conserva la irradiancia calculada hasta ahora</translation>
    </message>
    <message>
        <source>The baked irradiance was discarded: all its meshes were edited meanwhile</source>
        <translation>La irradiancia precalculada se ha descartado: todas sus mallas se editaron entretanto</translation>
    </message>
    <message>
        <source>Irradiance baked. Save the scene as IGRF to keep it.</source>
        <translation>Irradiancia precalculada. Guarde la escena como IGRF para conservarla.</translation>
    </message>
    <message numerus="yes">
        <source>%n mesh(es) were edited meanwhile and keep their old irradiance.</source>
        <translation>
            <numerusform>%n malla se editó entretanto y conserva su irradiancia anterior.</numerusform>
            <numerusform>%n mallas se editaron entretanto y conservan su irradiancia anterior.</numerusform>
        </translation>
    </message>
    <message>
        <source>Files that are included several times receive different light at each place, and are part of the scene now.</source>
        <translation>Los archivos incluidos varias veces reciben una luz distinta en cada lugar, y ahora forman parte de la escena.</translation>
    </message>
</context>
<context>
    <name>editor::BrdfAssignment</name>
    <message>
        <source>Assign %1</source>
        <translation>Asignar %1</translation>
    </message>
</context>
<context>
    <name>editor::BrdfController</name>
    <message>
        <source>Edit the BRDF</source>
        <translation>Editar la BRDF</translation>
    </message>
    <message>
        <source>No faces are selected to apply the BRDF to.</source>
        <translation>No hay caras seleccionadas a las que aplicar la BRDF.</translation>
    </message>
    <message>
        <source>Apply the BRDF</source>
        <translation>Aplicar la BRDF</translation>
    </message>
    <message>
        <source>Assign %1</source>
        <translation>Asignar %1</translation>
    </message>
</context>
<context>
    <name>editor::BrdfDrawing</name>
    <message>
        <source>The environment map is larger than the graphics driver&apos;s textures, of %1 pixels: the object is shaded on the CPU, more slowly</source>
        <translation>El mapa de entorno es mayor que las texturas del controlador gráfico, de %1 píxeles: el objeto se sombrea en la CPU, más despacio</translation>
    </message>
    <message>
        <source>The graphics driver cannot compile the shader of BRDF %1: it is shaded on the CPU, more slowly: %2</source>
        <translation>El controlador gráfico no puede compilar el shader de la BRDF %1: se sombrea en la CPU, más despacio: %2</translation>
    </message>
</context>
<context>
    <name>editor::BrdfEditor</name>
    <message>
        <source>Sphere</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>The BRDF on a sphere</source>
        <translation>La BRDF sobre una esfera</translation>
    </message>
    <message>
        <source>Lobe</source>
        <translation>Lóbulo</translation>
    </message>
    <message>
        <source>The lobe in three dimensions</source>
        <translation>El lóbulo en tres dimensiones</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficas</translation>
    </message>
    <message>
        <source>Plots in the plane of incidence, and albedo</source>
        <translation>Gráficas en el plano de incidencia, y albedo</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Biblioteca</translation>
    </message>
    <message>
        <source>Presets, BRDFs of the scene, and your own library</source>
        <translation>Ejemplos, BRDF de la escena, y su propia biblioteca</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposición</translation>
    </message>
    <message>
        <source>Exposure of the sphere in stops</source>
        <translation>Exposición de la esfera en pasos</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>View angle from the normal, in degrees</source>
        <translation>Ángulo de la vista con la normal, en grados</translation>
    </message>
    <message>
        <source>Multiply by the cosine of the light direction</source>
        <translation>Multiplica por el coseno de la dirección de la luz</translation>
    </message>
    <message>
        <source>Times cosine</source>
        <translation>Por el coseno</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>Logarithmic radius over five decades</source>
        <translation>Radio logarítmico sobre cinco décadas</translation>
    </message>
    <message>
        <source>Logarithmic radius</source>
        <translation>Radio logarítmico</translation>
    </message>
    <message>
        <source>Select faces to see their BRDF.</source>
        <translation>Seleccione caras para ver su BRDF.</translation>
    </message>
    <message>
        <source>Cannot show this BRDF:</source>
        <translation>No se puede mostrar esta BRDF:</translation>
    </message>
    <message>
        <source>Light of the sphere</source>
        <translation>Luz de la esfera</translation>
    </message>
    <message>
        <source>Studio and a lamp</source>
        <translation>Estudio y una lámpara</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Entorno</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>What lights the sphere: a studio and a lamp that the pointer moves, or the environment map of the scene, seen along -z</source>
        <translation>Qué ilumina la esfera: un estudio y una lámpara que mueve el puntero, o el mapa de entorno de la escena, visto hacia -z</translation>
    </message>
    <message>
        <source>The environment map of the scene can light the sphere; the scene has none</source>
        <translation>El mapa de entorno de la escena puede iluminar la esfera; la escena no tiene ninguno</translation>
    </message>
</context>
<context>
    <name>editor::BrdfForm</name>
    <message>
        <source>What is wrong with the BRDF</source>
        <translation>Qué falla en la BRDF</translation>
    </message>
    <message>
        <source>BRDF model</source>
        <translation>Modelo de BRDF</translation>
    </message>
    <message>
        <source>No selected face has a BRDF</source>
        <translation>Ninguna cara seleccionada tiene BRDF</translation>
    </message>
    <message>
        <source>The model of the BRDF; type a part of its name to search</source>
        <translation>El modelo de la BRDF; escriba una parte de su nombre para buscar</translation>
    </message>
    <message>
        <source>no BRDF</source>
        <translation>sin BRDF</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>Select faces to see and edit their BRDF.</source>
        <translation>Seleccione caras para ver y editar su BRDF.</translation>
    </message>
    <message>
        <source>Unknown BRDF model. Choose one here.</source>
        <translation>Modelo de BRDF desconocido. Elija uno aquí.</translation>
    </message>
    <message>
        <source>The faces have different models. Choose one here to assign it to all.</source>
        <translation>Las caras tienen modelos distintos. Elija uno aquí para asignarlo a todas.</translation>
    </message>
    <message>
        <source>This model has no parameters.</source>
        <translation>Este modelo no tiene parámetros.</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>De %1 a %2</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <translation>%1 o más</translation>
    </message>
    <message>
        <source>, a number or RGB (linear)</source>
        <translation>, un número o RGB (lineal)</translation>
    </message>
    <message>
        <source>%1 (unknown)</source>
        <translation>%1 (desconocido)</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Por defecto: %1</translation>
    </message>
    <message>
        <source>that of %1</source>
        <translation>el de %1</translation>
    </message>
</context>
<context>
    <name>editor::BrdfLibrary</name>
    <message>
        <source>Examples of all models</source>
        <translation>Ejemplos de todos los modelos</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search the library</source>
        <translation>Buscar en la biblioteca</translation>
    </message>
    <message>
        <source>Search by name, model or parameter value</source>
        <translation>Busca por nombre, modelo o valor de un parámetro</translation>
    </message>
    <message>
        <source>Category</source>
        <translation>Categoría</translation>
    </message>
    <message>
        <source>Category of BRDFs that is shown</source>
        <translation>Categoría de BRDF que se muestra</translation>
    </message>
    <message>
        <source>Save the BRDF to the library</source>
        <translation>Guardar la BRDF en la biblioteca</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Choose the library&apos;s folder</source>
        <translation>Elegir la carpeta de la biblioteca</translation>
    </message>
    <message>
        <source>Folder of the library, with one file per BRDF</source>
        <translation>Carpeta de la biblioteca, con un archivo por BRDF</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>My library</source>
        <translation>Mi biblioteca</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todo</translation>
    </message>
    <message>
        <source>No BRDFs yet.</source>
        <translation>Aún no hay BRDF.</translation>
    </message>
    <message>
        <source>No BRDF matches &apos;%1&apos;.</source>
        <translation>Ninguna BRDF coincide con &apos;%1&apos;.</translation>
    </message>
    <message>
        <source>Save the edited BRDF to the library&apos;s folder</source>
        <translation>Guarda la BRDF editada en la carpeta de la biblioteca</translation>
    </message>
    <message>
        <source>Choose a folder for the library first</source>
        <translation>Elija antes una carpeta para la biblioteca</translation>
    </message>
    <message>
        <source>There is no BRDF to save: select faces, or choose one</source>
        <translation>No hay ninguna BRDF que guardar: seleccione caras, o elija una</translation>
    </message>
    <message>
        <source>Select an entry of your library first</source>
        <translation>Seleccione antes una entrada de su biblioteca</translation>
    </message>
    <message>
        <source>Only entries of your library&apos;s folder can be changed</source>
        <translation>Solo se pueden cambiar las entradas de la carpeta de su biblioteca</translation>
    </message>
    <message>
        <source>Rename the file (F2)</source>
        <translation>Renombra el archivo (F2)</translation>
    </message>
    <message>
        <source>Move the file to the trash</source>
        <translation>Mueve el archivo a la papelera</translation>
    </message>
    <message>
        <source>Folder of the library</source>
        <translation>Carpeta de la biblioteca</translation>
    </message>
    <message>
        <source>Choose a folder for the library first.</source>
        <translation>Elija antes una carpeta para la biblioteca.</translation>
    </message>
    <message>
        <source>Cannot save a sum of BRDFs: it needs the definitions of its scene.</source>
        <translation>No se puede guardar una suma de BRDF: necesita las definiciones de su escena.</translation>
    </message>
    <message>
        <source>Cannot create the folder &apos;%1&apos;.</source>
        <translation>No se puede crear la carpeta &apos;%1&apos;.</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: %2.</source>
        <translation>No se puede escribir &apos;%1&apos;: %2.</translation>
    </message>
    <message>
        <source>Cannot rename &apos;%1&apos;: %2.</source>
        <translation>No se puede renombrar &apos;%1&apos;: %2.</translation>
    </message>
    <message>
        <source>Cannot move &apos;%1&apos; to the trash: %2.</source>
        <translation>No se puede mover &apos;%1&apos; a la papelera: %2.</translation>
    </message>
</context>
<context>
    <name>editor::BrdfPlots</name>
    <message>
        <source>Plot of the BRDF</source>
        <translation>Gráfica de la BRDF</translation>
    </message>
    <message>
        <source>Plot of the BRDF; the button with the arrow exports it</source>
        <translation>Gráfica de la BRDF; el botón con la flecha la exporta</translation>
    </message>
    <message>
        <source>Polar</source>
        <translation>Polar</translation>
    </message>
    <message>
        <source>Polar plot of the lobe in the plane of incidence; the radius is the value in 1/sr</source>
        <translation>Gráfica polar del lóbulo en el plano de incidencia; el radio es el valor en 1/sr</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Cartesian plot of the value in 1/sr against the light&apos;s angle in degrees</source>
        <translation>Gráfica cartesiana del valor en 1/sr según el ángulo de la luz en grados</translation>
    </message>
    <message>
        <source>Albedo</source>
        <translation>Albedo</translation>
    </message>
    <message>
        <source>Directional albedo: the fraction of light reflected, against the view angle in degrees</source>
        <translation>Albedo direccional: la fracción de luz reflejada, según el ángulo de la vista en grados</translation>
    </message>
    <message>
        <source>Save the plot</source>
        <translation>Guardar la gráfica</translation>
    </message>
    <message>
        <source>Save the plot as SVG, PNG or PDF, or its values as CSV</source>
        <translation>Guarda la gráfica como SVG, PNG o PDF, o sus valores como CSV</translation>
    </message>
    <message>
        <source>Plotted quantity</source>
        <translation>Magnitud representada</translation>
    </message>
    <message>
        <source>The BRDF f itself, or f times the cosine of the light&apos;s angle: both in 1/sr</source>
        <translation>La propia BRDF f, o f por el coseno del ángulo de la luz: ambas en 1/sr</translation>
    </message>
    <message>
        <source>Luminance</source>
        <translation>Luminancia</translation>
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
        <source>Channel</source>
        <translation>Canal</translation>
    </message>
    <message>
        <source>The channel of the value, or its luminance</source>
        <translation>El canal del valor, o su luminancia</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>Logarithmic scale, in decades below the peak</source>
        <translation>Escala logarítmica, en décadas bajo el máximo</translation>
    </message>
    <message>
        <source>Logarithmic scale</source>
        <translation>Escala logarítmica</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>View angles</source>
        <translation>Ángulos de la vista</translation>
    </message>
    <message>
        <source>View angles from the normal in degrees, 0 to below 90, separated by commas</source>
        <translation>Ángulos de la vista con la normal en grados, de 0 a menos de 90, separados por comas</translation>
    </message>
    <message>
        <source>No pdf</source>
        <translation>Sin pdf</translation>
    </message>
    <message>
        <source>Sampling scheme</source>
        <translation>Esquema de muestreo</translation>
    </message>
    <message>
        <source>Sampling scheme whose pdf in 1/sr is drawn, dashed</source>
        <translation>Esquema de muestreo cuya pdf en 1/sr se dibuja, discontinua</translation>
    </message>
    <message>
        <source>Enter view angles from 0 to below 90 degrees, such as 0, 30, 60.</source>
        <translation>Escriba ángulos de la vista de 0 a menos de 90 grados, como 0, 30, 60.</translation>
    </message>
    <message>
        <source>Straight lines: the specular (delta) part; its length is the fraction of light that it reflects.</source>
        <translation>Líneas rectas: la parte especular (delta); su longitud es la fracción de luz que refleja.</translation>
    </message>
    <message>
        <source>Cannot save the plot: the file name must end in .svg, .png, .pdf or .csv.</source>
        <translation>No se puede guardar la gráfica: el nombre del archivo debe acabar en .svg, .png, .pdf o .csv.</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;.</source>
        <translation>No se puede escribir &apos;%1&apos;.</translation>
    </message>
    <message>
        <source>SVG (*.svg);;PNG (*.png);;PDF (*.pdf);;Values as CSV (*.csv)</source>
        <translation>SVG (*.svg);;PNG (*.png);;PDF (*.pdf);;Valores como CSV (*.csv)</translation>
    </message>
    <message>
        <source>unknown sampling scheme &apos;%1&apos;</source>
        <translation>esquema de muestreo &apos;%1&apos; desconocido</translation>
    </message>
    <message>
        <source>Reflects up to %1 times the light it receives (at %2 degrees).</source>
        <translation>Refleja hasta %1 veces la luz que recibe (a %2 grados).</translation>
    </message>
    <message>
        <source>Reflects at most %1 % of the light it receives.</source>
        <translation>Refleja como máximo el %1 % de la luz que recibe.</translation>
    </message>
    <message>
        <source>%1 plot</source>
        <translation>Gráfica: %1</translation>
    </message>
    <message>
        <source>No pdf: %1.</source>
        <translation>Sin pdf: %1.</translation>
    </message>
    <message>
        <source>The model: %1.</source>
        <translation>El modelo: %1.</translation>
    </message>
</context>
<context>
    <name>editor::BrdfRenderer</name>
    <message>
        <source>The BRDF viewer needs OpenGL 3.3, which this display does not support. Exported figures are shaded on the CPU.</source>
        <translation>El visor de BRDF necesita OpenGL 3.3, que esta pantalla no admite. Las figuras exportadas se sombrean en la CPU.</translation>
    </message>
    <message>
        <source>The BRDF viewer cannot draw: the graphics driver cannot compile a shader: %1</source>
        <translation>El visor de BRDF no puede dibujar: el controlador gráfico no puede compilar un shader: %1</translation>
    </message>
</context>
<context>
    <name>editor::BrdfRow</name>
    <message>
        <source>BRDF</source>
        <translation>BRDF</translation>
    </message>
    <message>
        <source>Edit the BRDF</source>
        <translation>Editar la BRDF</translation>
    </message>
    <message>
        <source>Define the BRDF</source>
        <translation>Definir la BRDF</translation>
    </message>
    <message>
        <source>Pick the BRDF from a face</source>
        <translation>Tomar la BRDF de una cara</translation>
    </message>
    <message>
        <source>Pick: assign the BRDF of the face that you click in the view</source>
        <translation>Tomar: asigna la BRDF de la cara en la que haga clic en la vista</translation>
    </message>
    <message>
        <source>Reset the BRDF</source>
        <translation>Restablecer la BRDF</translation>
    </message>
    <message>
        <source>Reset BRDF</source>
        <translation>Restablecer la BRDF</translation>
    </message>
    <message>
        <source>The BRDF of the faces: a named definition of the scene, or a new one</source>
        <translation>La BRDF de las caras: una definición con nombre de la escena, o una nueva</translation>
    </message>
    <message>
        <source>The faces have several BRDFs.</source>
        <translation>Las caras tienen varias BRDF.</translation>
    </message>
    <message>
        <source>The faces have no BRDF.</source>
        <translation>Las caras no tienen BRDF.</translation>
    </message>
    <message>
        <source>Edit the BRDF: its lobe and its parameters</source>
        <translation>Edita la BRDF: su lóbulo y sus parámetros</translation>
    </message>
    <message>
        <source>Define: name the BRDF, so that other faces can share it</source>
        <translation>Definir: da un nombre a la BRDF para que otras caras puedan compartirla</translation>
    </message>
    <message>
        <source>The BRDF is a named definition already.</source>
        <translation>La BRDF ya es una definición con nombre.</translation>
    </message>
    <message>
        <source>Reset to the default BRDF: diffuse with kd = 0.5</source>
        <translation>Restablece la BRDF por defecto: difusa con kd = 0.5</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Diffuse with kd = 0.5</source>
        <translation>Difusa con kd = 0.5</translation>
    </message>
    <message>
        <source>Inline, only on these faces: %1</source>
        <translation>Propia, solo de estas caras: %1</translation>
    </message>
    <message>
        <source>The BRDF &apos;%1&apos; of the scene</source>
        <translation>La BRDF &apos;%1&apos; de la escena</translation>
    </message>
    <message>
        <source>Assign %1</source>
        <translation>Asignar %1</translation>
    </message>
    <message>
        <source>Define %1</source>
        <translation>Definir %1</translation>
    </message>
</context>
<context>
    <name>editor::BrdfView</name>
    <message>
        <source>Object with the BRDF</source>
        <translation>Objeto con la BRDF</translation>
    </message>
    <message>
        <source>Drag to turn the object, with the right button to move the light; wheel: distance; + and -: exposure</source>
        <translation>Arrastre para girar el objeto, con el botón derecho para mover la luz; rueda: distancia; + y -: exposición</translation>
    </message>
    <message>
        <source>Drag the highlight to move the light, with the right button to turn the object; arrow keys move the light, too</source>
        <translation>Arrastre el brillo para mover la luz, con el botón derecho para girar el objeto; las flechas también mueven la luz</translation>
    </message>
</context>
<context>
    <name>editor::BrdfViewerWindow</name>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Frames per second while something moves; else how far the image is refined</source>
        <translation>Imágenes por segundo mientras algo se mueve; si no, cuánto se ha refinado la imagen</translation>
    </message>
    <message>
        <source>Move the &amp;light</source>
        <translation>Mover la &amp;luz</translation>
    </message>
    <message>
        <source>Let the pointer and the arrow keys move the light, not the object</source>
        <translation>El puntero y las flechas mueven la luz en vez del objeto</translation>
    </message>
    <message>
        <source>Light that is &amp;moved</source>
        <translation>Luz que se &amp;mueve</translation>
    </message>
    <message>
        <source>Light &amp;%1</source>
        <translation>Luz &amp;%1</translation>
    </message>
    <message>
        <source>Move light %1, which is turned on if it is off</source>
        <translation>Mueve la luz %1, que se enciende si está apagada</translation>
    </message>
    <message>
        <source>&amp;Shader text</source>
        <translation>&amp;Texto del shader</translation>
    </message>
    <message>
        <source>Show the GLSL of the BRDFs, with the driver&apos;s messages</source>
        <translation>Muestra el GLSL de las BRDF, con los mensajes del controlador</translation>
    </message>
    <message>
        <source>%1 has no faces to show</source>
        <translation>%1 no tiene caras que mostrar</translation>
    </message>
    <message>
        <source>No model is open.

Open a file (Ctrl+O), or drop one here.</source>
        <translation>No hay ningún modelo abierto.

Abra un archivo (Ctrl+O) o suéltelo aquí.</translation>
    </message>
    <message>
        <source>There is no object to show: see the message above.</source>
        <translation>No hay ningún objeto que mostrar: vea el mensaje de arriba.</translation>
    </message>
    <message>
        <source>No environment map is open: open an EXR or HDR file.</source>
        <translation>No hay ningún mapa de entorno abierto: abra un archivo EXR o HDR.</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 imágenes/s</translation>
    </message>
    <message>
        <source> at 1/%1 resolution</source>
        <translation> a 1/%1 de la resolución</translation>
    </message>
    <message>
        <source>refined</source>
        <translation>refinada</translation>
    </message>
    <message>
        <source>refined %1 of %2 times</source>
        <translation>refinada %1 de %2 veces</translation>
    </message>
    <message>
        <source>, on the CPU</source>
        <translation>, en la CPU</translation>
    </message>
    <message>
        <source>BRDF %1 at θ = %2°: GPU %3; CPU %4; difference %5</source>
        <translation>BRDF %1 en θ = %2°: GPU %3; CPU %4; diferencia %5</translation>
    </message>
</context>
<context>
    <name>editor::CameraPanel</name>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Cameras of the scene</source>
        <translation>Cámaras de la escena</translation>
    </message>
    <message>
        <source>A double click looks through a camera; the check mark selects the one that renders</source>
        <translation>Un doble clic mira por una cámara; la marca elige la que se usa para renderizar</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Renders</source>
        <translation>Renderiza</translation>
    </message>
    <message>
        <source>Add a camera</source>
        <translation>Añadir una cámara</translation>
    </message>
    <message>
        <source>Add a camera at the viewpoint of the 3D view</source>
        <translation>Añade una cámara en el punto de vista de la vista 3D</translation>
    </message>
    <message>
        <source>Delete the camera</source>
        <translation>Eliminar la cámara</translation>
    </message>
    <message>
        <source>Move the camera to the view</source>
        <translation>Mover la cámara a la vista</translation>
    </message>
    <message>
        <source>Move the selected camera to the viewpoint of the 3D view</source>
        <translation>Mueve la cámara seleccionada al punto de vista de la vista 3D</translation>
    </message>
    <message>
        <source>Look through the camera</source>
        <translation>Mirar por la cámara</translation>
    </message>
    <message>
        <source>View the scene through the selected camera</source>
        <translation>Muestra la escena desde la cámara seleccionada</translation>
    </message>
    <message>
        <source>Set camera: %1</source>
        <translation>Ajustar la cámara: %1</translation>
    </message>
    <message>
        <source>Camera: %1, %2</source>
        <translation>Cámara: %1, %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>position of the camera in world space</source>
        <translation>posición de la cámara en el espacio de la escena</translation>
    </message>
    <message>
        <source>Look at</source>
        <translation>Mira hacia</translation>
    </message>
    <message>
        <source>the point that the camera looks at, in world space</source>
        <translation>el punto al que mira la cámara, en el espacio de la escena</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Campo de visión</translation>
    </message>
    <message>
        <source>Vertical field of view</source>
        <translation>Campo de visión vertical</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Distancia focal</translation>
    </message>
    <message>
        <source>Focal length of a full-frame camera, whose sensor is 24 mm high</source>
        <translation>Distancia focal de una cámara de formato completo, cuyo sensor mide 24 mm de alto</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Enfoque</translation>
    </message>
    <message>
        <source>Lens radius</source>
        <translation>Radio de la lente</translation>
    </message>
    <message>
        <source>Depth of field: the radius of the lens, half its aperture; 0: everything is sharp</source>
        <translation>Profundidad de campo: el radio de la lente, la mitad de su apertura; 0: todo es nítido</translation>
    </message>
    <message>
        <source>Focus distance</source>
        <translation>Distancia de enfoque</translation>
    </message>
    <message>
        <source>Distance to the plane in focus, along the view direction</source>
        <translation>Distancia al plano enfocado, según la dirección de la vista</translation>
    </message>
    <message>
        <source>Focus on…</source>
        <translation>Enfocar en…</translation>
    </message>
    <message>
        <source>Click the point of the scene that shall be in focus</source>
        <translation>Haga clic en el punto de la escena que debe estar enfocado</translation>
    </message>
    <message>
        <source>Level the horizon</source>
        <translation>Nivelar el horizonte</translation>
    </message>
    <message>
        <source>Remove the roll: the up vector becomes the vertical</source>
        <translation>Quita el alabeo: el vector hacia arriba pasa a ser la vertical</translation>
    </message>
    <message>
        <source>Add camera</source>
        <translation>Añadir cámara</translation>
    </message>
    <message>
        <source>camera %1</source>
        <translation>cámara %1</translation>
    </message>
    <message>
        <source>Move the camera</source>
        <translation>Mover la cámara</translation>
    </message>
    <message>
        <source>Focus the camera</source>
        <translation>Enfocar la cámara</translation>
    </message>
    <message>
        <source>Rename camera</source>
        <translation>Renombrar cámara</translation>
    </message>
    <message>
        <source>Select the camera that renders</source>
        <translation>Elegir la cámara que renderiza</translation>
    </message>
    <message>
        <source>Delete camera</source>
        <translation>Eliminar cámara</translation>
    </message>
    <message>
        <source>Render camera</source>
        <translation>Cámara de render</translation>
    </message>
    <message>
        <source>The camera of the render options cannot be deleted.</source>
        <translation>La cámara de las opciones de render no se puede eliminar.</translation>
    </message>
</context>
<context>
    <name>editor::ColourButton</name>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
</context>
<context>
    <name>editor::ColourFields</name>
    <message>
        <source>Choose a colour: %1</source>
        <translation>Elegir un color: %1</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rojo</translation>
    </message>
    <message>
        <source>green</source>
        <translation>verde</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>azul</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>editor::ColourRow</name>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>linear RGB factor of the BRDF</source>
        <translation>factor RGB lineal de la BRDF</translation>
    </message>
    <message>
        <source>Name of the colour</source>
        <translation>Nombre del color</translation>
    </message>
    <message>
        <source>A named colour of the scene, or RGB values only for these faces</source>
        <translation>Un color con nombre de la escena, o valores RGB solo para estas caras</translation>
    </message>
    <message>
        <source>Reset the colour</source>
        <translation>Restablecer el color</translation>
    </message>
    <message>
        <source>RGB values</source>
        <translation>Valores RGB</translation>
    </message>
    <message>
        <source>Reset to the default colour: white</source>
        <translation>Restablece el color por defecto: blanco</translation>
    </message>
    <message>
        <source>The faces have no colour of their own.</source>
        <translation>Las caras no tienen color propio.</translation>
    </message>
    <message>
        <source>Set colour</source>
        <translation>Cambiar el color</translation>
    </message>
    <message>
        <source>Reset colour</source>
        <translation>Restablecer el color</translation>
    </message>
</context>
<context>
    <name>editor::CostFile</name>
    <message>
        <source>%1 is no study: choose the JSON file that bpt cost wrote</source>
        <translation>%1 no es un estudio: elija el archivo JSON que escribió bpt cost</translation>
    </message>
    <message>
        <source>%1: expected a name that ends with svg, png, pdf, csv or json</source>
        <translation>%1: se esperaba un nombre que termine en svg, png, pdf, csv o json</translation>
    </message>
    <message>
        <source>cannot convert the figure</source>
        <translation>no se puede convertir la figura</translation>
    </message>
</context>
<context>
    <name>editor::CostForm</name>
    <message>
        <source>Compared schemes</source>
        <translation>Esquemas comparados</translation>
    </message>
    <message>
        <source>Each checked sampling scheme becomes a curve; without any, the scheme of the render settings is measured</source>
        <translation>Cada esquema de muestreo marcado da una curva; sin ninguno se mide el de los ajustes de render</translation>
    </message>
    <message>
        <source>Compare path</source>
        <translation>Comparar path</translation>
    </message>
    <message>
        <source>Measure path tracing with light sampling</source>
        <translation>Medir el trazado de caminos con muestreo de luces</translation>
    </message>
    <message>
        <source>Compare naive</source>
        <translation>Comparar naive</translation>
    </message>
    <message>
        <source>Measure the thesis&apos; estimator, which samples directions by the scheme alone</source>
        <translation>Medir el estimador de la tesis, que muestrea direcciones solo con el esquema</translation>
    </message>
    <message>
        <source>Compared ways</source>
        <translation>Caminos comparados</translation>
    </message>
    <message>
        <source>Each number of ways from the first hit becomes a curve, such as 1,2,4; while it is empty, that of the render settings is measured</source>
        <translation>Cada número de caminos desde el primer impacto da una curva, como 1,2,4; si está vacío se mide el de los ajustes de render</translation>
    </message>
    <message>
        <source>Compared samples</source>
        <translation>Muestras comparadas</translation>
    </message>
    <message>
        <source>Each number of samples per pixel becomes a point of every curve; the numbers ascend</source>
        <translation>Cada número de muestras por píxel da un punto de cada curva; los números son crecientes</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>Rondas</translation>
    </message>
    <message>
        <source>Each point is rendered so many times with different seeds; intervals need two rounds, and narrow with more</source>
        <translation>Cada punto se calcula tantas veces con semillas distintas; los intervalos necesitan dos rondas y se estrechan con más</translation>
    </message>
    <message>
        <source>Only the preview region</source>
        <translation>Solo la región de vista previa</translation>
    </message>
    <message>
        <source>Measure only the region of the mode Rendered, as the 3D view frames it</source>
        <translation>Medir solo la región del modo Renderizado, tal como la encuadra la vista 3D</translation>
    </message>
    <message>
        <source>as in the settings</source>
        <translation>como en los ajustes</translation>
    </message>
    <message>
        <source>Sampling schemes</source>
        <translation>Esquemas de muestreo</translation>
    </message>
    <message>
        <source>Integrators</source>
        <translation>Integradores</translation>
    </message>
    <message>
        <source>Ways</source>
        <translation>Caminos</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Muestras</translation>
    </message>
</context>
<context>
    <name>editor::CostPage</name>
    <message>
        <source>Error over render time</source>
        <translation>Error frente al tiempo de render</translation>
    </message>
    <message>
        <source>Error (square root of relMSE, in percent) over render time; both are logarithmic</source>
        <translation>Error (raíz de relMSE, en tanto por ciento) frente al tiempo de render; ambos son logarítmicos</translation>
    </message>
    <message>
        <source>Efficiencies</source>
        <translation>Eficiencias</translation>
    </message>
    <message>
        <source>Efficiency 1 / (relMSE x render seconds) with its 95 % interval over the rounds, and the time to an error of 1 % with building tables, in seconds</source>
        <translation>Eficiencia 1 / (relMSE x segundos de render) con su intervalo del 95 % entre rondas, y el tiempo hasta un error del 1 % contando la construcción de tablas, en segundos</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation>Eficiencia</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>Intervalo del 95 %</translation>
    </message>
    <message>
        <source>Seconds to 1 %</source>
        <translation>Segundos hasta 1 %</translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation>Progreso del estudio</translation>
    </message>
    <message>
        <source>Settings of the winner</source>
        <translation>Ajustes del ganador</translation>
    </message>
    <message>
        <source>The lines of an OP file, and the PDF of a scene, that take the winner</source>
        <translation>Las líneas de un archivo OP, y la PDF de una escena, que adoptan el ganador</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Start the study</source>
        <translation>Empezar el estudio</translation>
    </message>
    <message>
        <source>Measure all curves afresh</source>
        <translation>Medir de nuevo todas las curvas</translation>
    </message>
    <message>
        <source>Continue the study</source>
        <translation>Continuar el estudio</translation>
    </message>
    <message>
        <source>Measure what the shown study lacks</source>
        <translation>Medir lo que falta en el estudio mostrado</translation>
    </message>
    <message>
        <source>Stop the study</source>
        <translation>Detener el estudio</translation>
    </message>
    <message>
        <source>End the study, and keep what was measured</source>
        <translation>Terminar el estudio y conservar lo medido</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>Abrir un estudio</translation>
    </message>
    <message>
        <source>Open the JSON file of a study of bpt cost, to show or continue it</source>
        <translation>Abrir el archivo JSON de un estudio de bpt cost, para mostrarlo o continuarlo</translation>
    </message>
    <message>
        <source>Save the study</source>
        <translation>Guardar el estudio</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Abrir...</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Guardar...</translation>
    </message>
    <message>
        <source>Take the winner</source>
        <translation>Adoptar el ganador</translation>
    </message>
    <message>
        <source>Copy the settings</source>
        <translation>Copiar los ajustes</translation>
    </message>
    <message>
        <source>Copy the settings of the winner as text</source>
        <translation>Copiar los ajustes del ganador como texto</translation>
    </message>
    <message>
        <source>Picture A</source>
        <translation>Imagen A</translation>
    </message>
    <message>
        <source>The curve whose largest sample count sets the time or the error</source>
        <translation>La curva cuyo mayor número de muestras fija el tiempo o el error</translation>
    </message>
    <message>
        <source>Picture B</source>
        <translation>Imagen B</translation>
    </message>
    <message>
        <source>The curve that gets the same time or error</source>
        <translation>La curva que recibe el mismo tiempo o error</translation>
    </message>
    <message>
        <source>Pictures of</source>
        <translation>Imágenes de</translation>
    </message>
    <message>
        <source>and</source>
        <translation>y</translation>
    </message>
    <message>
        <source>At equal time</source>
        <translation>A igual tiempo</translation>
    </message>
    <message>
        <source>At equal error</source>
        <translation>A igual error</translation>
    </message>
    <message>
        <source>no region is framed: drag one by the action Preview region</source>
        <translation>no hay región encuadrada: arrastre una con la acción Región de vista previa</translation>
    </message>
    <message>
        <source>render time, s</source>
        <translation>tiempo de render, s</translation>
    </message>
    <message>
        <source>error, %</source>
        <translation>error, %</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>%1 wins: its interval is above those of all others.</source>
        <translation>%1 gana: su intervalo está por encima de todos los demás.</translation>
    </message>
    <message>
        <source>A study compares the error of renders over their time.</source>
        <translation>Un estudio compara el error de los renders frente a su tiempo.</translation>
    </message>
    <message>
        <source>One curve has nothing to win against: compare two or more.</source>
        <translation>Una curva sola no compite con nada: compare dos o más.</translation>
    </message>
    <message>
        <source>No clear winner: the intervals overlap, or are not known yet.</source>
        <translation>Sin ganador claro: los intervalos se solapan o aún no se conocen.</translation>
    </message>
    <message>
        <source>A study is running.</source>
        <translation>Hay un estudio en marcha.</translation>
    </message>
    <message>
        <source>There is no study.</source>
        <translation>No hay ningún estudio.</translation>
    </message>
    <message>
        <source>No study is running.</source>
        <translation>No hay ningún estudio en marcha.</translation>
    </message>
    <message>
        <source>Save the figure, the table or the study</source>
        <translation>Guardar la figura, la tabla o el estudio</translation>
    </message>
    <message>
        <source>Only a PDF of the scene has these settings.</source>
        <translation>Solo una PDF de la escena tiene estos ajustes.</translation>
    </message>
    <message>
        <source>There is no clear winner.</source>
        <translation>No hay un ganador claro.</translation>
    </message>
    <message>
        <source>Set the winner&apos;s settings in the render settings</source>
        <translation>Poner los ajustes del ganador en los ajustes de render</translation>
    </message>
    <message>
        <source>The pictures are being rendered.</source>
        <translation>Se están calculando las imágenes.</translation>
    </message>
    <message>
        <source>The curves do not reach it within a million samples.</source>
        <translation>Las curvas no lo alcanzan con un millón de muestras.</translation>
    </message>
    <message>
        <source>Render both in the same time, and compare them in Images</source>
        <translation>Calcular ambas en el mismo tiempo y compararlas en Imágenes</translation>
    </message>
    <message>
        <source>Render both with the same error, and compare them in Images</source>
        <translation>Calcular ambas con el mismo error y compararlas en Imágenes</translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation>Estudios (*.json)</translation>
    </message>
    <message>
        <source>Figure (*.svg *.png *.pdf);;Table (*.csv);;Study (*.json)</source>
        <translation>Figura (*.svg *.png *.pdf);;Tabla (*.csv);;Estudio (*.json)</translation>
    </message>
    <message>
        <source>%1, %2 samples</source>
        <translation>%1, %2 muestras</translation>
    </message>
</context>
<context>
    <name>editor::DataFileRow</name>
    <message>
        <source>Data</source>
        <translation>Datos</translation>
    </message>
    <message>
        <source>File of measured data</source>
        <translation>Archivo de datos medidos</translation>
    </message>
    <message>
        <source>A .bsdf file of the RGL material database for rgl; for measured a file of the MERL (.binary) or UTIA (.bin) database, of Zemax or LightTools (.bsdf), ASTM E1392 or CSV; by its path or relative to the scene</source>
        <translation>Un archivo .bsdf de la base de datos de materiales RGL para rgl; para measured, un archivo de la base de datos MERL (.binary) o UTIA (.bin), de Zemax o LightTools (.bsdf), ASTM E1392 o CSV; por su ruta o relativo a la escena</translation>
    </message>
    <message>
        <source>Choose the file of measured data</source>
        <translation>Elegir el archivo de datos medidos</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>choose a measured BRDF</source>
        <translation>elija una BRDF medida</translation>
    </message>
    <message>
        <source>Measured data</source>
        <translation>Datos medidos</translation>
    </message>
    <message>
        <source>Measured data (*.binary *.bsdf *.bin *.astm *.csv);;All files (*)</source>
        <translation>Datos medidos (*.binary *.bsdf *.bin *.astm *.csv);;Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>editor::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message numerus="yes">
        <source>The edit also applies at %n other place(s) that include the file</source>
        <translation>
            <numerusform>La edición se aplica también en %n otro lugar que incluye el archivo</numerusform>
            <numerusform>La edición se aplica también en otros %n lugares que incluyen el archivo</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>editor::EffectsController</name>
    <message>
        <source>E&amp;ffects</source>
        <translation>E&amp;fectos</translation>
    </message>
    <message>
        <source>Show which effects the scene needs, what they cost and what they contribute</source>
        <translation>Muestra qué efectos necesita la escena, cuánto cuestan y qué aportan</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Efectos</translation>
    </message>
    <message>
        <source>Effects of the scene: need, cost and contribution</source>
        <translation>Efectos de la escena: necesidad, coste y aportación</translation>
    </message>
</context>
<context>
    <name>editor::EffectsPage</name>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 to %2 %</source>
        <translation>%1 a %2 %</translation>
    </message>
    <message>
        <source>Area lights</source>
        <translation>Luces de área</translation>
    </message>
    <message>
        <source>Environment map</source>
        <translation>Mapa de entorno</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Diffuse interreflection</source>
        <translation>Interreflexión difusa</translation>
    </message>
    <message>
        <source>Glossy interreflection</source>
        <translation>Interreflexión brillante</translation>
    </message>
    <message>
        <source>Mirror reflection</source>
        <translation>Reflexión especular</translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <translation>Anisotropía</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Texturas</translation>
    </message>
    <message>
        <source>Vertex colours</source>
        <translation>Colores de vértice</translation>
    </message>
    <message>
        <source>Interpolated normals</source>
        <translation>Normales interpoladas</translation>
    </message>
    <message>
        <source>Measured BRDFs</source>
        <translation>BRDF medidas</translation>
    </message>
    <message>
        <source>Baked irradiance</source>
        <translation>Irradiancia precalculada</translation>
    </message>
    <message>
        <source>Depth of field</source>
        <translation>Profundidad de campo</translation>
    </message>
    <message>
        <source>Instances</source>
        <translation>Instancias</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Render a small image with and without each effect, in the background with the lowest priority</source>
        <translation>Renderiza una imagen pequeña con y sin cada efecto, en segundo plano con la prioridad más baja</translation>
    </message>
    <message>
        <source>Time of the measurement</source>
        <translation>Tiempo de la medición</translation>
    </message>
    <message>
        <source>Processor time for all effects together; more of it makes the intervals smaller</source>
        <translation>Tiempo de procesador para todos los efectos juntos; con más tiempo, los intervalos son menores</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Select faces</source>
        <translation>Seleccionar caras</translation>
    </message>
    <message>
        <source>Select the faces and lamps that call for the effect</source>
        <translation>Selecciona las caras y lámparas que requieren el efecto</translation>
    </message>
    <message>
        <source>Difference to the full image</source>
        <translation>Diferencia con la imagen completa</translation>
    </message>
    <message>
        <source>Compare the measured images without the effect, A, and with it, B, on the page Images</source>
        <translation>Compara las imágenes medidas sin el efecto, A, y con él, B, en la página Imágenes</translation>
    </message>
    <message>
        <source>Switch all on</source>
        <translation>Activar todos</translation>
    </message>
    <message>
        <source>Render all effects that the scene calls for</source>
        <translation>Renderiza todos los efectos que la escena requiere</translation>
    </message>
    <message>
        <source>State of the measurement</source>
        <translation>Estado de la medición</translation>
    </message>
    <message>
        <source>Effects of the scene</source>
        <translation>Efectos de la escena</translation>
    </message>
    <message>
        <source>Effects of the scene. Space switches the current one on or off; Return selects the faces and lamps that call for it, and shows the scene</source>
        <translation>Efectos de la escena. Espacio activa o desactiva el actual; Intro selecciona las caras y lámparas que lo requieren y muestra la escena</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Efecto</translation>
    </message>
    <message>
        <source>Needed, and why</source>
        <translation>Necesario, y por qué</translation>
    </message>
    <message>
        <source>Share of the light</source>
        <translation>Parte de la luz</translation>
    </message>
    <message>
        <source>Share of the time</source>
        <translation>Parte del tiempo</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>The part of the image&apos;s light that is lost without the effect, with the interval that contains it with 95 % probability; negative if the image gets brighter</source>
        <translation>La parte de la luz de la imagen que se pierde sin el efecto, con el intervalo que la contiene con una probabilidad del 95 %; negativa si la imagen se vuelve más clara</translation>
    </message>
    <message>
        <source>The part of the render time that is saved without the effect, for as many samples, with such an interval</source>
        <translation>La parte del tiempo de render que se ahorra sin el efecto, con el mismo número de muestras, con un intervalo igual</translation>
    </message>
    <message>
        <source>The root mean square difference of pixels to the full image, compared with its mean; the picture of it is brightened</source>
        <translation>La diferencia cuadrática media de los píxeles con la imagen completa, comparada con su media; su imagen está aclarada</translation>
    </message>
    <message>
        <source>If it is switched off: %1</source>
        <translation>Si se desactiva: %1</translation>
    </message>
    <message>
        <source>Needed: %1</source>
        <translation>Necesario: %1</translation>
    </message>
    <message>
        <source>Not needed: %1</source>
        <translation>No necesario: %1</translation>
    </message>
    <message>
        <source>Click to select these faces and lamps</source>
        <translation>Haga clic para seleccionar estas caras y lámparas</translation>
    </message>
    <message>
        <source>Stop measuring</source>
        <translation>Detener la medición</translation>
    </message>
    <message>
        <source>Cannot measure: %1</source>
        <translation>No se puede medir: %1</translation>
    </message>
    <message>
        <source>Measuring: %1 of %2 effects</source>
        <translation>Midiendo: %1 de %2 efectos</translation>
    </message>
    <message>
        <source>Measure what each effect costs and contributes.</source>
        <translation>Mida lo que cuesta y aporta cada efecto.</translation>
    </message>
    <message>
        <source>The scene or its options have changed since the effects were measured.</source>
        <translation>La escena o sus opciones han cambiado desde que se midieron los efectos.</translation>
    </message>
    <message>
        <source>Measured on a small image: what is lost without the effect, with intervals of 95 % probability.</source>
        <translation>Medido en una imagen pequeña: lo que se pierde sin el efecto, con intervalos del 95 % de probabilidad.</translation>
    </message>
    <message>
        <source>Switch on: %1</source>
        <translation>Activar: %1</translation>
    </message>
    <message>
        <source>Switch off: %1</source>
        <translation>Desactivar: %1</translation>
    </message>
    <message>
        <source>Switch all effects on</source>
        <translation>Activar todos los efectos</translation>
    </message>
    <message>
        <source>No face or lamp calls for it: %1</source>
        <translation>Ninguna cara ni lámpara lo requiere: %1</translation>
    </message>
    <message>
        <source>Selected because they call for it: faces: %1, area lights: %2 (%3)</source>
        <translation>Seleccionadas porque lo requieren: caras: %1, luces de área: %2 (%3)</translation>
    </message>
    <message>
        <source>%1: full image</source>
        <translation>%1: imagen completa</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Transmission</source>
        <translation>Transmisión</translation>
    </message>
</context>
<context>
    <name>editor::EmissionRow</name>
    <message>
        <source>Power</source>
        <translation>Potencia</translation>
    </message>
    <message>
        <source>Total power of the selected faces: π × area × mean of the radiance&apos;s RGB values</source>
        <translation>Potencia total de las caras seleccionadas: π × área × media de los valores RGB de la radiancia</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>Remove the emission</source>
        <translation>Quitar la emisión</translation>
    </message>
    <message>
        <source>Remove emission</source>
        <translation>Quitar la emisión</translation>
    </message>
    <message>
        <source>Radiance</source>
        <translation>Radiancia</translation>
    </message>
    <message>
        <source>radiance emitted by the front sides, W/(sr m²)</source>
        <translation>radiancia que emiten los lados frontales, W/(sr m²)</translation>
    </message>
    <message>
        <source>Set radiance</source>
        <translation>Cambiar la radiancia</translation>
    </message>
    <message>
        <source>Set power to %1 W</source>
        <translation>Cambiar la potencia a %1 W</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Remove the emission: the faces emit no light</source>
        <translation>Quita la emisión: las caras no emiten luz</translation>
    </message>
    <message>
        <source>The faces emit no light.</source>
        <translation>Las caras no emiten luz.</translation>
    </message>
</context>
<context>
    <name>editor::EnvironmentForm</name>
    <message>
        <source>Environment map</source>
        <translation>Mapa de entorno</translation>
    </message>
    <message>
        <source>The image whose radiance surrounds the scene and lights it</source>
        <translation>La imagen cuya radiancia rodea la escena y la ilumina</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>constant background radiance, W/(sr m²)</source>
        <translation>radiancia constante del fondo, W/(sr m²)</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Entorno</translation>
    </message>
    <message>
        <source>Set background</source>
        <translation>Cambiar el fondo</translation>
    </message>
    <message>
        <source>Rotation of the environment</source>
        <translation>Rotación del entorno</translation>
    </message>
    <message>
        <source>Rotates the environment map about the vertical axis, counter-clockwise seen from above</source>
        <translation>Rota el mapa de entorno alrededor del eje vertical, en sentido antihorario visto desde arriba</translation>
    </message>
    <message>
        <source>Rotation of the environment, slider</source>
        <translation>Rotación del entorno, deslizador</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotación</translation>
    </message>
    <message>
        <source>Rotate environment</source>
        <translation>Rotar el entorno</translation>
    </message>
    <message>
        <source>Brightness of the environment</source>
        <translation>Brillo del entorno</translation>
    </message>
    <message>
        <source>A factor of the radiance of the environment map or backplate</source>
        <translation>Un factor de la radiancia del mapa de entorno o del fondo</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Brillo</translation>
    </message>
    <message>
        <source>Set brightness of environment</source>
        <translation>Cambiar el brillo del entorno</translation>
    </message>
    <message>
        <source>Remove environment</source>
        <translation>Quitar el entorno</translation>
    </message>
    <message>
        <source>Set environment</source>
        <translation>Cambiar el entorno</translation>
    </message>
    <message>
        <source>Choose an environment map</source>
        <translation>Elegir un mapa de entorno</translation>
    </message>
    <message>
        <source>Images (%1);;All files (*)</source>
        <translation>Imágenes (%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>None: a constant background</source>
        <translation>Ninguno: un fondo constante</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Elegir un archivo…</translation>
    </message>
    <message>
        <source>Sky by place and time…</source>
        <translation>Cielo según lugar y hora…</translation>
    </message>
    <message>
        <source>Make an environment map of the clear sky and the sun at a place and a time</source>
        <translation>Crea un mapa de entorno del cielo despejado y el sol en un lugar y a una hora</translation>
    </message>
    <message>
        <source>Sky by place and time</source>
        <translation>Cielo según lugar y hora</translation>
    </message>
    <message>
        <source>Save the sky</source>
        <translation>Guardar el cielo</translation>
    </message>
    <message>
        <source>OpenEXR (*.exr)</source>
        <translation>OpenEXR (*.exr)</translation>
    </message>
</context>
<context>
    <name>editor::ErrorCurve</name>
    <message>
        <source>Estimated error over time</source>
        <translation>Error estimado según el tiempo</translation>
    </message>
    <message>
        <source>Estimated relative error of the image (square root of relMSE, in percent, logarithmic) over the seconds of rendering. The dashed line is the target error</source>
        <translation>Error relativo estimado de la imagen (raíz cuadrada de relMSE, en tanto por ciento, logarítmico) según los segundos de render. La línea discontinua es el error objetivo</translation>
    </message>
    <message>
        <source>The estimated error of a render appears here</source>
        <translation>El error estimado de un render aparece aquí</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>segundos</translation>
    </message>
    <message>
        <source>estimated error in %</source>
        <translation>error estimado en %</translation>
    </message>
</context>
<context>
    <name>editor::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Format of the exported file</source>
        <translation>Formato del archivo exportado</translation>
    </message>
    <message>
        <source>Grammar of &amp;2008, without extensions</source>
        <translation>Gramática de &amp;2008, sin extensiones</translation>
    </message>
    <message>
        <source>For programs that read only the first version of GRF</source>
        <translation>Para programas que solo leen la primera versión de GRF</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Formato</translation>
    </message>
    <message>
        <source>Summary of losses</source>
        <translation>Resumen de pérdidas</translation>
    </message>
    <message>
        <source>Losses</source>
        <translation>Pérdidas</translation>
    </message>
    <message>
        <source>What the file will not have of the scene</source>
        <translation>Lo que el archivo no tendrá de la escena</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportar</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Name of the exported file; its extension selects the format</source>
        <translation>Nombre del archivo exportado; su extensión elige el formato</translation>
    </message>
    <message>
        <source>Browse for a file</source>
        <translation>Buscar un archivo</translation>
    </message>
    <message>
        <source>Choose the exported file</source>
        <translation>Elegir el archivo exportado</translation>
    </message>
    <message>
        <source>Finding out what will be lost...</source>
        <translation>Se está averiguando qué se perderá...</translation>
    </message>
    <message>
        <source>The scene cannot be written in this format:</source>
        <translation>La escena no se puede escribir en este formato:</translation>
    </message>
    <message>
        <source>Nothing will be lost.</source>
        <translation>No se perderá nada.</translation>
    </message>
    <message>
        <source>This will be lost:</source>
        <translation>Esto se perderá:</translation>
    </message>
    <message>
        <source>Replace file</source>
        <translation>Reemplazar el archivo</translation>
    </message>
    <message>
        <source>%1 exists.</source>
        <translation>%1 ya existe.</translation>
    </message>
    <message>
        <source>Exporting overwrites it.</source>
        <translation>La exportación lo sobrescribe.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
</context>
<context>
    <name>editor::FaceQueryDialog</name>
    <message>
        <source>Select faces by</source>
        <translation>Seleccionar caras por</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>any</source>
        <translation>cualquiera</translation>
    </message>
    <message>
        <source>Name of a BRDF&apos;s definition, or of its model; * stands for any letters, ? for one</source>
        <translation>Nombre de la definición de una BRDF, o de su modelo; * representa cualesquiera letras, ? una</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Direction of the faces&apos; normals in world space; y is up</source>
        <translation>Dirección de las normales de las caras en el espacio de la escena; y apunta hacia arriba</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Largest angle between normal and direction</source>
        <translation>Ángulo máximo entre la normal y la dirección</translation>
    </message>
    <message>
        <source>within</source>
        <translation>hasta</translation>
    </message>
    <message>
        <source>Least area</source>
        <translation>Área mínima</translation>
    </message>
    <message>
        <source>Least area of a face in world space, m²</source>
        <translation>Área mínima de una cara en el espacio de la escena, m²</translation>
    </message>
    <message>
        <source>Largest area</source>
        <translation>Área máxima</translation>
    </message>
    <message>
        <source>Largest area of a face in world space, m²</source>
        <translation>Área máxima de una cara en el espacio de la escena, m²</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>Lowest y</source>
        <translation>y mínima</translation>
    </message>
    <message>
        <source>Least height of all corners of a face: y in world space</source>
        <translation>Altura mínima de todas las esquinas de una cara: y en el espacio de la escena</translation>
    </message>
    <message>
        <source>Highest y</source>
        <translation>y máxima</translation>
    </message>
    <message>
        <source>Largest height of all corners of a face: y in world space</source>
        <translation>Altura máxima de todas las esquinas de una cara: y en el espacio de la escena</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Same %1</source>
        <translation>Igual: %1</translation>
    </message>
    <message>
        <source>Tolerance of the %1</source>
        <translation>Tolerancia: %1</translation>
    </message>
    <message>
        <source>BRDF</source>
        <translation>BRDF</translation>
    </message>
    <message>
        <source>The BRDF is that of a selected face</source>
        <translation>La BRDF es la de una cara seleccionada</translation>
    </message>
    <message>
        <source>sampling</source>
        <translation>muestreo</translation>
    </message>
    <message>
        <source>The sampling scheme is that of a selected face</source>
        <translation>El esquema de muestreo es el de una cara seleccionada</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>color</translation>
    </message>
    <message>
        <source>The colour is that of a selected face</source>
        <translation>El color es el de una cara seleccionada</translation>
    </message>
    <message>
        <source>texture</source>
        <translation>textura</translation>
    </message>
    <message>
        <source>The texture is that of a selected face</source>
        <translation>La textura es la de una cara seleccionada</translation>
    </message>
    <message>
        <source>emission</source>
        <translation>emisión</translation>
    </message>
    <message>
        <source>The emission is that of a selected face</source>
        <translation>La emisión es la de una cara seleccionada</translation>
    </message>
    <message>
        <source>object</source>
        <translation>objeto</translation>
    </message>
    <message>
        <source>The face belongs to the mesh of a selected face</source>
        <translation>La cara es de la malla de una cara seleccionada</translation>
    </message>
    <message>
        <source>As selected</source>
        <translation>Como la selección</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>Largest angle to the mean normal of the selected faces</source>
        <translation>Ángulo máximo con la normal media de las caras seleccionadas</translation>
    </message>
    <message>
        <source>area</source>
        <translation>área</translation>
    </message>
    <message>
        <source>Largest deviation from the mean area of the selected faces, in percent of it</source>
        <translation>Desviación máxima del área media de las caras seleccionadas, en tanto por ciento de ella</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Encontradas</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Reemplazar</translation>
    </message>
    <message>
        <source>Select the found faces only</source>
        <translation>Selecciona solo las caras encontradas</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Añadir</translation>
    </message>
    <message>
        <source>Add the found faces to the selection</source>
        <translation>Añade las caras encontradas a la selección</translation>
    </message>
    <message>
        <source>&amp;Subtract</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>Remove the found faces from the selection</source>
        <translation>Quita las caras encontradas de la selección</translation>
    </message>
    <message>
        <source>&amp;Intersect</source>
        <translation>&amp;Intersecar</translation>
    </message>
    <message>
        <source>Keep only the found faces selected</source>
        <translation>Deja seleccionadas solo las caras encontradas</translation>
    </message>
    <message>
        <source>No face is selected to compare with</source>
        <translation>No hay ninguna cara seleccionada con la que comparar</translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>1 cara</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 caras</translation>
    </message>
</context>
<context>
    <name>editor::FigureView</name>
    <message>
        <source>Figure</source>
        <translation>Figura</translation>
    </message>
    <message>
        <source>Point at a part of the figure to read its values; drag it or use the arrow keys to turn it</source>
        <translation>Apunte a una parte de la figura para leer sus valores; arrástrela o use las flechas para girarla</translation>
    </message>
</context>
<context>
    <name>editor::FileActions</name>
    <message>
        <source>Scenes and models (%1);;All files (*)</source>
        <translation>Escenas y modelos (%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuevo</translation>
    </message>
    <message>
        <source>Start an empty scene</source>
        <translation>Empieza una escena vacía</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>Open scenes, or import models of other formats</source>
        <translation>Abre escenas, o importa modelos de otros formatos</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>A&amp;ppend...</source>
        <translation>Aña&amp;dir...</translation>
    </message>
    <message>
        <source>Append scenes or models to this one</source>
        <translation>Añade escenas o modelos a esta</translation>
    </message>
    <message>
        <source>Append</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Append with op&amp;tions...</source>
        <translation>Añadir con &amp;opciones...</translation>
    </message>
    <message>
        <source>Append models, and show the import options, also if they are hidden for their type</source>
        <translation>Añade modelos y muestra las opciones de importación, también si están ocultas para su tipo</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Guarda la escena</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Guardar &amp;como...</translation>
    </message>
    <message>
        <source>Save the scene under another name</source>
        <translation>Guarda la escena con otro nombre</translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation>Re&amp;vertir</translation>
    </message>
    <message>
        <source>Revert to the saved file of the scene</source>
        <translation>Vuelve al archivo guardado de la escena</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>&amp;Exportar...</translation>
    </message>
    <message>
        <source>Export the scene to another format</source>
        <translation>Exporta la escena a otro formato</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>Import &amp;memory limit...</source>
        <translation>Límite de &amp;memoria al importar...</translation>
    </message>
    <message>
        <source>Set how much memory the import of a model may use</source>
        <translation>Fija cuánta memoria puede usar la importación de un modelo</translation>
    </message>
    <message>
        <source>Import memory limit</source>
        <translation>Límite de memoria al importar</translation>
    </message>
    <message>
        <source>Cancel the import of a model if it needs more memory than this (GB):</source>
        <translation>Cancelar la importación de un modelo si necesita más memoria que esta (GB):</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>No hay archivos recientes</translation>
    </message>
    <message>
        <source>Save as: irradiance needs an IGRF file</source>
        <translation>Guardar como: la irradiancia necesita un archivo IGRF</translation>
    </message>
    <message>
        <source>IGRF scenes (*.igrf)</source>
        <translation>Escenas IGRF (*.igrf)</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Guardar como</translation>
    </message>
    <message>
        <source>GRF scenes (*.grf *.igrf)</source>
        <translation>Escenas GRF (*.grf *.igrf)</translation>
    </message>
    <message>
        <source>Append %1 files</source>
        <translation>Añadir %1 archivos</translation>
    </message>
    <message>
        <source>Append %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Abrir %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>Cancel: the scene stays as it is</source>
        <translation>Cancela: la escena queda como está</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Cancelado</translation>
    </message>
    <message>
        <source>Appended %1</source>
        <translation>Se ha añadido %1</translation>
    </message>
    <message>
        <source>Appended %1 files</source>
        <translation>Se han añadido %1 archivos</translation>
    </message>
    <message>
        <source>%1, with losses: %2</source>
        <translation>%1, con pérdidas: %2</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>Se ha abierto %1</translation>
    </message>
    <message>
        <source>Imported %1</source>
        <translation>Se ha importado %1</translation>
    </message>
    <message>
        <source>Save %1</source>
        <translation>Guardar %1</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Se ha guardado %1</translation>
    </message>
    <message>
        <source>Replace files</source>
        <translation>Reemplazar archivos</translation>
    </message>
    <message>
        <source>%1 was changed by another program, or belongs to another scene.</source>
        <translation>Otro programa ha cambiado %1, o es de otra escena.</translation>
    </message>
    <message>
        <source>Saving overwrites them.</source>
        <translation>Guardar los sobrescribe.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>Cannot revert: the scene was never saved</source>
        <translation>No se puede revertir: la escena nunca se ha guardado</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revertir</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>Reverting discards them. This cannot be undone.</source>
        <translation>Revertir los descarta. No se puede deshacer.</translation>
    </message>
    <message>
        <source>Cannot export %1: no format with this extension can be written</source>
        <translation>No se puede exportar %1: no hay ningún formato con esta extensión que se pueda escribir</translation>
    </message>
    <message>
        <source>Exported %1</source>
        <translation>Se ha exportado %1</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>Exportar %1</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>Discarding them cannot be undone.</source>
        <translation>Descartarlos no se puede deshacer.</translation>
    </message>
    <message>
        <source>Keep editing</source>
        <translation>Seguir editando</translation>
    </message>
    <message>
        <source>Re&amp;import</source>
        <translation>Re&amp;importar</translation>
    </message>
    <message>
        <source>Read the file of the selected imported object again; its faces keep what was assigned to them</source>
        <translation>Vuelve a leer el archivo del objeto importado que está seleccionado; sus caras conservan lo que se les asignó</translation>
    </message>
    <message>
        <source>Select an object that was imported from a file of another format, to read that file again.</source>
        <translation>Seleccione un objeto importado de un archivo de otro formato para volver a leer ese archivo.</translation>
    </message>
    <message>
        <source>%1 is gone: choose the file</source>
        <translation>%1 ya no está: elija el archivo</translation>
    </message>
    <message>
        <source>Reimport %1</source>
        <translation>Reimportar %1</translation>
    </message>
    <message>
        <source>Reimported %1: its objects are the same</source>
        <translation>Se reimportó %1: sus objetos son los mismos</translation>
    </message>
    <message>
        <source>Reimported %1: %2 objects changed</source>
        <translation>Se reimportó %1: cambiaron %2 objetos</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Reimported %1: 1 object changed</source>
        <translation>Se reimportó %1: cambió 1 objeto</translation>
    </message>
    <message>
        <source>1 camera of %1</source>
        <translation>1 cámara de %1</translation>
    </message>
    <message>
        <source>%1 cameras of %2</source>
        <translation>%1 cámaras de %2</translation>
    </message>
</context>
<context>
    <name>editor::FinalRender</name>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>a render is already running: stop it first</source>
        <translation>ya hay un render en marcha: deténgalo antes</translation>
    </message>
    <message>
        <source>the output %1 is the scene&apos;s environment map: choose another output</source>
        <translation>la salida %1 es el mapa de entorno de la escena: elija otra salida</translation>
    </message>
    <message>
        <source>%1 exists and was not rendered in this session: choose another output</source>
        <translation>%1 ya existe y no se renderizó en esta sesión: elija otra salida</translation>
    </message>
    <message>
        <source>another render is writing %1: wait for it, or choose another output</source>
        <translation>otro render está escribiendo %1: espere, o elija otra salida</translation>
    </message>
    <message>
        <source>stopped before the first image</source>
        <translation>detenido antes de la primera imagen</translation>
    </message>
    <message>
        <source>the renderer wrote no image</source>
        <translation>el programa de render no escribió ninguna imagen</translation>
    </message>
</context>
<context>
    <name>editor::FittedImage</name>
    <message>
        <source>Image</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>The image rendered so far. Click or press Return to open it</source>
        <translation>La imagen renderizada hasta ahora. Haga clic o pulse Intro para abrirla</translation>
    </message>
</context>
<context>
    <name>editor::ForecastRow</name>
    <message>
        <source>Forecast of the render time</source>
        <translation>Previsión del tiempo de renderizado</translation>
    </message>
    <message>
        <source>Time until the image has an error of:</source>
        <translation>Tiempo hasta que la imagen tenga un error de:</translation>
    </message>
    <message>
        <source>Forecast from a short probe of the image on this machine, as if nothing else ran. The true time is in the interval with 90 % probability</source>
        <translation>Previsión a partir de un breve sondeo de la imagen en este equipo, como si no se ejecutara nada más. El tiempo real está en el intervalo con una probabilidad del 90 %</translation>
    </message>
    <message>
        <source>Forecast: measuring how long a render takes…</source>
        <translation>Previsión: se mide cuánto tarda un renderizado…</translation>
    </message>
    <message>
        <source>A short probe of the image runs in the background with the lowest priority</source>
        <translation>Un breve sondeo de la imagen se ejecuta en segundo plano con la prioridad más baja</translation>
    </message>
    <message>
        <source>No forecast: %1</source>
        <translation>Sin previsión: %1</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nunca</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>Render until an error of %1</source>
        <translation>Renderizar hasta un error de %1</translation>
    </message>
    <message>
        <source>Set the target error to %1, without a limit of samples</source>
        <translation>Fijar el error objetivo en %1, sin límite de muestras</translation>
    </message>
    <message>
        <source>The render takes %1, with 90 % probability %2 to %3, until its estimated error is %4.</source>
        <translation>El renderizado tarda %1, con una probabilidad del 90 % de %2 a %3, hasta que su error estimado es %4.</translation>
    </message>
    <message>
        <source>under 1 s</source>
        <translation>menos de 1 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 días</translation>
    </message>
</context>
<context>
    <name>editor::ImageBrowser</name>
    <message>
        <source>Drop an image here, open one, or render: exr, hdr, pfm, raw, png, jpg, tga or webp.</source>
        <translation>Suelte aquí una imagen, abra una o renderice: exr, hdr, pfm, raw, png, jpg, tga o webp.</translation>
    </message>
    <message>
        <source>Values of the pixel</source>
        <translation>Valores del píxel</translation>
    </message>
    <message>
        <source>Linear values of the pixel under the pointer</source>
        <translation>Valores lineales del píxel bajo el puntero</translation>
    </message>
    <message>
        <source>Image statistics</source>
        <translation>Estadísticas de la imagen</translation>
    </message>
    <message>
        <source>Statistics of the whole image: its range and mean, or its error against B</source>
        <translation>Estadísticas de toda la imagen: su rango y su media, o su error respecto a B</translation>
    </message>
    <message>
        <source>Open images</source>
        <translation>Abrir imágenes</translation>
    </message>
    <message>
        <source>Save the image</source>
        <translation>Guardar la imagen</translation>
    </message>
    <message>
        <source>A - B: %1 against %2</source>
        <translation>A - B: %1 frente a %2</translation>
    </message>
    <message>
        <source>Point at a pixel to read its values.</source>
        <translation>Apunte a un píxel para leer sus valores.</translation>
    </message>
    <message>
        <source>R %1  G %2  B %3</source>
        <translation>R %1  G %2  B %3</translation>
    </message>
    <message>
        <source>RMSE %1</source>
        <translation>RMSE %1</translation>
    </message>
    <message>
        <source>relMSE %1</source>
        <translation>relMSE %1</translation>
    </message>
    <message>
        <source>average relative error %1 %</source>
        <translation>error relativo medio %1 %</translation>
    </message>
    <message>
        <source>PSNR %1 dB</source>
        <translation>PSNR %1 dB</translation>
    </message>
    <message>
        <source>PSNR infinite</source>
        <translation>PSNR infinita</translation>
    </message>
    <message>
        <source>%1 x %2</source>
        <translation>%1 x %2</translation>
    </message>
    <message>
        <source>%1 NaN (magenta)</source>
        <translation>%1 NaN (magenta)</translation>
    </message>
    <message>
        <source>%1 infinite (cyan)</source>
        <translation>%1 infinitos (cian)</translation>
    </message>
    <message>
        <source>%1 negative</source>
        <translation>%1 negativos</translation>
    </message>
    <message>
        <source>B is %1 x %2: a difference needs images of the same size</source>
        <translation>B es de %1 x %2: una diferencia necesita imágenes del mismo tamaño</translation>
    </message>
    <message>
        <source>x %1  y %2   %3</source>
        <translation>x %1  y %2   %3</translation>
    </message>
    <message>
        <source>   B: %1</source>
        <translation>   B: %1</translation>
    </message>
    <message>
        <source>   luminance %1 cd/m2</source>
        <translation>   luminancia %1 cd/m2</translation>
    </message>
    <message>
        <source>Images (%1);;All files (*)</source>
        <translation>Imágenes (%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>B has no layer %1</source>
        <translation>B no tiene la capa %1</translation>
    </message>
</context>
<context>
    <name>editor::ImageController</name>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>View and compare images of renders and files</source>
        <translation>Muestra y compara imágenes de renders y de archivos</translation>
    </message>
    <message>
        <source>%1, before</source>
        <translation>%1, antes</translation>
    </message>
</context>
<context>
    <name>editor::ImagePane</name>
    <message>
        <source>Image</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Arrow keys move the image; [ and ] move the line between two images.</source>
        <translation>Las flechas mueven la imagen; [ y ] mueven la línea entre dos imágenes.</translation>
    </message>
</context>
<context>
    <name>editor::ImageProcess</name>
    <message>
        <source>cannot read the image: cannot find the program bpt</source>
        <translation>no se puede leer la imagen: no se encuentra el programa bpt</translation>
    </message>
    <message>
        <source>cannot read the image: out of memory</source>
        <translation>no se puede leer la imagen: falta memoria</translation>
    </message>
    <message>
        <source>cannot read the image: decoding takes longer than %1 s</source>
        <translation>no se puede leer la imagen: la decodificación tarda más de %1 s</translation>
    </message>
    <message>
        <source>cannot read the image: cannot start the program bpt: %1</source>
        <translation>no se puede leer la imagen: no se puede iniciar el programa bpt: %1</translation>
    </message>
    <message>
        <source>cannot read the image: the file is corrupt (its decoder crashed)</source>
        <translation>no se puede leer la imagen: el archivo está dañado (su decodificador falló)</translation>
    </message>
    <message>
        <source>cannot read the image: the file is corrupt (its decoder wrote no image)</source>
        <translation>no se puede leer la imagen: el archivo está dañado (su decodificador no escribió ninguna imagen)</translation>
    </message>
</context>
<context>
    <name>editor::ImageServer</name>
    <message>
        <source>A program sent data that is not a packet of the tev protocol, and was disconnected.</source>
        <translation>Un programa envió datos que no son un paquete del protocolo de tev, y se ha desconectado.</translation>
    </message>
    <message>
        <source>A program sent a damaged packet of the tev protocol, and was disconnected.</source>
        <translation>Un programa envió un paquete dañado del protocolo de tev, y se ha desconectado.</translation>
    </message>
    <message>
        <source>A program sent more images than there is room for, and was disconnected.</source>
        <translation>Un programa envió más imágenes de las que caben y fue desconectado.</translation>
    </message>
    <message>
        <source>another viewer uses it</source>
        <translation>lo usa otro visor</translation>
    </message>
</context>
<context>
    <name>editor::ImageTools</name>
    <message>
        <source> (%1)</source>
        <translation> (%1)</translation>
    </message>
    <message>
        <source>Open images</source>
        <translation>Abrir imágenes</translation>
    </message>
    <message>
        <source>Open image files: exr, hdr, pfm, raw, png, jpg, tga or webp.</source>
        <translation>Abre archivos de imagen: exr, hdr, pfm, raw, png, jpg, tga o webp.</translation>
    </message>
    <message>
        <source>Save image as</source>
        <translation>Guardar la imagen como</translation>
    </message>
    <message>
        <source>Save image A: linear as exr, hdr, pfm and raw, with the exposure applied as png, jpg and tga.</source>
        <translation>Guarda la imagen A: lineal como exr, hdr, pfm y raw; con la exposición aplicada como png, jpg y tga.</translation>
    </message>
    <message>
        <source>Copy image</source>
        <translation>Copiar la imagen</translation>
    </message>
    <message>
        <source>Copy the image to the clipboard as the screen shows it.</source>
        <translation>Copia la imagen al portapapeles como se ve en pantalla.</translation>
    </message>
    <message>
        <source>Close image</source>
        <translation>Cerrar la imagen</translation>
    </message>
    <message>
        <source>Remove image A from the list; its file is kept.</source>
        <translation>Quita la imagen A de la lista; su archivo se conserva.</translation>
    </message>
    <message>
        <source>The wheel also zooms, about the pointer.</source>
        <translation>La rueda también amplía, alrededor del puntero.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Fit the whole image into the view.</source>
        <translation>Ajusta toda la imagen a la vista.</translation>
    </message>
    <message>
        <source>Actual size</source>
        <translation>Tamaño real</translation>
    </message>
    <message>
        <source>Show one image pixel per screen pixel.</source>
        <translation>Muestra un píxel de la imagen por píxel de la pantalla.</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Acercar</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Alejar</translation>
    </message>
    <message>
        <source>Flip to B</source>
        <translation>Alternar con B</translation>
    </message>
    <message>
        <source>Show B in place of A until pressed again.</source>
        <translation>Muestra B en lugar de A hasta que se pulse de nuevo.</translation>
    </message>
    <message>
        <source>Swap A and B</source>
        <translation>Intercambiar A y B</translation>
    </message>
    <message>
        <source>Exchange the image and the reference.</source>
        <translation>Intercambia la imagen y la referencia.</translation>
    </message>
    <message>
        <source>Brighter</source>
        <translation>Más clara</translation>
    </message>
    <message>
        <source>Increase the exposure by half a stop</source>
        <translation>Aumenta la exposición medio paso</translation>
    </message>
    <message>
        <source>Darker</source>
        <translation>Más oscura</translation>
    </message>
    <message>
        <source>Decrease the exposure by half a stop</source>
        <translation>Reduce la exposición medio paso</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Show all three channels</source>
        <translation>Muestra los tres canales</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rojo</translation>
    </message>
    <message>
        <source>Show the red channel</source>
        <translation>Muestra el canal rojo</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Verde</translation>
    </message>
    <message>
        <source>Show the green channel</source>
        <translation>Muestra el canal verde</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Azul</translation>
    </message>
    <message>
        <source>Show the blue channel</source>
        <translation>Muestra el canal azul</translation>
    </message>
    <message>
        <source>Luminance</source>
        <translation>Luminancia</translation>
    </message>
    <message>
        <source>Show the luminance in grey</source>
        <translation>Muestra la luminancia en gris</translation>
    </message>
    <message>
        <source>False colour</source>
        <translation>Falso color</translation>
    </message>
    <message>
        <source>Show the luminance in false colours</source>
        <translation>Muestra la luminancia en falso color</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>Zoom: screen pixels per image pixel.</source>
        <translation>Ampliación: píxeles de la pantalla por píxel de la imagen.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Image A</source>
        <translation>Imagen A</translation>
    </message>
    <message>
        <source>The displayed image.</source>
        <translation>La imagen que se muestra.</translation>
    </message>
    <message>
        <source>Image B</source>
        <translation>Imagen B</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparación</translation>
    </message>
    <message>
        <source>Only A</source>
        <translation>Solo A</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>Cortinilla</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Lado a lado</translation>
    </message>
    <message>
        <source>Signed difference</source>
        <translation>Diferencia con signo</translation>
    </message>
    <message>
        <source>Absolute difference</source>
        <translation>Diferencia absoluta</translation>
    </message>
    <message>
        <source>Relative difference</source>
        <translation>Diferencia relativa</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>How A and B are compared: only A, with a wipe line that can be dragged, side by side, or as a difference.</source>
        <translation>Cómo se comparan A y B: solo A, con una cortinilla que se puede arrastrar, lado a lado, o como diferencia.</translation>
    </message>
    <message>
        <source>Choose an image as B first.</source>
        <translation>Elija antes una imagen como B.</translation>
    </message>
    <message>
        <source>The reference that A is compared with.</source>
        <translation>La referencia con la que se compara A.</translation>
    </message>
    <message>
        <source>Open a second image to compare with.</source>
        <translation>Abra una segunda imagen con la que comparar.</translation>
    </message>
    <message>
        <source>Next layer</source>
        <translation>Capa siguiente</translation>
    </message>
    <message>
        <source>Show the next layer of the image.</source>
        <translation>Muestra la capa siguiente de la imagen.</translation>
    </message>
    <message>
        <source>Previous layer</source>
        <translation>Capa anterior</translation>
    </message>
    <message>
        <source>Show the previous layer of the image.</source>
        <translation>Muestra la capa anterior de la imagen.</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Capa</translation>
    </message>
    <message>
        <source>image</source>
        <translation>imagen</translation>
    </message>
    <message>
        <source>The layer of A and B that is shown. Keys L and Shift+L.</source>
        <translation>La capa de A y de B que se muestra. Teclas L y Shift+L.</translation>
    </message>
    <message>
        <source>Image A has no layers: the render option BPT_Layers adds them to an exr.</source>
        <translation>La imagen A no tiene capas: la opción de render BPT_Layers las añade a un exr.</translation>
    </message>
</context>
<context>
    <name>editor::ImageWindow</name>
    <message>
        <source>Images - wannabe</source>
        <translation>Imágenes - wannabe</translation>
    </message>
    <message>
        <source>Listening for renders with BPT_DisplayWindow on %1.</source>
        <translation>A la espera de renders con BPT_DisplayWindow en %1.</translation>
    </message>
    <message>
        <source>Cannot listen for renders on %1: %2.</source>
        <translation>No se pueden recibir renders en %1: %2.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cierra esta ventana</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
</context>
<context>
    <name>editor::ImportDialog</name>
    <message>
        <source>1 face</source>
        <translation>1 cara</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 caras</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 m, %4</source>
        <translation>%1 × %2 × %3 m, %4</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>Do not show &amp;again for .%1 files</source>
        <translation>No volver a &amp;mostrar para archivos .%1</translation>
    </message>
    <message>
        <source>Do not show again</source>
        <translation>No volver a mostrar</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importar</translation>
    </message>
    <message>
        <source>Picture of the model</source>
        <translation>Imagen del modelo</translation>
    </message>
    <message>
        <source>Resulting size</source>
        <translation>Tamaño resultante</translation>
    </message>
    <message>
        <source>Size of the imported model along x, y and z, with y up</source>
        <translation>Tamaño del modelo importado según x, y y z, con y hacia arriba</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>Eje vertical</translation>
    </message>
    <message>
        <source>The axis of the file that points up; it becomes y</source>
        <translation>El eje del archivo que apunta hacia arriba; pasa a ser y</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>The unit of the file&apos;s lengths; they become metres</source>
        <translation>La unidad de las longitudes del archivo; pasan a metros</translation>
    </message>
    <message>
        <source>&amp;Up axis</source>
        <translation>Eje &amp;vertical</translation>
    </message>
    <message>
        <source>Uni&amp;t</source>
        <translation>&amp;Unidad</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normales</translation>
    </message>
    <message>
        <source>Vertex normals: those of the file, smooth ones, or none</source>
        <translation>Normales de los vértices: las del archivo, suaves, o ninguna</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>del archivo</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>suaves</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>planas</translation>
    </message>
    <message>
        <source>Crease angle</source>
        <translation>Ángulo de arista</translation>
    </message>
    <message>
        <source>Edges over this angle stay sharp.</source>
        <translation>Las aristas por encima de este ángulo quedan vivas.</translation>
    </message>
    <message>
        <source>&amp;Weld</source>
        <translation>&amp;Soldar</translation>
    </message>
    <message>
        <source>Merge vertices that are closer than the tolerance</source>
        <translation>Une los vértices que están más cerca que la tolerancia</translation>
    </message>
    <message>
        <source>Weld tolerance</source>
        <translation>Tolerancia al soldar</translation>
    </message>
    <message>
        <source>In the unit of the file; 0 merges equal positions.</source>
        <translation>En la unidad del archivo; 0 une posiciones iguales.</translation>
    </message>
    <message>
        <source>&amp;Decimate to %</source>
        <translation>&amp;Diezmar al %</translation>
    </message>
    <message>
        <source>Reduce the triangles to about this percentage</source>
        <translation>Reduce los triángulos a este porcentaje, aproximadamente</translation>
    </message>
    <message>
        <source>Percentage of triangles</source>
        <translation>Porcentaje de triángulos</translation>
    </message>
    <message>
        <source>Percentage to keep.</source>
        <translation>Porcentaje que se conserva.</translation>
    </message>
    <message>
        <source>&amp;Normals</source>
        <translation>Norma&amp;les</translation>
    </message>
    <message>
        <source>BRDF</source>
        <translation>BRDF</translation>
    </message>
    <message>
        <source>BRDF for faces without a material, such as ward sx=0.15 ks=0.3 kd=0.2</source>
        <translation>BRDF para las caras sin material, como ward sx=0.15 ks=0.3 kd=0.2</translation>
    </message>
    <message>
        <source>&amp;BRDF</source>
        <translation>&amp;BRDF</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objetos</translation>
    </message>
    <message>
        <source>The objects to import, with their numbers of faces</source>
        <translation>Los objetos que se importan, con su número de caras</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>&amp;Objetos</translation>
    </message>
    <message>
        <source>Import with these options at once; File &gt; Append with options shows them again</source>
        <translation>Importa directamente con estas opciones; Archivo &gt; Añadir con opciones las muestra de nuevo</translation>
    </message>
</context>
<context>
    <name>editor::IrradianceBake</name>
    <message>
        <source>irradiance is already being baked: stop that first</source>
        <translation>ya se está precalculando la irradiancia: deténgalo antes</translation>
    </message>
    <message>
        <source>stopped before any irradiance was computed</source>
        <translation>detenido antes de calcular ninguna irradiancia</translation>
    </message>
</context>
<context>
    <name>editor::Job</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Remove this job from the queue</source>
        <translation>Quitar este trabajo de la cola</translation>
    </message>
</context>
<context>
    <name>editor::JobPanel</name>
    <message>
        <source>Waiting</source>
        <translation>En espera</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marcha</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 · %2 left</source>
        <translation>%1 · quedan %2</translation>
    </message>
    <message>
        <source>Progress of %1</source>
        <translation>Progreso de %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cancel %1</source>
        <translation>Cancelar %1</translation>
    </message>
    <message>
        <source>No jobs are running. Imports, saves, renders and other long tasks appear here</source>
        <translation>No hay trabajos en marcha. Las importaciones, el guardado, los renders y otras tareas largas aparecen aquí</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Trabajos</translation>
    </message>
    <message>
        <source>Running and queued jobs</source>
        <translation>Trabajos en marcha y en cola</translation>
    </message>
</context>
<context>
    <name>editor::LampForm</name>
    <message>
        <source>Set light: %1</source>
        <translation>Ajustar la luz: %1</translation>
    </message>
    <message>
        <source>centre of the light in world space</source>
        <translation>centro de la luz en el espacio de la escena</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Position, x</source>
        <translation>Posición, x</translation>
    </message>
    <message>
        <source>x: %1</source>
        <translation>x: %1</translation>
    </message>
    <message>
        <source>Position, y</source>
        <translation>Posición, y</translation>
    </message>
    <message>
        <source>y, upwards: %1</source>
        <translation>y, hacia arriba: %1</translation>
    </message>
    <message>
        <source>Position, z</source>
        <translation>Posición, z</translation>
    </message>
    <message>
        <source>z: %1</source>
        <translation>z: %1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Guiñada</translation>
    </message>
    <message>
        <source>Yaw of the direction of emission about +y, counter-clockwise seen from above: 0 is toward -z, 90 toward -x</source>
        <translation>Guiñada de la dirección de emisión alrededor de +y, en sentido antihorario vista desde arriba: 0 es hacia -z, 90 hacia -x</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevación</translation>
    </message>
    <message>
        <source>Elevation of the direction of emission above the horizon: -90 is straight down, 90 straight up</source>
        <translation>Elevación de la dirección de emisión sobre el horizonte: -90 es hacia abajo en vertical, 90 hacia arriba</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Alabeo</translation>
    </message>
    <message>
        <source>Roll about the direction of emission; at 0 the width is horizontal</source>
        <translation>Alabeo alrededor de la dirección de emisión; con 0 el ancho es horizontal</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Width of the rectangle, edge 1 of the area light</source>
        <translation>Ancho del rectángulo, la arista 1 de la luz de área</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Height of the rectangle, edge 2 of the area light</source>
        <translation>Alto del rectángulo, la arista 2 de la luz de área</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Radius of disc or sphere</source>
        <translation>Radio del disco o de la esfera</translation>
    </message>
    <message>
        <source>Radiance</source>
        <translation>Radiancia</translation>
    </message>
    <message>
        <source>emitted radiance, W/(sr m²)</source>
        <translation>radiancia emitida, W/(sr m²)</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Potencia</translation>
    </message>
    <message>
        <source>Emitted power: π × area × mean of the radiance&apos;s RGB values</source>
        <translation>Potencia emitida: π × área × media de los valores RGB de la radiancia</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>Colour temperature</source>
        <translation>Temperatura de color</translation>
    </message>
    <message>
        <source>Colour temperature: sets the radiance to the colour of a black body, with the same power. Candles have 1900 K, halogen lamps 3000 K, daylight 6500 K</source>
        <translation>Temperatura de color: da a la radiancia el color de un cuerpo negro, con la misma potencia. Las velas tienen 1900 K, las lámparas halógenas 3000 K, la luz de día 6500 K</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatura</translation>
    </message>
    <message>
        <source>Set light radiance</source>
        <translation>Cambiar la radiancia de la luz</translation>
    </message>
    <message>
        <source>Set light power</source>
        <translation>Cambiar la potencia de la luz</translation>
    </message>
    <message>
        <source>Set light colour temperature</source>
        <translation>Cambiar la temperatura de color de la luz</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Apuntar</translation>
    </message>
    <message>
        <source>Turn the light toward the point that is clicked next in the 3D view; Escape cancels</source>
        <translation>Gira la luz hacia el punto en el que se haga clic en la vista 3D; Escape cancela</translation>
    </message>
    <message>
        <source>Highlight</source>
        <translation>Reflejo</translation>
    </message>
    <message>
        <source>Place the light, at its distance, so that its reflection is where you click or drag in the 3D view; Escape cancels</source>
        <translation>Coloca la luz, a su distancia, de modo que su reflejo esté donde haga clic o arrastre en la vista 3D; Escape cancela</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
</context>
<context>
    <name>editor::LayersEditor</name>
    <message>
        <source>BRDF of the layer %1</source>
        <translation>BRDF de la capa %1</translation>
    </message>
    <message>
        <source>choose a BRDF</source>
        <translation>elija una BRDF</translation>
    </message>
    <message>
        <source>Define named BRDFs in the scene first: layers refer to those.</source>
        <translation>Defina antes BRDF con nombre en la escena: las capas se refieren a ellas.</translation>
    </message>
</context>
<context>
    <name>editor::LessonGuide</name>
    <message>
        <source>Look around</source>
        <translation>Mirar alrededor</translation>
    </message>
    <message>
        <source>Orbit, zoom, select faces and see what they are made of</source>
        <translation>Orbitar, acercarse, seleccionar caras y ver de qué están hechas</translation>
    </message>
    <message>
        <source>Drag with the middle mouse button to orbit, with Shift to pan. The arrow keys do the same.</source>
        <translation>Arrastre con el botón central del ratón para orbitar, con Mayús para desplazar la vista. Las flechas hacen lo mismo.</translation>
    </message>
    <message>
        <source>Turn the wheel to zoom about the pointer. The keys + and - zoom, too.</source>
        <translation>Gire la rueda para acercarse al puntero o alejarse de él. Las teclas + y - también lo hacen.</translation>
    </message>
    <message>
        <source>Click a face of the model to select it. A drag from a face selects all faces in a box; Shift adds, Ctrl removes.</source>
        <translation>Haga clic en una cara del modelo para seleccionarla. Arrastrar desde una cara selecciona todas las de un rectángulo; Mayús añade, Ctrl quita.</translation>
    </message>
    <message>
        <source>This is the surface of the selected faces: BRDF, colour, texture, emitted light and normals. Point at a field to read what it means, then press Next.</source>
        <translation>Esta es la superficie de las caras seleccionadas: BRDF, color, textura, luz emitida y normales. Señale un campo para leer qué significa, y pulse Siguiente.</translation>
    </message>
    <message>
        <source>Press F in the view to frame the selected faces, and Home to frame the whole scene.</source>
        <translation>Pulse F en la vista para encuadrar las caras seleccionadas, e Inicio para encuadrar toda la escena.</translation>
    </message>
    <message>
        <source>Change a material</source>
        <translation>Cambiar un material</translation>
    </message>
    <message>
        <source>Give faces another BRDF, adjust its parameters, and take it back</source>
        <translation>Dar otra BRDF a las caras, ajustar sus parámetros y deshacerlo</translation>
    </message>
    <message>
        <source>Click a face in the view.</source>
        <translation>Haga clic en una cara de la vista.</translation>
    </message>
    <message>
        <source>Press Ctrl+M to select the whole mesh: the menu Select has this and many other ways to select.</source>
        <translation>Pulse Ctrl+M para seleccionar toda la malla: el menú Selección tiene esta y muchas otras formas de seleccionar.</translation>
    </message>
    <message>
        <source>Open Library in the BRDF dock, and double-click a BRDF to assign it to the selected faces.</source>
        <translation>Abra Biblioteca en el panel BRDF y haga doble clic en una BRDF para asignarla a las caras seleccionadas.</translation>
    </message>
    <message>
        <source>Drag a slider of the BRDF&apos;s parameters. The sphere, the lobe, the plots and the view follow it.</source>
        <translation>Arrastre el control deslizante de un parámetro de la BRDF. La esfera, el lóbulo, las gráficas y la vista lo siguen.</translation>
    </message>
    <message>
        <source>Press Ctrl+Z to undo the last change. The History dock lists all of them.</source>
        <translation>Pulse Ctrl+Z para deshacer el último cambio. El panel Historial los muestra todos.</translation>
    </message>
    <message>
        <source>Light a scene</source>
        <translation>Iluminar una escena</translation>
    </message>
    <message>
        <source>Add a shape and a studio, and watch the path-traced preview while a light moves</source>
        <translation>Añadir una forma y un estudio, y ver la vista previa por trazado de caminos mientras se cambia una luz</translation>
    </message>
    <message>
        <source>Choose Scene &gt; Add a sphere. A model that is dropped on the window will do, too.</source>
        <translation>Elija Escena &gt; Añadir una esfera. También sirve un modelo que se suelte en la ventana.</translation>
    </message>
    <message>
        <source>Choose Scene &gt; Add a studio: a floor, a soft box and a rim light in proportion to what is there.</source>
        <translation>Elija Escena &gt; Añadir un estudio: un suelo, una luz suave y una luz de contorno en proporción a lo que hay.</translation>
    </message>
    <message>
        <source>Press F5 to start the preview, which follows each edit.</source>
        <translation>Pulse F5 para iniciar la vista previa, que sigue cada cambio.</translation>
    </message>
    <message>
        <source>Select a light in the list, and change its power, its size or where it is. Aim points it at what you click.</source>
        <translation>Seleccione una luz de la lista y cambie su potencia, su tamaño o su posición. Apuntar la dirige a lo que se señale con un clic.</translation>
    </message>
    <message>
        <source>Render as accurately as you need</source>
        <translation>Renderizar con la precisión necesaria</translation>
    </message>
    <message>
        <source>Know what an error costs in time before the render, and choose one</source>
        <translation>Saber antes del render cuánto tiempo cuesta un error, y elegir uno</translation>
    </message>
    <message>
        <source>Save the scene in a folder of your own by File &gt; Save as: the image is written beside it.</source>
        <translation>Guarde la escena en una carpeta suya con Archivo &gt; Guardar como: la imagen se escribe junto a ella.</translation>
    </message>
    <message>
        <source>The Render dock forecasts how long the image takes until its error is 5, 2 or 1 %, from a short probe. Wait until the times are there, and click one of them to take it as the target.</source>
        <translation>El panel Render predice, con una prueba corta, cuánto tarda la imagen en llegar a un error del 5, el 2 o el 1 %. Espere a que aparezcan los tiempos y haga clic en uno para tomarlo como objetivo.</translation>
    </message>
    <message>
        <source>Press F6 to render. The dock shows the estimated error, and the image so far.</source>
        <translation>Pulse F6 para renderizar. El panel muestra el error estimado y la imagen hasta el momento.</translation>
    </message>
    <message>
        <source>Open Images by Ctrl+7 to see the image, its error and its layers, and to compare it with the render before.</source>
        <translation>Abra Imágenes con Ctrl+7 para ver la imagen, su error y sus capas, y para compararla con el render anterior.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Atrás</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Siguiente</translation>
    </message>
    <message>
        <source>&amp;Close lesson</source>
        <translation>&amp;Cerrar la lección</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
    <message>
        <source>What to do in this step of the lesson</source>
        <translation>Qué hacer en este paso de la lección</translation>
    </message>
    <message>
        <source>Go to the step before</source>
        <translation>Vuelve al paso anterior</translation>
    </message>
    <message>
        <source>Go to the next step without doing this one</source>
        <translation>Pasa al paso siguiente sin hacer este</translation>
    </message>
    <message>
        <source>End the lesson; what was done stays</source>
        <translation>Termina la lección; lo que se hizo se conserva</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1: hecho</translation>
    </message>
    <message>
        <source>Help &gt; Welcome has the other lessons, and F1 lists all shortcuts.</source>
        <translation>Ayuda &gt; Bienvenida tiene las otras lecciones, y F1 muestra todos los atajos.</translation>
    </message>
    <message>
        <source>%1: step %2 of %3</source>
        <translation>%1: paso %2 de %3</translation>
    </message>
</context>
<context>
    <name>editor::LibraryList</name>
    <message>
        <source>BRDFs of the library</source>
        <translation>BRDF de la biblioteca</translation>
    </message>
    <message>
        <source>Double-click, press Return or drag to assign a BRDF to the selected faces</source>
        <translation>Haga doble clic, pulse Intro o arrastre para asignar una BRDF a las caras seleccionadas</translation>
    </message>
</context>
<context>
    <name>editor::LightController</name>
    <message>
        <source>The scene has no lights. Until it has one, renders use a grey sky.</source>
        <translation>La escena no tiene luces. Hasta que tenga una, los renders usan un cielo gris.</translation>
    </message>
    <message>
        <source>Add a light</source>
        <translation>Añadir una luz</translation>
    </message>
    <message>
        <source>Add an area light above the scene</source>
        <translation>Añade una luz de área sobre la escena</translation>
    </message>
    <message>
        <source>Add a studio</source>
        <translation>Añadir un estudio</translation>
    </message>
    <message>
        <source>Add a floor, a soft box and a rim light in proportion to the scene</source>
        <translation>Añade un suelo, una ventana de luz y una luz de contorno en proporción a la escena</translation>
    </message>
    <message>
        <source>The model has no lights, so a studio was added to the scene: a floor, a soft box and a rim light.</source>
        <translation>El modelo no tiene luces, así que se ha añadido un estudio a la escena: un suelo, una ventana de luz y una luz de contorno.</translation>
    </message>
    <message>
        <source>Without the studio</source>
        <translation>Sin el estudio</translation>
    </message>
    <message>
        <source>Remove the studio, and render under a grey sky</source>
        <translation>Quita el estudio y renderiza bajo un cielo gris</translation>
    </message>
    <message>
        <source>Click what the light shall shine on, or press Escape to cancel</source>
        <translation>Haga clic en lo que la luz deba iluminar, o pulse Escape para cancelar</translation>
    </message>
    <message>
        <source>Aim light</source>
        <translation>Apuntar la luz</translation>
    </message>
    <message>
        <source>Light highlight</source>
        <translation>Iluminar un reflejo</translation>
    </message>
    <message>
        <source>Click or drag where the light&apos;s reflection shall be, or press Escape to cancel</source>
        <translation>Haga clic o arrastre donde deba estar el reflejo de la luz, o pulse Escape para cancelar</translation>
    </message>
</context>
<context>
    <name>editor::LightPanel</name>
    <message>
        <source>light</source>
        <translation>claro</translation>
    </message>
    <message>
        <source>mesh light</source>
        <translation>malla emisora</translation>
    </message>
    <message>
        <source>faces of a mesh</source>
        <translation>caras de una malla</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Luces</translation>
    </message>
    <message>
        <source>Lights of the scene</source>
        <translation>Luces de la escena</translation>
    </message>
    <message>
        <source>All emitters, with their world-space area and their emitted power</source>
        <translation>Todos los emisores, con su área en el espacio de la escena y su potencia emitida</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>Area, m²</source>
        <translation>Área, m²</translation>
    </message>
    <message>
        <source>Power, W</source>
        <translation>Potencia, W</translation>
    </message>
    <message>
        <source>Add a light</source>
        <translation>Añadir una luz</translation>
    </message>
    <message>
        <source>Add a rectangular light above the scene, facing down; the arrow has discs and spheres</source>
        <translation>Añade una luz rectangular sobre la escena, hacia abajo; la flecha tiene discos y esferas</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>&amp;Rectángulo</translation>
    </message>
    <message>
        <source>Add a rectangular light above the scene, facing down</source>
        <translation>Añade una luz rectangular sobre la escena, hacia abajo</translation>
    </message>
    <message>
        <source>&amp;Disc</source>
        <translation>&amp;Disco</translation>
    </message>
    <message>
        <source>Add a disc above the scene, facing down: a mesh light</source>
        <translation>Añade un disco sobre la escena, hacia abajo: una malla emisora</translation>
    </message>
    <message>
        <source>&amp;Sphere</source>
        <translation>&amp;Esfera</translation>
    </message>
    <message>
        <source>Add a spherical light above the scene: a mesh light</source>
        <translation>Añade una luz esférica sobre la escena: una malla emisora</translation>
    </message>
    <message>
        <source>Delete the light</source>
        <translation>Eliminar la luz</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Esquina</translation>
    </message>
    <message>
        <source>Edge 1</source>
        <translation>Arista 1</translation>
    </message>
    <message>
        <source>Edge 2</source>
        <translation>Arista 2</translation>
    </message>
    <message>
        <source>a corner of the light, in the local space of its transform</source>
        <translation>una esquina de la luz, en el espacio local de su transformación</translation>
    </message>
    <message>
        <source>edge vector from the corner; the light emits along its normal, edge 1 × edge 2</source>
        <translation>vector de arista desde la esquina; la luz emite según su normal, arista 1 × arista 2</translation>
    </message>
    <message>
        <source>the other edge vector from the corner</source>
        <translation>el otro vector de arista desde la esquina</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Move light</source>
        <translation>Mover la luz</translation>
    </message>
    <message>
        <source>Select a light first; emission of faces is edited in the Surface dock.</source>
        <translation>Seleccione antes una luz; la emisión de las caras se edita en el panel Superficie.</translation>
    </message>
    <message>
        <source>The scene has no lights.

Add an area light with +, or select faces and set their emission in the Surface dock.</source>
        <translation>La escena no tiene luces.

Añada una luz de área con +, o seleccione caras y dé un valor a su emisión en el panel Superficie.</translation>
    </message>
    <message>
        <source>Select a light to edit it, or add one.</source>
        <translation>Seleccione una luz para editarla, o añada una.</translation>
    </message>
    <message>
        <source>One face of a mesh emits. It is selected: edit its emission in the Surface dock.</source>
        <translation>Emite una cara de una malla. Está seleccionada: edite su emisión en el panel Superficie.</translation>
    </message>
    <message>
        <source>%1 faces of a mesh emit. They are selected: edit their emission in the Surface dock.</source>
        <translation>Emiten %1 caras de una malla. Están seleccionadas: edite su emisión en el panel Superficie.</translation>
    </message>
    <message>
        <source>Add light</source>
        <translation>Añadir una luz</translation>
    </message>
    <message>
        <source>Delete light</source>
        <translation>Eliminar la luz</translation>
    </message>
</context>
<context>
    <name>editor::LiveSphere</name>
    <message>
        <source>Sphere with the BRDF</source>
        <translation>Esfera con la BRDF</translation>
    </message>
    <message>
        <source>Drag the highlight to move the light, or use the arrow keys; + and - change the exposure</source>
        <translation>Arrastre el brillo para mover la luz, o use las flechas; + y - cambian la exposición</translation>
    </message>
</context>
<context>
    <name>editor::LobeView</name>
    <message>
        <source>Lobe of the BRDF</source>
        <translation>Lóbulo de la BRDF</translation>
    </message>
    <message>
        <source>3D lobe: the value in 1/sr for all light directions. Drag or use the arrow keys to orbit, the wheel to zoom; Page Up and Page Down change the view angle by 5 degrees</source>
        <translation>Lóbulo 3D: el valor en 1/sr para todas las direcciones de la luz. Arrastre o use las flechas para orbitar, la rueda para acercar; Re Pág y Av Pág cambian el ángulo de la vista 5 grados</translation>
    </message>
    <message>
        <source>view</source>
        <translation>vista</translation>
    </message>
    <message>
        <source>specular</source>
        <translation>especular</translation>
    </message>
    <message>
        <source>half</source>
        <translation>media</translation>
    </message>
    <message>
        <source>%1: maximum %2 1/sr, view %3°</source>
        <translation>%1: máximo %2 1/sr, vista %3°</translation>
    </message>
    <message>
        <source>, specular part %1</source>
        <translation>, parte especular %1</translation>
    </message>
</context>
<context>
    <name>editor::MainWindow</name>
    <message>
        <source>Open a scene or a model, or drop one here</source>
        <translation>Abra una escena o un modelo, o suelte uno aquí</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>Scene outliner: objects, lights and definitions</source>
        <translation>Árbol de la escena: objetos, luces y definiciones</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Luces</translation>
    </message>
    <message>
        <source>Area lights, mesh lights and emissive faces of the scene</source>
        <translation>Luces de área, mallas emisoras y caras emisoras de la escena</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Position, rotation and scale of the selected object</source>
        <translation>Posición, rotación y escala del objeto seleccionado</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Cameras of the scene: position, lens and focus</source>
        <translation>Cámaras de la escena: posición, objetivo y enfoque</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Surface of the selected faces: BRDF, colour, texture, emission, normals</source>
        <translation>Superficie de las caras seleccionadas: BRDF, color, textura, emisión, normales</translation>
    </message>
    <message>
        <source>BRDF</source>
        <translation>BRDF</translation>
    </message>
    <message>
        <source>BRDF of the selected faces: parameters such as roughness, lobe, plots and sphere</source>
        <translation>BRDF de las caras seleccionadas: parámetros como la rugosidad, lóbulo, gráficas y esfera</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>Render</translation>
    </message>
    <message>
        <source>Previews and renders of the scene</source>
        <translation>Vistas previas y renders de la escena</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
    <message>
        <source>Errors and warnings about the scene and its file</source>
        <translation>Errores y avisos sobre la escena y su archivo</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Trabajos</translation>
    </message>
    <message>
        <source>Running and queued jobs, such as imports and renders</source>
        <translation>Trabajos en marcha y en cola, como importaciones y renders</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Abierto</translation>
    </message>
    <message>
        <source>Undo steps</source>
        <translation>Pasos de deshacer</translation>
    </message>
    <message>
        <source>All undo steps; a click goes back or forth to a step</source>
        <translation>Todos los pasos de deshacer; un clic va atrás o adelante hasta un paso</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>The undo steps, to go back to any of them</source>
        <translation>Los pasos de deshacer, para volver a cualquiera de ellos</translation>
    </message>
    <message>
        <source>Jobs (%1)</source>
        <translation>Trabajos (%1)</translation>
    </message>
    <message>
        <source>Click where the object shall stand, or press Escape to cancel</source>
        <translation>Haga clic donde deba estar el objeto, o pulse Escape para cancelar</translation>
    </message>
    <message>
        <source>Click the face to copy the surface from, or press Escape to cancel</source>
        <translation>Haga clic en la cara de la que copiar la superficie, o pulse Escape para cancelar</translation>
    </message>
    <message>
        <source>Click what the camera shall focus on, or press Escape to cancel</source>
        <translation>Haga clic en lo que la cámara deba enfocar, o pulse Escape para cancelar</translation>
    </message>
    <message>
        <source>Messages (%1)</source>
        <translation>Mensajes (%1)</translation>
    </message>
    <message>
        <source>%1 differs from the current render settings. Saving the scene writes it, too.</source>
        <translation>%1 difiere de los ajustes de render actuales. Al guardar la escena también se escribe.</translation>
    </message>
    <message>
        <source>Write now</source>
        <translation>Escribir ahora</translation>
    </message>
    <message>
        <source>Write the current render settings to the file; its comments are kept</source>
        <translation>Escribe los ajustes de render actuales en el archivo; sus comentarios se conservan</translation>
    </message>
    <message>
        <source>Another program has changed %1.</source>
        <translation>Otro programa ha cambiado %1.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Reload the scene; asks first if there are unsaved changes</source>
        <translation>Recarga la escena; antes pregunta si hay cambios sin guardar</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Compare the scene with its file, line by line</source>
        <translation>Compara la escena con su archivo, línea por línea</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Conservar la mía</translation>
    </message>
    <message>
        <source>Keep the scene as it is here; saving overwrites the file</source>
        <translation>Conserva la escena como está aquí; guardar sobrescribe el archivo</translation>
    </message>
    <message>
        <source>%1[*] - wannabe</source>
        <translation>%1[*] - wannabe</translation>
    </message>
    <message>
        <source>List all errors and warnings, each with its line</source>
        <translation>Enumera todos los errores y avisos, cada uno con su línea</translation>
    </message>
    <message>
        <source>Tabbed docks</source>
        <translation>Paneles en pestañas</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>A render is running.</source>
        <translation>Hay un render en marcha.</translation>
    </message>
    <message>
        <source>Irradiance is being baked.</source>
        <translation>Se está precalculando la irradiancia.</translation>
    </message>
    <message>
        <source>Closing stops it and keeps the image so far.</source>
        <translation>Cerrar lo detiene y conserva la imagen hasta ahora.</translation>
    </message>
    <message>
        <source>Closing cancels it.</source>
        <translation>Cerrar lo cancela.</translation>
    </message>
    <message numerus="yes">
        <source>%n other job(s) are cancelled.</source>
        <translation>
            <numerusform>Se cancela %n trabajo más.</numerusform>
            <numerusform>Se cancelan otros %n trabajos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Selección</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>Ob&amp;ject</source>
        <translation>Ob&amp;jeto</translation>
    </message>
    <message>
        <source>&amp;Render</source>
        <translation>&amp;Render</translation>
    </message>
    <message>
        <source>&amp;Image</source>
        <translation>&amp;Imagen</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Cierra la ventana</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edición</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Deshace el último cambio</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>Rehace el último cambio deshecho</translation>
    </message>
    <message>
        <source>&amp;Find action</source>
        <translation>&amp;Buscar una acción</translation>
    </message>
    <message>
        <source>Search all actions by name, and run one</source>
        <translation>Busca en todas las acciones por su nombre y ejecuta una</translation>
    </message>
    <message>
        <source>S&amp;cene</source>
        <translation>Es&amp;cena</translation>
    </message>
    <message>
        <source>Add a &amp;light</source>
        <translation>Añadir una &amp;luz</translation>
    </message>
    <message>
        <source>Add a square area light above the scene, facing down</source>
        <translation>Añade una luz de área cuadrada sobre la escena, hacia abajo</translation>
    </message>
    <message>
        <source>Add an &amp;observer</source>
        <translation>Añadir un &amp;observador</translation>
    </message>
    <message>
        <source>Add an observer at the viewpoint of the 3D view</source>
        <translation>Añade un observador en el punto de vista de la vista 3D</translation>
    </message>
    <message>
        <source>Bake the irradiance at all vertices and store it in the scene</source>
        <translation>Precalcula la irradiancia en todos los vértices y la guarda en la escena</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Ven&amp;tana</translation>
    </message>
    <message>
        <source>&amp;Images</source>
        <translation>&amp;Imágenes</translation>
    </message>
    <message>
        <source>Show the image view</source>
        <translation>Muestra la vista de imágenes</translation>
    </message>
    <message>
        <source>3D &amp;view</source>
        <translation>&amp;Vista 3D</translation>
    </message>
    <message>
        <source>Go to the 3D view</source>
        <translation>Va a la vista 3D</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Restablecer la disposición</translation>
    </message>
    <message>
        <source>Restore the default layout of the docks</source>
        <translation>Restablece la disposición por defecto de los paneles</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Herramientas</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Atajos de teclado</translation>
    </message>
    <message>
        <source>List and search all shortcuts</source>
        <translation>Enumera todos los atajos y busca en ellos</translation>
    </message>
    <message>
        <source>&amp;About wannabe</source>
        <translation>A&amp;cerca de wannabe</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Versión y licencia</translation>
    </message>
    <message>
        <source>wannabe %1, the scene editor of Granada. Its sources are under Apache-2.0; the program contains QCustomPlot and is under GPL-3.0. It uses Qt %2 (LGPL-3.0). All libraries with their licences: share/doc/granada-wannabe/sbom.spdx.json.</source>
        <translation>wannabe %1, el editor de escenas de Granada. Su código está bajo Apache-2.0; el programa contiene QCustomPlot y está bajo GPL-3.0. Usa Qt %2 (LGPL-3.0). Todas las bibliotecas con sus licencias: share/doc/granada-wannabe/sbom.spdx.json.</translation>
    </message>
    <message>
        <source>Language, theme, units, shortcuts, undo, threads, autosave</source>
        <translation>Idioma, tema, unidades, atajos, deshacer, hilos, autoguardado</translation>
    </message>
    <message>
        <source>Pr&amp;eferences</source>
        <translation>Pre&amp;ferencias</translation>
    </message>
    <message>
        <source>UV</source>
        <translation>UV</translation>
    </message>
    <message>
        <source>Texture coordinates (UVs) of the selected faces, over their image</source>
        <translation>Coordenadas de textura (UV) de las caras seleccionadas, sobre su imagen</translation>
    </message>
    <message>
        <source>Te&amp;xture coordinates</source>
        <translation>Coordenadas de te&amp;xtura</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>List what can make the image wrong or noisy, and repair it: lamps in solids, flipped normals, duplicates, values that are not finite</source>
        <translation>Lista lo que puede hacer que la imagen sea incorrecta o ruidosa, y lo repara: lámparas dentro de sólidos, normales invertidas, duplicados, valores no finitos</translation>
    </message>
    <message>
        <source>Ba&amp;ke irradiance</source>
        <translation>P&amp;recalcular la irradiancia</translation>
    </message>
    <message>
        <source>&amp;Cost</source>
        <translation>&amp;Coste</translation>
    </message>
    <message>
        <source>Compare sampling schemes and integrators by their error over time</source>
        <translation>Comparar esquemas de muestreo e integradores por su error frente al tiempo</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Coste</translation>
    </message>
    <message>
        <source>Error over render time of schemes and integrators</source>
        <translation>Error frente al tiempo de render de esquemas e integradores</translation>
    </message>
    <message>
        <source>C&amp;heck...</source>
        <translation>Co&amp;mprobar...</translation>
    </message>
</context>
<context>
    <name>editor::MapButton</name>
    <message>
        <source>%1, image</source>
        <translation>%1, imagen</translation>
    </message>
    <message>
        <source>Choose an image...</source>
        <translation>Elegir una imagen...</translation>
    </message>
    <message>
        <source>Remove the image</source>
        <translation>Quitar la imagen</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Red channel</source>
        <translation>Canal rojo</translation>
    </message>
    <message>
        <source>Green channel</source>
        <translation>Canal verde</translation>
    </message>
    <message>
        <source>Blue channel</source>
        <translation>Canal azul</translation>
    </message>
    <message>
        <source>Alpha channel</source>
        <translation>Canal alfa</translation>
    </message>
    <message>
        <source>The images of %1 are mixed</source>
        <translation>Las imágenes de %1 son distintas</translation>
    </message>
    <message>
        <source>Vary %1 over the faces by an image: choose it, or drop it on the row</source>
        <translation>Variar %1 sobre las caras con una imagen: elíjala o suéltela en la fila</translation>
    </message>
    <message>
        <source>Image of %1</source>
        <translation>Imagen de %1</translation>
    </message>
    <message>
        <source>Images (%1);;All files (*)</source>
        <translation>Imágenes (%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>%1 varies by the image %2, times the number, in previews and renders</source>
        <translation>%1 varía según la imagen %2, por el número, en las vistas previas y los renders</translation>
    </message>
    <message>
        <source>Choose the file of an image that varies %1 over the faces</source>
        <translation>Elegir el archivo de una imagen que varía %1 sobre las caras</translation>
    </message>
    <message>
        <source>All faces have the number of %1 again</source>
        <translation>Todas las caras vuelven a tener el número de %1</translation>
    </message>
    <message>
        <source>%1 varies by the colour of the image, as a texture does</source>
        <translation>%1 varía según el color de la imagen, como una textura</translation>
    </message>
    <message>
        <source>%1 varies by this channel of the image, as its file stores it</source>
        <translation>%1 varía según este canal de la imagen, tal como está en su archivo</translation>
    </message>
</context>
<context>
    <name>editor::MaterialActions</name>
    <message>
        <source>&amp;Copy material</source>
        <translation>&amp;Copiar el material</translation>
    </message>
    <message>
        <source>Copy the surface of the first selected face to the clipboard, as GRF text</source>
        <translation>Copia la superficie de la primera cara seleccionada al portapapeles, como texto GRF</translation>
    </message>
    <message>
        <source>&amp;Paste material</source>
        <translation>&amp;Pegar el material</translation>
    </message>
    <message>
        <source>Give the selected faces the material on the clipboard</source>
        <translation>Da a las caras seleccionadas el material del portapapeles</translation>
    </message>
    <message>
        <source>The material is on the clipboard</source>
        <translation>El material está en el portapapeles</translation>
    </message>
    <message>
        <source>The clipboard has no material. %1</source>
        <translation>No hay ningún material en el portapapeles. %1</translation>
    </message>
    <message>
        <source>Paste material</source>
        <translation>Pegar el material</translation>
    </message>
</context>
<context>
    <name>editor::MeshActions</name>
    <message>
        <source>of the selected faces, or of all if none is selected. Faces keep their BRDFs and colours</source>
        <translation>de las caras seleccionadas, o todas si no hay ninguna seleccionada. Las caras conservan sus BRDF y colores</translation>
    </message>
    <message>
        <source>&amp;Delete faces</source>
        <translation>&amp;Eliminar las caras</translation>
    </message>
    <message>
        <source>Delete the selected faces, and meshes that have no faces left</source>
        <translation>Elimina las caras seleccionadas, y las mallas que quedan sin caras</translation>
    </message>
    <message>
        <source>Subdivide (&amp;Catmull-Clark)</source>
        <translation>Subdividir (C&amp;atmull-Clark)</translation>
    </message>
    <message>
        <source>Subdivide the meshes %1; a face with n corners becomes n quads</source>
        <translation>Subdivide las mallas %1; una cara con n esquinas pasa a ser n cuadriláteros</translation>
    </message>
    <message>
        <source>Subdivide the meshes %1; they are triangulated, and each triangle becomes four</source>
        <translation>Subdivide las mallas %1; se triangulan, y cada triángulo pasa a ser cuatro</translation>
    </message>
    <message>
        <source>Smooth noise and small features of the meshes %1</source>
        <translation>Suaviza el ruido y los detalles pequeños de las mallas %1</translation>
    </message>
    <message>
        <source>The scene has no mesh</source>
        <translation>La escena no tiene ninguna malla</translation>
    </message>
    <message>
        <source>Cannot subdivide: the meshes would have %1 faces, too many for the editor. Subdivide the file with grfconvert --subdivide</source>
        <translation>No se puede subdividir: las mallas tendrían %1 caras, demasiadas para el editor. Subdivida el archivo con grfconvert --subdivide</translation>
    </message>
    <message>
        <source>Subdivide</source>
        <translation>Subdividir</translation>
    </message>
    <message>
        <source>Subdivided meshes lost their irradiance: bake it again</source>
        <translation>Las mallas subdivididas han perdido su irradiancia: precalcúlela de nuevo</translation>
    </message>
    <message>
        <source>Smooth vertices</source>
        <translation>Suavizar los vértices</translation>
    </message>
    <message>
        <source>No face is selected</source>
        <translation>No hay ninguna cara seleccionada</translation>
    </message>
    <message>
        <source>Delete faces</source>
        <translation>Eliminar caras</translation>
    </message>
    <message>
        <source>Cancel: the meshes stay as they are</source>
        <translation>Cancela: las mallas quedan como están</translation>
    </message>
    <message>
        <source>%1: meshes that were edited meanwhile were left unchanged</source>
        <translation>%1: las mallas que se editaron entretanto no se han cambiado</translation>
    </message>
    <message>
        <source>&amp;Recalculate outside</source>
        <translation>Recalcular &amp;hacia fuera</translation>
    </message>
    <message>
        <source>Make the normals of the faces agree and point outward, in the meshes %1</source>
        <translation>Hace que las normales de las caras concuerden y apunten hacia fuera, en las mallas %1</translation>
    </message>
    <message>
        <source>Recalculate outside</source>
        <translation>Recalcular hacia fuera</translation>
    </message>
    <message>
        <source>Select &amp;inward faces</source>
        <translation>Seleccionar caras in&amp;vertidas</translation>
    </message>
    <message>
        <source>Select the faces whose normals point inward (flipped normals), in the meshes of the selected faces, or in all if none is selected</source>
        <translation>Selecciona las caras cuyas normales apuntan hacia dentro (normales invertidas), en las mallas de las caras seleccionadas, o en todas si no hay ninguna seleccionada</translation>
    </message>
    <message>
        <source>Project the image onto the selected faces %1</source>
        <translation>Proyecta la imagen sobre las caras seleccionadas %1</translation>
    </message>
    <message>
        <source>Project along the &amp;normal</source>
        <translation>Proyectar según la &amp;normal</translation>
    </message>
    <message>
        <source>along their mean normal</source>
        <translation>según su normal media</translation>
    </message>
    <message>
        <source>Project along &amp;x</source>
        <translation>Proyectar según &amp;x</translation>
    </message>
    <message>
        <source>on a plane, as seen from +x</source>
        <translation>sobre un plano, visto desde +x</translation>
    </message>
    <message>
        <source>Project along &amp;y</source>
        <translation>Proyectar según &amp;y</translation>
    </message>
    <message>
        <source>on a plane, as seen from above</source>
        <translation>sobre un plano, visto desde arriba</translation>
    </message>
    <message>
        <source>Project along &amp;z</source>
        <translation>Proyectar según &amp;z</translation>
    </message>
    <message>
        <source>on a plane, as seen from +z</source>
        <translation>sobre un plano, visto desde +z</translation>
    </message>
    <message>
        <source>Project from a &amp;box</source>
        <translation>Proyectar desde una ca&amp;ja</translation>
    </message>
    <message>
        <source>from the side of a box that is nearest to the normal of each</source>
        <translation>desde el lado de una caja más cercano a la normal de cada una</translation>
    </message>
    <message>
        <source>Project from a &amp;cylinder</source>
        <translation>Proyectar desde un &amp;cilindro</translation>
    </message>
    <message>
        <source>around a vertical cylinder; on caps from above and below</source>
        <translation>alrededor de un cilindro vertical; en las tapas, desde arriba y desde abajo</translation>
    </message>
    <message>
        <source>Project from a &amp;sphere</source>
        <translation>Proyectar desde una &amp;esfera</translation>
    </message>
    <message>
        <source>by longitude and latitude about their centre</source>
        <translation>por longitud y latitud en torno a su centro</translation>
    </message>
    <message>
        <source>&amp;Rotate by 90°</source>
        <translation>&amp;Rotar 90°</translation>
    </message>
    <message>
        <source>Rotate the texture coordinates of the selected faces to the left</source>
        <translation>Rota a la izquierda las coordenadas de textura de las caras seleccionadas</translation>
    </message>
    <message>
        <source>Flip &amp;horizontally</source>
        <translation>Reflejar en &amp;horizontal</translation>
    </message>
    <message>
        <source>Mirror the texture coordinates of the selected faces, left to right</source>
        <translation>Refleja las coordenadas de textura de las caras seleccionadas, de izquierda a derecha</translation>
    </message>
    <message>
        <source>Flip &amp;vertically</source>
        <translation>Reflejar en &amp;vertical</translation>
    </message>
    <message>
        <source>Mirror the texture coordinates of the selected faces, top to bottom</source>
        <translation>Refleja las coordenadas de textura de las caras seleccionadas, de arriba abajo</translation>
    </message>
    <message>
        <source>&amp;Fit to the image</source>
        <translation>Aj&amp;ustar a la imagen</translation>
    </message>
    <message>
        <source>Scale and move the texture coordinates of the selected faces to the whole image</source>
        <translation>Escala y mueve las coordenadas de textura de las caras seleccionadas a toda la imagen</translation>
    </message>
    <message>
        <source>All faces point outward</source>
        <translation>Todas las caras apuntan hacia fuera</translation>
    </message>
    <message>
        <source>Find inward faces</source>
        <translation>Buscar caras invertidas</translation>
    </message>
    <message>
        <source>Cancel: the selection stays as it is</source>
        <translation>Cancelar: la selección queda como está</translation>
    </message>
    <message>
        <source>Subdi&amp;vide (Loop)</source>
        <translation>Su&amp;bdividir (Loop)</translation>
    </message>
    <message>
        <source>S&amp;mooth vertices</source>
        <translation>&amp;Suavizar los vértices</translation>
    </message>
</context>
<context>
    <name>editor::MessageModel</name>
    <message>
        <source>%1
Double-click to go to the line and select its faces</source>
        <translation>%1
Doble clic para ir a la línea y seleccionar sus caras</translation>
    </message>
</context>
<context>
    <name>editor::MessagePanel</name>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
    <message>
        <source>Messages about the scene</source>
        <translation>Mensajes sobre la escena</translation>
    </message>
    <message>
        <source>The scene has no errors or warnings.

Problems are listed here while you edit.</source>
        <translation>La escena no tiene errores ni avisos.

Los problemas aparecen aquí mientras edita.</translation>
    </message>
    <message>
        <source>1 error</source>
        <translation>1 error</translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation>%1 errores</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 aviso</translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation>%1 avisos</translation>
    </message>
</context>
<context>
    <name>editor::ModelImport</name>
    <message>
        <source>%1: the converted file could not be read</source>
        <translation>%1: no se pudo leer el archivo convertido</translation>
    </message>
    <message>
        <source>cannot find the program grfconvert</source>
        <translation>no se encuentra el programa grfconvert</translation>
    </message>
    <message>
        <source>cannot create a folder in %1</source>
        <translation>no se puede crear una carpeta en %1</translation>
    </message>
    <message>
        <source>cannot start grfconvert: %1</source>
        <translation>no se puede iniciar grfconvert: %1</translation>
    </message>
    <message>
        <source>%1: grfconvert crashed</source>
        <translation>%1: grfconvert falló</translation>
    </message>
    <message>
        <source>cannot read %1</source>
        <translation>no se puede leer %1</translation>
    </message>
</context>
<context>
    <name>editor::NoiseText</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Split count</source>
        <translation>Número de ramas</translation>
    </message>
    <message>
        <source>Sampling scheme of all BRDFs</source>
        <translation>Esquema de muestreo de todas las BRDF</translation>
    </message>
    <message>
        <source>Sampler</source>
        <translation>Muestreador</translation>
    </message>
    <message>
        <source>Resampling of the environment</source>
        <translation>Remuestreo del entorno</translation>
    </message>
    <message>
        <source>Adaptive sampling</source>
        <translation>Muestreo adaptativo</translation>
    </message>
    <message>
        <source>%1: it makes %2 of the noise and %3 of the light.</source>
        <translation>%1: produce el %2 del ruido y el %3 de la luz.</translation>
    </message>
    <message>
        <source>Area light %1</source>
        <translation>Luz de área %1</translation>
    </message>
    <message>
        <source>Emitting mesh %1</source>
        <translation>Malla emisora %1</translation>
    </message>
    <message>
        <source>Lamp &quot;%1&quot;</source>
        <translation>Lámpara «%1»</translation>
    </message>
    <message>
        <source>Environment and background</source>
        <translation>Entorno y fondo</translation>
    </message>
    <message>
        <source>Light that the eye sees</source>
        <translation>Luz que ve el ojo</translation>
    </message>
    <message>
        <source>Direct light</source>
        <translation>Luz directa</translation>
    </message>
    <message>
        <source>Light of %1 bounces</source>
        <translation>Luz de %1 rebotes</translation>
    </message>
    <message>
        <source>%1, sampled by %2</source>
        <translation>%1, muestreada por %2</translation>
    </message>
    <message>
        <source>None: the eye sees the light</source>
        <translation>Ninguna: el ojo ve la luz</translation>
    </message>
    <message>
        <source>Sampled by %1 instead of %2: %3</source>
        <translation>Muestreada por %1 en lugar de %2: %3</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1: %2 en lugar de %3</translation>
    </message>
    <message>
        <source>%1: %2 of the variance in %3 of the time, so the same error in %4 of the time, with 95 % probability in %5 to %6.</source>
        <translation>%1: %2 de la varianza en %3 del tiempo; así, el mismo error en %4 del tiempo, con una probabilidad del 95 % entre %5 y %6.</translation>
    </message>
    <message>
        <source>pays</source>
        <translation>compensa</translation>
    </message>
    <message>
        <source>does not pay</source>
        <translation>no compensa</translation>
    </message>
    <message>
        <source>no clear difference</source>
        <translation>sin diferencia clara</translation>
    </message>
    <message>
        <source>No change that was tried pays.</source>
        <translation>Ninguno de los cambios probados compensa.</translation>
    </message>
</context>
<context>
    <name>editor::NoiseWindow</name>
    <message>
        <source>95 % interval: %1 to %2</source>
        <translation>Intervalo del 95 %: de %1 a %2</translation>
    </message>
    <message>
        <source>Where the noise is from - wannabe</source>
        <translation>De dónde viene el ruido - wannabe</translation>
    </message>
    <message>
        <source>State of the measurement</source>
        <translation>Estado de la medición</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Progreso de la medición</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Consejo</translation>
    </message>
    <message>
        <source>Part of the light</source>
        <translation>Parte de la luz</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>Shares of the noise</source>
        <translation>Partes del ruido</translation>
    </message>
    <message>
        <source>Shares of the image&apos;s variance and light. Select a row to select its lamp or faces</source>
        <translation>Partes de la varianza y de la luz de la imagen. Seleccione una fila para seleccionar su lámpara o sus caras</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>Variance</source>
        <translation>Varianza</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Producto</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Changes of settings</source>
        <translation>Cambios de ajustes</translation>
    </message>
    <message>
        <source>What changes do, relative to now: a product of 0.8 means the same error in 0.8 of the time</source>
        <translation>Qué hacen los cambios, respecto a ahora: un producto de 0.8 significa el mismo error en 0.8 del tiempo</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>Measure where the noise of the image comes from, as it is now</source>
        <translation>Mide de dónde viene el ruido de la imagen tal como es ahora</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>Stop measuring and keep what is known</source>
        <translation>Detiene la medición y conserva lo que se sabe</translation>
    </message>
    <message>
        <source>&amp;Try</source>
        <translation>&amp;Probar</translation>
    </message>
    <message>
        <source>Measure what the selected change does</source>
        <translation>Mide qué hace el cambio seleccionado</translation>
    </message>
    <message>
        <source>Try &amp;all</source>
        <translation>Probar &amp;todos</translation>
    </message>
    <message>
        <source>Measure what each change does</source>
        <translation>Mide qué hace cada cambio</translation>
    </message>
    <message>
        <source>A&amp;pply</source>
        <translation>&amp;Aplicar</translation>
    </message>
    <message>
        <source>Write the selected change to the options or the faces</source>
        <translation>Escribe el cambio seleccionado en las opciones o las caras</translation>
    </message>
    <message>
        <source>Measuring where the noise is from…</source>
        <translation>Midiendo de dónde viene el ruido…</translation>
    </message>
    <message>
        <source>Measuring what changes do…</source>
        <translation>Midiendo qué hacen los cambios…</translation>
    </message>
    <message>
        <source>Not measured: %1</source>
        <translation>Sin medir: %1</translation>
    </message>
    <message>
        <source>Applied: %1. Measure again to see what is left</source>
        <translation>Aplicado: %1. Mida de nuevo para ver qué queda</translation>
    </message>
    <message>
        <source>The scene, its options or the camera have changed: measure again</source>
        <translation>La escena, sus opciones o la cámara han cambiado: mida de nuevo</translation>
    </message>
    <message>
        <source>The error is %1 % with %2 samples per pixel, in %3 x %4 pixels</source>
        <translation>El error es del %1 % con %2 muestras por píxel, en %3 x %4 píxeles</translation>
    </message>
    <message>
        <source>Light from</source>
        <translation>Luz de</translation>
    </message>
    <message>
        <source>Bounces between lamp and eye</source>
        <translation>Rebotes entre la lámpara y el ojo</translation>
    </message>
    <message>
        <source>Reflected first by</source>
        <translation>Reflejada primero por</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Apply: %1</source>
        <translation>Aplicar: %1</translation>
    </message>
</context>
<context>
    <name>editor::NormalsRow</name>
    <message>
        <source>Crease angle</source>
        <translation>Ángulo de arista</translation>
    </message>
    <message>
        <source>Edges stay sharp where the angle between their faces is larger</source>
        <translation>Las aristas quedan vivas donde el ángulo entre sus caras es mayor</translation>
    </message>
    <message>
        <source>Smooth normals</source>
        <translation>Normales suaves</translation>
    </message>
    <message>
        <source>Smooth shading: vertex normals, averaged across edges up to the crease angle</source>
        <translation>Sombreado suave: normales de los vértices, promediadas en las aristas hasta el ángulo de arista</translation>
    </message>
    <message>
        <source>Flat faces</source>
        <translation>Caras planas</translation>
    </message>
    <message>
        <source>Flat shading: remove the vertex normals</source>
        <translation>Sombreado plano: quita las normales de los vértices</translation>
    </message>
    <message>
        <source>Flip the faces</source>
        <translation>Invertir las caras</translation>
    </message>
    <message>
        <source>Flip faces: reverse their orientation and their normals</source>
        <translation>Invertir las caras: cambia el sentido de su orientación y de sus normales</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>suaves</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>planas</translation>
    </message>
    <message>
        <source>The faces have vertex normals</source>
        <translation>Las caras tienen normales en los vértices</translation>
    </message>
    <message>
        <source>The faces have no vertex normals</source>
        <translation>Las caras no tienen normales en los vértices</translation>
    </message>
    <message>
        <source>Flip faces</source>
        <translation>Invertir las caras</translation>
    </message>
</context>
<context>
    <name>editor::NoticeBar</name>
    <message>
        <source>Notice</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this notice</source>
        <translation>Cerrar este aviso</translation>
    </message>
</context>
<context>
    <name>editor::NumberBox</name>
    <message>
        <source>Use a point as the decimal separator, as in 0.5.</source>
        <translation>Use un punto como separador decimal, como en 0.5.</translation>
    </message>
    <message>
        <source>Type a number.</source>
        <translation>Escriba un número.</translation>
    </message>
    <message>
        <source>The value must be a finite number.</source>
        <translation>El valor debe ser un número finito.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>cualquiera</translation>
    </message>
    <message>
        <source>Range: %1 to %2</source>
        <translation>Rango: de %1 a %2</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>varios</translation>
    </message>
</context>
<context>
    <name>editor::ObjectActions</name>
    <message>
        <source>Add a &amp;plane</source>
        <translation>Añadir un &amp;plano</translation>
    </message>
    <message>
        <source>Add a square that faces up, on the floor at the orbit centre</source>
        <translation>Añade un cuadrado hacia arriba, sobre el suelo en el centro de la órbita</translation>
    </message>
    <message>
        <source>Add a &amp;box</source>
        <translation>Añadir una &amp;caja</translation>
    </message>
    <message>
        <source>Add a cube on the floor at the orbit centre</source>
        <translation>Añade un cubo sobre el suelo en el centro de la órbita</translation>
    </message>
    <message>
        <source>Add a &amp;sphere</source>
        <translation>Añadir una &amp;esfera</translation>
    </message>
    <message>
        <source>Add a sphere on the floor at the orbit centre</source>
        <translation>Añade una esfera sobre el suelo en el centro de la órbita</translation>
    </message>
    <message>
        <source>Add a closed cylinder on the floor at the orbit centre</source>
        <translation>Añade un cilindro cerrado sobre el suelo en el centro de la órbita</translation>
    </message>
    <message>
        <source>Add a &amp;disc</source>
        <translation>Añadir un &amp;disco</translation>
    </message>
    <message>
        <source>Add a disc that faces up, on the floor at the orbit centre</source>
        <translation>Añade un disco hacia arriba, sobre el suelo en el centro de la órbita</translation>
    </message>
    <message>
        <source>Add a &amp;torus</source>
        <translation>Añadir un &amp;toro</translation>
    </message>
    <message>
        <source>Add a torus on the floor at the orbit centre</source>
        <translation>Añade un toro sobre el suelo en el centro de la órbita</translation>
    </message>
    <message>
        <source>Add a st&amp;udio</source>
        <translation>Añadir un est&amp;udio</translation>
    </message>
    <message>
        <source>Add a floor, a soft box and a rim light in proportion to the scene</source>
        <translation>Añade un suelo, una ventana de luz y una luz de contorno en proporción a la escena</translation>
    </message>
    <message>
        <source>Add studio</source>
        <translation>Añadir un estudio</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Añadir: %1</translation>
    </message>
    <message>
        <source>Show arrows that move the selected objects along axes and in planes</source>
        <translation>Muestra flechas que mueven los objetos seleccionados según los ejes y en planos</translation>
    </message>
    <message>
        <source>Show rings that rotate the selected objects</source>
        <translation>Muestra anillos que rotan los objetos seleccionados</translation>
    </message>
    <message>
        <source>Show handles that scale the selected objects</source>
        <translation>Muestra tiradores que escalan los objetos seleccionados</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>Mo&amp;ver</translation>
    </message>
    <message>
        <source>Move the selected objects with the pointer; X, Y, Z choose an axis, digits the distance</source>
        <translation>Mueve los objetos seleccionados con el puntero; X, Y, Z eligen un eje, las cifras la distancia</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>R&amp;otar</translation>
    </message>
    <message>
        <source>Rotate the selected objects with the pointer; X, Y, Z choose an axis, digits the degrees</source>
        <translation>Rota los objetos seleccionados con el puntero; X, Y, Z eligen un eje, las cifras los grados</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>Es&amp;calar</translation>
    </message>
    <message>
        <source>Scale the selected objects with the pointer; X, Y, Z choose an axis, digits the factor</source>
        <translation>Escala los objetos seleccionados con el puntero; X, Y, Z eligen un eje, las cifras el factor</translation>
    </message>
    <message>
        <source>&amp;Centre</source>
        <translation>&amp;Centro</translation>
    </message>
    <message>
        <source>Rotate and scale about the centre of the selected objects</source>
        <translation>Rota y escala alrededor del centro de los objetos seleccionados</translation>
    </message>
    <message>
        <source>&amp;Origin</source>
        <translation>&amp;Origen</translation>
    </message>
    <message>
        <source>Rotate and scale about the origins of the selected objects&apos; transforms</source>
        <translation>Rota y escala alrededor de los orígenes de las transformaciones de los objetos seleccionados</translation>
    </message>
    <message>
        <source>&amp;Active object</source>
        <translation>Objeto &amp;activo</translation>
    </message>
    <message>
        <source>Rotate and scale about the origin of the last object</source>
        <translation>Rota y escala alrededor del origen del último objeto</translation>
    </message>
    <message>
        <source>&amp;World origin</source>
        <translation>Origen de la &amp;escena</translation>
    </message>
    <message>
        <source>Rotate and scale about the origin of the world</source>
        <translation>Rota y escala alrededor del origen de la escena</translation>
    </message>
    <message>
        <source>Move, rotate and scale along the axes of the object instead of the world</source>
        <translation>Mueve, rota y escala según los ejes del objeto en vez de los de la escena</translation>
    </message>
    <message>
        <source>Snap to the grid, to 5° and to factors of 0.1; Ctrl inverts it</source>
        <translation>Ajusta a la cuadrícula, a 5° y a factores de 0.1; Ctrl lo invierte</translation>
    </message>
    <message>
        <source>&amp;Drop to floor</source>
        <translation>&amp;Posar en el suelo</translation>
    </message>
    <message>
        <source>Move the selected objects vertically so that they stand on the floor, y = 0</source>
        <translation>Mueve los objetos seleccionados en vertical hasta que estén sobre el suelo, y = 0</translation>
    </message>
    <message>
        <source>R&amp;eset transform</source>
        <translation>Resta&amp;blecer la transformación</translation>
    </message>
    <message>
        <source>Remove position, rotation and scale of the selected objects</source>
        <translation>Quita la posición, la rotación y la escala de los objetos seleccionados</translation>
    </message>
    <message>
        <source>Apply trans&amp;form</source>
        <translation>Aplicar la trans&amp;formación</translation>
    </message>
    <message>
        <source>Apply position, rotation and scale of the selected objects to their vertices</source>
        <translation>Aplica la posición, la rotación y la escala de los objetos seleccionados a sus vértices</translation>
    </message>
    <message>
        <source>Place on a s&amp;urface…</source>
        <translation>Colocar en una &amp;superficie…</translation>
    </message>
    <message>
        <source>Click the point of a surface on which the selected objects shall stand</source>
        <translation>Haga clic en el punto de una superficie sobre el que deban estar los objetos seleccionados</translation>
    </message>
    <message>
        <source>Place along a norma&amp;l…</source>
        <translation>Colocar según una &amp;normal…</translation>
    </message>
    <message>
        <source>Click the point of a surface on which the selected objects shall stand, along its normal</source>
        <translation>Haga clic en el punto de una superficie sobre el que deban estar los objetos seleccionados, según su normal</translation>
    </message>
    <message>
        <source>Along &amp;%1</source>
        <translation>Según &amp;%1</translation>
    </message>
    <message>
        <source>Mirror the selected objects along %1 at the pivot</source>
        <translation>Refleja los objetos seleccionados según %1 en el pivote</translation>
    </message>
    <message>
        <source>Align %1 %2</source>
        <translation>Alinear %1, %2</translation>
    </message>
    <message>
        <source>Move the selected objects along %1 to the %2 of the last one</source>
        <translation>Mueve los objetos seleccionados según %1 hasta el %2 del último</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>mínimo</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>centro</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>máximo</translation>
    </message>
    <message>
        <source>Distribute along %1</source>
        <translation>Distribuir según %1</translation>
    </message>
    <message>
        <source>Space the centres of the selected objects evenly along %1</source>
        <translation>Reparte los centros de los objetos seleccionados por igual según %1</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Rotar</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Place on surface</source>
        <translation>Colocar en una superficie</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Reflejar</translation>
    </message>
    <message>
        <source>&amp;Pivot</source>
        <translation>P&amp;ivote</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>A&amp;grupar</translation>
    </message>
    <message>
        <source>Group the selected objects in a transform, beside the last one</source>
        <translation>Agrupa los objetos seleccionados en una transformación, junto al último</translation>
    </message>
    <message>
        <source>U&amp;ngroup</source>
        <translation>Desagr&amp;upar</translation>
    </message>
    <message>
        <source>Replace the selected groups by their objects, which stay where they are</source>
        <translation>Sustituye los grupos seleccionados por sus objetos, que se quedan donde están</translation>
    </message>
    <message>
        <source>Turn the selected instances into meshes of their own</source>
        <translation>Convierte las instancias seleccionadas en mallas propias</translation>
    </message>
    <message>
        <source>Make &amp;instance</source>
        <translation>&amp;Definir e instanciar</translation>
    </message>
    <message>
        <source>Turn the last of the selected meshes into a definition and an instance of it</source>
        <translation>Convierte la última de las mallas seleccionadas en una definición y una instancia de ella</translation>
    </message>
    <message>
        <source>Add a c&amp;ylinder</source>
        <translation>Añadir un c&amp;ilindro</translation>
    </message>
    <message>
        <source>Mo&amp;ve gizmo</source>
        <translation>Manipulador para &amp;mover</translation>
    </message>
    <message>
        <source>Rota&amp;te gizmo</source>
        <translation>Manipulador para &amp;rotar</translation>
    </message>
    <message>
        <source>S&amp;cale gizmo</source>
        <translation>Manipulador para &amp;escalar</translation>
    </message>
    <message>
        <source>Local a&amp;xes</source>
        <translation>Ejes &amp;locales</translation>
    </message>
    <message>
        <source>Sn&amp;ap</source>
        <translation>Ajus&amp;te</translation>
    </message>
    <message>
        <source>Ma&amp;ke single</source>
        <translation>&amp;Hacer único</translation>
    </message>
    <message>
        <source>Move up in the list</source>
        <translation>Subir en la lista</translation>
    </message>
    <message>
        <source>Move the selected objects up by one place in the list of the scene</source>
        <translation>Sube los objetos seleccionados un lugar en la lista de la escena</translation>
    </message>
    <message>
        <source>Move down in the list</source>
        <translation>Bajar en la lista</translation>
    </message>
    <message>
        <source>Move the selected objects down by one place in the list of the scene</source>
        <translation>Baja los objetos seleccionados un lugar en la lista de la escena</translation>
    </message>
    <message>
        <source>Move out of the group</source>
        <translation>Sacar del grupo</translation>
    </message>
    <message>
        <source>Move the selected objects out of their group, behind it; they stay in place</source>
        <translation>Saca los objetos seleccionados de su grupo, detrás de él; permanecen en su sitio</translation>
    </message>
    <message>
        <source>Move into the group above</source>
        <translation>Meter en el grupo de encima</translation>
    </message>
    <message>
        <source>Move the selected objects into the group above them in the list; they stay in place</source>
        <translation>Mete los objetos seleccionados en el grupo que está encima de ellos en la lista; permanecen en su sitio</translation>
    </message>
    <message>
        <source>Order in the list</source>
        <translation>Orden en la lista</translation>
    </message>
    <message>
        <source>Mirr&amp;or</source>
        <translation>Refle&amp;jar</translation>
    </message>
    <message>
        <source>Align and distri&amp;bute</source>
        <translation>&amp;Alinear y distribuir</translation>
    </message>
</context>
<context>
    <name>editor::ObjectPanel</name>
    <message>
        <source>Object</source>
        <translation>Objeto</translation>
    </message>
    <message>
        <source>Select an object to place it: click it in the 3D view, or in the scene outliner.</source>
        <translation>Seleccione un objeto para colocarlo: haga clic en él en la vista 3D, o en el árbol de la escena.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotación</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>translation relative to the parent, after rotation and scale</source>
        <translation>traslación respecto al padre, después de la rotación y la escala</translation>
    </message>
    <message>
        <source>rotation about the axis; about x first, then y, then z</source>
        <translation>rotación alrededor del eje; primero de x, después de y, después de z</translation>
    </message>
    <message>
        <source>scale factor, applied first; not 0</source>
        <translation>factor de escala, que se aplica primero; no 0</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Size of the object&apos;s bounds in world space, along x, y and z</source>
        <translation>Tamaño de los límites del objeto en el espacio de la escena, según x, y y z</translation>
    </message>
    <message>
        <source>Included file %1</source>
        <translation>Archivo incluido %1</translation>
    </message>
    <message>
        <source>Mesh without a name</source>
        <translation>Malla sin nombre</translation>
    </message>
    <message>
        <source>Light or observer</source>
        <translation>Luz u observador</translation>
    </message>
    <message numerus="yes">
        <source>%1, active of %n selected objects</source>
        <translation>
            <numerusform>%1, activo de %n objeto seleccionado</numerusform>
            <numerusform>%1, activo de %n objetos seleccionados</numerusform>
        </translation>
    </message>
    <message>
        <source>The transform shears the object, so that rotation and scale cannot be edited as numbers. Reset the transform to edit them.</source>
        <translation>La transformación cizalla el objeto, así que la rotación y la escala no se pueden editar como números. Restablezca la transformación para editarlas.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Rotar</translation>
    </message>
</context>
<context>
    <name>editor::OpDocument</name>
    <message>
        <source>Open options</source>
        <translation>Abrir opciones</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Cambiar %1</translation>
    </message>
    <message>
        <source>Edit the text</source>
        <translation>Editar el texto</translation>
    </message>
</context>
<context>
    <name>editor::OpTextView</name>
    <message>
        <source>Text of the OP file</source>
        <translation>Texto del archivo OP</translation>
    </message>
    <message>
        <source>Text of the OP file as it will be written. Edits here update the form.</source>
        <translation>Texto del archivo OP como se escribirá. Lo que se edita aquí cambia el formulario.</translation>
    </message>
    <message>
        <source>Set options on the left, or type them here, one per line:
BPT_Scene  scene.grf</source>
        <translation>Dé valores a las opciones a la izquierda, o escríbalas aquí, una por línea:
BPT_Scene  scene.grf</translation>
    </message>
</context>
<context>
    <name>editor::OpacityRow</name>
    <message>
        <source>Uniform</source>
        <translation>Uniforme</translation>
    </message>
    <message>
        <source>Cut out by alpha</source>
        <translation>Recortada por alfa</translation>
    </message>
    <message>
        <source>Blended by alpha</source>
        <translation>Mezclada por alfa</translation>
    </message>
    <message>
        <source>Kind of opacity</source>
        <translation>Tipo de opacidad</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Fraction of light that meets the faces. Cut out by alpha: the alpha of the texture below which they are absent. Blended by alpha: a factor of that alpha</source>
        <translation>Fracción de la luz que encuentra las caras. Recortada por alfa: el alfa de la textura por debajo del cual están ausentes. Mezclada por alfa: un factor de ese alfa</translation>
    </message>
    <message>
        <source>Reset the opacity</source>
        <translation>Restablecer la opacidad</translation>
    </message>
    <message>
        <source>Uniform, or by the alpha of the texture: faces that are absent below a cutoff, or that let part of the light pass</source>
        <translation>Uniforme, o según el alfa de la textura: caras ausentes por debajo de un umbral, o que dejan pasar parte de la luz</translation>
    </message>
    <message>
        <source>Reset to the default: opaque</source>
        <translation>Restablecer el valor predeterminado: opacas</translation>
    </message>
    <message>
        <source>The faces are opaque.</source>
        <translation>Las caras son opacas.</translation>
    </message>
    <message>
        <source>Set opacity</source>
        <translation>Cambiar la opacidad</translation>
    </message>
    <message>
        <source>Reset opacity</source>
        <translation>Restablecer la opacidad</translation>
    </message>
</context>
<context>
    <name>editor::OptionField</name>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Activado</translation>
    </message>
</context>
<context>
    <name>editor::OptionRow</name>
    <message>
        <source>%1. Default: %2; %3.</source>
        <translation>%1. Por defecto: %2; %3.</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>Restablecer %1</translation>
    </message>
    <message>
        <source>Reset to the default: remove the line from the file.</source>
        <translation>Restablece el valor por defecto: quita la línea del archivo.</translation>
    </message>
    <message>
        <source>Already at its default: the file does not set it.</source>
        <translation>Ya tiene el valor por defecto: el archivo no lo fija.</translation>
    </message>
    <message>
        <source>No effect: %1.</source>
        <translation>Sin efecto: %1.</translation>
    </message>
</context>
<context>
    <name>editor::OptionsEditor</name>
    <message>
        <source>Open options</source>
        <translation>Abrir opciones</translation>
    </message>
    <message>
        <source>Open an OP file.</source>
        <translation>Abre un archivo OP.</translation>
    </message>
    <message>
        <source>Save options</source>
        <translation>Guardar las opciones</translation>
    </message>
    <message>
        <source>Save the OP file; comments are kept.</source>
        <translation>Guarda el archivo OP; los comentarios se conservan.</translation>
    </message>
    <message>
        <source>Save options as</source>
        <translation>Guardar las opciones como</translation>
    </message>
    <message>
        <source>Save the OP file under another name.</source>
        <translation>Guarda el archivo OP con otro nombre.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Undo the last change of the options</source>
        <translation>Deshace el último cambio de las opciones</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Redo the last undone change of the options</source>
        <translation>Rehace el último cambio deshecho de las opciones</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
    <message>
        <source>Errors and warnings of bpt about these options. Select one to go to its option or line.</source>
        <translation>Errores y avisos de bpt sobre estas opciones. Seleccione uno para ir a su opción o línea.</translation>
    </message>
    <message>
        <source>These options have no errors or warnings.</source>
        <translation>Estas opciones no tienen errores ni avisos.</translation>
    </message>
    <message>
        <source>Line %1: </source>
        <translation>Línea %1: </translation>
    </message>
    <message>
        <source>Error. </source>
        <translation>Error. </translation>
    </message>
    <message>
        <source>Warning. </source>
        <translation>Aviso. </translation>
    </message>
</context>
<context>
    <name>editor::OptionsForm</name>
    <message>
        <source>No option matches the search.</source>
        <translation>Ninguna opción coincide con la búsqueda.</translation>
    </message>
    <message>
        <source>Search options</source>
        <translation>Buscar opciones</translation>
    </message>
    <message>
        <source>Show only options with these words in their names, meanings or defaults.</source>
        <translation>Muestra solo las opciones con estas palabras en su nombre, significado o valor por defecto.</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Opciones</translation>
    </message>
</context>
<context>
    <name>editor::OptionsWindow</name>
    <message>
        <source>%1[*] - options - wannabe</source>
        <translation>%1[*] - opciones - wannabe</translation>
    </message>
    <message>
        <source>untitled.op</source>
        <translation>sin_titulo.op</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cierra esta ventana</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edición</translation>
    </message>
    <message>
        <source>&amp;Search options</source>
        <translation>&amp;Buscar opciones</translation>
    </message>
    <message>
        <source>Find options by name or meaning</source>
        <translation>Busca opciones por su nombre o significado</translation>
    </message>
    <message>
        <source>Unsaved options</source>
        <translation>Opciones sin guardar</translation>
    </message>
    <message>
        <source>The options have unsaved changes.</source>
        <translation>Las opciones tienen cambios sin guardar.</translation>
    </message>
</context>
<context>
    <name>editor::Pages</name>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>Pages: the scene, images, and the source text of files</source>
        <translation>Páginas: la escena, las imágenes y el texto de los archivos</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>3D view of the scene</source>
        <translation>Vista 3D de la escena</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Source text of the file that a message refers to</source>
        <translation>Texto del archivo al que se refiere un mensaje</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Differences between the scene and its file</source>
        <translation>Diferencias entre la escena y su archivo</translation>
    </message>
</context>
<context>
    <name>editor::ParameterRow</name>
    <message>
        <source>One number for all channels, or one for each of red, green and blue (linear)</source>
        <translation>Un número para todos los canales, o uno para rojo, verde y azul (lineal)</translation>
    </message>
    <message>
        <source>Choose a colour: the numbers are its linear red, green and blue</source>
        <translation>Elige un color: los números son su rojo, verde y azul lineales</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>Reset to the default</source>
        <translation>Restablece el valor por defecto</translation>
    </message>
    <message>
        <source>Already at its default</source>
        <translation>Ya tiene el valor por defecto</translation>
    </message>
    <message>
        <source>%1 as RGB</source>
        <translation>%1 como RGB</translation>
    </message>
    <message>
        <source>%1, colour</source>
        <translation>%1, color</translation>
    </message>
    <message>
        <source>%1, reset to default</source>
        <translation>%1, restablecer el valor por defecto</translation>
    </message>
</context>
<context>
    <name>editor::PathField</name>
    <message>
        <source>Choose %1</source>
        <translation>Elegir %1</translation>
    </message>
    <message>
        <source>Choose the output file</source>
        <translation>Elegir el archivo de salida</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Elegir el archivo</translation>
    </message>
    <message>
        <source>Files (%1);;</source>
        <translation>Archivos (%1);;</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Write to</source>
        <translation>Escribir en</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Elegir un archivo</translation>
    </message>
</context>
<context>
    <name>editor::PdfRow</name>
    <message>
        <source>Sampling scheme</source>
        <translation>Esquema de muestreo</translation>
    </message>
    <message>
        <source>Reset the sampling scheme</source>
        <translation>Restablecer el esquema de muestreo</translation>
    </message>
    <message>
        <source>Reset PDF</source>
        <translation>Restablecer la PDF</translation>
    </message>
    <message>
        <source>How reflected directions are sampled; by default, with the BRDF&apos;s own scheme</source>
        <translation>Cómo se muestrean las direcciones reflejadas; por defecto, con el esquema propio de la BRDF</translation>
    </message>
    <message>
        <source>Reset to the default sampling scheme of each BRDF</source>
        <translation>Restablece el esquema de muestreo por defecto de cada BRDF</translation>
    </message>
    <message>
        <source>The faces have no sampling scheme of their own.</source>
        <translation>Las caras no tienen esquema de muestreo propio.</translation>
    </message>
    <message>
        <source>BRDF default</source>
        <translation>El de la BRDF</translation>
    </message>
    <message>
        <source>Each BRDF is sampled with its default scheme</source>
        <translation>Cada BRDF se muestrea con su esquema por defecto</translation>
    </message>
    <message>
        <source>The scheme &apos;%1&apos; of the scene</source>
        <translation>El esquema &apos;%1&apos; de la escena</translation>
    </message>
    <message>
        <source>%1 (unknown)</source>
        <translation>%1 (desconocido)</translation>
    </message>
    <message>
        <source>Unknown sampling scheme &apos;%1&apos;</source>
        <translation>Esquema de muestreo &apos;%1&apos; desconocido</translation>
    </message>
    <message>
        <source>Assign scheme %1</source>
        <translation>Asignar el esquema %1</translation>
    </message>
    <message>
        <source>Edit parameters of %1</source>
        <translation>Editar los parámetros de %1</translation>
    </message>
</context>
<context>
    <name>editor::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>Pages of the preferences</source>
        <translation>Páginas de las preferencias</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;General</translation>
    </message>
    <message>
        <source>&amp;Work</source>
        <translation>T&amp;rabajo</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>T&amp;eclas</translation>
    </message>
    <message>
        <source>Close: all changes are applied already</source>
        <translation>Cierra: todos los cambios ya están aplicados</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Language of the texts, from the next start</source>
        <translation>Idioma de los textos, desde el próximo inicio</translation>
    </message>
    <message>
        <source>that of the system</source>
        <translation>el del sistema</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Colours of windows and views</source>
        <translation>Colores de las ventanas y las vistas</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>oscuro</translation>
    </message>
    <message>
        <source>light</source>
        <translation>claro</translation>
    </message>
    <message>
        <source>&amp;Unit of length</source>
        <translation>&amp;Unidad de longitud</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Unidad de longitud</translation>
    </message>
    <message>
        <source>Unit of lengths in the Object, Lights and Cameras docks; a unit of the file is a metre</source>
        <translation>Unidad de las longitudes en los paneles Objeto, Luces y Cámaras; una unidad del archivo es un metro</translation>
    </message>
    <message>
        <source>metre</source>
        <translation>metro</translation>
    </message>
    <message>
        <source>centimetre</source>
        <translation>centímetro</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>milímetro</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pulgada</translation>
    </message>
    <message>
        <source>Up axis of imports</source>
        <translation>Eje vertical al importar</translation>
    </message>
    <message>
        <source>The axis that points up in models, unless the import dialog chose another one for the type</source>
        <translation>El eje que apunta hacia arriba en los modelos, salvo que el diálogo de importación haya elegido otro para el tipo</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>U&amp;ndo steps</source>
        <translation>Pasos de &amp;deshacer</translation>
    </message>
    <message>
        <source>Undo steps</source>
        <translation>Pasos de deshacer</translation>
    </message>
    <message>
        <source>Largest number of undo steps, which take memory; 0: no limit. While a scene has undo steps, the limit applies from the next scene on.</source>
        <translation>Número máximo de pasos de deshacer, que ocupan memoria; 0: sin límite. Mientras una escena tiene pasos de deshacer, el límite se aplica desde la siguiente escena.</translation>
    </message>
    <message>
        <source>Th&amp;reads</source>
        <translation>&amp;Hilos</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Hilos</translation>
    </message>
    <message>
        <source>Threads of previews and renders whose options leave it open; 0: one per core.</source>
        <translation>Hilos de las vistas previas y los renders cuyas opciones no los fijan; 0: uno por núcleo.</translation>
    </message>
    <message>
        <source>&amp;Autosave after</source>
        <translation>&amp;Autoguardar a los</translation>
    </message>
    <message>
        <source>Autosave after</source>
        <translation>Autoguardar a los</translation>
    </message>
    <message>
        <source>Time from a change to the autosave of unsaved work.</source>
        <translation>Tiempo desde un cambio hasta el autoguardado del trabajo sin guardar.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Buscar acciones</translation>
    </message>
    <message>
        <source>Show only actions whose name or keys have these words</source>
        <translation>Muestra solo las acciones cuyo nombre o teclas contienen estas palabras</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Acciones</translation>
    </message>
    <message>
        <source>Actions and their shortcuts; changed ones are bold</source>
        <translation>Acciones y sus atajos; los cambiados están en negrita</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Atajo nuevo</translation>
    </message>
    <message>
        <source>Press the new shortcut of the selected action</source>
        <translation>Pulse el atajo nuevo de la acción seleccionada</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>Por &amp;defecto</translation>
    </message>
    <message>
        <source>Restore the default shortcut of the selected action</source>
        <translation>Restablece el atajo por defecto de la acción seleccionada</translation>
    </message>
    <message>
        <source>&amp;No shortcut</source>
        <translation>&amp;Sin atajo</translation>
    </message>
    <message>
        <source>Remove the shortcut of the selected action</source>
        <translation>Quita el atajo de la acción seleccionada</translation>
    </message>
    <message>
        <source>Reset a&amp;ll</source>
        <translation>Restab&amp;lecer todos</translation>
    </message>
    <message>
        <source>Restore the default shortcuts of all actions</source>
        <translation>Restablece los atajos por defecto de todas las acciones</translation>
    </message>
    <message>
        <source>%1 is the shortcut of &quot;%2&quot;: change that one first</source>
        <translation>%1 es el atajo de &quot;%2&quot;: cambie antes ese</translation>
    </message>
    <message>
        <source>U&amp;p axis of imports</source>
        <translation>Eje &amp;vertical al importar</translation>
    </message>
    <message>
        <source>&amp;Farm</source>
        <translation>&amp;Granja</translation>
    </message>
    <message>
        <source>&amp;Server</source>
        <translation>&amp;Servidor</translation>
    </message>
    <message>
        <source>Server of the farm</source>
        <translation>Servidor de la granja</translation>
    </message>
    <message>
        <source>URL of the render farm&apos;s server, as printed by `bpt farm serve`: nats://HOST:4222. The Render dock can then render there. Empty: no farm.</source>
        <translation>URL del servidor de la granja de render, como la muestra `bpt farm serve`: nats://HOST:4222. El panel Render puede entonces renderizar allí. Vacío: sin granja.</translation>
    </message>
    <message>
        <source>T&amp;oken file</source>
        <translation>Archivo del t&amp;oken</translation>
    </message>
    <message>
        <source>Token file</source>
        <translation>Archivo del token</translation>
    </message>
    <message>
        <source>File with the secret token of the server; empty: the server asks for none.</source>
        <translation>Archivo con el token secreto del servidor; vacío: el servidor no pide ninguno.</translation>
    </message>
    <message>
        <source>C&amp;A certificates</source>
        <translation>Certificados de la C&amp;A</translation>
    </message>
    <message>
        <source>CA certificates</source>
        <translation>Certificados de la CA</translation>
    </message>
    <message>
        <source>File (PEM) with the certificates of the authority that signed the server&apos;s certificate, for TLS.</source>
        <translation>Archivo (PEM) con los certificados de la autoridad que firmó el del servidor, para TLS.</translation>
    </message>
    <message>
        <source>Own &amp;certificate</source>
        <translation>&amp;Certificado propio</translation>
    </message>
    <message>
        <source>Own certificate</source>
        <translation>Certificado propio</translation>
    </message>
    <message>
        <source>File (PEM) with the own certificate, for servers that ask for one.</source>
        <translation>Archivo (PEM) con el certificado propio, para servidores que lo piden.</translation>
    </message>
    <message>
        <source>&amp;Private key</source>
        <translation>Clave &amp;privada</translation>
    </message>
    <message>
        <source>Private key</source>
        <translation>Clave privada</translation>
    </message>
    <message>
        <source>File (PEM) with the key of the own certificate.</source>
        <translation>Archivo (PEM) con la clave del certificado propio.</translation>
    </message>
</context>
<context>
    <name>editor::Recovery</name>
    <message>
        <source>Cannot write the folder %1.</source>
        <translation>No se puede escribir en la carpeta %1.</translation>
    </message>
    <message>
        <source>Cannot create the folder %1.</source>
        <translation>No se puede crear la carpeta %1.</translation>
    </message>
</context>
<context>
    <name>editor::RecoveryController</name>
    <message>
        <source>Autosave failed: %1</source>
        <translation>El autoguardado falló: %1</translation>
    </message>
    <message>
        <source>a scene that was never saved</source>
        <translation>una escena que nunca se guardó</translation>
    </message>
    <message>
        <source>The last session ended unexpectedly. Unsaved work on %1 was autosaved at %2.</source>
        <translation>La última sesión terminó de forma inesperada. El trabajo sin guardar en %1 se autoguardó el %2.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Open the autosaved scene</source>
        <translation>Abre la escena autoguardada</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Delete the autosaved scene; this cannot be undone</source>
        <translation>Elimina la escena autoguardada; no se puede deshacer</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Recuperar el trabajo sin guardar</translation>
    </message>
    <message>
        <source>Cancel: the work can be recovered later</source>
        <translation>Cancela: el trabajo se puede recuperar más tarde</translation>
    </message>
    <message>
        <source>Recovered: save the scene to keep it</source>
        <translation>Recuperado: guarde la escena para conservarlo</translation>
    </message>
</context>
<context>
    <name>editor::ReimportText</name>
    <message>
        <source>%1 is no longer in the file: it stays as it was</source>
        <translation>%1 ya no está en el archivo: queda como estaba</translation>
    </message>
    <message>
        <source>%1 has 1 more face, with the surface of the mesh</source>
        <translation>%1 tiene 1 cara más, con la superficie de la malla</translation>
    </message>
    <message>
        <source>%1 has %2 more faces, with the surface of the mesh</source>
        <translation>%1 tiene %2 caras más, con la superficie de la malla</translation>
    </message>
    <message>
        <source>%1 has 1 face less</source>
        <translation>%1 tiene 1 cara menos</translation>
    </message>
    <message>
        <source>%1 has %2 fewer faces</source>
        <translation>%1 tiene %2 caras menos</translation>
    </message>
    <message>
        <source>%1 is new in the file: append the file to get it</source>
        <translation>%1 es nuevo en el archivo: añada el archivo para obtenerlo</translation>
    </message>
</context>
<context>
    <name>editor::RenderController</name>
    <message>
        <source>Lock the render camera to the 3D view</source>
        <translation>Une la cámara de render a la vista 3D</translation>
    </message>
    <message>
        <source>Align &amp;camera to view</source>
        <translation>Traer la cámara a&amp;quí</translation>
    </message>
    <message>
        <source>Move the render camera to the viewpoint of the 3D view</source>
        <translation>Mueve la cámara de render al punto de vista de la vista 3D</translation>
    </message>
    <message>
        <source>View the scene through the render camera</source>
        <translation>Muestra la escena desde la cámara de render</translation>
    </message>
    <message>
        <source>Draw the border of the rendered image and its thirds over the 3D view</source>
        <translation>Dibuja el borde de la imagen renderizada y sus tercios sobre la vista 3D</translation>
    </message>
    <message>
        <source>Move the camera</source>
        <translation>Mover la cámara</translation>
    </message>
    <message>
        <source>Camera follows &amp;the view</source>
        <translation>Fi&amp;jar la cámara a la vista</translation>
    </message>
    <message>
        <source>Loo&amp;k through the camera</source>
        <translation>&amp;Mirar por la cámara</translation>
    </message>
    <message>
        <source>Framing guides</source>
        <translation>Guías de encuadre</translation>
    </message>
</context>
<context>
    <name>editor::RenderHistory</name>
    <message>
        <source>%1 samples</source>
        <translation>%1 muestras</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>detenido</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>error %1</translation>
    </message>
    <message>
        <source>Renders of this session</source>
        <translation>Renders de esta sesión</translation>
    </message>
    <message>
        <source>Renders of this session, with samples per pixel, time and estimated error. Click or press Return to open the image</source>
        <translation>Renders de esta sesión, con muestras por píxel, tiempo y error estimado. Haga clic o pulse Intro para abrir la imagen</translation>
    </message>
    <message>
        <source>Press F6 to render. Finished renders are listed here until the editor is closed.</source>
        <translation>Pulse F6 para renderizar. Los renders terminados aparecen aquí hasta que se cierra el editor.</translation>
    </message>
    <message>
        <source>1 sample</source>
        <translation>1 muestra</translation>
    </message>
</context>
<context>
    <name>editor::RenderPanel</name>
    <message>
        <source>Ready</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>Render</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Options…</source>
        <translation>Opciones…</translation>
    </message>
    <message>
        <source>All render options, with their meanings</source>
        <translation>Todas las opciones de render, con su significado</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Progress of the render towards its samples, target error or time limit</source>
        <translation>Progreso del render hacia sus muestras, su error objetivo o su límite de tiempo</translation>
    </message>
    <message>
        <source>State of the render</source>
        <translation>Estado del render</translation>
    </message>
    <message>
        <source>Messages of the renderer appear here</source>
        <translation>Los mensajes del programa de render aparecen aquí</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>Messages of the renderer about the scene and its progress</source>
        <translation>Mensajes del programa de render sobre la escena y su progreso</translation>
    </message>
    <message>
        <source>Press F5 for a preview that follows your edits, F6 to render the final image</source>
        <translation>Pulse F5 para una vista previa que sigue sus ediciones, F6 para renderizar la imagen final</translation>
    </message>
    <message>
        <source>Change render options</source>
        <translation>Cambiar las opciones de render</translation>
    </message>
    <message>
        <source>Preview paused</source>
        <translation>Vista previa en pausa</translation>
    </message>
    <message>
        <source>Preview done</source>
        <translation>Vista previa terminada</translation>
    </message>
    <message>
        <source>Preview failed: see the log</source>
        <translation>La vista previa falló: vea el registro</translation>
    </message>
    <message>
        <source>Preview stopped</source>
        <translation>Vista previa detenida</translation>
    </message>
    <message>
        <source>Rendering %1</source>
        <translation>Renderizando %1</translation>
    </message>
    <message>
        <source>Render failed: %1</source>
        <translation>El render falló: %1</translation>
    </message>
    <message>
        <source>Stopped, image kept</source>
        <translation>Detenido; se conserva la imagen</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminado</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 muestras</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>error %1</translation>
    </message>
    <message>
        <source>Stop the preview</source>
        <translation>Detiene la vista previa</translation>
    </message>
    <message>
        <source>Render %1</source>
        <translation>Renderizar %1</translation>
    </message>
    <message>
        <source>Stop this render and keep its image</source>
        <translation>Detiene este render y conserva su imagen</translation>
    </message>
    <message>
        <source>Replace the image</source>
        <translation>Reemplazar la imagen</translation>
    </message>
    <message>
        <source>%1 exists.</source>
        <translation>%1 ya existe.</translation>
    </message>
    <message>
        <source>It was not rendered in this session. Rendering overwrites it.</source>
        <translation>No se renderizó en esta sesión. El render la sobrescribe.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>Stopping: the image is kept</source>
        <translation>Deteniéndose: se conserva la imagen</translation>
    </message>
    <message>
        <source>Rendering</source>
        <translation>Renderizando</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>quedan %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reanudar</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
    <message>
        <source>A render is already running: its image is shown until it is done</source>
        <translation>Ya hay un render en marcha: se muestra su imagen hasta que termina</translation>
    </message>
    <message>
        <source>Render a progressive preview that follows your edits</source>
        <translation>Renderiza una vista previa progresiva que sigue sus ediciones</translation>
    </message>
    <message>
        <source>Queue a render of the scene as it is now</source>
        <translation>Pone en cola un render de la escena como está ahora</translation>
    </message>
    <message>
        <source>Render the scene as it is now to the image file</source>
        <translation>Renderiza la escena como está ahora en el archivo de imagen</translation>
    </message>
    <message>
        <source>Stop the render and keep its image</source>
        <translation>Detiene el render y conserva su imagen</translation>
    </message>
    <message>
        <source>No render is running</source>
        <translation>No hay ningún render en marcha</translation>
    </message>
    <message>
        <source>Render &amp;cameras…</source>
        <translation>Renderizar &amp;cámaras…</translation>
    </message>
    <message>
        <source>Queue a render per camera that is chosen</source>
        <translation>Pone en cola un render por cada cámara elegida</translation>
    </message>
    <message>
        <source>Render &amp;animation…</source>
        <translation>Renderizar &amp;animación…</translation>
    </message>
    <message>
        <source>Queue a render of a turntable, or of a path through the cameras</source>
        <translation>Pone en cola el render de un plato giratorio, o de un recorrido por las cámaras</translation>
    </message>
    <message>
        <source>Without &amp;hidden faces</source>
        <translation>Sin caras &amp;ocultas</translation>
    </message>
    <message>
        <source>Without hidden faces</source>
        <translation>Sin caras ocultas</translation>
    </message>
    <message>
        <source>Preview the scene without the faces that are hidden in the 3D view; final renders have all faces</source>
        <translation>Vista previa de la escena sin las caras ocultas en la vista 3D; los renders finales tienen todas las caras</translation>
    </message>
    <message>
        <source>Render %1 and %2 more</source>
        <translation>Renderizar %1 y %2 más</translation>
    </message>
    <message>
        <source>&amp;Render</source>
        <translation>&amp;Renderizar</translation>
    </message>
    <message>
        <source>Render cameras</source>
        <translation>Renderizar cámaras</translation>
    </message>
    <message>
        <source>Cameras to render</source>
        <translation>Cámaras para renderizar</translation>
    </message>
    <message>
        <source>Each checked camera becomes a job; Space checks one</source>
        <translation>Cada cámara marcada será una tarea; la barra espaciadora marca una</translation>
    </message>
    <message>
        <source>Render camera</source>
        <translation>Cámara de render</translation>
    </message>
    <message>
        <source>Queue a render per camera</source>
        <translation>Pone en cola un render por cámara</translation>
    </message>
    <message>
        <source>No camera is checked</source>
        <translation>No hay ninguna cámara marcada</translation>
    </message>
    <message>
        <source>Render animation</source>
        <translation>Renderizar animación</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Fotogramas</translation>
    </message>
    <message>
        <source>Number of images of the animation</source>
        <translation>Número de imágenes de la animación</translation>
    </message>
    <message>
        <source>Camera path</source>
        <translation>Recorrido de la cámara</translation>
    </message>
    <message>
        <source>How the camera moves from frame to frame</source>
        <translation>Cómo se mueve la cámara de un fotograma a otro</translation>
    </message>
    <message>
        <source>Turntable about the look-at point</source>
        <translation>Plato giratorio en torno al punto de mira</translation>
    </message>
    <message>
        <source>Linear through the named cameras</source>
        <translation>Lineal por las cámaras con nombre</translation>
    </message>
    <message>
        <source>Smooth through the named cameras</source>
        <translation>Suave por las cámaras con nombre</translation>
    </message>
    <message>
        <source>&amp;Frames</source>
        <translation>&amp;Fotogramas</translation>
    </message>
    <message>
        <source>Camera &amp;path</source>
        <translation>&amp;Recorrido de la cámara</translation>
    </message>
    <message>
        <source>Render effects separately</source>
        <translation>Renderizar los efectos por separado</translation>
    </message>
    <message>
        <source>Effects to render</source>
        <translation>Efectos que se renderizan</translation>
    </message>
    <message>
        <source>Each checked effect becomes a job; Space checks one</source>
        <translation>Cada efecto marcado es una tarea; Espacio marca uno</translation>
    </message>
    <message>
        <source>Queue a render per effect</source>
        <translation>Pone en cola un render por efecto</translation>
    </message>
    <message>
        <source>No effect is checked</source>
        <translation>Ningún efecto está marcado</translation>
    </message>
    <message>
        <source>Render &amp;effects separately…</source>
        <translation>Renderizar los &amp;efectos por separado…</translation>
    </message>
    <message>
        <source>Queue a render per effect that the scene has, such as textures</source>
        <translation>Pone en cola un render por cada efecto que tiene la escena, como las texturas</translation>
    </message>
    <message>
        <source>Compare with the &amp;last render</source>
        <translation>Comparar con el ú&amp;ltimo render</translation>
    </message>
    <message>
        <source>Find the effects of the scene</source>
        <translation>Buscar los efectos de la escena</translation>
    </message>
    <message>
        <source>Cancel: nothing is rendered</source>
        <translation>Cancelar: no se renderiza nada</translation>
    </message>
    <message>
        <source>The plan finds no effect to render</source>
        <translation>El plan no encuentra ningún efecto que renderizar</translation>
    </message>
    <message>
        <source>%1 and %2 more images exist.</source>
        <translation>%1 y %2 imágenes más ya existen.</translation>
    </message>
    <message>
        <source>They were not rendered in this session. Rendering overwrites them.</source>
        <translation>No se renderizaron en esta sesión. El render las sobrescribe.</translation>
    </message>
    <message>
        <source>No render of this session has replaced an image yet: render once more</source>
        <translation>Ningún render de esta sesión ha reemplazado una imagen todavía: renderice otra vez</translation>
    </message>
    <message>
        <source>Compare the image of the last render with the one that it replaced</source>
        <translation>Compara la imagen del último render con la que reemplazó</translation>
    </message>
    <message>
        <source>Set target error</source>
        <translation>Fijar el error objetivo</translation>
    </message>
    <message>
        <source>Error of &amp;pixels</source>
        <translation>Error de los &amp;píxeles</translation>
    </message>
    <message>
        <source>Error of pixels</source>
        <translation>Error de los píxeles</translation>
    </message>
    <message>
        <source>Show error of pi&amp;xels</source>
        <translation>Mostrar el error de los pí&amp;xeles</translation>
    </message>
    <message>
        <source>Show the relative error of the preview&apos;s pixels in false colours, as it falls</source>
        <translation>Muestra en falso color el error relativo de los píxeles de la previsualización, según disminuye</translation>
    </message>
    <message>
        <source>Where is the &amp;noise from…</source>
        <translation>De dónde viene el &amp;ruido…</translation>
    </message>
    <message>
        <source>Measure which lamps, bounces and BRDFs the noise comes from, and what helps</source>
        <translation>Mide de qué lámparas, rebotes y BRDF viene el ruido, y qué ayuda</translation>
    </message>
    <message>
        <source>Scale of the error in the Render dock</source>
        <translation>Escala del error en el panel Render</translation>
    </message>
    <message>
        <source>Visible noise</source>
        <translation>Ruido visible</translation>
    </message>
    <message>
        <source>95 % of the pixels differ by less than this from the converged image, in units of CIEDE2000: below 1 the eye sees no difference. It sees %1 pixels per degree, as on a full HD screen of 24 inches from 63 cm, with the exposure of the render options. Estimated from two halves of the samples</source>
        <translation>El 95 % de los píxeles difiere en menos que esto de la imagen convergida, en unidades de CIEDE2000: por debajo de 1 el ojo no ve diferencia alguna. Ve %1 píxeles por grado, como en una pantalla Full HD de 24 pulgadas a 63 cm, con la exposición de las opciones de render. Se estima con dos mitades de las muestras</translation>
    </message>
    <message>
        <source>1 sample</source>
        <translation>1 muestra</translation>
    </message>
    <message>
        <source>%1 of %2 parts</source>
        <translation>%1 de %2 partes</translation>
    </message>
    <message>
        <source>no workers: `bpt farm work` starts one</source>
        <translation>sin trabajadores: `bpt farm work` inicia uno</translation>
    </message>
    <message numerus="yes">
        <source>%n worker(s)</source>
        <translation>
            <numerusform>%n trabajador</numerusform>
            <numerusform>%n trabajadores</numerusform>
        </translation>
    </message>
    <message>
        <source>Machines of final renders</source>
        <translation>Máquinas de los renders finales</translation>
    </message>
    <message>
        <source>Where final renders are made; the image is the same, to the last bit. Edit &gt; Preferences &gt; Farm names the farm</source>
        <translation>Dónde se hacen los renders finales; la imagen es la misma, hasta el último bit. Editar &gt; Preferencias &gt; Granja indica la granja</translation>
    </message>
    <message>
        <source>On this machine</source>
        <translation>En esta máquina</translation>
    </message>
    <message>
        <source>On the farm %1</source>
        <translation>En la granja %1</translation>
    </message>
</context>
<context>
    <name>editor::RenderReport</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>The eye sees no noise: ΔE %1</source>
        <translation>El ojo no ve ruido: ΔE %1</translation>
    </message>
    <message>
        <source>The eye sees noise: ΔE %1, until about %2 samples</source>
        <translation>El ojo ve ruido: ΔE %1, hasta unas %2 muestras</translation>
    </message>
</context>
<context>
    <name>editor::RenderSettingsRow</name>
    <message>
        <source>&lt;p&gt;%1.&lt;/p&gt;&lt;p&gt;Default: %2. In OP files: %3&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1.&lt;/p&gt;&lt;p&gt;Por defecto: %2. En archivos OP: %3&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Muestras</translation>
    </message>
    <message>
        <source>&lt;p&gt;auto: no sample limit if there is a target error or a time limit, otherwise the default.&lt;/p&gt;</source>
        <translation>&lt;p&gt;auto: sin límite de muestras si hay un error objetivo o un límite de tiempo; si no, el valor por defecto.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Sampling scheme</source>
        <translation>Esquema de muestreo</translation>
    </message>
    <message>
        <source>as in the scene</source>
        <translation>como en la escena</translation>
    </message>
    <message>
        <source>Target error</source>
        <translation>Error objetivo</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Límite de tiempo</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
</context>
<context>
    <name>editor::RenderedMode</name>
    <message>
        <source>Preview re&amp;gion</source>
        <translation>Re&amp;gión de la vista previa</translation>
    </message>
    <message>
        <source>&amp;Denoise the view</source>
        <translation>Re&amp;ducir el ruido de la vista</translation>
    </message>
    <message>
        <source>Smooth the noise of the mode Rendered; renders to files are never denoised</source>
        <translation>Suaviza el ruido del modo Renderizado; en los renders a archivo nunca se reduce</translation>
    </message>
    <message>
        <source>Drag the region to render, Return: the middle, Escape: cancel</source>
        <translation>Arrastre la región que se renderiza, Intro: el centro, Escape: cancelar</translation>
    </message>
    <message>
        <source>Rendered: only in perspective (5)</source>
        <translation>Renderizado: solo en perspectiva (5)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Rendered: stopped</source>
        <translation>Renderizado: detenido</translation>
    </message>
    <message>
        <source>Rendered: paused</source>
        <translation>Renderizado: en pausa</translation>
    </message>
    <message>
        <source>Rendered</source>
        <translation>Renderizado</translation>
    </message>
    <message>
        <source>denoised</source>
        <translation>sin ruido</translation>
    </message>
    <message>
        <source>Render the mode Rendered only in a rectangle that is dragged; Return takes the middle</source>
        <translation>Calcula el modo Renderizado solo en un rectángulo que se arrastra; Intro toma el centro</translation>
    </message>
    <message>
        <source>Scale of the error in the view</source>
        <translation>Escala del error en la vista</translation>
    </message>
    <message>
        <source>error of pixels</source>
        <translation>error de los píxeles</translation>
    </message>
    <message>
        <source>measuring the error</source>
        <translation>midiendo el error</translation>
    </message>
</context>
<context>
    <name>editor::RendererProcess</name>
    <message>
        <source>cannot find the renderer &apos;bpt&apos;: put it into the folder %1, or into one of PATH</source>
        <translation>no se encuentra el programa de render &apos;bpt&apos;: póngalo en la carpeta %1, o en una de PATH</translation>
    </message>
    <message>
        <source>cannot start the renderer %1: %2</source>
        <translation>no se puede iniciar el programa de render %1: %2</translation>
    </message>
    <message>
        <source>the renderer was terminated by a signal</source>
        <translation>una señal terminó el programa de render</translation>
    </message>
    <message>
        <source>the renderer exited with code %1</source>
        <translation>el programa de render terminó con el código %1</translation>
    </message>
</context>
<context>
    <name>editor::RiskDialog</name>
    <message>
        <source>Check the scene</source>
        <translation>Comprobar la escena</translation>
    </message>
    <message>
        <source>Risks of the scene</source>
        <translation>Riesgos de la escena</translation>
    </message>
    <message>
        <source>Select a risk to select its faces or its object</source>
        <translation>Seleccione un riesgo para seleccionar sus caras o su objeto</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Qué hacer</translation>
    </message>
    <message>
        <source>Result of the search for values that are not finite</source>
        <translation>Resultado de la búsqueda de valores no finitos</translation>
    </message>
    <message>
        <source>&amp;Repair</source>
        <translation>&amp;Reparar</translation>
    </message>
    <message>
        <source>Repair the selected risk, as one undo step</source>
        <translation>Repara el riesgo seleccionado, en un solo paso de deshacer</translation>
    </message>
    <message>
        <source>&amp;Find values that are not finite</source>
        <translation>&amp;Buscar valores no finitos</translation>
    </message>
    <message>
        <source>Render the scene in the background with 64 samples per pixel, and explain the first sample that is infinite or NaN</source>
        <translation>Renderiza la escena en segundo plano con 64 muestras por píxel y explica la primera muestra infinita o NaN</translation>
    </message>
    <message>
        <source>Checking the scene...</source>
        <translation>Comprobando la escena...</translation>
    </message>
    <message>
        <source>Nothing was found that can make the image wrong or noisy.</source>
        <translation>No se ha encontrado nada que pueda hacer que la imagen sea incorrecta o ruidosa.</translation>
    </message>
    <message>
        <source>1 risk was found.</source>
        <translation>Se ha encontrado 1 riesgo.</translation>
    </message>
    <message>
        <source>%1 risks were found. Those that change the image most come first.</source>
        <translation>Se han encontrado %1 riesgos. Primero van los que más cambian la imagen.</translation>
    </message>
    <message>
        <source>Repair: %1</source>
        <translation>Reparar: %1</translation>
    </message>
    <message>
        <source>Rendering...</source>
        <translation>Renderizando...</translation>
    </message>
    <message>
        <source>All %L1 samples are finite.</source>
        <translation>Las %L1 muestras son finitas.</translation>
    </message>
    <message>
        <source>%L1 of %L2 samples are not finite: %3.</source>
        <translation>%L1 de %L2 muestras no son finitas: %3.</translation>
    </message>
</context>
<context>
    <name>editor::ScaleBar</name>
    <message>
        <source>Colour scale</source>
        <translation>Escala de color</translation>
    </message>
    <message>
        <source>Signed difference: luminance of the image minus that of the reference, W/(sr m2).</source>
        <translation>Diferencia con signo: luminancia de la imagen menos la de la referencia, W/(sr m2).</translation>
    </message>
    <message>
        <source>Luminance in cd/m2: the luminance of the radiance, times %1 lm/W.</source>
        <translation>Luminancia en cd/m2: la luminancia de la radiancia, por %1 lm/W.</translation>
    </message>
    <message>
        <source>A - B</source>
        <translation>A - B</translation>
    </message>
    <message>
        <source>cd/m2</source>
        <translation>cd/m2</translation>
    </message>
    <message>
        <source>Values of the layer; of three channels their luminance.</source>
        <translation>Valores de la capa; de tres canales, su luminancia.</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>Relative standard error of the pixels.</source>
        <translation>Error típico relativo de los píxeles.</translation>
    </message>
    <message>
        <source>error, %</source>
        <translation>error, %</translation>
    </message>
</context>
<context>
    <name>editor::SceneComparison</name>
    <message>
        <source>Differences between the scene and its file</source>
        <translation>Diferencias entre la escena y su archivo</translation>
    </message>
    <message>
        <source>the scene in this window</source>
        <translation>la escena en esta ventana</translation>
    </message>
    <message>
        <source>Cannot start diff: %1</source>
        <translation>No se puede iniciar diff: %1</translation>
    </message>
    <message>
        <source>The scene and its file do not differ.</source>
        <translation>La escena y su archivo no difieren.</translation>
    </message>
</context>
<context>
    <name>editor::SceneLoader</name>
    <message>
        <source>%1 (and 1 more error)</source>
        <translation>%1 (y 1 error más)</translation>
    </message>
    <message>
        <source>%1 (and %2 more errors)</source>
        <translation>%1 (y %2 errores más)</translation>
    </message>
    <message>
        <source>Cannot read %1</source>
        <translation>No se puede leer %1</translation>
    </message>
</context>
<context>
    <name>editor::SceneModel</name>
    <message>
        <source>Rename to %1</source>
        <translation>Renombrar a %1</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueado</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>sin bloquear</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>oculto</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>visible</translation>
    </message>
    <message>
        <source>Unlock the faces</source>
        <translation>Desbloquea las caras</translation>
    </message>
    <message>
        <source>Lock the faces: the view does not select them</source>
        <translation>Bloquea las caras: la vista no las selecciona</translation>
    </message>
    <message>
        <source>Show the faces</source>
        <translation>Muestra las caras</translation>
    </message>
    <message>
        <source>Hide the faces in the view</source>
        <translation>Oculta las caras en la vista</translation>
    </message>
    <message>
        <source>Add instance</source>
        <translation>Añadir instancia</translation>
    </message>
    <message>
        <source>Move in the list</source>
        <translation>Mover en la lista</translation>
    </message>
</context>
<context>
    <name>editor::SceneTree</name>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search the scene</source>
        <translation>Buscar en la escena</translation>
    </message>
    <message>
        <source>Show only items whose names contain this text</source>
        <translation>Muestra solo los elementos cuyo nombre contiene este texto</translation>
    </message>
    <message>
        <source>The scene is empty.

Open or import a file, or drop one on the window.</source>
        <translation>La escena está vacía.

Abra o importe un archivo, o suelte uno en la ventana.</translation>
    </message>
    <message>
        <source>Items of the scene</source>
        <translation>Elementos de la escena</translation>
    </message>
    <message>
        <source>Scene outliner: objects, lights and definitions; selecting an item selects its faces</source>
        <translation>Árbol de la escena: objetos, luces y definiciones; al seleccionar un elemento se seleccionan sus caras</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>Rename the item</source>
        <translation>Renombra el elemento</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Duplicate the object beside itself, as an instance that shares its mesh</source>
        <translation>Duplica el objeto a su lado, como una instancia que comparte su malla</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete the selected items</source>
        <translation>Elimina los elementos seleccionados</translation>
    </message>
    <message>
        <source>Delete unused definitions</source>
        <translation>Eliminar las definiciones sin uso</translation>
    </message>
    <message>
        <source>Delete all definitions that nothing refers to</source>
        <translation>Elimina todas las definiciones a las que nada se refiere</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Duplicar %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Eliminar %1</translation>
    </message>
    <message>
        <source>Delete %1 objects</source>
        <translation>Eliminar %1 objetos</translation>
    </message>
    <message>
        <source>All definitions are used.</source>
        <translation>Todas las definiciones se usan.</translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>1 cara</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 caras</translation>
    </message>
    <message>
        <source>rotated by %1°</source>
        <translation>rotado %1°</translation>
    </message>
    <message>
        <source>scaled by %1</source>
        <translation>escalado por %1</translation>
    </message>
    <message>
        <source>translated by %1</source>
        <translation>trasladado %1</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objetos</translation>
    </message>
    <message>
        <source>The objects of the scene, nested as in its scene graph</source>
        <translation>Los objetos de la escena, anidados como en su grafo</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>BRDFs</source>
        <translation>BRDF</translation>
    </message>
    <message>
        <source>Sampling schemes</source>
        <translation>Esquemas de muestreo</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>Texturas</translation>
    </message>
    <message>
        <source>Mesh definitions</source>
        <translation>Definiciones de mallas</translation>
    </message>
    <message>
        <source>Named definitions of the scene</source>
        <translation>Definiciones con nombre de la escena</translation>
    </message>
    <message>
        <source>A mesh</source>
        <translation>Una malla</translation>
    </message>
    <message>
        <source>mesh light</source>
        <translation>malla emisora</translation>
    </message>
    <message>
        <source>A mesh that emits light</source>
        <translation>Una malla que emite luz</translation>
    </message>
    <message>
        <source>light</source>
        <translation>claro</translation>
    </message>
    <message>
        <source>A parallelogram area light</source>
        <translation>Una luz de área con forma de paralelogramo</translation>
    </message>
    <message>
        <source>file</source>
        <translation>archivo</translation>
    </message>
    <message>
        <source>The blocks of the file %1</source>
        <translation>Los bloques del archivo %1</translation>
    </message>
    <message>
        <source>transform</source>
        <translation>transformación</translation>
    </message>
    <message>
        <source>observer</source>
        <translation>observador</translation>
    </message>
    <message>
        <source>The viewpoint for view-dependent irradiance</source>
        <translation>El punto de vista para la irradiancia que depende de él</translation>
    </message>
    <message>
        <source>use</source>
        <translation>uso</translation>
    </message>
    <message>
        <source>An instance of the mesh &apos;%1&apos;</source>
        <translation>Una instancia de la malla &apos;%1&apos;</translation>
    </message>
    <message>
        <source>unused</source>
        <translation>sin uso</translation>
    </message>
    <message>
        <source>1 use</source>
        <translation>1 uso</translation>
    </message>
    <message>
        <source>%1 uses</source>
        <translation>%1 usos</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>Color %1</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>malla</translation>
    </message>
    <message>
        <source>1 object</source>
        <translation>1 objeto</translation>
    </message>
    <message>
        <source>%1 objects</source>
        <translation>%1 objetos</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Hide or show</source>
        <translation>Ocultar o mostrar</translation>
    </message>
    <message>
        <source>Hide the faces of the selected items in the view, or show them again</source>
        <translation>Oculta en la vista las caras de los elementos seleccionados, o las vuelve a mostrar</translation>
    </message>
    <message>
        <source>Lock or unlock</source>
        <translation>Bloquear o desbloquear</translation>
    </message>
    <message>
        <source>Make the view not select the faces of the selected items, or select them again</source>
        <translation>Hace que la vista no seleccione las caras de los elementos seleccionados, o que vuelva a seleccionarlas</translation>
    </message>
</context>
<context>
    <name>editor::SceneView</name>
    <message>
        <source>default diffuse</source>
        <translation>difusa por defecto</translation>
    </message>
    <message>
        <source>textured</source>
        <translation>con textura</translation>
    </message>
    <message>
        <source>emissive</source>
        <translation>emisora</translation>
    </message>
    <message>
        <source>%1 · face %2 · %3</source>
        <translation>%1 · cara %2 · %3</translation>
    </message>
    <message>
        <source>unnamed mesh</source>
        <translation>malla sin nombre</translation>
    </message>
    <message>
        <source>light</source>
        <translation>claro</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vista 3D</translation>
    </message>
    <message>
        <source>The scene. Arrow keys orbit, with Shift they pan, plus and minus zoom, Space selects the face in the middle, F frames the selection, Home frames all, 1, 3, 7 and 9 are standard views, 5 changes perspective.</source>
        <translation>La escena. Las flechas orbitan, con Mayúsculas desplazan, más y menos acercan y alejan, Espacio selecciona la cara del centro, F encuadra la selección, Inicio lo encuadra todo, 1, 3, 7 y 9 son vistas estándar, 5 cambia la perspectiva.</translation>
    </message>
</context>
<context>
    <name>editor::ScreenControls</name>
    <message>
        <source>Exposure in stops: +1 doubles the brightness. Keys E and Shift+E.</source>
        <translation>Exposición en pasos: +1 duplica el brillo. Teclas E y Mayúsculas+E.</translation>
    </message>
    <message>
        <source>Exposure in stops</source>
        <translation>Exposición en pasos</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposición</translation>
    </message>
    <message>
        <source>sRGB</source>
        <translation>sRGB</translation>
    </message>
    <message>
        <source>Filmic</source>
        <translation>Película</translation>
    </message>
    <message>
        <source>Reinhard</source>
        <translation>Reinhard</translation>
    </message>
    <message>
        <source>Tone curve</source>
        <translation>Curva de tonos</translation>
    </message>
    <message>
        <source>Tone mapping of radiance for the screen. sRGB: as in 8-bit files, clipped at 1. Filmic: highlights roll off as on film. Reinhard: x / (1 + x), without clipping.</source>
        <translation>Mapeo de tonos de la radiancia para la pantalla. sRGB: como en archivos de 8 bits, recortado en 1. Película: las altas luces se atenúan como en una película. Reinhard: x / (1 + x), sin recorte.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
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
        <source>Luminance</source>
        <translation>Luminancia</translation>
    </message>
    <message>
        <source>False colour</source>
        <translation>Falso color</translation>
    </message>
    <message>
        <source>Channels shown</source>
        <translation>Canales que se muestran</translation>
    </message>
    <message>
        <source>Channels that are shown: all, one of them, the luminance in grey, or the luminance in false colours with a scale. Keys C, R, G, B, Y and P.</source>
        <translation>Canales que se muestran: todos, uno de ellos, la luminancia en gris, o la luminancia en falso color con una escala. Teclas C, R, G, B, Y y P.</translation>
    </message>
</context>
<context>
    <name>editor::SelectionActions</name>
    <message>
        <source>&amp;All</source>
        <translation>&amp;Todas</translation>
    </message>
    <message>
        <source>Select all faces</source>
        <translation>Selecciona todas las caras</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Ninguna</translation>
    </message>
    <message>
        <source>Deselect all faces</source>
        <translation>Deselecciona todas las caras</translation>
    </message>
    <message>
        <source>Invert the selection</source>
        <translation>Invierte la selección</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>A&amp;mpliar</translation>
    </message>
    <message>
        <source>Grow the selection by faces that share an edge with it</source>
        <translation>Amplía la selección con las caras que comparten una arista con ella</translation>
    </message>
    <message>
        <source>&amp;Shrink</source>
        <translation>&amp;Reducir</translation>
    </message>
    <message>
        <source>Shrink the selection by the faces at its border</source>
        <translation>Reduce la selección en las caras de su borde</translation>
    </message>
    <message>
        <source>&amp;Connected</source>
        <translation>&amp;Conectadas</translation>
    </message>
    <message>
        <source>Select all faces that are connected to the selected ones</source>
        <translation>Selecciona todas las caras conectadas con las seleccionadas</translation>
    </message>
    <message>
        <source>Expand to whole &amp;mesh</source>
        <translation>Extender a toda la ma&amp;lla</translation>
    </message>
    <message>
        <source>Expand the selection to all faces of its meshes</source>
        <translation>Extiende la selección a todas las caras de sus mallas</translation>
    </message>
    <message>
        <source>Select &amp;faces by...</source>
        <translation>&amp;Seleccionar caras por...</translation>
    </message>
    <message>
        <source>Select faces by normal, area, height, material, and by several similarities at once</source>
        <translation>Selecciona caras por normal, área, altura, material, y por varias semejanzas a la vez</translation>
    </message>
    <message>
        <source>Within %1°</source>
        <translation>Hasta %1°</translation>
    </message>
    <message>
        <source>Select connected faces that are coplanar within %1°</source>
        <translation>Selecciona las caras conectadas que son coplanarias hasta %1°</translation>
    </message>
    <message>
        <source>&amp;BRDF</source>
        <translation>&amp;BRDF</translation>
    </message>
    <message>
        <source>Select all faces with the same BRDF as a selected one</source>
        <translation>Selecciona todas las caras con la misma BRDF que una seleccionada</translation>
    </message>
    <message>
        <source>&amp;Sampling</source>
        <translation>&amp;Muestreo</translation>
    </message>
    <message>
        <source>Select all faces with the same sampling scheme as a selected one</source>
        <translation>Selecciona todas las caras con el mismo esquema de muestreo que una seleccionada</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Color</translation>
    </message>
    <message>
        <source>Select all faces with the same colour as a selected one</source>
        <translation>Selecciona todas las caras con el mismo color que una seleccionada</translation>
    </message>
    <message>
        <source>&amp;Texture</source>
        <translation>Te&amp;xtura</translation>
    </message>
    <message>
        <source>Select all faces with the same texture as a selected one</source>
        <translation>Selecciona todas las caras con la misma textura que una seleccionada</translation>
    </message>
    <message>
        <source>&amp;Emission</source>
        <translation>&amp;Emisión</translation>
    </message>
    <message>
        <source>Select all faces with the same emission as a selected one</source>
        <translation>Selecciona todas las caras con la misma emisión que una seleccionada</translation>
    </message>
    <message>
        <source>Select all faces with the same surface as a selected one</source>
        <translation>Selecciona todas las caras con la misma superficie que una seleccionada</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>La&amp;zo</translation>
    </message>
    <message>
        <source>Drag a lasso around faces instead of a box</source>
        <translation>Arrastra un lazo alrededor de las caras en vez de un recuadro</translation>
    </message>
    <message>
        <source>Select &amp;through</source>
        <translation>Seleccionar a tra&amp;vés</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Brocha</translation>
    </message>
    <message>
        <source>Paint over faces to select them, with Ctrl to deselect them; [ and ] change the radius, Escape ends</source>
        <translation>Pinta sobre las caras para seleccionarlas, con Ctrl para deseleccionarlas; [ y ] cambian el radio, Escape termina</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>&amp;Polígono</translation>
    </message>
    <message>
        <source>Click the corners of a polygon around faces; Return or a double click selects, Escape ends</source>
        <translation>Haga clic en las esquinas de un polígono alrededor de las caras; Intro o un doble clic selecciona, Escape termina</translation>
    </message>
    <message>
        <source>C&amp;oplanar</source>
        <translation>C&amp;oplanarias</translation>
    </message>
    <message>
        <source>Select simila&amp;r</source>
        <translation>S&amp;eleccionar similares</translation>
    </message>
    <message>
        <source>Select occluded faces, too, with boxes, lassos, brush and polygon</source>
        <translation>Selecciona también las caras ocultas tras otras, con rectángulos, lazos, pincel y polígono</translation>
    </message>
    <message>
        <source>In&amp;vert</source>
        <translation>&amp;Invertir</translation>
    </message>
</context>
<context>
    <name>editor::ShaderTextView</name>
    <message>
        <source>BRDF</source>
        <translation>BRDF</translation>
    </message>
    <message>
        <source>The BRDF whose shader is shown</source>
        <translation>La BRDF cuyo shader se muestra</translation>
    </message>
    <message>
        <source>Shader - BRDF viewer</source>
        <translation>Shader - visor de BRDF</translation>
    </message>
    <message>
        <source>BRDF A</source>
        <translation>BRDF A</translation>
    </message>
    <message>
        <source>BRDF B</source>
        <translation>BRDF B</translation>
    </message>
    <message>
        <source>Fragment shader</source>
        <translation>Shader de fragmentos</translation>
    </message>
    <message>
        <source>This BRDF has no shader: it is shaded on the CPU.</source>
        <translation>Esta BRDF no tiene shader: se sombrea en la CPU.</translation>
    </message>
</context>
<context>
    <name>editor::ShapeForm</name>
    <message>
        <source>New plane</source>
        <translation>Plano nuevo</translation>
    </message>
    <message>
        <source>New box</source>
        <translation>Caja nueva</translation>
    </message>
    <message>
        <source>New sphere</source>
        <translation>Esfera nueva</translation>
    </message>
    <message>
        <source>New cylinder</source>
        <translation>Cilindro nuevo</translation>
    </message>
    <message>
        <source>New disc</source>
        <translation>Disco nuevo</translation>
    </message>
    <message>
        <source>New torus</source>
        <translation>Toro nuevo</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Width of the new shape</source>
        <translation>Anchura de la forma nueva</translation>
    </message>
    <message>
        <source>extent along x</source>
        <translation>extensión a lo largo de x</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Depth of the new shape</source>
        <translation>Profundidad de la forma nueva</translation>
    </message>
    <message>
        <source>extent along z</source>
        <translation>extensión a lo largo de z</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Radius of the new shape</source>
        <translation>Radio de la forma nueva</translation>
    </message>
    <message>
        <source>distance from the axis; of a torus to the middle of its tube</source>
        <translation>distancia al eje; en un toro, hasta el centro de su tubo</translation>
    </message>
    <message>
        <source>Tube radius</source>
        <translation>Radio del tubo</translation>
    </message>
    <message>
        <source>Tube radius of the new shape</source>
        <translation>Radio del tubo de la forma nueva</translation>
    </message>
    <message>
        <source>radius of the tube of a torus</source>
        <translation>radio del tubo de un toro</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Height of the new shape</source>
        <translation>Altura de la forma nueva</translation>
    </message>
    <message>
        <source>extent along y</source>
        <translation>extensión a lo largo de y</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmentos</translation>
    </message>
    <message>
        <source>Segments of the new shape</source>
        <translation>Segmentos de la forma nueva</translation>
    </message>
    <message>
        <source>number of faces about the y axis; spheres and tubes have half as many across</source>
        <translation>número de caras alrededor del eje y; las esferas y los tubos tienen la mitad a lo ancho</translation>
    </message>
</context>
<context>
    <name>editor::SkyDialog</name>
    <message>
        <source>Sky by place and time</source>
        <translation>Cielo según lugar y hora</translation>
    </message>
    <message>
        <source>Picture of the sky</source>
        <translation>Imagen del cielo</translation>
    </message>
    <message>
        <source>The environment map: its middle is toward -z, its right half toward +x</source>
        <translation>El mapa de entorno: su centro está hacia -z, su mitad derecha hacia +x</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Latitud</translation>
    </message>
    <message>
        <source>Latitude of the place; north is positive</source>
        <translation>Latitud del lugar; el norte es positivo</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Longitude of the place; east is positive</source>
        <translation>Longitud del lugar; el este es positivo</translation>
    </message>
    <message>
        <source>Offset from UTC</source>
        <translation>Diferencia con UTC</translation>
    </message>
    <message>
        <source>Hours that the local time is ahead of UTC; with daylight saving time one more</source>
        <translation>Horas que la hora local está adelantada respecto a UTC; con el horario de verano, una más</translation>
    </message>
    <message>
        <source>Turbidity</source>
        <translation>Turbidez</translation>
    </message>
    <message>
        <source>Turbidity of the air, from clear, 2, to hazy, 6</source>
        <translation>Turbidez del aire, de despejado, 2, a brumoso, 6</translation>
    </message>
    <message>
        <source>Direction of north</source>
        <translation>Dirección del norte</translation>
    </message>
    <message>
        <source>Direction of north from -z, counter-clockwise seen from above; with 0, east is +x</source>
        <translation>Dirección del norte desde -z, en sentido antihorario visto desde arriba; con 0, el este es +x</translation>
    </message>
    <message>
        <source>The sun and its light</source>
        <translation>El sol y su luz</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>The day: year, month and day, from 1950 to 2050</source>
        <translation>El día: año, mes y día, de 1950 a 2050</translation>
    </message>
    <message>
        <source>Local time</source>
        <translation>Hora local</translation>
    </message>
    <message>
        <source>The local time of the day</source>
        <translation>La hora local del día</translation>
    </message>
    <message>
        <source>Set environment</source>
        <translation>Cambiar el entorno</translation>
    </message>
    <message>
        <source>Write the map as OpenEXR, and light the scene by it</source>
        <translation>Escribe el mapa como OpenEXR e ilumina la escena con él</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Close without a map</source>
        <translation>Cierra sin ningún mapa</translation>
    </message>
    <message>
        <source>The sun is %1° below the horizon: the model is one of the day.</source>
        <translation>El sol está %1° bajo el horizonte: el modelo es del día.</translation>
    </message>
    <message>
        <source>Sun: azimuth %1° from north over east, elevation %2°. Horizontal illuminance: %3 klux by the sun, %4 klux by the sky.</source>
        <translation>Sol: acimut %1° desde el norte por el este, elevación %2°. Iluminancia horizontal: %3 klux del sol, %4 klux del cielo.</translation>
    </message>
</context>
<context>
    <name>editor::SourceText</name>
    <message>
        <source>Text of the file</source>
        <translation>Texto del archivo</translation>
    </message>
    <message>
        <source>The file as it is on disk, read-only. Edit it in the text editor.</source>
        <translation>El archivo como está en el disco, de solo lectura. Edítelo en el editor de texto.</translation>
    </message>
</context>
<context>
    <name>editor::SourceView</name>
    <message>
        <source>Lines %1 to %2 of %3: the file is too long to be shown whole.</source>
        <translation>Líneas %1 a %2 de %3: el archivo es demasiado largo para mostrarlo entero.</translation>
    </message>
    <message>
        <source>Lines with more than %1 characters are shown in part.</source>
        <translation>Las líneas con más de %1 caracteres se muestran en parte.</translation>
    </message>
    <message>
        <source>No file is shown.

Select a message to see the line that it refers to.</source>
        <translation>No se muestra ningún archivo.

Seleccione un mensaje para ver la línea a la que se refiere.</translation>
    </message>
    <message>
        <source>Open in text editor</source>
        <translation>Abrir en el editor de texto</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Source text</source>
        <translation>Texto del archivo</translation>
    </message>
    <message>
        <source>Path of the file</source>
        <translation>Ruta del archivo</translation>
    </message>
    <message>
        <source>No file</source>
        <translation>Ningún archivo</translation>
    </message>
    <message>
        <source>No file is shown yet: select a message first</source>
        <translation>Aún no se muestra ningún archivo: seleccione antes un mensaje</translation>
    </message>
    <message>
        <source>Open the file in the default program of the desktop</source>
        <translation>Abre el archivo en el programa por defecto del escritorio</translation>
    </message>
    <message>
        <source>Reload the file from disk (F5)</source>
        <translation>Recarga el archivo del disco (F5)</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 no es un archivo</translation>
    </message>
    <message>
        <source>Cannot read %1: %2</source>
        <translation>No se puede leer %1: %2</translation>
    </message>
</context>
<context>
    <name>editor::SphereRenderer</name>
    <message>
        <source>The graphics driver cannot compile the shader of a BRDF: its sphere is shaded on the CPU: %1</source>
        <translation>El controlador gráfico no puede compilar el shader de una BRDF: su esfera se sombrea en la CPU: %1</translation>
    </message>
</context>
<context>
    <name>editor::StatusLine</name>
    <message>
        <source>Message</source>
        <translation>Mensaje</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Progress of the job</source>
        <translation>Progreso del trabajo</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Recuento</translation>
    </message>
    <message>
        <source>Selected faces, and triangles of the whole scene with all instances</source>
        <translation>Caras seleccionadas, y triángulos de toda la escena con todas las instancias</translation>
    </message>
    <message>
        <source>%1 of %2 selected  ·  %3</source>
        <translation>%1 de %2 seleccionadas  ·  %3</translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>1 cara</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 caras</translation>
    </message>
    <message>
        <source>1 triangle</source>
        <translation>1 triángulo</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 triángulos</translation>
    </message>
    <message>
        <source>%1 (+%2)</source>
        <translation>%1 (+%2)</translation>
    </message>
</context>
<context>
    <name>editor::StudyForm</name>
    <message>
        <source>Open a file, or drop it here</source>
        <translation>Abra un archivo, o suéltelo aquí</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Distribución</translation>
    </message>
    <message>
        <source>BRDF</source>
        <translation>BRDF</translation>
    </message>
    <message>
        <source>Sampling scheme</source>
        <translation>Esquema de muestreo</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>The files that are shown; drop others here or on the figure</source>
        <translation>Los archivos que se muestran; suelte otros aquí o en la figura</translation>
    </message>
    <message>
        <source>Add a file</source>
        <translation>Añadir un archivo</translation>
    </message>
    <message>
        <source>Open a file of the kinds that the tool shows</source>
        <translation>Abre un archivo de los tipos que muestra la herramienta</translation>
    </message>
    <message>
        <source>Remove the file</source>
        <translation>Quitar el archivo</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Remove the selected file from the figure</source>
        <translation>Quita el archivo seleccionado de la figura</translation>
    </message>
    <message>
        <source>No file is selected.</source>
        <translation>No hay ningún archivo seleccionado.</translation>
    </message>
</context>
<context>
    <name>editor::StudyWindow</name>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>Stop computing the figure</source>
        <translation>Detiene el cálculo de la figura</translation>
    </message>
    <message>
        <source>No file is open.

Open a file (Ctrl+O), or drop one here.</source>
        <translation>No hay ningún archivo abierto.

Abra un archivo (Ctrl+O) o suéltelo aquí.</translation>
    </message>
    <message>
        <source>There is no figure for these settings: see the message above.</source>
        <translation>No hay figura para estos ajustes: vea el mensaje de arriba.</translation>
    </message>
</context>
<context>
    <name>editor::SurfacePanel</name>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>No face is selected.

Click a face in the view, drag a box around several, or select an object in the Scene dock.</source>
        <translation>No hay ninguna cara seleccionada.

Haga clic en una cara de la vista, arrastre un recuadro alrededor de varias, o seleccione un objeto en el panel Escena.</translation>
    </message>
    <message>
        <source>World-space area of the selected faces, summed over all instances</source>
        <translation>Área de las caras seleccionadas en el espacio de la escena, sumada sobre todas las instancias</translation>
    </message>
    <message>
        <source>Copy surface from a face</source>
        <translation>Copiar la superficie de una cara</translation>
    </message>
    <message>
        <source>Copy surface from the face that you click in the view</source>
        <translation>Copia la superficie de la cara en la que haga clic en la vista</translation>
    </message>
    <message>
        <source>&amp;BRDF</source>
        <translation>&amp;BRDF</translation>
    </message>
    <message>
        <source>Sam&amp;pling</source>
        <translation>&amp;Muestreo</translation>
    </message>
    <message>
        <source>C&amp;olour</source>
        <translation>C&amp;olor</translation>
    </message>
    <message>
        <source>Te&amp;xture</source>
        <translation>Te&amp;xtura</translation>
    </message>
    <message>
        <source>E&amp;mission</source>
        <translation>Emisió&amp;n</translation>
    </message>
    <message>
        <source>&amp;Normals</source>
        <translation>Norma&amp;les</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vértices</translation>
    </message>
    <message>
        <source>Irr&amp;adiance</source>
        <translation>Irra&amp;diancia</translation>
    </message>
    <message>
        <source>1 face selected</source>
        <translation>1 cara seleccionada</translation>
    </message>
    <message>
        <source>%1 faces selected</source>
        <translation>%1 caras seleccionadas</translation>
    </message>
    <message>
        <source>Pick BRDF</source>
        <translation>Tomar la BRDF</translation>
    </message>
    <message>
        <source>Opacit&amp;y</source>
        <translation>Opa&amp;cidad</translation>
    </message>
</context>
<context>
    <name>editor::TermsEditor</name>
    <message>
        <source>Add a BRDF</source>
        <translation>Añadir una BRDF</translation>
    </message>
    <message>
        <source>Add a BRDF to the sum</source>
        <translation>Añadir una BRDF a la suma</translation>
    </message>
    <message>
        <source>Define named BRDFs in the scene first: a sum refers to those.</source>
        <translation>Defina antes BRDF con nombre en la escena: una suma se refiere a ellas.</translation>
    </message>
    <message>
        <source>The faces have different sums. Adding a BRDF here replaces them.</source>
        <translation>Las caras tienen sumas distintas. Añadir aquí una BRDF las reemplaza.</translation>
    </message>
    <message>
        <source>Add the BRDFs of the sum.</source>
        <translation>Añada las BRDF de la suma.</translation>
    </message>
    <message>
        <source>The scene has no named BRDFs</source>
        <translation>La escena no tiene BRDF con nombre</translation>
    </message>
    <message>
        <source>Add a BRDF of the scene, with a weight</source>
        <translation>Añade una BRDF de la escena, con un peso</translation>
    </message>
    <message>
        <source>The weight of this BRDF in the sum</source>
        <translation>El peso de esta BRDF en la suma</translation>
    </message>
    <message>
        <source>BRDF of the term</source>
        <translation>BRDF del término</translation>
    </message>
    <message>
        <source>A BRDF that the scene defines</source>
        <translation>Una BRDF que define la escena</translation>
    </message>
    <message>
        <source>Remove this BRDF from the sum</source>
        <translation>Quita esta BRDF de la suma</translation>
    </message>
    <message>
        <source>weight of %1</source>
        <translation>peso de %1</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>quitar %1</translation>
    </message>
</context>
<context>
    <name>editor::TextureImage</name>
    <message>
        <source>reading %1 …</source>
        <translation>leyendo %1 …</translation>
    </message>
</context>
<context>
    <name>editor::TexturePreview</name>
    <message>
        <source>Texture</source>
        <translation>Textura</translation>
    </message>
    <message>
        <source>The texture, with the selected faces drawn at their texture coordinates (UVs)</source>
        <translation>La textura, con las caras seleccionadas dibujadas en sus coordenadas de textura (UV)</translation>
    </message>
</context>
<context>
    <name>editor::TextureRow</name>
    <message>
        <source>Set texture</source>
        <translation>Cambiar la textura</translation>
    </message>
    <message>
        <source>Remove texture</source>
        <translation>Quitar la textura</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textura</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Browse for an image</source>
        <translation>Buscar una imagen</translation>
    </message>
    <message>
        <source>Browse for an image file</source>
        <translation>Busca un archivo de imagen</translation>
    </message>
    <message>
        <source>Remove the texture</source>
        <translation>Quita la textura</translation>
    </message>
    <message>
        <source>The faces have no texture coordinates (UVs): all of them show the same point of the image.</source>
        <translation>Las caras no tienen coordenadas de textura (UV): todas muestran el mismo punto de la imagen.</translation>
    </message>
    <message>
        <source>Image texture that multiplies the colour: a texture of the scene, or a file name</source>
        <translation>Imagen de textura que multiplica el color: una textura de la escena, o un nombre de archivo</translation>
    </message>
    <message>
        <source>The faces have no texture.</source>
        <translation>Las caras no tienen textura.</translation>
    </message>
    <message>
        <source>Images (%1);;All files (*)</source>
        <translation>Imágenes (%1);;Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>editor::ToolWindow</name>
    <message>
        <source>%1 - wannabe</source>
        <translation>%1 - wannabe</translation>
    </message>
    <message>
        <source>What is under the pointer</source>
        <translation>Lo que hay bajo el puntero</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>Open the settings of a figure, or files that the tool shows</source>
        <translation>Abre los ajustes de una figura, o archivos que muestra la herramienta</translation>
    </message>
    <message>
        <source>&amp;Save settings...</source>
        <translation>&amp;Guardar los ajustes...</translation>
    </message>
    <message>
        <source>Save the settings as text, from which the figure can be made again</source>
        <translation>Guarda los ajustes como texto, con el que la figura se puede hacer de nuevo</translation>
    </message>
    <message>
        <source>&amp;Export figure...</source>
        <translation>&amp;Exportar la figura...</translation>
    </message>
    <message>
        <source>Export the figure as SVG, PNG or PDF</source>
        <translation>Exporta la figura como SVG, PNG o PDF</translation>
    </message>
    <message>
        <source>Export the figure</source>
        <translation>Exportar la figura</translation>
    </message>
    <message>
        <source>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</source>
        <translation>SVG (*.svg);;PNG (*.png);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Export &amp;data...</source>
        <translation>Exportar los da&amp;tos...</translation>
    </message>
    <message>
        <source>Export the values of the figure, or its images</source>
        <translation>Exporta los valores de la figura, o sus imágenes</translation>
    </message>
    <message>
        <source>Export &amp;animation...</source>
        <translation>Exportar la a&amp;nimación...</translation>
    </message>
    <message>
        <source>Export a picture for each of %1 steps of %2</source>
        <translation>Exporta una imagen por cada uno de %1 pasos de %2</translation>
    </message>
    <message>
        <source>Export the animation</source>
        <translation>Exportar la animación</translation>
    </message>
    <message>
        <source>PNG (*.png);;SVG (*.svg);;PDF (*.pdf)</source>
        <translation>PNG (*.png);;SVG (*.svg);;PDF (*.pdf)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cierra esta ventana</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edición</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Undo the last change of the settings</source>
        <translation>Deshace el último cambio de los ajustes</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Redo the change that was undone</source>
        <translation>Rehace el cambio que se deshizo</translation>
    </message>
    <message>
        <source>&amp;Copy settings</source>
        <translation>&amp;Copiar los ajustes</translation>
    </message>
    <message>
        <source>Copy the settings as text</source>
        <translation>Copia los ajustes como texto</translation>
    </message>
    <message>
        <source>&amp;Paste settings</source>
        <translation>&amp;Pegar los ajustes</translation>
    </message>
    <message>
        <source>Paste settings from text</source>
        <translation>Pega los ajustes desde texto</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>portapapeles</translation>
    </message>
    <message>
        <source>Reset &amp;all settings</source>
        <translation>Restablecer &amp;todos los ajustes</translation>
    </message>
    <message>
        <source>Reset the tool to its first settings</source>
        <translation>Restablece los primeros ajustes de la herramienta</translation>
    </message>
    <message>
        <source>Apply to the &amp;faces</source>
        <translation>Aplicar a las ca&amp;ras</translation>
    </message>
    <message>
        <source>Apply the BRDF to the faces that are selected in the editor</source>
        <translation>Aplica la BRDF a las caras seleccionadas en el editor</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>Show all values of %1 one after the other</source>
        <translation>Muestra todos los valores de %1 uno tras otro</translation>
    </message>
    <message>
        <source>This tool has no BRDF of its own.</source>
        <translation>Esta herramienta no tiene BRDF propia.</translation>
    </message>
    <message>
        <source>Open this tool from the editor to apply its BRDF to faces.</source>
        <translation>Abra esta herramienta desde el editor para aplicar su BRDF a caras.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Files of this tool (%1)</source>
        <translation>Archivos de esta herramienta (%1)</translation>
    </message>
    <message>
        <source>Save the settings</source>
        <translation>Guardar los ajustes</translation>
    </message>
    <message>
        <source>Settings (*.%1)</source>
        <translation>Ajustes (*.%1)</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>Se ha escrito %1</translation>
    </message>
    <message>
        <source>Export the data</source>
        <translation>Exportar los datos</translation>
    </message>
    <message>
        <source>GRF &amp;viewer</source>
        <translation>&amp;Visor de GRF</translation>
    </message>
    <message>
        <source>View a scene without editing it</source>
        <translation>Muestra una escena sin editarla</translation>
    </message>
    <message>
        <source>Render &amp;options</source>
        <translation>&amp;Opciones de render</translation>
    </message>
    <message>
        <source>Edit and check the render options of an OP file</source>
        <translation>Edita y comprueba las opciones de render de un archivo OP</translation>
    </message>
    <message>
        <source>&amp;Image view</source>
        <translation>Vista de &amp;imágenes</translation>
    </message>
    <message>
        <source>View and compare images, and renders in progress</source>
        <translation>Muestra y compara imágenes, y renders en marcha</translation>
    </message>
</context>
<context>
    <name>editor::UvPanel</name>
    <message>
        <source>UV</source>
        <translation>UV</translation>
    </message>
    <message>
        <source>Select faces to see and edit their texture coordinates (UVs).</source>
        <translation>Seleccione caras para ver y editar sus coordenadas de textura (UV).</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Proyectar</translation>
    </message>
    <message>
        <source>Project or transform the texture coordinates of the selected faces</source>
        <translation>Proyecta o transforma las coordenadas de textura de las caras seleccionadas</translation>
    </message>
    <message>
        <source>Fit the view</source>
        <translation>Ajustar la vista</translation>
    </message>
    <message>
        <source>Fit the image and the faces into the view</source>
        <translation>Ajusta la imagen y las caras a la vista</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centro</translation>
    </message>
    <message>
        <source>centre of the bounds of the texture coordinates</source>
        <translation>centro de los límites de las coordenadas de textura</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>size of their bounds; the image has the size 1</source>
        <translation>tamaño de sus límites; la imagen tiene el tamaño 1</translation>
    </message>
    <message>
        <source>Move texture coordinates</source>
        <translation>Mover coordenadas de textura</translation>
    </message>
    <message>
        <source>%1 u, v</source>
        <translation>%1 u, v</translation>
    </message>
    <message>
        <source>UV %1</source>
        <translation>UV %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Scale texture coordinates</source>
        <translation>Escalar coordenadas de textura</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>Rotar</translation>
    </message>
    <message>
        <source>UV rotation</source>
        <translation>Rotación UV</translation>
    </message>
    <message>
        <source>Rotate by: angle to the left, about the centre of the bounds</source>
        <translation>Rotar: ángulo hacia la izquierda, en torno al centro de los límites</translation>
    </message>
    <message>
        <source>Rotate texture coordinates</source>
        <translation>Rotar coordenadas de textura</translation>
    </message>
    <message>
        <source>%1 of %2 faces are drawn</source>
        <translation>se dibujan %1 de %2 caras</translation>
    </message>
    <message>
        <source>1 face</source>
        <translation>1 cara</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 caras</translation>
    </message>
    <message>
        <source>The faces have no texture coordinates: project some.</source>
        <translation>Las caras no tienen coordenadas de textura: proyecte unas.</translation>
    </message>
</context>
<context>
    <name>editor::UvView</name>
    <message>
        <source>Texture coordinates</source>
        <translation>Coordenadas de textura</translation>
    </message>
    <message>
        <source>The selected faces over their image; a drag or the arrows move their texture coordinates, the wheel zooms, the middle button pans, 0 fits</source>
        <translation>Las caras seleccionadas sobre su imagen; arrastrar o las flechas mueven sus coordenadas de textura, la rueda amplía, el botón central desplaza, 0 ajusta</translation>
    </message>
</context>
<context>
    <name>editor::VertexRow</name>
    <message>
        <source>Vertex colour</source>
        <translation>Color de los vértices</translation>
    </message>
    <message>
        <source>linear RGB per vertex, which replaces the colour</source>
        <translation>RGB lineal por vértice, que reemplaza el color</translation>
    </message>
    <message>
        <source>Irradiance</source>
        <translation>Irradiancia</translation>
    </message>
    <message>
        <source>irradiance per vertex, W/m²</source>
        <translation>irradiancia por vértice, W/m²</translation>
    </message>
    <message>
        <source>Bake the irradiance</source>
        <translation>Precalcular la irradiancia</translation>
    </message>
    <message>
        <source>Bake the irradiance at all vertices of the scene</source>
        <translation>Precalcula la irradiancia en todos los vértices de la escena</translation>
    </message>
    <message>
        <source>Clear the vertex colours</source>
        <translation>Borrar los colores de los vértices</translation>
    </message>
    <message>
        <source>Clear the irradiance</source>
        <translation>Borrar la irradiancia</translation>
    </message>
    <message>
        <source>The vertices have no colours.</source>
        <translation>Los vértices no tienen colores.</translation>
    </message>
    <message>
        <source>The vertices have no irradiance.</source>
        <translation>Los vértices no tienen irradiancia.</translation>
    </message>
    <message>
        <source>Clear the irradiance of the vertices</source>
        <translation>Borra la irradiancia de los vértices</translation>
    </message>
    <message>
        <source>Set vertex colours</source>
        <translation>Cambiar los colores de los vértices</translation>
    </message>
    <message>
        <source>Set irradiance</source>
        <translation>Cambiar la irradiancia</translation>
    </message>
</context>
<context>
    <name>editor::ViewActions</name>
    <message>
        <source>&amp;Grid and axes</source>
        <translation>&amp;Cuadrícula y ejes</translation>
    </message>
    <message>
        <source>Show the ground grid in whole units, and the axes</source>
        <translation>Muestra la cuadrícula del suelo en unidades enteras, y los ejes</translation>
    </message>
    <message>
        <source>Show face normals as lines</source>
        <translation>Muestra las normales de las caras como líneas</translation>
    </message>
    <message>
        <source>Show vertex normals as lines</source>
        <translation>Muestra las normales de los vértices como líneas</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>Encuadrar &amp;todo</translation>
    </message>
    <message>
        <source>Frame the whole scene</source>
        <translation>Encuadra toda la escena</translation>
    </message>
    <message>
        <source>Frame the selected faces</source>
        <translation>Encuadra las caras seleccionadas</translation>
    </message>
    <message>
        <source>Look along -z</source>
        <translation>Mira según -z</translation>
    </message>
    <message>
        <source>Look along -x</source>
        <translation>Mira según -x</translation>
    </message>
    <message>
        <source>Look along -y</source>
        <translation>Mira según -y</translation>
    </message>
    <message>
        <source>Look from the opposite side</source>
        <translation>Mira desde el lado opuesto</translation>
    </message>
    <message>
        <source>Toggle perspective and orthographic projection</source>
        <translation>Alterna entre proyección en perspectiva y ortográfica</translation>
    </message>
    <message>
        <source>Display mode of the scene (Alt and a digit)</source>
        <translation>Modo de visualización de la escena (Alt y una cifra)</translation>
    </message>
    <message>
        <source>Display mode</source>
        <translation>Modo de visualización</translation>
    </message>
    <message>
        <source>Only vertices</source>
        <translation>Solo vértices</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>A&amp;lámbrico</translation>
    </message>
    <message>
        <source>Only edges</source>
        <translation>Solo aristas</translation>
    </message>
    <message>
        <source>Faces in their colours, lit by a headlight</source>
        <translation>Caras con sus colores, iluminadas por una luz frontal</translation>
    </message>
    <message>
        <source>Faces in their colours, with their edges</source>
        <translation>Caras con sus colores y con sus aristas</translation>
    </message>
    <message>
        <source>Faces with their textures</source>
        <translation>Caras con sus texturas</translation>
    </message>
    <message>
        <source>The vertex colours</source>
        <translation>Los colores de los vértices</translation>
    </message>
    <message>
        <source>&amp;Irradiance</source>
        <translation>&amp;Irradiancia</translation>
    </message>
    <message>
        <source>The irradiance baked at the vertices</source>
        <translation>La irradiancia precalculada en los vértices</translation>
    </message>
    <message>
        <source>&amp;BRDF</source>
        <translation>&amp;BRDF</translation>
    </message>
    <message>
        <source>Faces shaded with their BRDFs, lit by a headlight and a sky</source>
        <translation>Caras sombreadas con sus BRDF, iluminadas por una luz frontal y un cielo</translation>
    </message>
    <message>
        <source>The renderer&apos;s preview, which follows the view and your edits</source>
        <translation>La vista previa del renderizador, que sigue a la vista y a sus ediciones</translation>
    </message>
    <message>
        <source>Poi&amp;nts</source>
        <translation>Punto&amp;s</translation>
    </message>
    <message>
        <source>So&amp;lid</source>
        <translation>Sólid&amp;o</translation>
    </message>
    <message>
        <source>&amp;Solid with edges</source>
        <translation>Sólido con &amp;aristas</translation>
    </message>
    <message>
        <source>T&amp;extured</source>
        <translation>Con te&amp;xturas</translation>
    </message>
    <message>
        <source>Vertex colo&amp;urs</source>
        <translation>Colores de los &amp;vértices</translation>
    </message>
    <message>
        <source>Ren&amp;dered</source>
        <translation>Renderi&amp;zado</translation>
    </message>
    <message>
        <source>Face nor&amp;mals</source>
        <translation>&amp;Normales de las caras</translation>
    </message>
    <message>
        <source>Verte&amp;x normals</source>
        <translation>No&amp;rmales de los vértices</translation>
    </message>
    <message>
        <source>F&amp;rame selection</source>
        <translation>&amp;Encuadrar la selección</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Frente</translation>
    </message>
    <message>
        <source>Rig&amp;ht</source>
        <translation>&amp;Derecha</translation>
    </message>
    <message>
        <source>To&amp;p</source>
        <translation>&amp;Planta</translation>
    </message>
    <message>
        <source>&amp;Opposite</source>
        <translation>Op&amp;uesta</translation>
    </message>
    <message>
        <source>Perspecti&amp;ve or orthographic</source>
        <translation>Pro&amp;yección perspectiva u ortográfica</translation>
    </message>
</context>
<context>
    <name>editor::ViewController</name>
    <message>
        <source>Move the light</source>
        <translation>Mover la luz</translation>
    </message>
    <message>
        <source>Move the observer</source>
        <translation>Mover el observador</translation>
    </message>
    <message>
        <source>%1 is the environment now</source>
        <translation>%1 es ahora el entorno</translation>
    </message>
    <message>
        <source>Add an observer</source>
        <translation>Añadir un observador</translation>
    </message>
    <message>
        <source>Add instance</source>
        <translation>Añadir instancia</translation>
    </message>
</context>
<context>
    <name>editor::ViewDrawing</name>
    <message>
        <source>The graphics driver cannot compile the shader of the BRDF %1: the 3D view shades it on the CPU, more slowly: %2</source>
        <translation>El controlador gráfico no puede compilar el shader de la BRDF %1: la vista 3D la sombrea en la CPU, más despacio: %2</translation>
    </message>
    <message>
        <source>The BRDF %1 is previewed as diffuse in the 3D view</source>
        <translation>La BRDF %1 se muestra como difusa en la vista 3D</translation>
    </message>
    <message>
        <source>The 3D view shows %1 at a lower resolution: the graphics driver&apos;s textures have at most %2 pixels per row</source>
        <translation>La vista 3D muestra %1 con menor resolución: las texturas del controlador gráfico tienen como máximo %2 píxeles por fila</translation>
    </message>
    <message>
        <source>The 3D view leaves out %1 of %2 meshes: the graphics driver&apos;s buffers have at most %3 entries. Split the scene into files, and open one at a time</source>
        <translation>La vista 3D omite %1 de %2 mallas: los búferes del controlador gráfico tienen como máximo %3 entradas. Divida la escena en archivos y ábralos de uno en uno</translation>
    </message>
</context>
<context>
    <name>editor::ViewRenderer</name>
    <message>
        <source>The 3D view needs OpenGL 3.3, which this display does not support.</source>
        <translation>La vista 3D necesita OpenGL 3.3, que esta pantalla no admite.</translation>
    </message>
    <message>
        <source>The 3D view cannot draw: the graphics driver cannot compile a shader: %1</source>
        <translation>La vista 3D no puede dibujar: el controlador gráfico no puede compilar un shader: %1</translation>
    </message>
</context>
<context>
    <name>editor::ViewerWindow</name>
    <message>
        <source>1 face</source>
        <translation>1 cara</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 caras</translation>
    </message>
    <message>
        <source>1 triangle</source>
        <translation>1 triángulo</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 triángulos</translation>
    </message>
    <message>
        <source>GRF viewer</source>
        <translation>Visor de GRF</translation>
    </message>
    <message>
        <source>The viewer moves nothing: open the scene in the editor for that</source>
        <translation>El visor no mueve nada: abra la escena en el editor para eso</translation>
    </message>
    <message>
        <source>No scene is open.

Open a file (Ctrl+O), or drop one here.</source>
        <translation>No hay ninguna escena abierta.

Abra un archivo (Ctrl+O) o suéltelo aquí.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>What is under the pointer</source>
        <translation>Lo que hay bajo el puntero</translation>
    </message>
    <message>
        <source>Selected faces</source>
        <translation>Caras seleccionadas</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>Size of the scene</source>
        <translation>Tamaño de la escena</translation>
    </message>
    <message>
        <source>Faces of all meshes, each mesh counted once, and triangles, each instance counted</source>
        <translation>Caras de todas las mallas, cada malla una vez, y triángulos, cada instancia contada</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>Open a scene, or a model of another format</source>
        <translation>Abre una escena, o un modelo de otro formato</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Recargar</translation>
    </message>
    <message>
        <source>Nothing to reload: open a file first</source>
        <translation>Nada que recargar: abra antes un archivo</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
    <message>
        <source>Close the window</source>
        <translation>Cierra la ventana</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Reload the file; this also happens when the file changes</source>
        <translation>Recarga el archivo; también ocurre cuando el archivo cambia</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Leyendo %1</translation>
    </message>
    <message>
        <source>%1 - GRF viewer</source>
        <translation>%1 - visor de GRF</translation>
    </message>
    <message>
        <source>Show the line</source>
        <translation>Mostrar la línea</translation>
    </message>
    <message>
        <source>Show the line of the file with the error</source>
        <translation>Muestra la línea del archivo con el error</translation>
    </message>
    <message>
        <source>
The previous version is still shown.</source>
        <translation>
La versión anterior se sigue mostrando.</translation>
    </message>
    <message>
        <source>
%1 is still shown.</source>
        <translation>
%1 se sigue mostrando.</translation>
    </message>
    <message>
        <source>Source text - GRF viewer</source>
        <translation>Texto del archivo - visor de GRF</translation>
    </message>
    <message>
        <source>%1 selected</source>
        <translation>%1 seleccionadas</translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation>1 aviso</translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation>%1 avisos</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>y %1 más</translation>
    </message>
</context>
<context>
    <name>editor::VisibilityActions</name>
    <message>
        <source>S&amp;ets</source>
        <translation>Con&amp;juntos</translation>
    </message>
    <message>
        <source>&amp;Hide selected</source>
        <translation>Ocult&amp;ar la selección</translation>
    </message>
    <message>
        <source>Hide the selected faces in the view</source>
        <translation>Oculta en la vista las caras seleccionadas</translation>
    </message>
    <message>
        <source>Hide all faces but the selected ones in the view</source>
        <translation>Oculta en la vista todas las caras salvo las seleccionadas</translation>
    </message>
    <message>
        <source>Sho&amp;w all</source>
        <translation>Mostrar to&amp;das</translation>
    </message>
    <message>
        <source>Show all hidden faces again</source>
        <translation>Vuelve a mostrar todas las caras ocultas</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>Aislar &amp;geometría</translation>
    </message>
    <message>
        <source>Hide all meshes but those with selected faces, or show again what that hid</source>
        <translation>Oculta todas las mallas salvo las que tienen caras seleccionadas, o vuelve a mostrar lo que se ocultó así</translation>
    </message>
    <message>
        <source>Loc&amp;k selected</source>
        <translation>&amp;Fijar (bloquear) la selección</translation>
    </message>
    <message>
        <source>Lock the selected faces: they are shown, but the view does not select them</source>
        <translation>Bloquea las caras seleccionadas: se muestran, pero la vista no las selecciona</translation>
    </message>
    <message>
        <source>&amp;Unlock all</source>
        <translation>Desblo&amp;quear todas</translation>
    </message>
    <message>
        <source>Unlock all faces, so that they can be selected</source>
        <translation>Desbloquea todas las caras, para que se puedan seleccionar</translation>
    </message>
    <message>
        <source>Name of the set</source>
        <translation>Nombre del conjunto</translation>
    </message>
    <message>
        <source>Save the selection as a set</source>
        <translation>Guardar la selección como conjunto</translation>
    </message>
    <message>
        <source>Rename a set</source>
        <translation>Cambiar el nombre de un conjunto</translation>
    </message>
    <message>
        <source>&amp;Save selection as...</source>
        <translation>&amp;Guardar la selección como...</translation>
    </message>
    <message>
        <source>Save the selected faces as a set with a name</source>
        <translation>Guarda las caras seleccionadas como un conjunto con nombre</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Seleccionar</translation>
    </message>
    <message>
        <source>Select the faces of the set</source>
        <translation>Selecciona las caras del conjunto</translation>
    </message>
    <message>
        <source>Re&amp;name...</source>
        <translation>Cambiar &amp;nombre...</translation>
    </message>
    <message>
        <source>Give the set another name</source>
        <translation>Da otro nombre al conjunto</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>Forget the set; its faces stay</source>
        <translation>Olvida el conjunto; sus caras se quedan</translation>
    </message>
    <message>
        <source>Hi&amp;de others</source>
        <translation>Oc&amp;ultar las demás</translation>
    </message>
</context>
<context>
    <name>editor::WelcomeController</name>
    <message>
        <source>&amp;Welcome</source>
        <translation>&amp;Bienvenida</translation>
    </message>
    <message>
        <source>Recent files, sample scenes and lessons</source>
        <translation>Archivos recientes, escenas de ejemplo y lecciones</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bienvenida</translation>
    </message>
</context>
<context>
    <name>editor::WelcomePage</name>
    <message>
        <source>Welcome to wannabe</source>
        <translation>Bienvenida a wannabe</translation>
    </message>
    <message>
        <source>&amp;Show this page at the start</source>
        <translation>&amp;Mostrar esta página al empezar</translation>
    </message>
    <message>
        <source>Show this page when the editor starts without a file; Help &gt; Welcome shows it, too</source>
        <translation>Muestra esta página cuando el editor empieza sin un archivo; Ayuda &gt; Bienvenida también la muestra</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>&amp;New scene</source>
        <translation>&amp;Nueva escena</translation>
    </message>
    <message>
        <source>Start an empty scene</source>
        <translation>Empieza una escena vacía</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Abrir...</translation>
    </message>
    <message>
        <source>Open scenes, or import models of other formats</source>
        <translation>Abre escenas, o importa modelos de otros formatos</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) in the window</source>
        <translation>
            <numerusform>%n paso en la ventana</numerusform>
            <numerusform>%n pasos en la ventana</numerusform>
        </translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>No samples are installed: they are in the package granada-samples.</source>
        <translation>No hay ejemplos instalados: están en el paquete granada-samples.</translation>
    </message>
    <message>
        <source>Open the sample %1</source>
        <translation>Abre el ejemplo %1</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Abre %1</translation>
    </message>
    <message>
        <source>%1 is not there any more</source>
        <translation>%1 ya no está</translation>
    </message>
    <message>
        <source>Files that were opened are listed here.</source>
        <translation>Aquí aparecen los archivos que se han abierto.</translation>
    </message>
</context>
</TS>
