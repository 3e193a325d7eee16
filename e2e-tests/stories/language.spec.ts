/// What a program prints, the notes about it, and its own sensors and commands, as the page shows them.

import {expect} from "@playwright/test"
import {Learner} from "./learner.ts"
import {test} from "./story.ts"

const program = `newtype Charge = Charge Int

instance Sensor Charge where
  sensor = topic "/dock/core" "kobuki_msgs/SensorState" (Charge <$> field "battery")

warn :: Charge -> Maybe Say
warn (Charge level) = if level < 130 then Just (Say ("low " ++ show level)) else Nothing

remember :: Bumper -> Memory Int
remember _ = Memory 7

main :: IO ()
main = do
  putStrLn "printed first"
  print (6 * 7)
  simulate (warn, remember)
`

test("what a program prints, a note about it, and a message by hand on a topic of its own", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"])
  await page.evaluate(text => navigator.clipboard.writeText(text), program)
  await learner.emptiesHaskell()
  await page.keyboard.press("Control+v")

  // The blocks show the sensor with its topic.
  await expect(learner.definition("warn")).toBeVisible()
  await expect(page.getByRole("region", {name: "The program in blocks"})).toContainText("/dock/core")

  // A note: it stands last, is not counted, and says why.
  await page.getByRole("tab", {name: "Problems"}).click()
  const problems = page.getByRole("tabpanel")
  await expect(problems).toContainText("remember writes Memory Int, and no function reads it.")
  await expect(page.getByRole("tab", {name: "Problems"})).toHaveText("Problems")

  await page.getByRole("tab", {name: "Values"}).click()
  const form = page.getByRole("region", {name: "Messages by hand"})
  await expect(form).toContainText("/dock/core")
  await expect(form.getByRole("button", {name: "Send"})).toBeDisabled()
  await learner.runs()
  await expect(learner.status()).toHaveText("Running")
  await form.getByRole("textbox", {name: "battery"}).fill("120")
  await form.getByRole("button", {name: "Send"}).click()
  await page.getByRole("tab", {name: "Console"}).click()
  await expect(learner.console()).toContainText("printed first")
  await expect(learner.console()).toContainText("42")
  await expect(learner.console()).toContainText("low 120")
  await learner.keeps("own-topic")
  await learner.stops()
})
