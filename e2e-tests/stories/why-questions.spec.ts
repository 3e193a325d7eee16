/// Questions of `sim-service/tests/system/questions.md`, one for each kind of question and of sentence in an answer, asked in the page: the sentences, the blocks, the lines, the nodes of the diagram and
/// the moments of each answer. One page for all runs.

import {expect, type Locator, type Page} from "@playwright/test"
import {boxAtRest} from "./at_rest.ts"
import {Learner} from "./learner.ts"
import {
  type AskedQuestion,
  ControlledRuns,
  type DefinedNames,
  definedIn,
  type QuestionedRun,
  type QuestionTimes,
  questionedRuns,
} from "./questions.ts"
import {test} from "./story.ts"

/// A question or a sentence without its names, code and numbers.
const kindOf = (sentence: string) =>
  sentence
    .replace(/`[^`]*`/g, "…")
    .replace(/\*\*\w+\*\*/g, "…")
    .replace(/[\d.]+/g, "…")

/// The runs with those of their questions that have a kind of sentence which none before had. The service answers all of them without a page
/// (`sim-service/tests/system/test_questions.py`).
function withNewKinds(runs: readonly QuestionedRun[]): readonly QuestionedRun[] {
  const seen = new Set<string>()
  const isNew = ({text, answer}: AskedQuestion): boolean => {
    const before = seen.size
    for (const sentence of [text, ...answer]) seen.add(kindOf(sentence))
    return seen.size > before
  }
  return runs
    .map(run => ({...run, questions: run.questions.filter(isNew)}))
    .filter(({questions}) => questions.length > 0)
}

const runs = withNewKinds(questionedRuns())

const why = (page: Page) => page.getByTestId("why")
const diagram = (page: Page) => page.getByRole("region", {name: "Diagram", exact: true})

test("the questions about the examples have their answers in text, blocks, lines, diagram and time line", async ({
  page,
}) => {
  // Blocks, diagram and text are all in sight.
  await page.setViewportSize({width: 1900, height: 1100})
  const controlled = await ControlledRuns.of(page)
  const learner = new Learner(page)
  const asker = new Asker(page, learner, controlled)
  for (const [number, run] of runs.entries()) {
    if (number === 0) {
      await learner.opens(run.example)
      await page.getByRole("button", {name: "Diagram", exact: true}).click()
    } else {
      await page.getByRole("button", {name: "Examples"}).click()
      await page
        .getByRole("dialog")
        .getByRole("button", {name: new RegExp(`^${run.example}\\b`)})
        .click()
      await expect(page.getByRole("textbox", {name: "Name of the program"})).toHaveValue(run.example)
      await expect(learner.runButton()).toHaveText("Run")
    }
    await expect(diagram(page).locator(".node").first()).toBeVisible()
    await controlled.repeats(
      run,
      run.questions.map(({text}) => formOf(text).at),
    )
    await learner.runs()
    if (await controlled.isOver()) await expect(learner.runButton()).toHaveText("Run")
    else {
      // The program stands still already; now the page knows.
      await page.getByRole("button", {name: "Pause", exact: true}).click()
      await expect(page.getByTestId("clock")).toHaveText(`${run.seconds.toFixed(2)} s`)
    }
    const defined = definedIn(run.example)
    for (const question of run.questions)
      await test.step(`${run.title}: ${question.text}`, () => asker.asks(question, defined))
  }
})

interface QuestionForm {
  readonly form: RegExp
  readonly times: (found: readonly string[]) => QuestionTimes
  /// The displayed moment, s.
  readonly at: (found: readonly string[]) => number
  readonly ask: (asker: Asker, found: readonly string[]) => Promise<void>
}

const number = String.raw`(\d+(?:\.\d+)?)`
const from = `from ${number} s to ${number} s`

const at = (group: number) => (found: readonly string[]) => Number(found[group])
const during = (group: number) => (found: readonly string[]) => ({
  since: Number(found[group]),
  until: Number(found[group + 1]),
})
const moment = (group: number) => (found: readonly string[]) => ({time: Number(found[group])})

/// How each question of the table is asked with the controls of the page.
const forms: readonly QuestionForm[] = [
  {
    form: new RegExp(`^Why does the robot move like this at ${number} s\\?$`),
    at: at(1),
    times: moment(1),
    ask: asker => asker.asksOfRobot(),
  },
  {
    form: new RegExp(`^Why is the robot there at ${number} s\\?$`),
    at: at(1),
    times: moment(1),
    ask: async asker => {
      await asker.asksOfRobot()
      await asker.follows("Why was it there?")
    },
  },
  {
    form: new RegExp(`^Why \`(\\w+)\` at ${number} s\\?$`),
    at: at(2),
    times: moment(2),
    ask: (asker, [, type = ""]) =>
      asker.asksOfNode("command", type, type === "Velocity" ? "Why does it move like this?" : `Why ${type}?`),
  },
  {
    form: new RegExp(`^Why does \`(Memory [^\`]+)\` have its value at ${number} s\\?$`),
    at: at(2),
    times: moment(2),
    ask: (asker, [, type = ""]) => asker.asksOfNode("memory", type, `Why does ${type} have its value?`),
  },
  {
    form: new RegExp(`^What happened with \`([^\`]+)\` by ${number} s\\?$`),
    at: at(2),
    times: moment(2),
    ask: (asker, [, event = ""]) =>
      event.includes(" ")
        ? asker.asksOfLine(event)
        : asker.asksOfNode("event", event, `What happened with ${event}?`),
  },
  {
    form: new RegExp(`^Why did \\*\\*(\\w+)\\*\\* run at ${number} s\\?$`),
    at: at(2),
    times: moment(2),
    ask: (asker, [, name = ""]) => asker.asksOfFunction(name, `Why did ${name} run?`),
  },
  {
    form: new RegExp(`^Why did \\*\\*(\\w+)\\*\\* not run ${from}\\?$`),
    at: at(3),
    times: during(2),
    ask: (asker, [, name = ""]) => asker.asksOfFunction(name, `Why did ${name} not run?`),
  },
  {
    form: new RegExp(`^Why did \\*\\*(\\w+)\\*\\* send no \`([^\`]+)\` ${from}\\?$`),
    at: at(4),
    times: during(3),
    ask: async (asker, [, name = "", type = ""]) => {
      await asker.asksOfFunction(name, `Why did ${name} not run?`)
      await asker.follows(`Why no ${type}?`)
    },
  },
  {
    form: new RegExp(`^Why no \`([^\`]+)\` ${from}\\?$`),
    at: at(3),
    times: during(2),
    ask: (asker, [, type = ""]) => asker.asksOfNode("command", type, `Why no ${type}?`),
  },
  {
    form: new RegExp(`^Why not the case \`([^\`]+)\` of \\*\\*\\w+\\*\\* ${from}\\?$`),
    at: at(3),
    times: during(2),
    ask: (asker, [, told = ""]) => asker.asksOfCase(told),
  },
  {
    form: new RegExp(`^Why was no \`([^\`]+)\` received by ${number} s\\?$`),
    at: at(2),
    times: found => ({since: 0, until: Number(found[2])}),
    ask: (asker, [, type = ""]) => asker.asksOfNode("event", type, `Why was no ${type} received?`),
  },
]

