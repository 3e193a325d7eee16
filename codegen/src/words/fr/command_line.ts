/// What `to-haskell` and `to-blocks` say in a terminal, in French.

import type {Words} from "../index.ts"

export const commandLine: Words["commandLine"] = {
  usage: "Utilisation : to-haskell FICHIER.rosy, ou to-blocks FICHIER.hs -o FICHIER.rosy",
  cannotRead: path => `Impossible de lire ${path}.`,
  cannotWrite: path => `Impossible d'écrire ${path}.`,
  diskIsFull: path => `Impossible d'écrire ${path} : le disque est plein.`,
  writingIsNotAllowed: path => `Impossible d'écrire ${path} : ce n'est pas permis.`,
  outputCannotBeWritten: "La sortie ne peut pas être écrite : le disque est peut-être plein.",
  looseBlocks: count =>
    count === 1
      ? "Un bloc isolé n'appartient à aucune fonction et n'est pas dans le Haskell."
      : `${count} blocs isolés n'appartiennent à aucune fonction et ne sont pas dans le Haskell.`,
  textWasChanged: "Le texte a été modifié après les blocs ; c'est le texte qui a été pris.",
  staysAsText: (what, reason) => `${what} reste du texte. ${reason}`.trim(),
  charactersWereReplaced: "Certains caractères de ce fichier ne sont pas en UTF-8 et ont été remplacés.",
}
