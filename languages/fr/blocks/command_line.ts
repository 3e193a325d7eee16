/// What `to-haskell` and `to-blocks` say in a terminal, in French.

import type {Words} from "../../../codegen/src/words/index.ts"

export const commandLine: Words["commandLine"] = {
  usage:
    "Utilisation : to-haskell FICHIER.rosy, ou to-blocks FICHIER.hs -o FICHIER.rosy [--encoding windows-1252]",
  cannotRead: path => `Impossible de lire ${path}.`,
  cannotWrite: path => `Impossible d’écrire ${path}.`,
  diskIsFull: path => `Impossible d’écrire ${path} : le disque est plein.`,
  writingIsNotAllowed: path => `Impossible d’écrire ${path} : ce n’est pas permis.`,
  outputCannotBeWritten: "La sortie ne peut pas être écrite : le disque est peut-être plein.",
  looseBlocks: count =>
    count === 1
      ? "Un bloc isolé n’appartient à aucune fonction et n’est pas dans le Haskell."
      : `${count} blocs isolés n’appartiennent à aucune fonction et ne sont pas dans le Haskell.`,
  textWasChanged: "Le texte a été modifié après les blocs ; c’est le texte qui a été pris.",
  staysAsText: (what, reason) => `${what} reste du texte. ${reason}`.trim(),
  notText: "Ce fichier n’est pas du texte en UTF-8.",
  noCode:
    "Ce fichier ne contient pas de code : en Haskell lettré, le code se trouve derrière > ou entre \\begin{code} et \\end{code}.",
  olderEncoding: ({encoding, number, line}) =>
    `Ce fichier est dans l’encodage ${encoding}, pas en UTF-8 : voir la ligne ${number}, « ${line.trim()} ». Enregistre-le en UTF-8 dans ton éditeur, ou ajoute ici --encoding ${encoding}.`,
}
