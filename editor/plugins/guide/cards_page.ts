/// Cards of the toolbox's blocks to cut out, and the poster that has them all on one sheet.

import {events, commands as sent, states} from "../../../codegen/src/robot/roles.ts"
import {cardMarkdown} from "./card_block.ts"
import {worksheetWords} from "./teaching_words.ts"
import {paperBlocks} from "./toolbox_blocks.ts"

export const cardsName = "cards"

export const posterName = "poster"

export function cardsPage(language: string): string {
  const {cards} = worksheetWords(language)
  return [
    `# ${cards.title}`,
    cards.lead,
    ...paperBlocks(language).flatMap(({name, blocks}) => [
      `## ${name}`,
      ...blocks.map(block => cardMarkdown({...block, caption: name})),
    ]),
  ].join("\n\n")
}

const roles = {event: events, state: states, command: sent} as const

export function posterPage(language: string): string {
  const {poster} = worksheetWords(language)
  const roleOf = (family: string) => {
    const types = family in roles ? roles[family as keyof typeof roles] : new Set<string>()
    if (types.size === 0) return []
    return [
      `${poster.roles[family as keyof typeof roles]} ${[...types].map(type => `\`${type}\``).join(" ")}`,
    ]
  }
  return [
    `# ${poster.title}`,
    poster.lead,
    ...paperBlocks(language).flatMap(({name, family, blocks}) => [
      `## ${name}`,
      ...roleOf(family),
      ...blocks.map(({family: own, label, haskell}) =>
        cardMarkdown({family: own, caption: label, drawn: "", haskell}),
      ),
    ]),
  ].join("\n\n")
}
