/// What `to-haskell` and `to-blocks` say in a terminal, in German.

import type {Words} from "../../../codegen/src/words/index.ts"

export const commandLine: Words["commandLine"] = {
  usage: "Aufruf: to-haskell DATEI.rosy, oder to-blocks DATEI.hs -o DATEI.rosy [--encoding windows-1252]",
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
  notText: "Diese Datei ist kein Text in UTF-8.",
  noCode:
    "Diese Datei hat keinen Code: In literarischem Haskell steht Code hinter > oder zwischen \\begin{code} und \\end{code}.",
  olderEncoding: ({encoding, number, line}) =>
    `Diese Datei ist in der Kodierung ${encoding} gespeichert, nicht in UTF-8: siehe Zeile ${number}, „${line.trim()}“. Speichere sie in deinem Editor als UTF-8, oder setze hier --encoding ${encoding} dazu.`,
}
