/// A learner who builds a program from nothing: a recipe (`recipes.ts`) is followed by hands, for now a mouse's (`mouse.ts`).
///
/// One block that stands alone is in hand: the one that was started or taken up last. What is put goes into its first
/// empty socket, as one reads.

/// The block in hand, or the one in it that was put last.
export type Of = "whole" | "last"

export interface Hands {
  /// Begins with an empty program.
  begins(): Promise<void>
  /// Finds a block that stands alone and takes it in hand.
  starts(found: string): Promise<void>
  /// Takes the block in hand that a screen reader calls this, also inside another.
  takesUp(called: string): Promise<void>
  /// Finds blocks and puts each into the next empty socket: ready blocks, names that are known there, numbers as they
  /// are typed, new names.
  puts(...found: readonly string[]): Promise<void>
  /// Finds a step or a definition and puts it into the empty stack under these words, or below the one before.
  stacks(found: string, under?: string): Promise<void>
  /// Throws away the block that this label is on.
  throws(label: RegExp, of?: Of): Promise<void>
  /// Enters something in the field with this label.
  writes(label: RegExp, text: string, of?: Of): Promise<void>
  /// Chooses from the menu with this label.
  chooses(label: RegExp, option: string, of?: Of): Promise<void>
  /// Presses a small button.
  presses(label: RegExp, times?: number, of?: Of): Promise<void>
  /// Chooses from the menu of a block.
  asks(entry: string, of?: Of): Promise<void>
  /// Writes a remark on the block in hand.
  remarks(text: string): Promise<void>
}
