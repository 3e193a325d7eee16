/// The room's robot as a robot of the ROS world: npm's roslib, as a program and in a page of its own.

import {expect, type Page} from "@playwright/test"
import {Ros, Topic} from "roslib"
import {Learner, screenshot, until} from "./learner.ts"
import {test} from "./story.ts"

/// The link in the menu names the session.
async function handLink(page: Page): Promise<string> {
  await page.getByRole("button", {name: "More", exact: true}).click()
  const href = await page.getByRole("link", {name: /Drive by hand/}).getAttribute("href")
  await page.keyboard.press("Escape")
  return href ?? ""
}

test("roslib lists the topics, hears the robot, drives it into the wall and sees the bump", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  const session = new URL(await handLink(page), page.url()).searchParams.get("session")
  const ros = new Ros()
  await ros.connect(`${page.url().replace(/^http/, "ws").replace(/\?.*/, "")}rosbridge/${session}`)
  const topics = await new Promise<{topics: string[]; types: string[]}>((found, lost) =>
    ros.getTopics(found, lost),
  )
  const types = Object.fromEntries(topics.topics.map((name, i) => [name, topics.types[i]]))
  expect(types["/odom"]).toBe("nav_msgs/Odometry")
  expect(types["/mobile_base/commands/velocity"]).toBe("geometry_msgs/Twist")

  const hear = <T>(name: string) =>
    new Promise<T>(heard => new Topic<T>({ros, name, messageType: types[name] ?? ""}).subscribe(heard))
  expect(await hear<{state: number}>("/mobile_base/events/robot_state")).toEqual({state: 1})
  const bump = hear<{bumper: number; state: number}>("/mobile_base/events/bumper")
  const velocity = new Topic({
    ros,
    name: "/mobile_base/commands/velocity",
    messageType: "geometry_msgs/Twist",
  })
  const drive = setInterval(
    () => velocity.publish({linear: {x: 0.7, y: 0, z: 0}, angular: {x: 0, y: 0, z: 0}}),
    100,
  )
  try {
    await until(learner.robot("speed"), v => v > 0.6)
    expect(await bump).toEqual({bumper: 1, state: 1})
  } finally {
    clearInterval(drive)
    ros.close()
  }
  await expect(learner.robot("bumpers")).toHaveText("centre")
})

test("the page that drives by hand goes with keys and with a finger, and stops when let go", async ({
  page,
}) => {
  const learner = new Learner(page)
  await learner.opens("move")
  await page.getByRole("button", {name: "More", exact: true}).click()
  const opening = page.waitForEvent("popup")
  await page.getByRole("link", {name: /Drive by hand/}).click()
  const hand = await opening
  await expect(hand.getByRole("status")).toHaveText("The robot listens.")
  await hand.keyboard.down("ArrowUp")
  await until(learner.robot("speed"), v => v > 0.2)
  await hand.keyboard.up("ArrowUp")
  await until(learner.robot("speed"), v => v === 0)
  // A button is held for as long as the pointer is down on it.
  const button = hand.getByRole("button", {name: "Turn left"})
  await button.hover()
  await hand.mouse.down()
  await until(learner.robot("heading"), degrees => degrees > 20)
  await hand.mouse.up()
  await hand.getByRole("slider").fill("0.7")
  await hand.keyboard.press("Tab")
  await hand.keyboard.down("ArrowUp")
  await expect(
    hand
      .getByRole("listitem")
      .filter({hasText: /bumper pressed/})
      .first(),
  ).toBeVisible()
  await hand.keyboard.up("ArrowUp")
  await hand.screenshot({
    path: screenshot("teleop"),
    fullPage: true,
  })
})
