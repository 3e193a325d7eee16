/// Page of a lesson for teachers: aims, steps with their answers, questions to ask, attempts that fail with what the page says of them,
/// and solutions. All but the questions and one sentence stands in the lesson's data.

import type {LessonSource, LessonStep, NearMiss} from "./lesson_source.ts"
import {panelWords, seenSentence, type TeachingWordsOfLesson, teachingWords} from "./teaching_words.ts"
import {minutesOf, type Term} from "./term.ts"

/// Attempts of one step that a page shows: more do not teach more.
const nearMissesShown = 4
/// Solutions besides the reference that a page shows.
const othersShown = 2

export function lessonPage(lesson: LessonSource, term: Term, language: string): string {
  const {labels, lessons} = teachingWords(language)
  const words: TeachingWordsOfLesson = lessons[lesson.name as keyof typeof lessons]
  const panel = panelWords(language)
  const texts = lesson.texts(language)
  const strand = term.strands.find(({course}) => course === lesson.course)
  const week = term.weeks.findIndex(({lessons: names}) => names.includes(lesson.name)) + 1
  const minutes = minutesOf(lesson, term)
  const checksOf = (step: LessonStep) => step.checks.map(id => texts.checks[id] ?? id)
  const tried = lesson.steps.filter(step => step.checks.length > 0)

  const stepRow = (step: LessonStep) => {
    const {say, answers} = texts.steps[step.id] ?? {say: step.id}
    const right = step.right === null ? checksOf(step).join("; ") : (answers?.[step.right] ?? step.right)
    return `| ${(panel.kinds[step.kind] ?? step.kind).trim()} | ${inTable(say)} | ${inTable(right)} |`
  }
  const missesOf = (step: LessonStep) =>
    attemptsShown(lesson, step).flatMap(miss => {
      const check = texts.checks[miss.check] ?? miss.check
      return [
        code(differing(miss, [lesson.start, ...step.solutions.slice(0, 1)])),
        `> ${labels.says(check, seenSentence(miss.seen, check, language))}`,
      ]
    })
  const solutionsOf = (step: LessonStep) => {
    const [reference = "", ...others] = step.solutions
    const shown = step === tried.at(-1) ? others.slice(0, othersShown) : []
    return [
      `### ${texts.steps[step.id]?.say ?? step.id}`,
      code(reference),
      ...(shown.length === 0 ? [] : [labels.others, ...shown.map(code)]),
    ]
  }

  return [
    `# ${lesson.number}. ${texts.title}`,
    `*${strand === undefined ? labels.about(minutes, week) : labels.optional(minutes, strand.from)} · ${panel.courses[lesson.course] ?? lesson.course}*`,
    `## ${labels.aims}`,
    `- ${texts.idea}\n- ${texts.learned}`,
    `## ${labels.steps}`,
    [
      `| ${labels.step} | ${labels.steps} | ${labels.rightAnswer} |`,
      "|---|---|---|",
      ...lesson.steps.map(stepRow),
    ].join("\n"),
    `## ${labels.begins}`,
    code(lesson.start),
    `## ${labels.ask}`,
    words.ask.map(question => `- *${question}*`).join("\n"),
    `## ${labels.wrong}`,
    words.often,
    labels.nearMisses,
    ...tried.flatMap(missesOf),
    "---",
    `## ${labels.solutions}`,
    ...tried.filter(step => step.solutions.length > 0).flatMap(solutionsOf),
  ].join("\n\n")
}

/// Without the program that was not changed.
const attemptsShown = ({start}: LessonSource, {nearMisses}: LessonStep): readonly NearMiss[] =>
  nearMisses.filter(miss => miss.program !== start).slice(0, nearMissesShown)

export const code = (program: string): string => `\`\`\`haskell fragment\n${program}\n\`\`\``

/// The lines that the programs which it is like do not have; the whole of a short program, or of one that only lacks something.
function differing({program}: NearMiss, like: readonly string[]): string {
  const lines = program.split("\n")
  const known = new Set(like.flatMap(text => text.split("\n").map(line => line.trim())))
  const own = lines.filter(line => !known.has(line.trim()))
  return lines.length <= 4 || own.length === 0 ? program : own.join("\n")
}

/// Text in a cell of a table.
export const inTable = (text: string): string => text.replaceAll("|", "\\|").replaceAll("\n", " ")
