/// What `to-haskell` and `to-blocks` say in a terminal, in English.

export const commandLine = {
  usage: "Usage: to-haskell FILE.rosy, or to-blocks FILE.hs -o FILE.rosy [--encoding windows-1252]",
  cannotRead: (path: string) => `Cannot read ${path}.`,
  cannotWrite: (path: string) => `Cannot write ${path}.`,
  diskIsFull: (path: string) => `Cannot write ${path}: the disk is full.`,
  writingIsNotAllowed: (path: string) => `Cannot write ${path}: it is not allowed.`,
  outputCannotBeWritten: "The output cannot be written: the disk may be full.",
  looseBlocks: (count: number) =>
    count === 1
      ? "One loose block belongs to no function and is not in the Haskell."
      : `${count} loose blocks belong to no function and are not in the Haskell.`,
  textWasChanged: "The text was changed after the blocks; the text was taken.",
  staysAsText: (what: string, reason: string) => `${what} stays as text. ${reason}`.trim(),
  notText: "This file is not text in UTF-8.",
  noCode:
    "This file has no code: in literate Haskell, code stands behind > or between \\begin{code} and \\end{code}.",
  olderEncoding: ({encoding, number, line}: {encoding: string; number: number; line: string}) =>
    `This file is in the encoding ${encoding}, not in UTF-8: see line ${number}, “${line.trim()}”. Save it as UTF-8 in your editor, or add --encoding ${encoding} here.`,
}
