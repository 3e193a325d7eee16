/// What `to-haskell` and `to-blocks` say in a terminal, in German.

import type {Words} from "../index.ts"

export const commandLine: Words["commandLine"] = {
  usage: "Aufruf: to-haskell DATEI.rosy, oder to-blocks DATEI.hs -o DATEI.rosy",
  cannotRead: path => `${path} lässt sich nicht lesen.`,
  cannotWrite: path => `${path} lässt sich nicht schreiben.`,
  diskIsFull: path => `${path} lässt sich nicht schreiben: Der Datenträger ist voll.`,
  writingIsNotAllowed: path => `${path} lässt sich nicht schreiben: Es ist nicht erlaubt.`,
  outputCannotBeWritten: "Die Ausgabe lässt sich nicht schreiben: Vielleicht ist der Datenträger voll.",
  looseBlocks: count =>
    count === 1
      ? "Ein loser Block gehört zu keiner Funktion und steht nicht im Haskell."
      : `${count} lose Blöcke gehören zu keiner Funktion und stehen nicht im Haskell.`,
  textWasChanged: "Der Text wurde nach den Blöcken geändert; der Text gilt.",
  staysAsText: (what, reason) => `${what} bleibt Text. ${reason}`.trim(),
  charactersWereReplaced: "Einige Zeichen dieser Datei sind kein UTF-8 und wurden ersetzt.",
}
