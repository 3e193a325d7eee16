import System.IO

main = openTempFile "/tmp" "TARGET" >>= \(f, _) -> simulate (Say f)
