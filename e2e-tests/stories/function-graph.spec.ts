/// The graph of a function in the charts, drawn from the run, with its cases; and speed above position on one time axis.

import {AxeBuilder} from "@axe-core/playwright"
import {expect} from "@playwright/test"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const program = `go :: Position -> Velocity
go (Position x _)
  | x < 0.4 = Velocity (0.1 + x) 0
  | x < 0.8 = Velocity (0.9 - x) 0
  | otherwise = Velocity 0 0

main = simulate go
`

test("the graph of a function has a point for each answer, by case, and follows the time line", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await learner.emptiesHaskell()
  await learner.types(program)
  await page.getByRole("tab", {name: "Charts"}).click()
  await page.getByRole("button", {name: "Graph of go"}).click()
  await expect(page.getByTestId("no-graph")).toHaveText(/^Run the program/)
  await page.getByRole("button", {name: "Speed and position"}).click()
  await learner.runs()
  const cases = page.getByTestId("graph-cases").getByRole("listitem")
  await expect(cases).toHaveText(["x < 0.4", "x < 0.8", "otherwisenow"])
  await page.getByText("The points as a table").click()
  await expect(page.getByRole("row", {name: "0.00 0.10 x < 0.4"})).toBeVisible()
  await expect(
    page.getByRole("img", {name: /^Graph of go: Position: x, metres from 0 to 0\.8/}),
  ).toBeVisible()
  await page.getByRole("button", {name: "Pause", exact: true}).click()
  await learner.keeps("function-graph")
  const {violations} = await new AxeBuilder({page}).include("#tab-panel").analyze()
  expect(violations).toEqual([])

  // At an earlier moment only what was until then.
  await page.getByRole("slider", {name: "Look back in the run"}).fill("1")
  await expect(cases).toHaveText(["x < 0.4now"])
  await expect(page.getByTestId("motion-chart")).toContainText(/Position ahead0\.\d\d m/)
})
