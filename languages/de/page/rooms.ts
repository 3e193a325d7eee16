/// The words of the world editor and of the gallery of rooms in German.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"
import type {Spot} from "../../../editor/src/worlds/world.ts"

const {metres, degrees} = measuresOf("de")
const place = ([x, y]: Spot) => `${metres(x)} / ${metres(y)}`

export const world: Words["world"] = {
  rooms: "Räume",
  roomsLead: "Wähle, wo der Roboter fährt. Dein Programm bleibt, wie es ist.",
  robot: "Roboter",
  roomsLoading: "Die Räume werden gesucht …",
  choose: name => `Raum zum Fahren: ${name}`,
  change: "Diesen Raum ändern",
  /// Title of a room of the gallery that the learner has changed.
  changed: room => `${room}, verändert`,
  title: "Diesen Raum ändern",
  done: "Fertig",
  leave: "Alles lassen, wie es war",
  tools: "Was du zeichnest",
  toolNames: {
    choose: "Auswählen",
    wall: "Wand",
    box: "Klotz",
    crate: "Schiebekiste",
    round: "Pfosten",
    drum: "Schiebetonne",
    solid: "Wandfelder",
    hole: "Löcher",
    floor: "Boden",
    line: "Linie",
    reach: "Komm hierher",
    touch: "Berühre das",
    avoid: "Bleib weg",
    visit: "Besuche alle",
    lap: "Rundenlinie",
    draw: "Zeichne das",
  },
  toolHints: {
    choose: "Zieh Dinge, um sie zu verschieben. Zieh an einem Griff, um sie zu ändern oder zu drehen.",
    wall: "Zieh von einem Ende der Wand zum anderen.",
    box: "Zieh von Ecke zu Ecke. Ein Klotz bleibt, wo er ist.",
    crate: "Zieh von Ecke zu Ecke. Diese Kiste kann der Roboter schieben.",
    round: "Zieh von der Mitte zum Rand. Ein Pfosten bleibt, wo er ist.",
    drum: "Zieh von der Mitte zum Rand. Diese Tonne kann der Roboter schieben.",
    solid: "Zieh über den Boden, um Felder mit Wand zu füllen.",
    hole: "Zieh über den Boden, um Löcher zu machen. Die Räder des Roboters fallen hinein.",
    floor: "Zieh über Wände oder Löcher, um wieder Boden daraus zu machen.",
    line: "Zeichne die schwarze Linie, der ein Liniensensor folgt, oder klick ihre Ecken an.",
    reach: "Zieh einen Kreis. Der Roboter soll hineinkommen.",
    touch: "Zieh einen Kreis. Der Roboter soll dort an etwas stoßen.",
    avoid: "Zieh einen Kreis. Der Roboter soll draußen bleiben.",
    visit: "Klick jeden Ort an, den der Roboter besuchen soll.",
    lap: "Zieh die Linie, die jede Runde überquert.",
    draw: "Zeichne den Weg, dem der Roboter folgen soll, oder klick seine Ecken an.",
  },
  sheetLabel:
    "Der Raum von oben. Die Pfeiltasten verschieben, was ausgewählt ist, oder ein Fadenkreuz; Enter beginnt und beendet eine Zeichnung; Komma und Punkt drehen; Entf nimmt weg.",
  aimAt: at => `Bei ${place(at)}`,
  startFaults: {
    outside: "Der Roboter würde außerhalb des Raums starten. Verschiebe ihn, bevor du weitermachst.",
    wall: "Der Roboter würde in einer Wand starten; er braucht 0,35 Meter freien Boden. Verschiebe ihn, bevor du weitermachst.",
    hole: "Der Roboter würde über einem Loch starten; er braucht Boden unter sich. Verschiebe ihn, bevor du weitermachst.",
  },
  refused: {
    things: (most: number) =>
      `Ein Raum kann höchstens ${most} Wände, Kisten und Pfosten haben. Lösche etwas, bevor du mehr zeichnest.`,
    movable: (most: number) =>
      `Höchstens ${most} Dinge in einem Raum lassen sich schieben. Lösche eines, oder zeichne eines, das fest steht.`,
    lines: (most: number) =>
      `Ein Raum kann höchstens ${most} Linien haben. Nimm eine weg, bevor du eine neue zeichnest.`,
    points: (most: number) =>
      `Eine Linie oder Form kann höchstens ${most} Punkte haben. Lass los und beginne eine neue.`,
    goals: (most: number) =>
      `Ein Raum kann höchstens ${most} Ziele haben. Lösche eines, bevor du ein weiteres anlegst.`,
  },
  snap: "Am Raster einrasten",
  room: "Dieser Raum",
  name: "Name",
  width: "Breite",
  height: "Höhe",
  x: "x",
  y: "y",
  angle: "Winkel",
  radius: "Radius",
  length: "Länge",
  movable: "Lässt sich schieben",
  mass: "Gewicht",
  delete: "Wegnehmen",
  duplicate: "Noch eins",
  things: "In diesem Raum",
  goalTitle: "Was zu tun ist",
  tolerance: "Wie nah",
  laps: "Runden",
  timed: "In einer bestimmten Zeit",
  within: "Zeit",
  avoids: {bumps: "Der Roboter soll nirgends anstoßen", holes: "Kein Rad soll hineinfallen"},
  realistic: "Die Räder rutschen, wie auf echtem Boden",
  dock: "Eine Ladestation, wo der Roboter startet",
  scanner: "Der Roboter hat einen Abstandssensor",
  openFile: "Raum öffnen …",
  saveFile: "Diesen Raum speichern",
  start: "Start des Roboters",
  wall: n => `Wand ${n}`,
  box: (n, movable) => `${movable ? "Kiste" : "Klotz"} ${n}`,
  unknown: n => `Unbekannter Bereich ${n}`,
  floorLine: n => `Linie ${n}`,
  round: (n, movable) => `${movable ? "Tonne" : "Pfosten"} ${n}`,
  goals: {
    reach: "Komm an den Ort",
    touch: "Berühre das Ding",
    avoid: "Bleib weg",
    visit: "Besuche alle Orte",
    lap: "Fahre eine Runde",
    draw: "Zeichne die Figur",
  },
  described: {
    start: (name, at, angle) => `${name} bei ${place(at)}, schaut nach ${degrees(angle)}`,
    line: (name, from, to) => `${name} von ${place(from)} bis ${place(to)}`,
    box: (name, at, [w, h], angle) =>
      `${name} bei ${place(at)}, ${metres(w)} mal ${metres(h)}${angle === 0 ? "" : `, gedreht um ${degrees(angle)}`}`,
    circle: (name, at, r) => `${name} bei ${place(at)}, Radius ${metres(r)}`,
    points: (name, n) => `${name}, ${n} Punkte`,
    at: (name, at) => `${name} bei ${place(at)}`,
  },
}
