/// Words that people say, in each language of the page: what the search finds first for them.

import {blockTypes, type Level, libraryItems, type ToolboxItem, toolbox, typedItems} from "@rosy/codegen"
import {speak, type Words} from "@rosy/codegen/words"
import {afterEach, describe, expect, test} from "vitest"
import {table as de} from "../../../languages/de/blocks/index.ts"
import {en} from "../../../languages/en/blocks/index.ts"
import {table as es} from "../../../languages/es/blocks/index.ts"
import {table as fr} from "../../../languages/fr/blocks/index.ts"
import {table as pt} from "../../../languages/pt/blocks/index.ts"
import type {Language} from "../../src/views/blocks/construction/language.ts"
import {levels, search, searchable, searchEntries} from "../../src/views/blocks/interaction/toolbox_search.ts"

afterEach(() => speak(en))

/// What is meant, as something that stands in the block that is found.
const meanings = {
  back: /step_drive_back|backOff|"-0.2"/,
  wall: /Bumper|step_drive_until_bump|backOff|countBumps/,
  again: /step_forever|step_repeat/,
  choice: /"type":"(if|step_if|step_when|branches|case)"/,
  reaction: /"type":"define"/,
  light: /"con":"Led1"/,
  pause: /step_wait/,
  memory: /Memory/,
  chance: /step_turn_between|step_either_or|step_bind/,
} as const

/// The queries of each meaning.
const asked: readonly (readonly [string, Words, {readonly [Meaning in keyof typeof meanings]: string}])[] = [
  [
    "English",
    en,
    {
      back: "backwards,reverse,back",
      wall: "wall,bump,hit,crash",
      again: "forever,loop,again",
      choice: "if",
      reaction: "when",
      light: "light,lamp,LED,led,lights,lamps,leds",
      pause: "wait,sleep",
      memory: "variable,remember",
      chance: "random,dice,chance",
    },
  ],
  [
    "German",
    de,
    {
      back: "rückwärts,zurück",
      wall: "Wand,anstoßen,stoßen,Stoßstange",
      again: "immer,Schleife,nochmal,wiederholen",
      choice: "falls,entscheiden",
      reaction: "wenn",
      light: "Licht,Lampe,LED,led,Lichter,Lampen,Leuchte,LEDs",
      pause: "warten,schlafen",
      memory: "Variable,merken",
      chance: "zufällig,Zufall,Würfel",
    },
  ],
  [
    "French",
    fr,
    {
      back: "reculer,arrière",
      wall: "mur,choc,cogner",
      again: "répéter,boucle,encore",
      choice: "si",
      reaction: "quand",
      light: "lumière,lampe,LED,led,lumières,voyant",
      pause: "attendre,dormir",
      memory: "variable,retenir",
      chance: "hasard,aléatoire,dé",
    },
  ],
  [
    "Spanish",
    es,
    {
      back: "atrás,retroceder",
      wall: "pared,chocar,choque",
      again: "siempre,bucle,otra vez",
      choice: "si",
      reaction: "cuando",
      light: "luz,lámpara,LED,led,luces",
      pause: "esperar,dormir",
      memory: "variable,recordar",
      chance: "azar,aleatorio,dado",
    },
  ],
  [
    "Portuguese",
    pt,
    {
      back: "ré,trás,recuar",
      wall: "parede,bater,batida",
      again: "sempre,laço,de novo",
      choice: "se",
      reaction: "quando",
      light: "luz,lâmpada,LED,led,luzes",
      pause: "esperar,dormir",
      memory: "variável,lembrar",
      chance: "acaso,aleatório,dado",
    },
  ],
]

/// Only what the search asks of a language.
const language = () => ({toolbox, libraryItems, typedItems}) as unknown as Language

describe.each(asked)("in %s", (_, table, queries) => {
  const rows = Object.entries(queries).flatMap(([meaning, all]) =>
    all.split(",").map(query => [query, meaning as keyof typeof meanings] as const),
  )
  const entries = levels.map(level => {
    speak(table)
    return {level, items: searchEntries(searchable(language(), level), blockTypes)}
  })
  const find = (level: Level, query: string): readonly ToolboxItem[] =>
    search(entries.find(one => one.level === level)?.items ?? [], query)

  test.each(levels)("the commands of the lights come first at the level %s", level => {
    for (const query of queries.light.split(",")) {
      const commands = find(level, query)
        .slice(0, 3)
        .map(({block}) => `${block.type} ${block.extraState?.con} ${block.extraState?.args}`)
      expect(commands.slice(0, 2), query).toEqual(["construct Led1 1", "construct Led2 1"])
      expect(commands[2], query).not.toMatch(/ 0$/)
    }
  })

  test.each(rows)("%s is about %s", (query, meaning) => {
    const found = find("reactions", query)
    expect(
      JSON.stringify(found[0]?.block ?? null),
      found
        .slice(0, 3)
        .map(item => item.label)
        .join(" | "),
    ).toMatch(meanings[meaning])
  })
})
