/// Building in the diagram alone: by mouse, where wires are dragged, and by keyboard, in the list form. Each drag, press, choice and typed text is one action.

import {expect, type Locator, type Page} from "@playwright/test"
import {diagram, drags, node} from "./diagram_page.ts"
import type {Answers, End, Wiring} from "./diagram_recipes.ts"

/// Opens an empty program where nothing but the diagram is seen of it.
async function beginsAlone(page: Page): Promise<void> {
  await page.getByRole("button", {name: "More", exact: true}).click()
  await page.getByText("New program").click()
  await expect(diagram(page)).toContainText("The program simulates nothing yet.")
}

abstract class DiagramHands implements Wiring {
  /// Since the empty program was opened.
  actions = 0
  protected readonly page: Page

  constructor(page: Page) {
    this.page = page
  }

  async begins(): Promise<void> {
    await beginsAlone(this.page)
    this.actions = 0
  }

  async connects(from: End, to: End, answers: Answers = {}): Promise<void> {
    await this.joins(from, to)
    // What has one meaning and no name is made without a question.
    if (Object.keys(answers).length > 0) await this.answers(answers)
    // A function without an example has its equation to be written at once; it is written when all wires are there.
    const equation = this.editor(answers.name ?? "")
    if ((await equation.count()) === 0) return
    await this.page.keyboard.press("Escape")
    await expect(equation).toBeHidden()
  }

  async writes(name: string, text: string): Promise<void> {
    await this.opens(name)
    await this.fills(this.editor(name), text)
  }

  async defines(_name: string, text: string): Promise<void> {
    await this.presses(diagram(this.page).getByRole("button", {name: "New definition"}))
    await this.fills(diagram(this.page).getByRole("form", {name: "New definition"}), text)
  }

  abstract adds(task: string): Promise<void>
  abstract presses(button: Locator): Promise<void>
  protected abstract joins(from: End, to: End): Promise<void>

  protected editor(name: string): Locator {
    return diagram(this.page).getByRole("form", {name: `Definition of ${name}`, exact: true})
  }

  /// Opens the text of a definition: of a node, or of one that is none.
  private async opens(name: string): Promise<void> {
    const other = diagram(this.page)
      .getByRole("group", {name: "Also defined:"})
      .getByRole("button", {name, exact: true})
    if ((await other.count()) > 0) return this.presses(other)
    await this.presses(node(this.page, new RegExp(`^${name}: function`)))
    const actions = diagram(this.page).getByRole("group", {name: `What can be done with ${name}`})
    await this.presses(actions.getByRole("button", {name: "Equation"}))
  }

  private async fills(form: Locator, text: string): Promise<void> {
    await form.getByRole("textbox").fill(text)
    this.actions++
    await this.finishes(form)
  }

  private async finishes(form: Locator): Promise<void> {
    await this.page.keyboard.press("Control+Enter")
    this.actions++
    await expect(form).toBeHidden()
  }

  private async answers({name, remembers, joins}: Answers): Promise<void> {
    const form = diagram(this.page).locator("form.diagram-ask:not(.definition)")
    await expect(form).toBeVisible()
    if (remembers !== undefined) {
      await form.getByRole("combobox", {name: "What it remembers"}).selectOption(remembers)
      this.actions++
    }
    if (name !== undefined) {
      await form.getByRole("textbox").first().fill(name)
      this.actions++
    }
    if (joins !== undefined) {
      await form.getByRole("radio", {name: /^Either:/}).check()
      this.actions++
    }
    await this.presses(form.getByRole("button", {name: /^(Connect|Done)$/}))
    await expect(form).toBeHidden()
  }
}

/// Wires are dragged.
export class DiagramMouse extends DiagramHands {
  async adds(task: string): Promise<void> {
    await this.unfolds("Steps")
    const step = diagram(this.page)
      .getByRole("list", {name: "Steps"})
      .getByRole("listitem")
      .filter({hasText: new RegExp(`^${task}$`)})
    await drags(this.page, step, diagram(this.page).locator("[data-free-space]:visible"))
    this.actions++
  }

  async presses(button: Locator): Promise<void> {
    await button.click()
    this.actions++
  }

  protected async joins(from: End, to: End): Promise<void> {
    await drags(this.page, await this.end(from), await this.end(to))
    this.actions++
  }

  private async end(end: End): Promise<Locator> {
    const [kind, name = "New memory"] = end.split(" ")
    if (kind === "function") return node(this.page, new RegExp(`^${name}: function`))
    if (kind === "event") return node(this.page, new RegExp(`^${name}: event`))
    if (kind === "memory" && end !== "memory")
      return node(this.page, new RegExp(`^(Memory )?${name}: memory`))
    const side = kind === "sensor" ? "Sensors" : "Actuators"
    await this.unfolds(side)
    return diagram(this.page)
      .locator(`.diagram-palette.of-${side.toLowerCase()}`)
      .getByRole("listitem")
      .filter({hasText: new RegExp(`^${name}$`)})
  }

  private async unfolds(palette: string): Promise<void> {
    const button = diagram(this.page).getByRole("button", {name: palette, exact: true})
    if ((await button.getAttribute("aria-expanded")) === "false") await this.presses(button)
  }
}

/// Wires are chosen in the list form.
export class DiagramKeys extends DiagramHands {
  async adds(task: string): Promise<void> {
    await diagram(this.page).getByRole("combobox", {name: "New step"}).selectOption(`task ${task}`)
    this.actions++
    await this.presses(diagram(this.page).getByRole("button", {name: "Add it at the end"}))
  }

  async presses(button: Locator): Promise<void> {
    await button.press("Enter")
    this.actions++
  }

  protected async joins(from: End, to: End): Promise<void> {
    for (const [menu, end] of [
      ["From", from],
      ["To", to],
    ] as const) {
      const list = diagram(this.page).getByRole("combobox", {name: menu, exact: true})
      await list.selectOption(
        await list
          .locator("option")
          .filter({hasText: this.option(end)})
          .evaluate(option => option.textContent ?? ""),
      )
      this.actions++
    }
    await this.presses(diagram(this.page).getByRole("button", {name: "Connect"}))
  }

  private option(end: End): RegExp {
    if (end === "memory") return /^New memory, memory$/
    const [kind, name] = end.split(" ")
    const kinds = {
      sensor: "(robot event|robot state|value to read)",
      actuator: "command",
      function: "function",
      memory: "memory",
      event: "event of the program",
    }
    const called = kind === "memory" ? `Memory ${name}` : name
    return new RegExp(`^${called}, ${kinds[kind as keyof typeof kinds]}$`)
  }
}
