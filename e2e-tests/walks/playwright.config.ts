/// Settings of the walks in the real page: as the stories, several pages at a time.

import {defineConfig} from "@playwright/test"
import stories, {reports} from "../playwright.config.ts"

export default defineConfig({
  ...stories,
  testDir: ".",
  outputDir: "../test-results/walks",
  workers: Number(process.env["PAGES"] ?? 2),
  expect: {timeout: Number(process.env["ROSY_EXPECT"] ?? 60_000)},
  reporter: [["list"], ["json", {outputFile: `${reports}/walks.json`}]],
})
