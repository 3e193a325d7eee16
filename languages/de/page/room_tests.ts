/// Words of the dialog that tests a program in many rooms, in German.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short, seconds, metres, count} = measuresOf("de")

export const roomTests: Words["roomTests"] = {
  menu: "In vielen Räumen testen …",
  title: "In vielen Räumen testen",
  lead: "Klappt dein Programm in Räumen, die es noch nie gesehen hat?",
  hold: "Das soll in jedem Raum gelten:",
  properties: {
    "reaches-goal": "Er kommt ans Ziel",
    "never-falls": "Er fällt nie in ein Loch",
    "never-pushes": "Er drückt nie länger gegen etwas als",
    "returns-to-start": "Er verlässt den Start und kommt zurück",
    covers: "Er fährt über so viel vom Boden:",
    "room-goals": "Er schafft alles, was der Raum verlangt",
  },
  units: {"never-pushes": "Sekunden", covers: "Prozent"},
  family: "Räume",
  families: {
    obstacles: "mit Hindernissen",
    maze: "Labyrinthe",
    pits: "mit Löchern",
    like: "wie der Raum hier",
  },
  howMany: "Wie viele",
  start: "Testen",
  otherRooms: "In anderen Räumen testen",
  cancel: "Test beenden",
  noProperty: "Wähle etwas, das gelten soll.",
  noConnection: "Rosy ist nicht verbunden. Es versucht es von selbst wieder.",
  lost: "Die Verbindung ist weg und mit ihr der Test. Versuche es noch einmal.",
  waiting: "Der Test beginnt …",
  queued: place => `Andere testen gerade. Dein Platz in der Schlange ist ${place}.`,
  progress: (done, rooms, passed) => `${done} von ${rooms} Räumen, ${passed} bestanden`,
  shrinking: tried =>
    `Gesucht wird der kleinste Raum, in dem es nicht klappt: ${count(tried, {one: "ein Raum probiert", other: n => `${n} Räume probiert`})}`,
  refused: "Das Programm kann noch nicht laufen:",
  allPassed: rooms => `Es klappt in allen ${rooms} Räumen.`,
  passed: (passed, rooms) => `Es klappt in ${passed} von ${rooms} Räumen.`,
  smallest: "Der kleinste Raum, in dem es nicht klappt",
  things: (things, of) =>
    things === 0
      ? "Es klappt nicht einmal, wenn der Raum leer ist."
      : things === of
        ? "Nichts darin kann fehlen."
        : `Von ${of} Dingen ${count(things, {one: "ist nur eins", other: n => `sind ${n}`})} dafür nötig.`,
  openSmallest: "Öffnen und starten",
  failures: "Räume, in denen es nicht klappt, der schlimmste zuerst",
  picture: "Bild",
  room: "Raum",
  what: "Was geschah",
  open: "Öffnen und starten",
  openNamed: room => `Raum ${room} öffnen und starten`,
  more: n =>
    count(n, {
      one: "In einem weiteren Raum klappt es nicht.",
      other: m => `In ${m} weiteren Räumen klappt es nicht.`,
    }),
  back: "Zurück in meinen Raum",
  found: {
    "reaches-goal": share => `Er kam ${short(share * 100, 0)} % des Weges zum Ziel.`,
    "never-falls": time => `Er fiel nach ${seconds(time, 1)}.`,
    "never-pushes": (push, time) =>
      `Er drückte ${seconds(push, 1)} lang, bis ${seconds(time, 1)} nach dem Start.`,
    "returns-to-start": distance =>
      distance === 0 ? "Er blieb nahe am Start." : `Er kam nur bis auf ${metres(distance)} zurück.`,
    covers: share => `Er fuhr über ${short(share, 0)} % des Bodens.`,
    "room-goals": share => `Er schaffte ${short(share * 100, 0)} % von dem, was der Raum verlangt.`,
  },
}
