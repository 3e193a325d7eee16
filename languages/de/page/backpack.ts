/// Der Rucksack.

import type {Words} from "../../../editor/src/words/index.ts"

export const backpack: Words["backpack"] = {
  title: "Rucksack",
  lead: "Was du hier hineinlegst, kann jedes Programm in diesem Browser herausnehmen.",
  empty: "Der Rucksack ist leer.",
  with: names => `mit ${names}`,
  take: "In dieses Programm nehmen",
  takeOf: name => `${name} in dieses Programm nehmen`,
  removeOf: name => `${name} aus dem Rucksack entfernen`,
  from: "Aus diesem Programm:",
  putIn: "Hineinlegen",
  put: name => `${name} in den Rucksack legen`,
  open: "Den Rucksack öffnen",
  packed: name => `${name} ist im Rucksack.`,
  cameAlong: names => `Das wird gebraucht und kam mit: ${names}`,
  notPacked: name => `${name} kann nicht in den Rucksack.`,
  notPackedHint: "Der Text ist unfertig. Bring ihn zuerst in Ordnung.",
  onlyDefinitions: "In den Rucksack kommt nur eine Definition: ein Block mit eigenem Namen.",
  full: "Der Rucksack lässt sich nicht speichern.",
  fullHint:
    "Dieser Browser hat keinen Platz mehr. Entferne etwas aus dem Rucksack oder lösche alte Programme.",
  notUnpacked: name => `${name} passt nicht in dieses Programm.`,
  unpacked: names => `Neu in deinem Programm: ${names}.`,
  present: names => `Das hat dein Programm schon: ${names}.`,
  renamed: (from, to) => `${from} heißt hier ${to}, weil es schon ein anderes ${from} gab.`,
}
