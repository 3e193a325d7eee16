/// Settings of the stories in Firefox and WebKit. Playwright runs and counts them; it drives neither browser.

import {defineConfig} from "@playwright/test"
import stories, {reports} from "../playwright.config.ts"

export default defineConfig({
  ...stories,
  testDir: ".",
  outputDir: "../test-results/browsers",
  // One browser each.
  fullyParallel: false,
  workers: 2,
  reporter: [["list"], ["json", {outputFile: `${reports}/browsers.json`}]],
})
