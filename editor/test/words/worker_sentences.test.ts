/// The explained mistakes in every language: the worker's gallery, worded by `languages/<tag>/sentences.json`.

import {readdirSync, readFileSync} from "node:fs"
import {afterEach, describe, expect, it} from "vitest"
import {emptyProgram, locateProblem} from "../../src/program/program.ts"
import {readServiceMessage} from "../../src/state/messages/message_decoder.ts"
import {decode, list} from "../../src/wire/decode.ts"
import {type Problem, problem, type Sentence} from "../../src/wire/problem.generated.ts"
import {languages as offered, sentencesOf as sentenceFormsOf} from "../../src/words/language_choice.ts"
import {accented} from "../../src/words/pseudo_locales.ts"
import {
  chooseSentences,
  formsOf,
  placeholder,
  put,
  type SentenceForms,
  type SentenceTable,
  worded,
  wordedText,
} from "../../src/words/worker_sentences.ts"

const gallery = new URL("../../../rosy-hs/test-worker/gallery/", import.meta.url)

/// Name and problems of each mistake.
const mistakes: readonly (readonly [string, readonly Problem[]])[] = readdirSync(gallery, {
  withFileTypes: true,
})
  .filter(entry => entry.isDirectory())
  .map(({name}) => {
    const expected = JSON.parse(readFileSync(new URL(`${name}/expected.json`, gallery), "utf8")) as {
      readonly problems: readonly object[]
    }
    // The gallery leaves the text of the compiler out.
    const problems = expected.problems.map(found => ({ghc: "", ...found}))
    const said = decode(list(problem), problems)
    if (said.kind !== "ok") throw new Error(`${name}: ${JSON.stringify(said)}`)
    return [name, said.value] as const
  })

const tables = import.meta.glob<SentenceTable>("../../../languages/*/sentences.json", {
  import: "default",
  eager: true,
})
const languages = Object.entries(tables).map(
  ([path, table]) => [path.split("/").at(-2) ?? "", formsOf(table)] as const,
)

const sentencesOf = (p: Problem): readonly (Sentence | null)[] => [
  p.sentences?.message ?? null,
  p.sentences?.hint ?? null,
  ...p.fixes.map(fix => fix.sentence),
]

/// The arguments that stand in a sentence as they are; one that is a sentence itself is put into the language first.
const phrases = (s: Sentence) =>
  Object.values(s.arguments)
    .flatMap(a => (typeof a === "number" ? [] : a))
    .filter(a => typeof a === "string")

afterEach(() => chooseSentences(null))

it("there are mistakes and languages to test", () => {
  expect(mistakes.length).toBeGreaterThan(200)
  expect(languages.map(([name]) => name)).toContain("de")
})

it.each(Object.keys(offered).filter(tag => tag !== "en"))("the page in %s has its sentences", async tag => {
  const forms = await sentenceFormsOf(tag)
  const table = languages.find(([name]) => name === tag)
  expect(forms?.template("Check its spelling.")).toBe(table?.[1].template("Check its spelling."))
  expect(forms?.template("Check its spelling.")).toBeDefined()
})

it("English has no table", async () => {
  expect(await sentenceFormsOf("en")).toBeNull()
})

describe.each(languages)("in %s", (language, forms) => {
  it.each(mistakes)("%s is explained with the same arguments", (_, problems) => {
    for (const p of problems)
      for (const sentence of sentencesOf(p)) {
        if (sentence === null) continue
        const text = put(forms, sentence)
        expect(text, sentence.id).toBeDefined()
        for (const phrase of phrases(sentence)) expect(text).toContain(phrase)
      }
  })

  it("the explanations are those that were read and approved", async () => {
    const page = mistakes.map(([name, problems]) => `## ${name}\n${problems.map(entry(forms)).join("\n")}\n`)
    await expect(page.join("\n")).toMatchFileSnapshot(`explained_mistakes.${language}.md`)
  })
})

const entry =
  (forms: SentenceForms) =>
  (p: Problem): string => {
    const say = (s: Sentence | null, english: string) => (s === null ? english : (put(forms, s) ?? english))
    const offers = p.fixes.map(fix => ` [${say(fix.sentence, fix.title)}]`)
    return `- ${say(p.sentences?.message ?? null, p.message)} ${say(p.sentences?.hint ?? null, p.hint)}${offers.join("")}`
  }

