/// Ready-made pieces from the toolbox drop in whole, by mouse, by keyboard and by finger: they run at once.

import {afterAll, beforeAll, expect, inject, test} from "vitest"
import {drag, Finger, openStage, type Spot, type Stage, settled} from "./browser.ts"
import {Keys} from "./keyboard_user.ts"

let stage: Stage
beforeAll(async () => {
  stage = await openStage(inject("stage"))
})
afterAll(() => stage.close())

const complain = `complain :: Bumper -> Maybe Sound
complain (Bumper _ Pressed) = Just ErrorSound
complain (Bumper _ Released) = Nothing

main :: IO ()
main = simulate complain
`

const lightShow = `lightShow :: Task ()
lightShow = replicateM_ 5 $ do
  once (Led1 Red)
  wait 0.5
  once (Led1 Black)
  wait 0.5

main :: IO ()
main = simulate lightShow
`

const pieces = [
  {found: "complain at a bump", called: "complain", text: complain},
  {found: "flash five times", called: "lightShow", text: lightShow},
] as const

/// Where a block of the toolbox can be taken that the search finds first.
async function finds(keys: Keys, words: string): Promise<Spot> {
  await keys.page.locator(".rosySearch").click()
  await keys.page.keyboard.insertText(words)
  await settled(keys.page)
  const box = (await keys.page
    .locator(".blocklyFlyout .blocklyDraggable > .blocklyPath")
    .first()
    .boundingBox())!
  return {x: box.x + 9, y: box.y + 12}
}

const free: Spot = {x: 520, y: 320}

test.each(pieces)("$called by mouse", async ({found, text}) => {
  const keys = await Keys.onEmpty(stage)
  await drag(keys.page, await finds(keys, found), free)
  await settled(keys.page)
  expect(await keys.haskell()).toBe(text)
})

test.each(pieces)("$called by keyboard", async ({found, text}) => {
  const keys = await Keys.onEmpty(stage)
  await keys.take(found)
  expect(await keys.haskell()).toBe(text)
})

test.each(pieces)("$called by finger", async ({found, text}) => {
  const keys = await Keys.onEmpty(stage)
  const {page} = keys
  const finger = await Finger.on(page)
  await finger.drag(await finds(keys, found), free)
  await settled(page)
  expect(await keys.haskell()).toBe(text)
})
