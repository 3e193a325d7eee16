/// Examples of the robot's types for the toolbox, from the robot's description.

import type {ToolboxItem} from "../../api.ts"
import {choiceOf, choices} from "../../blocks/spec/constructor_labels.ts"
import {robot} from "../../robot/description.generated.ts"
import type {SavedBlock} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"
import {con, match, named, num, pat, pick, reaction, sometimes} from "./block_builders.ts"
import {item} from "./toolbox_item.ts"

type Kind = "event" | "state" | "command"

/// A use of each type of the robot that its description gives an example of.
export function examples(kind: Kind): readonly ToolboxItem[] {
  const labels: {readonly [type: string]: string} = words.toolbox.examples
  const table: readonly RobotExample[] = robot.toolbox
  return table
    .filter(example => example.kind === kind)
    .map(example => item(labels[example.type] ?? example.type, exampleBlock(example)))
}

/// As `protocol/robots/README.md` describes it.
interface RobotExample {
  readonly type: string
  readonly kind: Kind
  readonly function?: string
  readonly parts: readonly string[]
}

/// A function that takes the type, or for a command the command itself.
function exampleBlock({type, kind, function: name, parts}: RobotExample): SavedBlock {
  const menu = choices[type]
  if (name === undefined) {
    return menu === undefined
      ? con(type, ...parts.map(valuePart))
      : pick(type, parts[0] ?? menu.options[0] ?? "")
  }
  if (menu !== undefined) return sometimes(name, match(type, parts[0] ?? ""), kind)
  return reaction(name, kind, [pat(type, ...parts.map(patternPart))])
}

function valuePart(part: string): SavedBlock {
  const type = choiceOf(part)
  return type === undefined ? num(part) : pick(type, part)
}

function patternPart(part: string): SavedBlock {
  const type = choiceOf(part)
  return type === undefined ? named(part) : match(type, part)
}
