/// Words of the run tree: runs of a program in a room, what was changed between them, and their comparison.

import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {seconds, count} = measuresOf("de")

export const runs = {
  show: "Die Läufe in diesem Raum zeigen",
  empty: "Starte das Programm: Jeder Lauf bleibt hier, mit einem Bild seines Weges.",
  choose: "Wähle einen Lauf, um ihn wieder anzusehen.",
  isRunning: "Stoppe das Programm, um einen anderen Lauf anzusehen.",
  run: (number: number) => `Lauf ${number}`,
  goOn: (number: number) => `Mit Lauf ${number} weitermachen`,
  otherProgram: (number: number) => `Lauf ${number} hatte ein anderes Programm.`,
  showProgram: "Sein Programm zeigen",
  continued: (run: number, at: number) => `geht weiter aus Lauf ${run} bei ${seconds(at, 2)}`,
  changes: {
    same: "dasselbe Programm",
    layout: "nur Kommentare oder Layout",
    value: (name: string, before: string, after: string) => `${name}: ${before} → ${after}`,
    added: {function: (name: string) => `neue Funktion ${name}`, type: (name: string) => `neuer Typ ${name}`},
    removed: (name: string) => `ohne ${name}`,
    changed: (name: string) => `${name} geändert`,
    renamed: (before: string, after: string) => `${before} heißt jetzt ${after}`,
    more: (n: number) => count(n, {one: "und noch eine Änderung", other: n => `und ${n} weitere Änderungen`}),
  },
  goals: (done: number, all: number) => `${done} von ${all} Zielen`,
  compare: "Vergleichen mit",
  none: "keinem anderen Lauf",
  compared: "verglichen",
  paused: "angehalten",
  /// How the path of each of two runs is drawn.
  lines: {shown: "durchgezogen", compared: "gepunktet"},
  both: "Die zwei Läufe",
  length: "Dauer",
  way: "Gefahrener Weg",
  goalStates: {
    open: "nicht geschafft",
    done: (at: number) => `geschafft bei ${seconds(at, 1)}`,
    missed: (at: number) => `verfehlt bei ${seconds(at, 1)}`,
  },
  dropped: (n: number) =>
    count(n, {
      one: "Ein älterer Lauf ist nicht mehr da.",
      other: n => `${n} ältere Läufe sind nicht mehr da.`,
    }),
} as const
