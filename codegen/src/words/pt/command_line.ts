/// What `to-haskell` and `to-blocks` say in a terminal, in Portuguese.

import type {Words} from "../index.ts"

export const commandLine: Words["commandLine"] = {
  usage: "Uso: to-haskell ARQUIVO.rosy, ou to-blocks ARQUIVO.hs -o ARQUIVO.rosy",
  cannotRead: path => `Não dá para ler ${path}.`,
  cannotWrite: path => `Não dá para escrever ${path}.`,
  diskIsFull: path => `Não dá para escrever ${path}: o disco está cheio.`,
  writingIsNotAllowed: path => `Não dá para escrever ${path}: não é permitido.`,
  outputCannotBeWritten: "Não dá para escrever a saída: talvez o disco esteja cheio.",
  looseBlocks: count =>
    count === 1
      ? "Um bloco solto não pertence a nenhuma função e não está no Haskell."
      : `${count} blocos soltos não pertencem a nenhuma função e não estão no Haskell.`,
  textWasChanged: "O texto foi mudado depois dos blocos; vale o texto.",
  staysAsText: (what, reason) => `${what} continua como texto. ${reason}`.trim(),
  charactersWereReplaced: "Alguns caracteres deste arquivo não são UTF-8 e foram substituídos.",
}
