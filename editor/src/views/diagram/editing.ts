/// Interface of the edits that the diagram makes in a program.

import type {DeclaredType, DefinitionText, NetworkAction, WrittenNetwork} from "@rosy/codegen/network-edits"
import type {Connection, ConnectionEnd, Joining} from "./network/connections.ts"
import type {StepOption} from "./network/step_options.ts"

/// What becomes of a connection.
export type Proposal =
  | {readonly kind: "refused"; readonly why: string}
  /// Changes of tasks, of which one is chosen.
  | {readonly kind: "steps"; readonly title: string; readonly options: readonly StepOption[]}
  | {
      readonly kind: "offered"
      readonly connection: Connection
      /// What it will do, in one line.
      readonly title: string
      readonly asks: "function" | "event" | null
      readonly name: string
      readonly joinings: readonly Joining[]
      /// What a new memory can remember; empty where there is no new memory.
      readonly memories: readonly string[]
    }

export interface NetworkEditing {
  /// The program's text.
  text(): string
  /// The functions of the program as its text has them.
  written(): WrittenNetwork
  propose(from: ConnectionEnd, to: ConnectionEnd): Proposal
  /// Makes an edit, as one undo step, and shows the definition that it is about; the reason if that is impossible.
  edit(action: NetworkAction, declares?: DeclaredType): string | null
  /// All definitions of the program.
  definitions(): readonly DefinitionText[]
  /// Writes another text for a definition, or a new one when `name` is null, as one undo step; the reason if that is impossible.
  define(name: string | null, text: string): string | null
}
