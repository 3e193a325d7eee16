/// What `to-haskell` and `to-blocks` say in a terminal, in Portuguese.

import type {Words} from "../../../codegen/src/words/index.ts"

export const commandLine: Words["commandLine"] = {
  usage: "Uso: to-haskell ARQUIVO.rosy, ou to-blocks ARQUIVO.hs -o ARQUIVO.rosy [--encoding windows-1252]",
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
  notText: "Este arquivo não é texto em UTF-8.",
  noCode:
    "Este arquivo não tem código: em Haskell literário, o código fica depois de > ou entre \\begin{code} e \\end{code}.",
  olderEncoding: ({encoding, number, line}) =>
    `Este arquivo está na codificação ${encoding}, não em UTF-8: veja a linha ${number}, “${line.trim()}”. Salve-o como UTF-8 no seu editor, ou acrescente aqui --encoding ${encoding}.`,
}
