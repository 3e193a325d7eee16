import GHC.Fingerprint

main = getFileHash "CANARY" >>= \h -> simulate (Say (if null (show h) then "no" else "HARM"))
