/// Pages for teachers that are made from the lessons' data: nothing of a lesson is left out, in any language.

import {fileURLToPath} from "node:url"
import {robot} from "@rosy/codegen/robot"
import {describe, expect, test} from "vitest"
import {cardOf} from "../../plugins/guide/card_block.ts"
import {quoted, readCurricula} from "../../plugins/guide/curricula_page.ts"
import {tags} from "../../plugins/guide/language_tables.ts"
import {readLessons} from "../../plugins/guide/lesson_source.ts"
import {madeFile, madePages, madeText} from "../../plugins/guide/made_pages.ts"
import {convertMarkdown} from "../../plugins/guide/markdown.ts"
import {seenSentence, teachingWords, worksheetWords} from "../../plugins/guide/teaching_words.ts"
import {readKey} from "../../plugins/guide/written_test_page.ts"

const root = fileURLToPath(new URL("../../..", import.meta.url))
const lessons = readLessons(root)
const pages = madePages(root)

const textOf = (name: string, language: string) =>
  madeText(
    pages,
    language === "en" ? madeFile(name) : madeFile(name).replace("docs/", `docs/${language}/`),
  ) ?? ""

const cardsIn = (text: string) =>
  [...text.matchAll(/^```(card .*)\n([\s\S]*?)\n```$/gm)].flatMap(([, info = "", inside = ""]) => {
    const card = cardOf(info, inside)
    return card === null ? [] : [card]
  })

/// Lines of a text in a column of the poster.
const linesOf = (text: string, width: number) =>
  text.split("\n").reduce((sum, line) => sum + Math.max(1, Math.ceil(line.length / width)), 0)

test("the plan has each lesson in one week or strand", () => {
  const links = [...textOf("plan", "en").matchAll(/\(teach-([\w-]+)\.md\)/g)].map(([, name]) => name)
  expect(links).toEqual(lessons.map(lesson => lesson.name))
})

test("a curriculum asks for lessons that exist, and each lesson is asked for", () => {
  const asked = readCurricula(root).flatMap(({statements}) =>
    statements.flatMap(one => (one.lessons === "all" ? [] : one.lessons)),
  )
  expect([...new Set(asked)].sort()).toEqual(lessons.map(lesson => lesson.name).sort())
})

