/// What `to-haskell` and `to-blocks` say in a terminal, in English.

export const commandLine = {
  usage: "Usage: to-haskell FILE.rosy, or to-blocks FILE.hs -o FILE.rosy",
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
  charactersWereReplaced: "Some characters of this file are not UTF-8 and were replaced.",
}
