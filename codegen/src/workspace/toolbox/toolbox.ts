/// Toolbox: ready blocks by category, with sockets filled where a newcomer would have to search.
///
/// Three levels filter and order; none locks anything: text and saved programs may hold every block at every level.

import type {Level, ToolboxCategory, ToolboxItem} from "../../api.ts"
import {perLanguage, words} from "../../words/index.ts"
import {readyReactions, readyTasks} from "./ready_made_definitions.ts"
import {item} from "./toolbox_item.ts"
import {
  decide,
  functionItems,
  lists,
  memory,
  motionItems,
  numbers,
  random,
  robotActionItems,
  taskItems,
  types,
} from "./toolbox_language_items.ts"
import {commands, senses, states} from "./toolbox_robot_items.ts"

const category = (
  name: string,
  family: ToolboxCategory["family"],
  items: readonly ToolboxItem[],
): ToolboxCategory => ({
  name,
  family,
  items,
})

const isSecond = ({block}: ToolboxItem) =>
  ["backOff", "buttonSound", "edgeLight"].some(name => name === block.extraState?.name)

const categories = perLanguage(() => ({
  ready: category(words.toolbox.readyMade, "task", [
    ...motionItems(),
    ...[...readyTasks(), ...readyReactions()].map(found => item(found.label, found.block)),
  ]),
  reactions: category(words.toolbox.readyMade, "event", [
    // What is taken beside a first function is in sight at once.
    ...readyReactions()
      .filter(isSecond)
      .map(found => item(found.label, found.block)),
    ...motionItems(),
    ...[...readyReactions(), ...readyTasks()]
      .filter(found => !isSecond(found))
      .map(found => item(found.label, found.block)),
  ]),
  senses: category(words.toolbox.whenItSenses, "event", senses()),
  states: category(words.toolbox.howIt, "state", states()),
  commands: category(words.toolbox.tellTheRobot, "command", commands()),
  memory: category(words.toolbox.memory, "memory", memory()),
  tasks: category(words.toolbox.tasks, "task", taskItems()),
  numbers: category(words.toolbox.numbers, "number", [...numbers(), ...random()]),
  choices: category(words.toolbox.choices, "choice", decide()),
  types: category(words.toolbox.ownTypes, "own", types()),
  functions: category(words.toolbox.functions, "own", functionItems()),
  lists: category(words.toolbox.textAndLists, "own", lists()),
}))

export function toolbox(level: Level): ToolboxCategory[] {
  const all = categories()
  switch (level) {
    case "tasks":
      return [
        all.ready,
        all.tasks,
        all.commands,
        all.senses,
        all.numbers,
        all.choices,
        {...all.functions, items: functionItems().slice(0, 3)},
      ]
    case "reactions":
      return [
        all.reactions,
        all.senses,
        all.states,
        all.commands,
        all.memory,
        all.numbers,
        all.choices,
        all.types,
        all.functions,
        all.tasks,
      ]
    case "haskell":
      return [
        all.senses,
        all.states,
        all.commands,
        all.memory,
        {...all.tasks, items: [...taskItems(), ...robotActionItems()]},
        all.numbers,
        all.choices,
        all.lists,
        all.types,
        all.functions,
        all.reactions,
      ]
  }
}
