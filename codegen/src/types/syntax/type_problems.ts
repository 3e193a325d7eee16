/// Problems that inference reports, and constraints that it has yet to solve.

import type {Node} from "../../model/syntax_tree.ts"
import type {Constraint, Type} from "./type.ts"

/// What inference can find wrong. `node` is where it shows.
export type TypeProblem =
  | {
      readonly kind: "mismatch"
      readonly node: Node
      readonly wanted: Type
      readonly found: Type
      /// One of the two parts that differ is a variable of a signature.
      readonly isOfVariable: boolean
    }
  | {readonly kind: "no-instance"; readonly node: Node; readonly constraint: Constraint}
  | {readonly kind: "unknown-name"; readonly node: Node; readonly name: string}
  | {readonly kind: "taken"; readonly node: Node; readonly name: string}
  | {readonly kind: "twice"; readonly node: Node; readonly name: string}
  /// A definition in an instance that its class does not ask for.
  | {readonly kind: "no-method"; readonly node: Node; readonly name: string; readonly of: string}
  /// A type that is said to belong to a class twice.
  | {readonly kind: "second-instance"; readonly node: Node; readonly name: string; readonly of: string}
  | {
      readonly kind: "too-many-arguments"
      readonly node: Node
      readonly type: Type
      /// What gets the arguments is of a type that a signature has a variable for.
      readonly isOfVariable: boolean
    }
  | {
      readonly kind: "wrong-field-count"
      readonly node: Node
      readonly name: string
      readonly wanted: number
      readonly found: number
    }
  | {readonly kind: "ambiguous"; readonly node: Node; readonly constraint: Constraint}
  | {readonly kind: "too-general"; readonly node: Node; readonly constraint: Constraint}
  | {readonly kind: "bad-signature"; readonly node: Node; readonly text: string}
  | {readonly kind: "unknown-type"; readonly node: Node; readonly name: string}
  | {readonly kind: "unknown-class"; readonly node: Node; readonly name: string}
  /// A type with too few or too many arguments.
  | {readonly kind: "kind"; readonly node: Node; readonly name: string}
  /// A derived class without one that it builds on.
  | {
      readonly kind: "missing-superclass"
      readonly node: Node
      readonly name: string
      readonly of: string
      readonly wanted: string
    }
  /// A signature without an equation.
  | {readonly kind: "no-binding"; readonly node: Node; readonly name: string}
  /// Equations of one function that take different numbers of inputs.
  | {readonly kind: "clause-arity"; readonly node: Node}

/// A constraint and the node that asks for it.
export interface Wanted extends Constraint {
  readonly node: Node
}
