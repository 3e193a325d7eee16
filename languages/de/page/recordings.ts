/// Aufzeichnungen von Läufen auf echten Robotern.

import type {Words} from "../../../editor/src/words/index.ts"

export const recordings: Words["recordings"] = {
  open: "Aufzeichnung öffnen …",
  openHint: "Ein Lauf auf einem echten Roboter, als MCAP-Datei auf diesem Computer",
  again: "Diesen Lauf noch einmal ansehen",
  where: file => `Dieser Lauf ist aufgezeichnet, auf dem Computer von Rosy: ${file}`,
  run: number => `Lauf ${number}, aufgezeichnet`,
  on: robot => `auf dem Roboter ${robot}`,
  tooLarge: name => `${name} ist zu groß für die Aufzeichnung eines Laufs.`,
  notSent: name => `${name} kam nicht bei Rosy an. Versuch es noch einmal.`,
  notConnected: "Rosy ist nicht erreichbar. Öffne die Aufzeichnung, wenn es wieder da ist.",
  driving: "Ein Roboter fährt. Halte ihn an und öffne dann die Aufzeichnung.",
  refused:
    "Das Programm dieser Aufzeichnung ist von einer anderen Version von Rosy. Darum lässt sich der Lauf nicht zeigen.",
}
