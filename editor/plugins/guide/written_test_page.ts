/// Written test for paper, with its key on a second sheet. The right answers and the programs are in `examples/written-tests.json`, the questions in the words.

import {readFileSync} from "node:fs"
import {join} from "node:path"
import {code, inTable} from "./lesson_page.ts"
import {worksheetWords} from "./teaching_words.ts"
import {choices, line} from "./worksheet_page.ts"

export interface KeyQuestion {
  readonly right: string | number
  readonly within?: number
  readonly program?: string
}

export type Key = Readonly<Record<string, readonly KeyQuestion[]>>

export const readKey = (root: string): Key =>
  JSON.parse(readFileSync(join(root, "examples/written-tests.json"), "utf8")) as Key

export function writtenTestPage(name: string, key: readonly KeyQuestion[], language: string): string {
  const {labels, tests} = worksheetWords(language)
  const words = tests[name] ?? []
  if (words.length !== key.length)
    throw new Error(`test ${name} has other questions in ${language} than in its key`)
  return [
    `# ${labels.test(Number(name))}`,
    `${labels.name} ${line}`,
    labels.testLead,
    ...words.flatMap(({ask, answers}, i) => {
      const {program} = key[i] ?? {}
      return [
        `**${i + 1}.** ${ask}`,
        ...(program === undefined ? [] : [code(program)]),
        answers === undefined ? `${labels.answer} ${line}` : choices(answers),
      ]
    }),
    "---",
    `## ${labels.forTeachers}`,
    [
      "| | | |",
      "|---|---|---|",
      ...words.map(({why}, i) => `| ${i + 1} | **${shown(key[i])}** | ${inTable(why)} |`),
    ].join("\n"),
    labels.marking,
  ].join("\n\n")
}

const shown = (question: KeyQuestion | undefined): string =>
  question?.within === undefined ? `${question?.right}` : `${question.right} ± ${question.within}`
