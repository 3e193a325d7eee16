/// Lektionen: ihr Feld und ihre Liste.

import type {Words} from "../../../editor/src/words/index.ts"

const komma = (value: number, digits: number) => value.toFixed(digits).replace(".", ",")
const seconds = (time: number | null) => (time === null ? "" : ` bei ${komma(time, 1)} s`)
const measure = (value: number | null) => komma(Math.abs(value ?? 0), 2)

export const lessons: Words["lessons"] = {
  title: "Lektionen",
  lead: "Kurze Lektionen mit je einer neuen Idee. Du machst weiter, wo du warst.",
  loading: "Die Lektionen werden geholt …",
  failed:
    "Die Lektionen konnten nicht geladen werden. Rosys Dienst antwortet nicht; versuche es gleich noch einmal.",
  missing: (name: string) => `Es gibt keine Lektion mit dem Namen ${name}.`,
  damaged: (name: string, at: string) =>
    `${name} lässt sich nicht als Lektion öffnen: Bei ${at} fehlt etwas oder stimmt etwas nicht.`,
  damagedHint: "Bitte noch einmal um die Datei, oder verbessere sie dort und öffne sie noch einmal.",
  newer: (name: string) => `${name} lässt sich nicht öffnen: Das ist eine Lektion eines neueren Rosy.`,
  newerHint: (version: number, newest: number) =>
    `Sie hat die Version ${version}, und dieses Rosy liest bis ${newest}. Hole dir ein neueres Rosy.`,
  linked: "Dieser Link",
  link: "Link zu dieser Lektion",
  courses: {
    drive: "Fahren: Ein Programm ist ein Wert",
    react: "Reagieren: Es passiert etwas",
    remember: "Merken: Was war",
    tasks: "Aufgaben: Eins nach dem anderen",
    algebra: "Algebra: Eine Funktion hat einen Graphen",
  },
  otherLessons: "Weitere Lektionen",
  finished: "geschafft",
  stepsDone: (done: number, all: number) => `${done} von ${all} Schritten`,
  panel: "Lektion",
  number: (n: number) => `Lektion ${n}`,
  leave: "Lektion verlassen",
  kinds: {predict: "Rate", run: "Starte", investigate: "Schau genau", modify: "Ändere", make: "Baue"},
  yourGuess: (answer: string) => `Du hast geraten: ${answer}`,
  done: "erledigt",
  open: "noch offen",
  missed: "noch nicht",
  go: "Nächster Schritt",
  nextLesson: "Nächste Lektion",
  freePlay: "Mit diesem Programm frei spielen",
  again: "Diesen Schritt neu beginnen",
  hint: "Gib mir einen Tipp",
  moreHint: "Noch ein Tipp",
  notRun: (name: string) => `\`${name}\` ist definiert, aber nichts benutzt es. Führt \`simulate\` es aus?`,
  notTaken: (type: string) => `Noch nimmt keine deiner Funktionen einen Wert vom Typ \`${type}\`.`,
  notGiven: (type: string) => `Noch gibt nichts in deinem Programm einen Wert vom Typ \`${type}\`.`,
  mendFirst: "Im Programm ist ein Fehler. Behebe ihn zuerst: Eine Karte sagt, was zu tun ist.",
  pressRun: "Drücke Start, dann wird während der Fahrt geprüft.",
  letItRun: (time: number) => `Lass es ${time} Sekunden laufen.`,
  learned: "Das hast du gelernt",
  wellDone: "Lektion geschafft!",
  seen: {
    "goal-late": (_n, time, name) => `„${name}“ war erst${seconds(time)} geschafft.`,
    happened: (_n, time, name) => `\`${name}\` ist${seconds(time)} passiert.`,
    "goal-missed": (_n, time, name) => `„${name}“ wurde verfehlt${seconds(time)}.`,
    "goal-open": (_n, time, name) => `„${name}“ war noch offen${seconds(time)}.`,
    away: (n, time) => `Er war ${measure(n)} Meter davon entfernt${seconds(time)}.`,
    turned: (n, time) =>
      `Er schaute ${Math.round(Math.abs(n ?? 0))} Grad zu weit nach ${(n ?? 0) > 0 ? "rechts" : "links"}${seconds(time)}.`,
    "too-short": (_n, time) => `Der Lauf war vor ${time ?? 0} s zu Ende.`,
    moved: (_n, time) => `Er bewegte sich noch${seconds(time)}.`,
    drove: n => `Er fuhr ${measure(n)} Meter.`,
    fastest: (n, time) => `Er war in ${time ?? 0} s höchstens ${measure(n)} Meter in der Sekunde schnell.`,
    "fastest-back": (n, time) =>
      (n ?? 0) === 0
        ? "Er fuhr nicht rückwärts."
        : `Rückwärts war er in ${time ?? 0} s höchstens ${measure(n)} Meter in der Sekunde schnell.`,
    "came-far": n => `Er kam ${measure(n)} Meter vom Start weg.`,
    "not-back": n => `Am Ende war er ${measure(n)} Meter vom Start entfernt.`,
    "ends-far": n => `Am Ende war er ${measure(n)} Meter davon entfernt.`,
    "not-faster": (_n, time, name) => `\`${name}\` passierte${seconds(time)}, und er wurde nicht schneller.`,
    varied: n => `Es wurden ${n ?? 0} verschiedene Werte gesendet.`,
    "not-again": (n, _t, name) => `\`${name}\` passierte ${n ?? 0}-mal, und es war nie wieder wie am Anfang.`,
    miscounted: (n, time, name) => `Er sagte ${name}${seconds(time)}, und es war Nummer ${n ?? 0}.`,
    "not-measured": n => `Er fuhr ${Math.round(n ?? 0)} Zentimeter, und keine solche Zahl wurde gesagt.`,
    "goes-on": (_n, time) => `Das Programm war noch nicht zu Ende${seconds(time)}.`,
    "not-said": (_n, _t, name) => `„${name}“ wurde nicht gesagt.`,
    "not-sent": (_n, _t, name) => `\`${name}\` wurde nicht gesendet.`,
    "not-happened": (n, _t, name) =>
      (n ?? 0) === 0 ? `\`${name}\` ist nicht passiert.` : `\`${name}\` ist nur ${n}-mal passiert.`,
    "no-answer": (_n, time, name) => `\`${name}\` passierte${seconds(time)}, und was folgen soll, kam nicht.`,
    answer: (_n, time, name) =>
      `\`${name}\` passierte${seconds(time)}, und es folgte etwas, das nicht kommen soll.`,
    functions: n => `Das Programm hat ${n ?? 0} eigene Funktionen.`,
    "gives-not": (_n, _t, name) => `\`${name}\` sendet das nicht.`,
    "no-function": (_n, _t, name) => `Keine Funktion handelt von \`${name}\`.`,
    "not-never-falls": (_n, time) => `Ein Rad hing über einem Loch${seconds(time)}.`,
    "not-never-pushes": n => `Er drückte ${measure(n)} Sekunden lang gegen etwas.`,
    "not-reaches-goal": (_n, time) => `Er war nicht am Ziel${seconds(time)}.`,
    "not-returns-to-start": n => `Er kam bis auf ${measure(n)} Meter an den Start zurück.`,
    "not-covers": n => `Er war auf ${Math.round(n ?? 0)} % des Bodens.`,
    "not-room-goals": (_n, time) => `Ein Ziel des Raums war noch offen${seconds(time)}.`,
  },
}