/// The form that a question has: its moment, its times, and how it is asked.
function formOf(text: string) {
  for (const {form, at, times, ask} of forms) {
    const found = form.exec(text)
    if (found !== null) return {at: at(found), times: times(found), ask: (asker: Asker) => ask(asker, found)}
  }
  throw new Error(`expected a question, found: ${text}`)
}

class Asker {
  readonly #page: Page
  readonly #learner: Learner
  readonly #controlled: ControlledRuns

  constructor(page: Page, learner: Learner, controlled: ControlledRuns) {
    this.#page = page
    this.#learner = learner
    this.#controlled = controlled
  }

  async asks({text, answer}: AskedQuestion, defined: DefinedNames): Promise<void> {
    const {at, times, ask} = formOf(text)
    const beyond = await this.#looksAt(at)
    await this.#controlled.asksAbout(times)
    await ask(this)
    await expect(this.#sentences()).toHaveText(answer.map(plain))
    // Blocks, text and diagram are drawn after the sentences.
    await expect(() => this.#seesPath(answer, defined)).toPass({timeout: 180_000})
    // A line of the console asks about its own time.
    if (!/^What happened|`Say`/.test(text))
      expect(await this.#controlled.offset()).toBeLessThan(0.03 + beyond)
    await why(this.#page).getByRole("button", {name: "Close the answer"}).click()
    await expect(this.#page.locator(".rosyWhy, .hs-why, svg.diagram .node.why, .why-marks i")).toHaveCount(0)
  }

  async asksOfRobot(): Promise<void> {
    await this.#page.getByRole("button", {name: "Why does the robot move like this?"}).click()
  }

  /// By the node of the function, or by the menu of its block when it is not in the diagram. The cursor in its first line scrolls the block
  /// into view.
  async asksOfFunction(name: string, question: string): Promise<void> {
    const node = diagram(this.#page).getByRole("button", {name: new RegExp(`^${name}: function`)})
    if ((await node.count()) > 0) {
      await node.first().focus()
      await this.#page.keyboard.press("Enter")
      await diagram(this.#page).getByRole("button", {name: question, exact: true}).click()
      return
    }
    const line = this.#learner.haskell().locator(".cm-line", {hasText: new RegExp(`^${name} ::`)})
    await line.click({position: {x: 2, y: 6}})
    await expect(this.#page.locator(".source-host .hs-linked-line").first()).toHaveText(
      new RegExp(`^${name} ::`),
    )
    const block = this.#page.locator(".rosyTold").first()
    // It scrolls into view.
    await boxAtRest(block)
    await block.click({button: "right", position: {x: 8, y: 8}})
    await this.#page.getByRole("menuitem", {name: question}).click()
  }

  /// By a node of the diagram; a command that no function sends is asked about in the table of sensors.
  async asksOfNode(kind: "command" | "memory" | "event", type: string, question: string): Promise<void> {
    // An event of the robot or of the program.
    const kinds = {command: ["command"], event: ["event", "channel"]}
    const node =
      kind === "memory"
        ? // The node is called as the program writes the type, which may be a synonym.
          diagram(this.#page).locator('[data-node*="store:"]').filter({hasText: type})
        : diagram(this.#page).locator(kinds[kind].map(of => `[data-node$="${of}:${type}"]`).join(", "))
    if (type === "Say" && (await node.count()) === 0) {
      await this.#asksOfSpeech()
      return
    }
    if (kind === "command" && (await node.count()) === 0) {
      await this.#asksOfUnsent(type)
      if (question.startsWith("Why no ")) await this.follows(question)
      return
    }
    await node.first().focus()
    await this.#page.keyboard.press("Enter")
    await diagram(this.#page).getByRole("button", {name: question, exact: true}).click()
  }

  async #asksOfUnsent(type: string): Promise<void> {
    await this.#page.getByRole("tab", {name: "Values"}).click()
    const row = type.replace(/Led(\d)/, "LED $1")
    await this.#page
      .getByTestId("sensors")
      .getByRole("button", {name: `Why ${row}?`, exact: true})
      .click()
  }

  /// By the newest line that the robot said; a task says it, and the diagram shows what functions send.
  async #asksOfSpeech(): Promise<void> {
    await this.#page.getByRole("tab", {name: "Console"}).click()
    const line = this.#page.getByTestId("console").locator(".line.said").last()
    await line.getByRole("button", {name: /^Why /}).click()
  }

  /// By the newest line of the console that says so.
  async asksOfLine(text: string): Promise<void> {
    await this.#page.getByRole("tab", {name: "Console"}).click()
    await this.#page
      .getByTestId("console")
      .getByRole("button", {name: `Why ${text}?`, exact: true})
      .last()
      .click()
  }

  /// By the button above the text, with the cursor in the case.
  async asksOfCase(told: string): Promise<void> {
    // An equation, a guard, or the first side of an `if`.
    const words = escaped(told)
    const forms = [
      new RegExp(`^${words}`, "m"),
      new RegExp(`\\| ${words}(?= )`),
      new RegExp(`if ${words} then \\S+`),
    ]
    const text = await this.#learner.haskellText()
    const [found] = forms.flatMap(form => form.exec(text)?.[0] ?? [])
    await this.#learner.findsInHaskell(found ?? told)
    await this.#page.getByRole("button", {name: "Why not this case?"}).click()
  }

  async follows(question: string): Promise<void> {
    await why(this.#page).getByRole("button", {name: question, exact: true}).click()
  }

  #sentences(): Locator {
    return this.#page.getByTestId("why-answer").locator("p")
  }

  /// The seconds by which the time lies behind the end of the run, where the line ends.
  async #looksAt(time: number): Promise<number> {
    const line = this.#page.getByRole("slider", {name: "Look back in the run"})
    return line.evaluate((input: HTMLInputElement, value) => {
      input.value = String(value)
      input.dispatchEvent(new Event("input", {bubbles: true}))
      return Math.max(0, value - Number(input.max))
    }, time)
  }

  /// The functions that the answer names are marked in blocks, text and diagram, in all three the same ones, and its times on the time line.
  /// Functions of the library are not in the program. The block of a local function is within that of the definition around it, whose lines
  /// are marked.
  async #seesPath(answer: readonly string[], defined: DefinedNames): Promise<void> {
    const named = answer.flatMap(sentence =>
      [...sentence.matchAll(/\*\*(\w+)\*\*/g)].map(found => found[1] ?? ""),
    )
    const times = answer.flatMap(sentence =>
      [...sentence.matchAll(/^At ([\d.]+) s/g)].map(found => Number(found[1])),
    )
    const seen = await this.#page.evaluate(() => {
      const all = (selector: string) => [...document.querySelectorAll<HTMLElement>(selector)]
      const nameOf = (node: Element) => node.getAttribute("aria-label")?.split(":")[0] ?? ""
      const line = document.querySelector<HTMLInputElement>("input.lookback")
      const from = Number(line?.min)
      const length = Number(line?.max) - from
      // A definition begins at the first column, and so does its signature.
      const marked = all(".cm-line.hs-why").map(one => /^\w+/.exec(one.textContent ?? "")?.[0])
      return {
        lines: [...new Set(marked.filter(name => name !== undefined))].sort(),
        blocks: all(".rosyWhy").map(one => one.textContent ?? ""),
        nodes: all("svg.diagram .node.function.why").map(nameOf),
        allNodes: all("svg.diagram .node.function").map(nameOf),
        times: all(".why-marks i").map(
          mark => from + (length * Number.parseFloat(mark.style.insetInlineStart)) / 100,
        ),
      }
    })
    expect(seen.lines).toEqual(
      expect.arrayContaining([...new Set(named)].filter(name => defined.global.has(name))),
    )
    const local = new Set(named.filter(name => defined.local.has(name)))
    expect(seen.blocks.length).toBe(seen.lines.length + local.size)
    for (const name of seen.lines) expect(seen.blocks.some(block => block.includes(name))).toBe(true)
    expect([...new Set(seen.nodes)].sort()).toEqual(seen.lines.filter(name => seen.allNodes.includes(name)))
    expect(seen.times.length).toBeGreaterThan(0)
    for (const time of times)
      expect(Math.min(...seen.times.map(one => Math.abs(one - time)))).toBeLessThan(0.011)
  }
}

/// A sentence as the page shows it. Functions that stand as operators keep their backquotes: ``second `mod` 15``.
const plain = (sentence: string) =>
  sentence.replaceAll("**", "").replaceAll(/`((?: `[\w.']+` |[^`])*)`/g, "$1")

const escaped = (text: string) => text.replaceAll(/[[\]()\\.*+?^$|{}]/g, "\\$&")
