/// The sentences and labels of the page in Spanish.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short, seconds, count} = measuresOf("es")

export const page: Omit<
  Words,
  | "backpack"
  | "blocks"
  | "challenges"
  | "classroom"
  | "world"
  | "recordings"
  | "companions"
  | "diagram"
  | "film"
  | "graph"
  | "replies"
  | "roomTests"
  | "preview"
  | "runs"
  | "keys"
  | "lessons"
  | "lessonEditor"
  | "twin"
  | "welcome"
  | "why"
  | "blockly"
> = {
  rosy: "Rosy",
  run: "Ejecutar",
  stop: "Detener",
  runHint: "Ejecutar (Ctrl+Enter)",
  stopHint: "Detener (Espacio)",
  reset: "Al inicio",
  resetHint: "Volver a poner el robot en el inicio",
  sameAgain: "Lo mismo otra vez",
  sameAgainHint: "La misma ejecución otra vez: con la misma suerte en los dados y en las ruedas que resbalan",
  pause: "Pausa",
  resume: "Seguir",
  continueHere: "Continuar desde aquí",
  continueHint: "Seguir desde este momento, con el programa como está ahora",
  forward: "Un paso (0,02 s)",
  stepBefore: "Paso anterior: donde empezó una función",
  stepAfter: "Paso siguiente: donde empieza una función",
  lookBack: "Mirar atrás en la ejecución",
  saveTable: "Guardar como tabla (CSV)",
  noRun: "Ejecuta el programa para ver sus valores.",
  chartedValues: "Valores del gráfico",
  chartSpan: "Tiempo del gráfico",
  chartSpans: {20: "20 s", 60: "1 min", all: "Todo"},
  remembers: "El programa recuerda",
  robotValues: "El robot",
  time: "Tiempo",
  quantities: {
    speed: "Velocidad",
    turning: "Giro",
    x: "x",
    y: "y",
    heading: "Dirección",
    believedX: "x estimada",
    believedY: "y estimada",
    believedHeading: "Dirección estimada",
  },
  readout: {
    time: "tiempo",
    heading: "dirección",
    speed: "velocidad",
    bumpers: "parachoques",
    cliffs: "sensores de suelo",
    wheels: "ruedas",
    led1: "LED 1",
    led2: "LED 2",
  },
  sides: {left: "izquierda", centre: "centro", right: "derecha"},
  senses: {
    bumper: ["pulsado", "suelto"],
    cliff: ["agujero", "suelo"],
    wheel: ["en el aire", "en el suelo"],
    button: ["pulsado", "suelto"],
  },
  led: n => `LED ${n}`,
  speed: "Velocidad",
  fastest: "máx.",
  examples: "Ejemplos",
  undo: "Deshacer",
  redo: "Rehacer",
  menu: "Más",
  programName: "Nombre del programa",
  unnamed: "mi programa",
  yourProgram: "Tu programa",
  saved: {saved: "guardado", changed: "guardando…", failed: "sin guardar"},
  view: "Vista",
  views: {blocks: "Bloques", both: "Bloques + Haskell", haskell: "Haskell", diagram: "Diagrama"},
  regions: {blocks: "Bloques", haskell: "Haskell", diagram: "Diagrama", room: "Sala"},
  region: "Mostrar",
  canvasHeight: "Altura de la sala",
  arrange: {
    title: "Organizar",
    hint: "Pon los bloques, Haskell y la sala donde quieras",
    choices: "Dónde está cada cosa",
    beside: (one, other) => `${one} al lado de ${other}`,
    below: (one, other) => `${one} encima de ${other}`,
    shown: "Lo que ves",
    reset: "Como al principio",
    how: "Arrastra los puntos de la parte de arriba de un panel, o el borde entre dos.",
    move: region => `Mover ${region}`,
    moveHint: "Arrástralo a otro lugar. Las flechas lo mueven hacia ese lado.",
    hide: region => `Ocultar ${region}`,
    border: (one, other) => `Borde entre ${one} y ${other}`,
  },
  room: "Sala",
  worldName: "Sala del robot",
  ownWorld: "sala propia",
  soundOn: "El sonido está activado",
  soundOff: "El sonido está desactivado",
  clock: "Tiempo de la ejecución",
  tabs: {
    console: "Consola",
    charts: "Gráficos",
    runs: "Ejecuciones",
    sensors: "Valores",
    problems: "Problemas",
  },
  emptyConsole: "Aquí aparece lo que el robot siente y dice.",
  moreEvents: n => count(n, {one: "Mostrar un evento más", other: k => `Mostrar ${k} eventos más`}),
  fewerEvents: "Mostrar solo los eventos más importantes",
  noProblems: "Ningún problema.",
  times: n => `×${n}`,
  plays: "toca",
  pastedText: "El texto pegado",
  newName: old => `Nombre nuevo para ${old}`,
  rename: "Cambiar el nombre",
  format: "Dar formato al Haskell",
  editor: {
    Find: "Buscar",
    Replace: "Reemplazar por",
    next: "Siguiente",
    previous: "Anterior",
    all: "Seleccionar todo",
    "match case": "Aa cuenta",
    "by word": "Palabras enteras",
    regexp: "Patrón",
    replace: "Reemplazar",
    "replace all": "Todo",
    close: "Cerrar",
    "current match": "encontrado aquí",
    "replaced $ matches": "lugares cambiados: $",
    "replaced match on line $": "cambiado un lugar en la línea $",
    "on line": "en la línea",
    Diagnostics: "Problemas",
    "No diagnostics": "Ningún problema",
    Completions: "Lo que encaja aquí",
    "Control character": "Carácter invisible",
  },
  showIt: "Mostrar dónde",
  nothingToRun: "Todavía no se ejecuta nada. Elige un bloque para `simulate` y pulsa Ejecutar.",
  nothingRuns: name => `Todavía no se ejecuta nada. ¿Ejecutar \`${name}\`?`,
  runIt: name => `Ejecutar ${name}`,
  readMore: "Leer más",
  fromToolbox: "De la caja de herramientas",
  writeType: signature => `Escribir su tipo: ${signature}`,
  compilerSays: "Lo que ha dicho el compilador",
  givenInputs: "Recibió",
  atTime: time => `a los ${seconds(time, 2)}`,
  close: "Cerrar",
  newProgram: "Programa nuevo",
  openFile: "Abrir un archivo…",
  saveFile: "Guardar como archivo",
  saveHaskell: "Guardar el Haskell",
  share: {
    menu: "Compartir o imprimir…",
    title: "Compartir",
    lead: "El enlace contiene todo el programa y su sala. No se sube nada a internet.",
    making: "Creando el enlace…",
    reach: {
      network:
        "La dirección de esta página solo lleva a este ordenador. El enlace tiene en su lugar su dirección en la red: los demás pueden abrirlo mientras Rosy funcione aquí.",
      computer:
        "Este enlace solo lleva a este ordenador. Para otras personas guarda el programa como archivo, o inicia Rosy con `--host 0.0.0.0` y vuelve a compartir.",
    },
    link: "Enlace",
    copy: "Copiar",
    copied: "Copiado.",
    notCopied: "Pulsa Ctrl+C para copiarlo.",
    code: "El enlace como código QR",
    codeHint: "El código QR contiene el programa y su sala, pero no dónde están colocados los bloques.",
    noCode: "Este programa es demasiado largo para un código QR. En el enlace sí cabe.",
    embed: "Para ponerlo en una página tuya",
    page: "Guardar una página que funciona en todas partes",
    pageHint:
      "Un solo archivo con los bloques, el Haskell y la película de la última ejecución. Se abre sin Rosy, desde un disco o un sitio web.",
    pageWithoutFilm:
      "Un solo archivo con los bloques y el Haskell. Ejecuta primero el programa, y tendrá también la película de la ejecución.",
    print: "Imprimir bloques y Haskell",
    openInRosy: "Abrir en Rosy",
  },
  sharedPage: {
    film: "La última ejecución",
    noFilm: "El programa aún no se había ejecutado cuando se hizo esta página.",
    olderFilm: "La película muestra el programa antes de sus últimos cambios.",
    play: "Reproducir",
    reach: {
      network:
        "El enlace funciona para otros en la misma red, mientras Rosy esté en marcha en el ordenador donde se hizo esta página.",
      computer:
        "El enlace solo funciona en el ordenador donde se hizo esta página, mientras Rosy esté en marcha allí.",
    },
    made: version => `Hecho con Rosy ${version}`,
  },
  driveByHand: "Conducir a mano (ROS)",
  help: {
    title: "Los nombres propios de Haskell",
    lead: "Todo programa de Haskell los conoce. Cada uno aparece con su tipo y un ejemplo.",
  },
  guide: {
    menu: "Guía",
    teachers: "Para docentes",
    isEnglish: "Esta página de la guía está solo en inglés.",
    more: "Leer más en la guía",
  },
  about: version => `Sobre Rosy ${version}: licencias`,
  language: "Idioma",
  theme: "Colores",
  themes: {auto: "Como el sistema", light: "Claros", dark: "Oscuros"},
  galleryTitle: "Ejemplos",
  galleryLead: "Abre uno, ejecútalo, cámbialo. Tu propio programa se conserva.",
  galleryLoading: "Buscando los ejemplos…",
  galleryFailed:
    "No se han podido cargar los ejemplos. El servicio de Rosy no responde; inténtalo otra vez dentro de un momento.",
  exampleLevels: {
    start: "Primeros pasos",
    react: "Reaccionar y recordar",
    tasks: "Una cosa después de otra",
    large: "Programas más grandes",
  },
  otherExamples: "Más ejemplos",
  moreAbout: title => `Qué enseña ${title}`,
  again: "Probar otra vez",
  myPrograms: {
    title: "Mis programas",
    lead: "Este navegador guarda todos los programas que cambias.",
    none: "Cambia un ejemplo o empieza un programa nuevo, y se guardará aquí.",
    open: "abierto ahora",
    rename: name => `Cambiar el nombre de ${name}`,
    newName: name => `Nombre nuevo para ${name}`,
    duplicate: name => `Duplicar ${name}`,
    remove: name => `Eliminar ${name}`,
    removed: name => `${name} se ha eliminado.`,
    undo: "Deshacer",
    deleted: "Programas eliminados",
    restore: name => `Recuperar ${name}`,
    restoreShort: "Recuperar",
  },
  invite: {
    change: "Cambia",
    from: "+",
    to: "por",
    into: "-",
    after: "y ejecuta otra vez. ¿Hacia dónde va ahora el robot?",
  },
  haskellPane: "El programa en Haskell",
  haskellKeys: "Escape y después Tab sale del texto. F8 va al problema siguiente.",
  blocksPane: "El programa en bloques",
  link: {
    connecting: "Buscando el robot…",
    lost: "Se ha perdido la conexión con Rosy. Vuelve por sí sola; tu programa se conserva.",
  },
  programComing:
    "Los bloques están en camino. La primera vez tardan más; después tu navegador los tiene guardados.",
  worker: {
    starting: "El ayudante que lee Haskell se está iniciando.",
    restarting:
      "El ayudante que lee Haskell se está reiniciando. Tu programa se conserva; ejecútalo otra vez dentro de un momento.",
  },
  queued: place =>
    place === 1
      ? "La sala está llena. Tu programa es el próximo."
      : place === 2
        ? "La sala está llena. Hay un programa antes que el tuyo."
        : `La sala está llena. Hay ${place - 1} programas antes que el tuyo.`,
  roomLabel: world =>
    `La sala ${world} desde arriba, con el robot dentro. Mientras funciona, las flechas mueven el robot, la coma y el punto lo giran, y B toma en su lugar algo que se empuja; más y menos cambian el tamaño, F lo sigue. W pregunta por qué se mueve así, y P por qué está ahí.`,
  sight: "Cómo ver la sala",
  follow: "Seguir al robot",
  followHint: "Seguir al robot (F)",
  closer: "Más cerca",
  further: "Más lejos",
  wholeRoom: "Toda la sala",
  sightMenu: "Rastro, foto y película",
  trail: "Rastro",
  trails: {plain: "Un color", speed: "Velocidad", time: "Tiempo"},
  trailEnds: {speed: ["lento", "rápido"], time: ["inicio", "ahora"]},
  savePicture: "Guardar una foto",
  startFilm: "Empezar una película",
  endFilm: "Terminar la película",
  robots: {
    title: "¿Qué robot?",
    lead: "El mismo programa funciona en todos.",
    choose: "Elegir un robot",
    simulated: "Robot simulado",
    simulatedShort: "Simulado",
    simulatedHint: "Vive en la sala de esta página, y no se puede romper nada.",
    free: "está libre",
    has: who => `lo tiene ${who}`,
    domain: domain => `dominio ${domain} de ROS 2`,
    charge: percent => `batería ${percent} %`,
    volts: volts => `batería ${short(volts, 1)} V`,
    several: "varios robots en los mismos topics: da a cada uno un espacio de nombres (namespace)",
    discovers: "Un robot en ROS 2 que se enciende en esta red aparece aquí por sí solo.",
    yours: "lo tienes tú",
    who: "Tu nombre, para que lo vean los demás",
    locked: "Los robots están bloqueados. La persona que inició Rosy te puede decir el código.",
    code: "Código",
    unlock: "Abrir",
    take: "Tomarlo",
    leave: "Dejarlo",
    leaveHint: "El robot se para, y los demás lo pueden tomar",
    link: {connecting: "Buscándolo…", connected: "Conectado", lost: "Perdido, buscándolo…"},
    safetyOn: "Retrocede por sí solo",
    safetyOnHint: "Se aparta de paredes y agujeros antes de que tu programa pueda seguir.",
    safetyOff: "No retrocede",
    safetyOffHint:
      "Las reglas de seguridad están desactivadas: vigila su camino. El escudo de encima de la sala las activa.",
    backing: "Retrocediendo…",
    limits: speed => `como máximo ${short(speed, 2)} m/s`,
    estop: "Parada de emergencia",
    estopHint: "Parar el robot enseguida (Espacio)",
    stopped: "Se detuvo y está quieto.",
    letDrive: "Dejar que se mueva otra vez",
    region: name => `El robot ${name}`,
    floor: name => `El camino del robot ${name}, medido por él mismo; más y menos cambian el tamaño.`,
  },
  topics: {
    title: "Mensajes a mano",
    send: "Enviar",
    runFirst: "Pulsa primero Ejecutar: solo un programa en marcha recibe mensajes",
    ofRobot: topic => `Los mensajes de ${topic} los envía el propio robot.`,
    computed: type =>
      `El programa calcula el nombre del tema (topic) de ${type}, así que no hay formulario para él: escribe el nombre como un solo texto.`,
  },
  safety: {
    name: "Reglas de seguridad",
    on: "Las reglas de seguridad están activadas: el robot se aparta de paredes y agujeros antes de que tu programa siga, aquí y en robots de verdad",
    off: "Las reglas de seguridad están desactivadas: solo conduce tu programa, aquí y en robots de verdad",
    overrides: "Reglas de seguridad: retrocediendo…",
    tookOver: "Las reglas de seguridad toman el control: retrocediendo",
  },
  blocked: {
    pushes: "El robot empuja contra algo y no puede seguir.",
    withBumper: "Una función con Bumper como entrada puede apartarlo.",
    withoutBumper: "No tiene parachoques en ese lado: haz que vaya por otro camino.",
  },
  goals: "Objetivos",
  goalStates: {open: "pendiente", done: "logrado", missed: "no logrado"},
  hands: "Toca el robot",
  robotButton: n => `Pulsar el botón ${n} del robot`,
  holdsThing: (kind, n) =>
    `${kind === "box" ? "Caja" : "Barril"} ${n}: se empuja con las flechas. Escape toma otra vez el robot.`,
  lift: "Levantar",
  liftHint: "Levantar el robot del suelo y volver a ponerlo",
  doing: {
    lookingBack: "Mirando atrás",
    standing: "En pausa",
    ready: "Listo",
    waiting: "Esperando",
    queued: "Esperando",
    compiling: "Iniciando",
    running: "En marcha",
  },
  ended: {
    done: "Terminado",
    error: "Terminado por un problema",
    stuck: "Terminado por un problema",
    hole: "Parado en un hueco",
    stopped: "Detenido",
    time: "Se acabó el tiempo",
    refused: "No iniciado",
    lost: "Conexión perdida",
  },
  notices: {
    diverged: {
      message: time => `Tu programa cambiado hace otra cosa a partir de los ${time}.`,
      hint: "Se ejecutó desde el inicio hasta el momento que elegiste.",
    },
    uncompared: {
      message: time => `Después de ${time} no se sabe si tu programa cambiado hace otra cosa.`,
      hint: "Los comandos de una ejecución se guardan más o menos una hora.",
    },
    notText: {
      message: name => `${name} no contiene texto.`,
      hint: "Rosy abre programas: archivos que terminan en .rosy o .hs.",
    },
    olderEncoding: {
      message: ({name, encoding, number, line}) =>
        `${name} está en la codificación ${encoding}, no en UTF-8: mira la línea ${number}, «${line.trim()}».`,
      hint: "Si la línea está bien, lee el archivo así. Rosy lo guarda en UTF-8.",
      readAs: encoding => `Leerlo como ${encoding}`,
    },
    emptyFile: {
      message: name => `${name} está vacío.`,
      hint: "No hay en él ningún programa que abrir.",
    },
    confusable: {
      message: (name, n, {character, plain, name: called}) =>
        `${name}: ${count(n, {one: "un carácter parece correcto y no lo es", other: k => `${k} caracteres parecen correctos y no lo son. El primero`})}: ${plain.trim() === "" ? `uno que no se ve (${called})` : `‘${character}’ (${called}) en lugar de ‘${plain}’`}.`,
      hint: "Los comentarios y los textos entre comillas se quedan como están.",
      repair: "Reparar",
    },
    severalPrograms: {
      message: (name, n) => `${name} tiene ${n} programas.`,
      hint: unread =>
        unread === 0
          ? "Elige uno."
          : `Elige uno. ${count(unread, {one: "Otro más no se pudo", other: n => `Otros ${n} no se pudieron`})} leer.`,
    },
    noPrograms: name => `No hay programas en ${name}.`,
    tooManyFiles: {
      message: name => `${name} contiene demasiado.`,
      hint: "Rosy mira como máximo 2000 archivos y 20 millones de letras. Suelta aquí la carpeta donde está tu programa.",
    },
    damagedArchive: {
      message: name => `${name} no se puede descomprimir.`,
      hint: "Está dañado o tiene contraseña. Descomprímelo en tu ordenador y suelta aquí la carpeta.",
    },
    notProgram: name => `${name} no es un programa.`,
    tooLarge: {
      message: name => `${name} es demasiado grande.`,
      hint: "Un programa tiene como máximo 200 000 letras. El tuyo sigue abierto.",
    },
    notWorld: name => `${name} no es una sala que Rosy pueda usar.`,
    exampleMissing: {
      message: name => `No hay ningún ejemplo ${name}.`,
      hint: "En Ejemplos, arriba, puedes ver los que hay.",
    },
    noFilm: {
      message: "La película está vacía.",
      hint: "Empiézala mientras el robot se mueve y termínala más tarde.",
    },
    filmFailed: {
      message: "No se pudo hacer la película.",
      hint: "Deja que el programa se ejecute un rato o prueba el otro tipo de película.",
    },
    noReader: {
      message: "Falta una parte de la página.",
      hint: "Vuelve a cargar la página; no se pierde nada tuyo.",
    },
    notFormatted: {
      message: left =>
        count(left, {
          one: "Una definición se ha dejado como está.",
          other: n => `${n} definiciones se han dejado como están.`,
        }),
      hint: "No están terminadas, o al darles formato se habría perdido algo.",
    },
    otherMeaning: {
      message: name =>
        `El texto Haskell de ${name} no puede decir exactamente este cambio de los bloques. El cambio no se ha hecho.`,
      hint: "Haz el cambio en el texto Haskell o construye este lugar de otra manera.",
    },
    groupedOtherwise: {
      message: name =>
        `Después de este cambio, el compilador no agrupa el texto Haskell de ${name} como los bloques. El programa vuelve a estar como antes.`,
    },
    unreadableEdit: {
      message: name =>
        `Después de este cambio, el compilador no puede leer el texto Haskell de ${name}. El programa vuelve a estar como antes.`,
    },
    unfinishedText: {
      message: name =>
        `Todavía no está completo en el texto Haskell: ${name}. Este cambio de los bloques no se ha hecho.`,
      hint: "Termina la línea en el texto o pulsa Deshacer y después cambia los bloques. Los bloques que el texto ya dice se pueden cambiar.",
    },
    progressNotSaved: {
      message: "Este navegador no tiene espacio para guardar lo que llevas hecho de la lección.",
      hint: "Elimina programas en Mis programas y haz después el siguiente paso. Tu programa no se ve afectado.",
    },
    notSaved: {
      message: "Este navegador no tiene espacio para guardar tu programa.",
      hint: "Elimina programas en Mis programas, o guarda este como archivo con el menú de arriba a la derecha.",
    },
    madeWay: {
      message: names =>
        `Este navegador está lleno, así que Rosy ha quitado para siempre estos programas eliminados: ${names}.`,
      hint: "Elimina los programas que ya no necesites y guarda como archivos lo que quieras conservar.",
    },
    robotGone: {
      message: name => `Ya no tienes ${name}.`,
      hint: "Tómalo otra vez cuando lo necesites.",
    },
    outOfSight: {
      message: name => `${name} se ha parado porque esta página no estaba a la vista.`,
      hint: "Deja la página a la vista mientras se mueve un robot de verdad.",
    },
    damagedLink: {
      message: "Este enlace está dañado.",
      hint: "Copia el enlace entero y ábrelo otra vez.",
    },
    becameTwo: {
      message: name => `${name === "" ? "Tu programa" : name} se ha cambiado en dos pestañas a la vez.`,
      hint: copy => `Ahora hay dos: este se llama ${copy}.`,
    },
    noStorage: {
      message: "Este navegador no guarda nada de esta página.",
      hint: "Guarda tu programa como archivo antes de cerrar la página.",
    },
  },
}
