/// The sentences and labels of the page in German.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short, seconds, count} = measuresOf("de")

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
  run: "Start",
  stop: "Stopp",
  runHint: "Starten (Strg+Enter)",
  stopHint: "Anhalten (Leertaste)",
  reset: "Zurück",
  resetHint: "Den Roboter zurück an den Anfang stellen",
  sameAgain: "Noch einmal genauso",
  sameAgainHint: "Noch einmal genauso: mit demselben Glück beim Würfeln und bei rutschenden Rädern",
  pause: "Pause",
  resume: "Weiter",
  continueHere: "Von hier aus weiter",
  continueHint: "Läuft von diesem Moment an weiter, mit dem Programm, wie es jetzt ist",
  forward: "Ein Schritt (0,02 s)",
  stepBefore: "Schritt davor: wo eine Funktion begann",
  stepAfter: "Nächster Schritt: wo eine Funktion beginnt",
  lookBack: "Im Lauf zurückschauen",
  saveTable: "Als Tabelle speichern (CSV)",
  noRun: "Starte das Programm, um seine Werte zu sehen.",
  chartedValues: "Werte zum Zeichnen",
  chartSpan: "Zeit zum Zeichnen",
  chartSpans: {20: "20 s", 60: "1 min", all: "Alles"},
  remembers: "Das merkt sich das Programm",
  robotValues: "Der Roboter",
  time: "Zeit",
  quantities: {
    speed: "Tempo",
    turning: "Drehung",
    x: "x",
    y: "y",
    heading: "Richtung",
    believedX: "Geglaubtes x",
    believedY: "Geglaubtes y",
    believedHeading: "Geglaubte Richtung",
  },
  readout: {
    time: "Zeit",
    heading: "Richtung",
    speed: "Tempo",
    bumpers: "Stoßstange",
    cliffs: "Bodensensoren",
    wheels: "Räder",
    led1: "LED 1",
    led2: "LED 2",
  },
  sides: {left: "links", centre: "Mitte", right: "rechts"},
  senses: {
    bumper: ["gedrückt", "losgelassen"],
    cliff: ["Loch", "Boden"],
    wheel: ["in der Luft", "am Boden"],
    button: ["gedrückt", "losgelassen"],
  },
  led: n => `LED ${n}`,
  speed: "Tempo",
  fastest: "max.",
  examples: "Beispiele",
  undo: "Rückgängig",
  redo: "Wiederholen",
  menu: "Mehr",
  programName: "Name des Programms",
  unnamed: "mein Programm",
  yourProgram: "Dein Programm",
  saved: {saved: "gespeichert", changed: "speichert …", failed: "nicht gespeichert"},
  view: "Ansicht",
  views: {blocks: "Blöcke", both: "Blöcke + Haskell", haskell: "Haskell", diagram: "Diagramm"},
  regions: {blocks: "Blöcke", haskell: "Haskell", diagram: "Diagramm", room: "Raum"},
  region: "Zeigen",
  canvasHeight: "Höhe des Raums",
  arrange: {
    title: "Anordnen",
    hint: "Stell Blöcke, Haskell und Raum hin, wo du willst",
    choices: "Wo alles steht",
    beside: (one, other) => `${one} neben ${other}`,
    below: (one, other) => `${one} über ${other}`,
    shown: "Was du siehst",
    reset: "Wie am Anfang",
    how: "Zieh an den Punkten oben an einem Teil oder an einer Grenze zwischen zweien.",
    move: region => `${region} verschieben`,
    moveHint: "Zieh es an einen anderen Ort. Die Pfeiltasten schieben es auf diese Seite.",
    hide: region => `${region} verstecken`,
    border: (one, other) => `Grenze zwischen ${one} und ${other}`,
  },
  room: "Raum",
  worldName: "Raum zum Fahren",
  ownWorld: "eigener Raum",
  soundOn: "Der Ton ist an",
  soundOff: "Der Ton ist aus",
  clock: "Zeit des Laufs",
  tabs: {console: "Ausgabe", charts: "Kurven", runs: "Läufe", sensors: "Werte", problems: "Probleme"},
  emptyConsole: "Hier erscheint, was der Roboter spürt und sagt.",
  moreEvents: n => count(n, {one: "Noch ein Ereignis zeigen", other: k => `Noch ${k} Ereignisse zeigen`}),
  fewerEvents: "Nur die wichtigsten Ereignisse zeigen",
  noProblems: "Keine Probleme.",
  times: n => `×${n}`,
  plays: "spielt",
  pastedText: "Der eingefügte Text",
  newName: old => `Neuer Name für ${old}`,
  rename: "Umbenennen",
  format: "Das Haskell ordentlich setzen",
  editor: {
    Find: "Suchen",
    Replace: "Ersetzen durch",
    next: "Weiter",
    previous: "Zurück",
    all: "Alle auswählen",
    "match case": "Aa zählt",
    "by word": "Ganze Wörter",
    regexp: "Muster",
    replace: "Ersetzen",
    "replace all": "Alle",
    close: "Schließen",
    "current match": "hier gefunden",
    "replaced $ matches": "$ Stellen geändert",
    "replaced match on line $": "eine Stelle in Zeile $ geändert",
    "on line": "in Zeile",
    Diagnostics: "Probleme",
    "No diagnostics": "Keine Probleme",
    Completions: "Was hier passt",
    "Control character": "Unsichtbares Zeichen",
  },
  showIt: "Zeig es mir",
  nothingToRun: "Noch läuft nichts. Wähle einen Block für `simulate` und drücke dann auf Start.",
  nothingRuns: name => `Noch läuft nichts. \`${name}\` laufen lassen?`,
  runIt: name => `${name} laufen lassen`,
  readMore: "Mehr lesen",
  fromToolbox: "Aus dem Werkzeugkasten",
  writeType: signature => `Den Typ hinschreiben: ${signature}`,
  compilerSays: "Was der Compiler gesagt hat",
  givenInputs: "Es bekam",
  atTime: time => `bei ${seconds(time, 2)}`,
  close: "Schließen",
  newProgram: "Neues Programm",
  openFile: "Datei öffnen …",
  saveFile: "Als Datei speichern",
  saveHaskell: "Das Haskell speichern",
  share: {
    menu: "Teilen oder drucken …",
    title: "Teilen",
    lead: "Der Link enthält das ganze Programm und seinen Raum. Nichts wird hochgeladen.",
    making: "Der Link entsteht …",
    reach: {
      network:
        "Die Adresse dieser Seite führt nur zu diesem Computer. Der Link hat stattdessen seine Adresse im Netz: Andere dort können ihn öffnen, solange Rosy hier läuft.",
      computer:
        "Dieser Link führt nur zu diesem Computer. Speichere das Programm für andere als Datei, oder starte Rosy mit `--host 0.0.0.0` und teile noch einmal.",
    },
    link: "Link",
    copy: "Kopieren",
    copied: "Kopiert.",
    notCopied: "Drücke Strg+C, um ihn zu kopieren.",
    code: "Der Link als QR-Code",
    codeHint: "Der QR-Code enthält das Programm und seinen Raum, aber nicht die Plätze der Blöcke.",
    noCode: "Dieses Programm ist zu lang für einen QR-Code. In den Link passt es.",
    embed: "Zum Einbetten in eine eigene Seite",
    page: "Eine Seite speichern, die überall geht",
    pageHint:
      "Eine Datei mit den Blöcken, dem Haskell und dem Film des letzten Laufs. Sie öffnet sich ohne Rosy, von einem Datenträger oder einer Website.",
    pageWithoutFilm:
      "Eine Datei mit den Blöcken und dem Haskell. Lass das Programm erst laufen, dann enthält sie auch den Film des Laufs.",
    print: "Blöcke und Haskell drucken",
    openInRosy: "In Rosy öffnen",
  },
  sharedPage: {
    film: "Der letzte Lauf",
    noFilm: "Das Programm war noch nicht gelaufen, als diese Seite entstand.",
    olderFilm: "Der Film zeigt das Programm vor seinen letzten Änderungen.",
    play: "Abspielen",
    reach: {
      network:
        "Der Link führt andere im selben Netz zu Rosy, solange es auf dem Computer läuft, auf dem diese Seite entstand.",
      computer: "Der Link geht nur auf dem Computer, auf dem diese Seite entstand, solange Rosy dort läuft.",
    },
    made: version => `Mit Rosy ${version} gemacht`,
  },
  driveByHand: "Von Hand fahren (ROS)",
  help: {
    title: "Haskells eigene Namen",
    lead: "Diese kennt jedes Haskell-Programm. Jeder steht mit seinem Typ und einem Beispiel da.",
  },
  guide: {
    menu: "Handbuch",
    teachers: "Für Lehrkräfte",
    isEnglish: "Diese Seite des Handbuchs gibt es nur auf Englisch.",
    more: "Mehr dazu im Handbuch",
  },
  about: version => `Über Rosy ${version}: Lizenzen`,
  language: "Sprache",
  theme: "Farben",
  themes: {auto: "Wie das System", light: "Hell", dark: "Dunkel"},
  galleryTitle: "Beispiele",
  galleryLead: "Öffne eins, starte es, ändere es. Dein eigenes Programm bleibt erhalten.",
  galleryLoading: "Die Beispiele werden gesucht …",
  galleryFailed:
    "Die Beispiele konnten nicht geladen werden. Rosys Dienst antwortet nicht; versuch es gleich noch einmal.",
  exampleLevels: {
    start: "Erste Schritte",
    react: "Reagieren und merken",
    tasks: "Eins nach dem anderen",
    large: "Größere Programme",
  },
  otherExamples: "Weitere Beispiele",
  moreAbout: title => `Was ${title} zeigt`,
  again: "Noch einmal versuchen",
  myPrograms: {
    title: "Meine Programme",
    lead: "Dieser Browser behält jedes Programm, das du änderst.",
    none: "Ändere ein Beispiel oder beginne ein neues Programm; hier findest du es wieder.",
    open: "gerade offen",
    rename: name => `${name} umbenennen`,
    newName: name => `Neuer Name für ${name}`,
    duplicate: name => `${name} verdoppeln`,
    remove: name => `${name} löschen`,
    removed: name => `${name} ist gelöscht.`,
    undo: "Rückgängig",
    deleted: "Gelöschte Programme",
    restore: name => `${name} wiederherstellen`,
    restoreShort: "Wiederherstellen",
  },
  invite: {
    change: "Ändere",
    from: "+",
    to: "in",
    into: "-",
    after: "und starte noch einmal. Wohin fährt der Roboter jetzt?",
  },
  haskellPane: "Das Programm in Haskell",
  haskellKeys: "Escape und dann Tab verlässt den Text. F8 geht zum nächsten Problem.",
  blocksPane: "Das Programm in Blöcken",
  link: {
    connecting: "Der Roboter wird gesucht …",
    lost: "Die Verbindung zu Rosy ist weg. Sie kommt von selbst wieder; dein Programm bleibt erhalten.",
  },
  programComing: "Die Blöcke sind unterwegs. Das erste Mal dauert am längsten; dein Browser behält sie.",
  worker: {
    starting: "Der Helfer, der Haskell liest, startet gerade.",
    restarting:
      "Der Helfer, der Haskell liest, startet neu. Dein Programm bleibt erhalten; starte es gleich noch einmal.",
  },
  queued: place =>
    place === 1
      ? "Der Raum ist voll. Dein Programm ist als nächstes dran."
      : `Der Raum ist voll. ${count(place - 1, {one: "Ein Programm ist", other: n => `${n} Programme sind`})} vor deinem dran.`,
  roomLabel: world =>
    `Der Raum ${world} von oben, mit dem Roboter darin. Während das Programm läuft, schieben die Pfeiltasten den Roboter, Komma und Punkt drehen ihn, und B nimmt stattdessen ein Ding zum Schieben; Plus und Minus zoomen, F folgt ihm. W fragt, warum er sich so bewegt, und P, warum er dort ist.`,
  sight: "Wie man den Raum sieht",
  follow: "Dem Roboter folgen",
  followHint: "Dem Roboter folgen (F)",
  closer: "Näher",
  further: "Weiter weg",
  wholeRoom: "Der ganze Raum",
  sightMenu: "Spur, Bild und Film",
  trail: "Spur",
  trails: {plain: "Eine Farbe", speed: "Tempo", time: "Zeit"},
  trailEnds: {speed: ["langsam", "schnell"], time: ["Anfang", "jetzt"]},
  savePicture: "Ein Bild speichern",
  startFilm: "Einen Film beginnen",
  endFilm: "Den Film beenden",
  robots: {
    title: "Welcher Roboter?",
    lead: "Dasselbe Programm läuft auf jedem von ihnen.",
    choose: "Einen Roboter wählen",
    simulated: "Simulierter Roboter",
    simulatedShort: "Simuliert",
    simulatedHint: "Er lebt im Raum auf dieser Seite, und nichts kann kaputtgehen.",
    free: "frei",
    has: who => `${who} hat ihn`,
    domain: domain => `ROS-2-Domain ${domain}`,
    charge: percent => `Akku ${percent} %`,
    volts: volts => `Akku ${short(volts, 1)} V`,
    several: "mehrere Roboter auf denselben Topics: Gib jedem einen Namensraum (namespace)",
    discovers: "Ein Roboter auf ROS 2, der in diesem Netz eingeschaltet wird, erscheint hier von selbst.",
    yours: "du hast ihn",
    who: "Dein Name, damit die anderen ihn sehen",
    locked: "Die Roboter sind gesperrt. Wer Rosy gestartet hat, kann dir den Code sagen.",
    code: "Code",
    unlock: "Öffnen",
    take: "Nehmen",
    leave: "Loslassen",
    leaveHint: "Der Roboter bleibt stehen, und andere dürfen ihn haben",
    link: {connecting: "Wird gesucht …", connected: "Verbunden", lost: "Verloren, wird gesucht …"},
    safetyOn: "Weicht von selbst zurück",
    safetyOnHint: "Er weicht vor Wänden und Löchern zurück, bevor dein Programm wieder fahren darf.",
    safetyOff: "Weicht nicht zurück",
    safetyOffHint:
      "Die Sicherheitsregeln sind ausgeschaltet: Behalte seinen Weg im Auge. Der Schild über dem Raum schaltet sie ein.",
    backing: "Weicht zurück …",
    limits: speed => `höchstens ${short(speed, 2)} m/s`,
    estop: "Notstopp",
    estopHint: "Den Roboter sofort anhalten (Leertaste)",
    stopped: "Er wurde angehalten und steht.",
    letDrive: "Wieder fahren lassen",
    region: name => `Der Roboter ${name}`,
    floor: name => `Der Weg des Roboters ${name}, wie er ihn selbst misst; Plus und Minus zoomen.`,
  },
  topics: {
    title: "Nachrichten von Hand",
    send: "Senden",
    runFirst: "Drück zuerst auf Start: Nur ein laufendes Programm bekommt Nachrichten",
    ofRobot: topic => `Die Nachrichten auf ${topic} sendet der Roboter selbst.`,
    computed: type =>
      `Das Programm berechnet den Namen des Topics von ${type}, daher gibt es dafür kein Formular: Schreib den Namen als einen Text.`,
  },
  safety: {
    name: "Sicherheitsregeln",
    on: "Die Sicherheitsregeln sind an: Der Roboter weicht vor Wänden und Löchern zurück, bevor dein Programm weiterfährt, hier und auf echten Robotern",
    off: "Die Sicherheitsregeln sind aus: Nur dein Programm fährt, hier und auf echten Robotern",
    overrides: "Sicherheitsregeln: weicht zurück …",
    tookOver: "Die Sicherheitsregeln übernehmen: weicht zurück",
  },
  blocked: {
    pushes: "Der Roboter drückt gegen etwas und kommt nicht weiter.",
    withBumper: "Eine Funktion mit Bumper als Eingabe kann ihn abwenden.",
    withoutBumper: "Auf dieser Seite hat er keine Stoßstange: Lass ihn anders fahren.",
  },
  goals: "Ziele",
  goalStates: {open: "offen", done: "geschafft", missed: "verfehlt"},
  hands: "Den Roboter anfassen",
  robotButton: n => `Knopf ${n} des Roboters drücken`,
  holdsThing: (kind, n) =>
    `${kind === "box" ? "Kiste" : "Tonne"} ${n}: Die Pfeiltasten schieben sie. Escape nimmt wieder den Roboter.`,
  lift: "Hochheben",
  liftHint: "Den Roboter vom Boden heben und wieder hinstellen",
  doing: {
    lookingBack: "Rückblick",
    standing: "Pause",
    ready: "Bereit",
    waiting: "Wartet",
    queued: "Wartet",
    compiling: "Startet",
    running: "Läuft",
  },
  ended: {
    done: "Fertig",
    error: "Durch ein Problem beendet",
    stuck: "Durch ein Problem beendet",
    hole: "Leere Stelle erreicht",
    stopped: "Angehalten",
    time: "Die Zeit ist um",
    refused: "Nicht gestartet",
    lost: "Verbindung verloren",
  },
  notices: {
    diverged: {
      message: time => `Dein geändertes Programm tut ab ${time} etwas anderes.`,
      hint: "Es lief vom Anfang bis zu dem Moment, den du gewählt hast.",
    },
    uncompared: {
      message: time => `Ob dein geändertes Programm nach ${time} etwas anderes tut, ist nicht bekannt.`,
      hint: "Die Befehle eines Laufs werden etwa eine Stunde lang aufgehoben.",
    },
    notText: {
      message: name => `In ${name} steht kein Text.`,
      hint: "Rosy öffnet Programme: Dateien, die auf .rosy oder .hs enden.",
    },
    olderEncoding: {
      message: ({name, encoding, number, line}) =>
        `${name} ist in der Kodierung ${encoding} gespeichert, nicht in UTF-8: siehe Zeile ${number}, „${line.trim()}“.`,
      hint: "Wenn die Zeile stimmt, lies die Datei so. Rosy speichert sie in UTF-8.",
      readAs: encoding => `Als ${encoding} lesen`,
    },
    emptyFile: {
      message: name => `${name} ist leer.`,
      hint: "Darin ist kein Programm zum Öffnen.",
    },
    confusable: {
      message: (name, n, {character, plain, name: called}) =>
        `${name}: ${count(n, {one: "Ein Zeichen sieht richtig aus und ist es nicht", other: k => `${k} Zeichen sehen richtig aus und sind es nicht. Das erste`})}: ${plain.trim() === "" ? `eines, das man nicht sieht (${called})` : `‘${character}’ (${called}) statt ‘${plain}’`}.`,
      hint: "Kommentare und Texte in Anführungszeichen bleiben, wie sie sind.",
      repair: "Reparieren",
    },
    severalPrograms: {
      message: (name, n) => `In ${name} sind ${n} Programme.`,
      hint: unread =>
        unread === 0
          ? "Wähle eines."
          : `Wähle eines. ${count(unread, {one: "Ein weiteres ließ", other: n => `${n} weitere ließen`})} sich nicht lesen.`,
    },
    noPrograms: name => `In ${name} sind keine Programme.`,
    tooManyFiles: {
      message: name => `In ${name} ist zu viel.`,
      hint: "Rosy sieht höchstens 2.000 Dateien und 20 Millionen Zeichen an. Zieh den Ordner hierher, in dem dein Programm ist.",
    },
    damagedArchive: {
      message: name => `${name} lässt sich nicht entpacken.`,
      hint: "Die Datei ist beschädigt oder hat ein Passwort. Entpacke sie auf deinem Computer und zieh den Ordner hierher.",
    },
    notProgram: name => `${name} ist kein Programm.`,
    tooLarge: {
      message: name => `${name} ist zu groß.`,
      hint: "Ein Programm hat höchstens 200.000 Zeichen. Deins ist noch offen.",
    },
    notWorld: name => `${name} ist kein Raum, den Rosy benutzen kann.`,
    exampleMissing: {
      message: name => `Es gibt kein Beispiel ${name}.`,
      hint: "„Beispiele“ oben zeigt die, die es gibt.",
    },
    noFilm: {
      message: "Der Film ist leer.",
      hint: "Beginne ihn, während der Roboter fährt, und beende ihn später.",
    },
    filmFailed: {
      message: "Der Film konnte nicht entstehen.",
      hint: "Lass das Programm eine Weile laufen oder versuch die andere Art von Film.",
    },
    noReader: {
      message: "Ein Teil der Seite fehlt.",
      hint: "Lade die Seite neu; nichts von dir geht verloren.",
    },
    notFormatted: {
      message: left =>
        count(left, {
          one: "Eine Definition blieb, wie sie ist.",
          other: n => `${n} Definitionen blieben, wie sie sind.`,
        }),
      hint: "Sie sind nicht fertig, oder beim Setzen wäre etwas verloren gegangen.",
    },
    otherMeaning: {
      message: name =>
        `Der Haskell-Text von ${name} kann diese Änderung an den Blöcken nicht genau sagen. Sie wurde nicht gemacht.`,
      hint: "Mache die Änderung im Haskell-Text, oder baue diese Stelle anders.",
    },
    groupedOtherwise: {
      message: name =>
        `Der Compiler fasst den Haskell-Text von ${name} nach dieser Änderung anders zusammen als die Blöcke. Das Programm ist wieder so wie davor.`,
    },
    unreadableEdit: {
      message: name =>
        `Der Compiler kann den Haskell-Text von ${name} nach dieser Änderung nicht lesen. Das Programm ist wieder so wie davor.`,
    },
    unfinishedText: {
      message: name =>
        `Im Haskell-Text noch nicht fertig: ${name}. Diese Änderung an den Blöcken wurde nicht gemacht.`,
      hint: "Schreibe die Zeile im Text zu Ende oder drücke „Rückgängig“, dann ändere die Blöcke. Blöcke, die schon im Text stehen, kannst du ändern.",
    },
    progressNotSaved: {
      message: "Dieser Browser hat keinen Platz mehr, um deinen Stand in der Lektion zu behalten.",
      hint: "Lösche Programme unter „Meine Programme“, und mach dann den nächsten Schritt. Dein Programm ist nicht betroffen.",
    },
    notSaved: {
      message: "Dieser Browser hat keinen Platz, um dein Programm zu behalten.",
      hint: "Lösche Programme unter „Meine Programme“, oder speichere dieses als Datei, mit dem Menü oben in der Ecke.",
    },
    madeWay: {
      message: names =>
        `Dieser Browser ist voll. Deshalb hat Rosy diese gelöschten Programme endgültig entfernt: ${names}.`,
      hint: "Lösche Programme, die du nicht mehr brauchst, und speichere als Datei, was du behalten willst.",
    },
    robotGone: {
      message: name => `Du hast ${name} nicht mehr.`,
      hint: "Nimm ihn wieder, wenn du ihn brauchst.",
    },
    outOfSight: {
      message: name => `${name} wurde angehalten, weil diese Seite nicht zu sehen war.`,
      hint: "Lass die Seite sichtbar, solange ein echter Roboter fährt.",
    },
    damagedLink: {
      message: "Dieser Link ist beschädigt.",
      hint: "Kopiere den ganzen Link und öffne ihn noch einmal.",
    },
    becameTwo: {
      message: name => `${name === "" ? "Dein Programm" : name} wurde in zwei Tabs zugleich geändert.`,
      hint: copy => `Jetzt sind es zwei: dieses heißt ${copy}.`,
    },
    noStorage: {
      message: "Dieser Browser behält nichts für diese Seite.",
      hint: "Speichere dein Programm als Datei, bevor du die Seite schließt.",
    },
  },
}
