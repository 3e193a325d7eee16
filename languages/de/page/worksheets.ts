/// Arbeitsblätter der ersten acht Lektionen, zu jeder etwas ohne Computer, und zwei Tests, auf Deutsch.

import type {WorksheetWords} from "../../en/page/worksheets.ts"

export const worksheets: WorksheetWords = {
  labels: {
    sheet: lesson => `Arbeitsblatt: ${lesson}`,
    slides: course => `Folien: ${course}`,
    name: "Name:",
    answer: "Deine Antwort:",
    forTeachers: "Für die Lehrkraft: Antworten",
    unplugged: title => `Ohne Computer: ${title}`,
    test: number => `Test ${number}`,
    testLead:
      "20 Minuten, auf Papier, ohne Computer. Ein Punkt für jede Frage. Kreuze eine Antwort an oder schreib eine Zahl.",
    marking:
      "Schreib die Antworten in eine Tabelle: ein Name, der Test, dann die Antworten der Reihe nach, und speichere sie als CSV. `./rosy class marks answers.csv -o marks.csv` zählt die Punkte. Eine Zahl darf ein wenig abweichen, wo es im Schlüssel steht.",
  },
  cards: {
    title: "Karten der Blöcke",
    lead: "Karten für die Blöcke: in Worten, in der Farbe ihrer Familie, und in Haskell. Blöcke, die nur in anderen stehen, und große Beispiele haben keine. Gedruckt füllen acht ein Blatt; wähl die Blätter, die du brauchst, und schneide sie aus. Die Kinder legen damit ein Programm, lesen die der anderen und tippen es ab.",
  },
  poster: {
    title: "Die Sprache auf einem Blatt",
    lead: "Die Blöcke der Karten mit ihrem Haskell, für die Wand. Das füllt ein Blatt A3 quer; für A4 lass den Drucker verkleinern.",
    roles: {
      event: "Geschieht in einem Moment:",
      state: "Hat immer einen Wert:",
      command: "Wird an den Roboter gesendet:",
    },
  },
  sheets: {
    "hello-robot": {
      tasks: [
        {
          say: "Der Roboter soll nach 10 Sekunden 3 Meter weiter vorn sein. Welche Zahl?",
          answer: "0,3 (im Programm 0.3)",
        },
        {
          say: "Zeichne, wo `Velocity (-0.2) 0` nach 5 Sekunden ist und nach 10.",
          answer: "1 Meter und 2 Meter hinter dem Start",
        },
      ],
      unplugged: {
        title: "der Roboter, der nie anhält",
        steps: [
          "Ein Kind ist der Roboter und steht an einer Linie. Ein anderes ist das Programm und hält eine Karte: 1 Schritt in der Sekunde.",
          "Die Klasse zählt laut die Sekunden. Der Roboter tut, was auf der Karte steht, solange die Karte da ist.",
          "Das Programm zeigt eine andere Karte: 2 Schritte, oder 1 Schritt zurück. Frag: Wann bleibt der Roboter stehen? (Wenn auf einer Karte 0 steht.)",
        ],
      },
    },
    "turn-on-the-spot": {
      tasks: [
        {
          say: "Wie lange dauert eine ganze Drehung mit `Velocity 0 0.5`? Eine ganze Drehung ist 6,28.",
          answer: "etwa 12,6 Sekunden",
        },
        {
          say: "Welche zweite Zahl dreht in 2 Sekunden um ein Viertel (1,57) nach rechts?",
          answer: "etwa −0,79",
        },
      ],
      unplugged: {
        title: "Radiant mit einer Schnur",
        steps: [
          "Je zwei Kinder zeichnen mit Kreide einen Kreis auf den Boden, mit einer Schnur, die in der Mitte festgehalten wird.",
          "Sie legen dieselbe Schnur am Kreis entlang und markieren, wie oft sie passt: etwas mehr als sechsmal.",
          "Eine Schnurlänge am Kreis entlang ist ein Radiant. Stellt euch in die Mitte und dreht euch um einen, dann um drei.",
        ],
      },
    },
    "round-the-box": {
      tasks: [
        {
          say: "Welchen Radius hat der Kreis von `Velocity 0.4 0.2`?",
          answer: "2 Meter (0,4 geteilt durch 0,2)",
        },
        {
          say: "Finde zwei andere Zahlen für denselben Kreis, halb so schnell gefahren.",
          answer: "`Velocity 0.2 0.1`",
        },
      ],
      unplugged: {
        title: "einen Kreis gehen",
        steps: [
          "Ein Kind macht einen Schritt nach vorn, dreht sich dann ein wenig nach links, immer wieder. Andere markieren den Weg.",
          "Jetzt sind die Drehungen kleiner. Ist der Kreis größer oder kleiner?",
          "Jetzt geschehen Schritt und Drehung gleichzeitig: So macht es der Roboter.",
        ],
      },
    },
    "light-and-motion": {
      tasks: [
        {
          say: "Schreib den Wert für: rückwärts mit 0,1 fahren, erstes Licht orange.",
          answer: "`(Velocity (-0.1) 0, Led1 Orange)`",
        },
        {
          say: "In einem Programm stehen `Led1 Red` und `Led1 Green` nebeneinander. Was ist daran seltsam?",
          answer: "Zwei Werte für ein Licht: Sie ersetzen einander.",
        },
      ],
      unplugged: {
        title: "ein Orchester",
        steps: [
          "Drei Kinder bekommen je eine Karte: klatschen, mit dem Fuß tippen, summen. Alle beginnen, wenn du „Start“ sagst.",
          "Lass sie in anderer Reihenfolge stehen und noch einmal beginnen. Was ist anders? (Nichts.)",
          "Gib einem Kind zwei Karten, die nicht zusammengehen: sitzen, stehen. Was geschieht?",
        ],
      },
    },
    faster: {
      tasks: [
        {
          say: "Die Geschwindigkeit ist 0, und 50-mal in der Sekunde kommt 0,01 dazu. Wie groß ist sie nach 1 Sekunde?",
          answer: "0,5 Meter in der Sekunde",
        },
        {say: "Ergänze: `slower (Velocity vl va) = Velocity (vl ___ 0.01) va`", answer: "`-`"},
      ],
      unplugged: {
        title: "eine Maschine für Zahlen",
        steps: [
          "Ein Kind hinter einem Tisch ist eine Maschine: Eine Zahl kommt auf einem Zettel hinein und kommt plus 2 heraus.",
          "Was herauskommt, kommt wieder hinein. Die Klasse rät die Zahl nach fünf Malen.",
          "Andere Regeln: verdoppeln, eins wegnehmen. Welche wird am schnellsten groß?",
        ],
      },
    },
    "stop-in-time": {
      tasks: [
        {say: "Was gibt `go` für x = 0,5, für x = 0,99 und für x = 1?", answer: "0,3, 0,3 und 0"},
        {
          say: "Füge eine Zeile ein: Zwischen 1 und 1,5 fährt er mit 0,1.",
          answer: "`| x < 1.5 = Velocity 0.1 0` als zweite Zeile",
        },
      ],
      unplugged: {
        title: "die Klasse entscheidet",
        steps: [
          "Ein Kind geht. Nach jedem Schritt sagt es laut, wie viele Schritte es waren.",
          "Die Klasse ist die Funktion und antwortet jedes Mal: „weniger als 5: gehen, sonst: stehen“.",
          "Stell das Kind zwei Schritte zurück und mach weiter. Was antwortet die Klasse jetzt?",
        ],
      },
    },
    bump: {
      tasks: [
        {say: "Die Stoßstange wird 3-mal gedrückt und 3-mal losgelassen. Wie viele Ereignisse?", answer: "6"},
        {
          say: "Ereignis oder Zustand: ein Stoß, die Geschwindigkeit, ein Knopf, die Position?",
          answer: "Ereignis, Zustand, Ereignis, Zustand",
        },
      ],
      unplugged: {
        title: "klatschen oder nichts",
        steps: [
          "Du hebst eine Karte und nimmst sie herunter. Beides sind Ereignisse. Die Klasse antwortet auf jedes mit einem Klatschen.",
          "Neue Regel: klatschen, wenn die Karte hochgeht; nichts, wenn sie heruntergeht. Auch „nichts“ ist eine Antwort.",
          "Wer klatscht, solange die Karte oben ist, hat ein Ereignis für einen Zustand gehalten.",
        ],
      },
    },
    "which-side": {
      tasks: [
        {
          say: "Fälle in dieser Reihenfolge: jede Seite, linke Seite. Wann wird der zweite benutzt?",
          answer: "Nie: Der erste passt auf alles.",
        },
        {
          say: "Schreib das Muster für: Die rechte Stoßstange wird losgelassen.",
          answer: "`Bumper RightBumper Released`",
        },
      ],
      unplugged: {
        title: "die Post",
        steps: [
          "Kisten stehen in einer Reihe: „rote Briefe“, „Briefe an Ada“, „alle anderen“. Ein Brief kommt in die erste Kiste, die passt.",
          "Sortiert zehn Briefe. Wohin kommt ein roter Brief an Ada?",
          "Stellt „alle anderen“ nach vorn und sortiert noch einmal. Was ist in den anderen Kisten?",
        ],
      },
    },
  },
  tests: {
    "1": [
      {
        ask: "Wie weit kommt der Roboter in 5 Sekunden, in Zentimetern?",
        why: "0,3 Meter in jeder von 5 Sekunden.",
      },
      {
        ask: "Wann bleibt er von selbst stehen?",
        answers: ["Nach 1 Meter", "Nach 5 Sekunden", "Nie"],
        why: "Eine Geschwindigkeit gilt, bis eine andere kommt.",
      },
      {
        ask: "Welcher Wert fährt einen Kreis nach rechts?",
        answers: ["`Velocity 0.3 0`", "`Velocity 0 (-0.3)`", "`Velocity 0.3 (-0.3)`"],
        why: "Er fährt und dreht sich zugleich nach rechts.",
      },
      {
        ask: "Was tut dieses Programm?",
        answers: ["Es fährt, dann kommt das Licht", "Beides von Anfang an", "Nur das Licht"],
        why: "Werte stehen nebeneinander.",
      },
      {
        ask: "Wie oft wird gefragt, ob `x < 1` ist?",
        answers: ["Einmal, am Anfang", "Bei jeder Meldung des Roboters", "Wenn er ankommt"],
        why: "Eine Funktion eines Zustands wird immer wieder gefragt.",
      },
      {
        ask: "Der Roboter stößt 3-mal an und kommt jedes Mal wieder frei. Wie viele Töne?",
        why: "Gedrückt und losgelassen sind zwei Ereignisse, dreimal.",
      },
      {
        ask: "Was tut der Roboter an der Wand?",
        answers: ["Er drückt weiter", "Er fährt zurück", "Er hält an"],
        why: "`go` wird immer wieder gesendet und ersetzt, was `back` gesendet hat.",
      },
      {
        ask: "Wann antwortet `back`?",
        answers: [
          "Wenn ein Stoß und ein Loch beide geschehen sind",
          "Bei jedem Stoß und bei jeder Änderung des Bodens",
          "Nur bei dem, was zuerst kommt",
        ],
        why: "`Either` ist das eine oder das andere, jedes Mal.",
      },
    ],
    "2": [
      {
        ask: "Die Stoßstange wird 3-mal gedrückt. Welche Zahl ist dann in der Erinnerung?",
        why: "Sie beginnt mit 0, und bei jedem Drücken kommt 2 dazu.",
      },
      {
        ask: "Was tut der Roboter nach einem Stoß?",
        answers: ["Er fährt zurück", "Er hält an", "Er fährt geradeaus wie vorher"],
        why: "`drive` schaut nicht in die Erinnerung.",
      },
      {
        ask: "Was tut der Roboter am Anfang?",
        answers: ["Er fährt geradeaus", "Er fährt zurück", "Er dreht sich"],
        why: "Die Erinnerung beginnt mit dem ersten Fall.",
      },
      {
        ask: "Was tut das Programm in der Sekunde nach einem Stoß?",
        answers: ["Es wartet eine Sekunde", "Es vergleicht immer wieder die Uhr", "Nichts"],
        why: "Nichts wartet; die Uhr entscheidet.",
      },
      {
        ask: "Ein Programm mit `StdGen` läuft zweimal mit demselben Startwert. Was ist anders?",
        answers: ["Nichts", "Alles", "Nur die erste Drehung"],
        why: "Derselbe Startwert gibt dieselben Zahlen.",
      },
      {
        ask: "Wann beginnt `turn 90`?",
        answers: ["Gleichzeitig mit `drive`", "Wenn `drive 100` zu Ende ist", "Nach einer Sekunde"],
        why: "Die Schritte einer Aufgabe kommen nacheinander.",
      },
      {
        ask: "Wie viele Ecken hat die Figur, die der Roboter fährt?",
        why: "Fünfmal 72 Grad ist eine ganze Drehung.",
      },
      {
        ask: "Wann ist dieses Programm zu Ende?",
        answers: ["Nach 5 Metern", "Wenn beide Aufgaben zu Ende sind", "Nach 4 Sekunden"],
        why: "`race` endet mit der ersten; 5 Meter dauern länger.",
      },
    ],
  },
}
