/// The Chromium that tests and benchmarks start, and its command line: no sandbox (containers have no user namespaces), no GPU, and
/// none of the browser's own pages.
///
/// Chromium's headless mode is a whole browser. Each window of it preloads the list of the address bar as a page of its own, which
/// costs as much processor time as Rosy's page (measured with Chromium 156: 3.5 s per window with it, 2.0 s without).
///
/// The headless shell is the same engine without the browser's own windows (1.2 s of processor time until Rosy's page is ready,
/// 1.6 s in the whole browser). Debian has it as a package of its own; where it is not installed, the whole browser is started.

import {existsSync} from "node:fs"
import {isNightly} from "../../codegen/test/extent.ts"

/// Not `/usr/bin/chromium-headless-shell`, a script that would outlive the browser when a test kills it.
const headlessShell = "/usr/lib/chromium/chromium-headless-shell"

/// The whole browser, as people have it. `ROSY_CHROMIUM` names another one for all tests.
export const wholeChromium: string = process.env["ROSY_CHROMIUM"] ?? "/usr/bin/chromium"

/// Nightly runs, and those without the shell, take the whole browser.
export const chromiumPath: string =
  process.env["ROSY_CHROMIUM"] === undefined && !isNightly && existsSync(headlessShell)
    ? headlessShell
    : wholeChromium

/// Playwright switches these off. A second `--disable-features` replaces the first, so they stand here again.
const offByPlaywright = [
  "AvoidUnnecessaryBeforeUnloadCheckSync",
  "DestroyProfileOnBrowserClose",
  "HttpsUpgrades",
  "HttpsFirstBalancedModeAutoEnable",
  "LensOverlay",
  "MediaRouter",
  "PaintHolding",
  "ThirdPartyStoragePartitioning",
  "AvoidCorsURLLoaderRestartOnRedirect",
  "OptimizationHints",
  "NetworkTimeServiceQuerying",
  "AimEnabled",
  "PreconnectToSearch",
]

const pagesOfTheBrowser = [
  "PreloadTopChromeWebUI",
  "WebUIOmniboxPopup",
  "WebUIOmniboxAimPopup",
  "WebUIOmniboxFullPopup",
]

export const chromiumFlags: string[] = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-dev-shm-usage",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  `--disable-features=${[...offByPlaywright, ...pagesOfTheBrowser].join(",")}`,
]
