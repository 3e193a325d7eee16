/// Replies of the robot's own programs are sentences in the console.

import {expect, test} from "vitest"
import {replySentence} from "../../src/values/reply_sentence.ts"

test.each([
  ["Reply dock Succeeded", "dock answered: docked."],
  ["Reply dock Feedback", "dock answered: still at work."],
  ["Reply dock Aborted Aborted: no dock is in sight.", "dock answered: given up (no dock is in sight)."],
  ["Reply navigate_to Succeeded", "navigateTo answered: arrived."],
  ["Reply rotate_angle Cancelled", "rotateAngle answered: stopped."],
  ["Reply /count Unavailable No action server available", "/count answered: nobody here does that."],
  ["Reply /count Unavailable gone", "/count answered: nobody here does that (gone)."],
  [
    "Reply /a_b Rejected Action goal was rejected: two\nlines",
    "/a_b answered: refused (Action goal was rejected: two\nlines).",
  ],
])("%s", (event, sentence) => {
  const reply = replySentence(event)
  expect(`${reply?.name} ${reply?.text}`).toBe(sentence)
})

test("another event is none", () => {
  expect(replySentence("Bumper LeftBumper Pressed")).toBeNull()
  expect(replySentence("Reply dock")).toBeNull()
})
