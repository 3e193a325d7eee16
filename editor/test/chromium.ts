/// Command line of the Chromium that tests and benchmarks start: no sandbox (containers have no user namespaces), no GPU, and
/// none of the browser's own pages.
///
/// Chromium's headless mode is a whole browser. Each window of it preloads the list of the address bar as a page of its own, which
/// costs as much processor time as Rosy's page (measured with Chromium 156: 3.5 s per window with it, 2.0 s without).

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