describe.each(tags)("in %s", language => {
  test("the words know the lessons, and no others", () => {
    expect(Object.keys(teachingWords(language).lessons).sort()).toEqual(lessons.map(one => one.name).sort())
  })

  test("a worksheet has the lesson's program, its questions, and its right answers", () => {
    const sheets = lessons.filter(lesson => lesson.name in worksheetWords("en").sheets)
    expect(sheets.map(lesson => lesson.number)).toEqual([1, 2, 3, 4, 5, 6, 7, 8])
    for (const lesson of sheets) {
      const text = textOf(`sheet-${lesson.name}`, language)
      expect(text).toContain(lesson.start)
      for (const step of lesson.steps.filter(one => one.right !== null)) {
        const {say, answers} = lesson.texts(language).steps[step.id] ?? {}
        expect(text).toContain(say)
        expect(text.split("---")[1]).toContain(answers?.[step.right ?? ""])
      }
    }
  })

  test("the curricula are quoted in their own language, with their source and the lessons", () => {
    const text = textOf("curricula", language)
    const first = text.split("\n\n").find(part => part.startsWith("*"))
    expect(readCurricula(root).find(({source}) => first === `*${source}*`)?.language).toBe(language)
    for (const {source, language: written, statements} of readCurricula(root)) {
      expect(source).toMatch(/\b20\d\d\b/)
      const table = text.split(`*${source}*`)[1]?.split("\n## ")[0] ?? ""
      for (const one of statements) {
        const row = table.split("\n").find(line => line.includes(quoted(one.text, written))) ?? ""
        expect(row).toContain(one.section)
        const links = [...row.matchAll(/\(teach-([\w-]+)\.md\)/g)].map(([, name]) => name)
        expect(links).toEqual(one.lessons === "all" ? [] : one.lessons)
        expect(row.includes(teachingWords(language).curricula.part)).toBe(one.part === true)
      }
    }
  })

  test("each thing that a program does has one card, in words and in Haskell", () => {
    const cards = cardsIn(textOf("cards", language))
    const english = cardsIn(textOf("cards", "en"))
    const haskell = cards.map(card => card.haskell)
    expect(new Set(haskell).size).toBe(haskell.length)
    expect(haskell).toEqual(english.map(card => card.haskell))
    for (const one of [
      "drive 50",
      "wait 1",
      "Velocity 0.5 0",
      "onBump (Bumper _ Pressed) = Just _\nonBump _ = Nothing",
      "Memory _",
      "_ + _",
    ])
      expect(haskell).toContain(one)
    // A type whose values are chosen from a menu is not in the Haskell, but its value is.
    for (const {type, parts} of robot.toolbox)
      expect(haskell.filter(one => [type, ...parts].some(name => one.includes(name)))).not.toEqual([])
    const same = cards.filter(({drawn}, i) => drawn === english[i]?.drawn)
    expect(language === "en" ? 0 : same.length).toBeLessThan(cards.length / 2)
  })

  test("a card shows blocks inside of blocks, and is found by its words", () => {
    const text = textOf("cards", language)
    const {html, sections, faults} = convertMarkdown(text, {
      link: () => null,
      picture: () => null,
      openAddress: () => "",
    })
    expect(faults).toEqual([])
    expect(html).not.toMatch(/[⟦⟧⟨⟩]/)
    expect(html.match(/<figure /g)).toHaveLength(cardsIn(text).length)
    expect(html.match(/<\/span>/g)).toHaveLength(html.match(/<span /g)?.length ?? 0)
    expect(html).toMatch(
      /class="block family-task">[^<]*<span class="block family-number"><span class="field">50</,
    )
    expect(sections.map(one => one.text).join(" ")).not.toMatch(/[⟦⟧⟨⟩]/)
  })

  // A3 across has six columns of 64 by 270 mm; a line of 7 points takes 3.1 mm and holds some 40 letters. Some lines are lost where a column ends.
  test("the poster has the Haskell of each card and the robots' types, and fits on its sheet", () => {
    const text = textOf("poster", language)
    const cards = cardsIn(text)
    expect(cards.map(card => card.haskell)).toEqual(
      cardsIn(textOf("cards", language)).map(card => card.haskell),
    )
    const types = [...robot.roles.events, ...robot.roles.states, ...robot.roles.commands]
    for (const type of types) expect(text).toContain(`\`${type}\``)
    const lines = cards.reduce(
      (sum, {caption, haskell}) => sum + linesOf(caption, 40) + linesOf(haskell, 36) + 0.7,
      linesOf(types.join("    "), 40) + 4 * (text.match(/^## /gm)?.length ?? 0),
    )
    expect(lines).toBeLessThan(6 * (270 / 3.1 - 4))
  })

  test("the slides have the idea and the goal of each lesson", () => {
    const text = [...new Set(lessons.map(lesson => lesson.course))]
      .map(course => textOf(`slides-${course}`, language))
      .join("\n")
    for (const lesson of lessons) {
      const texts = lesson.texts(language)
      const goal = texts.steps[lesson.steps.at(-1)?.id ?? ""]?.say
      for (const part of [`${lesson.number}. ${texts.title}`, texts.idea, texts.learned, goal])
        expect(text).toContain(part)
    }
  })

  test.each(Object.entries(readKey(root)))(
    "test %s has an answer to choose for each letter of the key",
    (name, key) => {
      const questions = worksheetWords(language).tests[name] ?? []
      expect(questions.map(({answers}) => answers?.length)).toEqual(
        key.map(({right}) => (typeof right === "string" ? 3 : undefined)),
      )
      for (const {right} of key) expect(typeof right === "string" ? "abc" : `${right}`).toContain(`${right}`)
      const text = textOf(`test-${name}`, language)
      for (const {program = ""} of key) expect(text).toContain(program)
    },
  )

  test.each(lessons)("$number has its aims, its solutions, and what a check says of a near miss", lesson => {
    const text = textOf(`teach-${lesson.name}`, language)
    const texts = lesson.texts(language)
    const [miss] = lesson.steps.flatMap(step => step.nearMisses).filter(one => one.program !== lesson.start)
    if (miss === undefined) throw new Error(`expected a near miss of ${lesson.name}`)
    const solutions = lesson.steps.flatMap(step => step.solutions.slice(0, 1))
    const parts = [texts.title, texts.idea, texts.learned, lesson.start, ...solutions]
    for (const part of [...parts, seenSentence(miss.seen, texts.checks[miss.check] ?? "", language)])
      expect(text).toContain(part)
  })
})