describe("a sentence", () => {
  const forms: SentenceForms = {
    type: "T‘{type}’",
    function: "F‘{type}’",
    alternative: " o ",
    sequence: " > ",
    numbers: ["n", "e", "z"],
    template: id => id,
  }
  const say = (id: string, given: Sentence["arguments"]) => put(forms, {id, arguments: given})

  it("formats its arguments as the language does", () => {
    expect(say("{x}", {x: "f"})).toBe("f")
    expect(say("{a x}", {x: "Bumper"})).toBe("T‘Bumper’")
    expect(say("{a x}", {x: "Maybe (a -> b)"})).toBe("T‘Maybe (a -> b)’")
    expect(say("{a x}", {x: "Bumper -> Sound"})).toBe("F‘Bumper -> Sound’")
    expect(say("{or x}", {x: ["a", "b", "c"]})).toBe("‘a’, ‘b’ o ‘c’")
    expect(say("{or x}", {x: ["a"]})).toBe("‘a’")
    expect(say("{then x}", {x: ["Int", "a -> b"]})).toBe("T‘Int’ > F‘a -> b’")
    expect(say("{count x} {x}", {x: 2})).toBe("z 2")
    expect(say("{count x}", {x: 3})).toBe("3")
  })

  it("keeps braces that belong to no argument, and puts arguments in literally", () => {
    expect(say("{starting = …} {x}", {x: "$& {y}"})).toBe("{starting = …} $& {y}")
    expect("a {b} {c d}".match(placeholder)).toEqual(["{b}", "{c d}"])
  })

  it("is not said when an argument is missing", () => {
    expect(say("{x} and {y}", {x: "a"})).toBeUndefined()
    expect(say("{toString}", {})).toBeUndefined()
  })
})

describe("a problem on the page", () => {
  const compilerError: Problem = {
    severity: "error",
    kind: "not-in-scope",
    start: null,
    end: null,
    function: null,
    message: "There is nothing called ‘f’.",
    hint: "Check its spelling.",
    ghc: "Variable not in scope: f",
    time: null,
    inputs: [],
    sentences: {
      message: {id: "There is nothing called ‘{name}’.", arguments: {name: "f"}},
      hint: {id: "A sentence of a newer worker.", arguments: {}},
    },
    fixes: [{title: "Write g", sentence: {id: "Write {code}", arguments: {code: "g"}}, edits: []}],
  }
  const shown = () => locateProblem(emptyProgram, compilerError, "compiler")

  it("is worded in the language of the page; the compiler's words stay", () => {
    const german = languages.find(([name]) => name === "de")
    chooseSentences(german?.[1] ?? null)
    expect(shown().message).toBe("Es gibt nichts namens ‘f’.")
    expect(shown().fixes.map(fix => fix.title)).toEqual(["g schreiben"])
    expect(shown().ghc).toBe(compilerError.ghc)
  })

  it("is in English where the language does not know the sentence", () => {
    chooseSentences(languages[0]?.[1] ?? null)
    expect(shown().hint).toBe("Check its spelling.")
    expect(worded(null, "GHC says so.")).toBe("GHC says so.")
  })

  it("is in English on an English page", () => {
    expect(shown().message).toBe("There is nothing called ‘f’.")
  })

  it("leaves no English word in a pseudo-language but its arguments", () => {
    chooseSentences(accented.sentences ?? null)
    expect(shown().message).toMatch(/f’/)
    expect(shown().message).not.toMatch(/nothing|called/)
  })
})

it("a sentence within a sentence is worded in the same language", async () => {
  const spanish = await sentenceFormsOf("es")
  if (spanish === null) throw new Error("no Spanish")
  const why = {id: "the row is empty.", arguments: {}}
  expect(put(spanish, {id: "at {path}: {why}", arguments: {path: "tiles", why}})).toBe(
    "en tiles: la fila está vacía.",
  )
  const foreign = {id: "In no table: {n}.", arguments: {n: 1}}
  expect(put(spanish, {id: "at {path}: {why}", arguments: {path: "tiles", why: foreign}})).toBe(
    "en tiles: In no table: 1.",
  )
})

it("titles of our own rooms and goals are worded, and those of others stay", async () => {
  chooseSentences(await sentenceFormsOf("es"))
  expect(["A room", "Touch nothing", "My room"].map(wordedText)).toEqual([
    "Una sala",
    "No toques nada",
    "My room",
  ])
})

it("a refusal of the service is read in the language of the page", async () => {
  chooseSentences(await sentenceFormsOf("de"))
  const refusal = {
    op: "refusal",
    message: "That place is outside the room.",
    hint: "",
    sentences: {message: {id: "That place is outside the room."}},
  }
  const read = readServiceMessage(JSON.stringify(refusal))
  expect(read).toMatchObject({value: {message: "Dieser Ort ist außerhalb des Raums.", hint: ""}})
})

it("the reason why a robot cannot be driven is read in the language of the page, with its arguments", async () => {
  chooseSentences(await sentenceFormsOf("de"))
  const lost = {
    op: "robot",
    name: "Kitchen",
    link: "lost",
    why: "its firmware 0.9 speaks another protocol",
    sentence: {id: "its firmware {version} speaks another protocol", arguments: {version: "0.9"}},
    stopped: true,
    max_speed: 0.7,
    max_turn: 3.1,
  }
  const read = readServiceMessage(JSON.stringify(lost))
  const why = "seine Firmware 0.9 spricht ein anderes Protokoll"
  expect(read).toMatchObject({kind: "ok", value: {robot: {why}}})
})
