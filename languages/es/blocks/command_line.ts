/// What `to-haskell` and `to-blocks` say in a terminal, in Spanish.

import type {Words} from "../../../codegen/src/words/index.ts"

export const commandLine: Words["commandLine"] = {
  usage: "Uso: to-haskell ARCHIVO.rosy, o to-blocks ARCHIVO.hs -o ARCHIVO.rosy [--encoding windows-1252]",
  cannotRead: path => `No se puede leer ${path}.`,
  cannotWrite: path => `No se puede escribir ${path}.`,
  diskIsFull: path => `No se puede escribir ${path}: el disco está lleno.`,
  writingIsNotAllowed: path => `No se puede escribir ${path}: no está permitido.`,
  outputCannotBeWritten: "No se puede escribir la salida: quizá el disco está lleno.",
  looseBlocks: count =>
    count === 1
      ? "Un bloque suelto no pertenece a ninguna función y no está en el Haskell."
      : `${count} bloques sueltos no pertenecen a ninguna función y no están en el Haskell.`,
  textWasChanged: "El texto se cambió después que los bloques; se tomó el texto.",
  staysAsText: (what, reason) => `${what} queda como texto. ${reason}`.trim(),
  notText: "Este archivo no es texto en UTF-8.",
  noCode:
    "Este archivo no tiene código: en Haskell literario, el código va detrás de > o entre \\begin{code} y \\end{code}.",
  olderEncoding: ({encoding, number, line}) =>
    `Este archivo está en la codificación ${encoding}, no en UTF-8: mira la línea ${number}, «${line.trim()}». Guárdalo como UTF-8 en tu editor, o añade aquí --encoding ${encoding}.`,
}
